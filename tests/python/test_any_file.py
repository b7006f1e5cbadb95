# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files that were cut, spliced and scribbled in: a net, or a refusal that names the place."""

import pytest
from hypothesis import given, strategies as st

import funicular as fn
from mesh_bytes import SUFFIXES, check_reading, seeds

SEEDS = list(seeds())
TOKENS = [
    b"-1",
    b"0",
    b"1e999",
    b"nan",
    b"99999999999",
    b"\n",
    b" ",
    b"\\\n",
    b"#",
    b"\0",
    b"\xff",
    b"1_0",
    b"1.5",
]
TOKENS += [
    b"element x 9999999999\n",
    b"property list char int vertex_indices\n",
    b"element face 4000000000\n",
]


@st.composite
def scribbled(draw):
    suffix, content = draw(st.sampled_from(SEEDS))
    for _ in range(draw(st.integers(0, 4))):
        begin = draw(st.integers(0, len(content)))
        end = min(len(content), begin + draw(st.sampled_from([0, 1, 1, 2, 8, 60])))
        piece = draw(
            st.one_of(st.sampled_from(TOKENS), st.binary(max_size=4), st.just(content[end : end + 20]))
        )
        content = content[:begin] + piece + content[end:]
    return suffix, content


@given(scribbled())
def test_a_scribbled_file_is_read_or_refused(tmp_path_factory, file):
    suffix, content = file
    check_reading(tmp_path_factory.getbasetemp() / f"scribbled.{suffix}", content)


@given(st.sampled_from(SUFFIXES), st.binary(max_size=300))
def test_any_bytes_are_read_or_refused(tmp_path_factory, suffix, content):
    check_reading(tmp_path_factory.getbasetemp() / f"bytes.{suffix}", content)


def test_every_seed_is_a_net(tmp_path):
    import funicular as fn

    for number, (suffix, content) in enumerate(SEEDS):
        path = tmp_path / f"{number}.{suffix}"
        path.write_bytes(content)
        assert len(fn.Net.read(path).panels) >= 1


PLY = "ply\nformat {} 1.0\nelement vertex 3\n" + "".join(f"property float {axis}\n" for axis in "xyz")
PLY += "{}end_header\n"
FACE = "element face 1\nproperty list uchar int vertex_indices\n"
TRIANGLE = "0 0 0\n1 0 0\n0 1 0\n"
EMPTY = "element x 9999999999\n"
ENDS = "".join(f"vertex {x} 0 0\n" for x in ("1e308", "-1e308", "0"))
FOUND = {
    "no end of nothing": ("ply", PLY.format("binary_little_endian", EMPTY) + "\0" * 36, "faces"),
    "corners by halves": ("ply", PLY.format("ascii", FACE.replace("int", "float")), "list of integers"),
    "xyz in lists": ("ply", PLY.replace("float z", "list int int z").format("ascii", ""), "one number"),
    "one corner a face": ("ply", PLY.format("ascii", FACE.replace("list uchar ", "")), "list of integers"),
    "half a list": ("ply", PLY.format("ascii", FACE.replace("uchar", "float")), ":8: this line"),
    "less than no list": ("ply", PLY.format("ascii", FACE) + TRIANGLE + "-1 0 1 2\n", r":13: a count is -1"),
    "less than no faces": ("off", "OFF\n3 -1 0\n" + TRIANGLE, r":2: the number of faces is -1"),
    "digits of Python": ("obj", "v 0 1_0 0\n", r":1: a coordinate .*'1_0'"),
    "digits of Egypt": ("obj", "v 0 0 0\nf ١ 2\n", r":2: a vertex index .*'١'"),
    "from end to end": ("stl", f"solid\n{ENDS}endsolid\n", "span more"),
}  # fmt: skip


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("case", FOUND)
def test_what_scribbling_found_is_refused(tmp_path, case):
    suffix, content, message = FOUND[case]
    path = tmp_path / f"found.{suffix}"
    path.write_text(content, "utf-8")
    with pytest.raises(ValueError, match=message):
        fn.Net.read(path)


def test_a_comment_that_ends_in_a_backslash_is_over_all_the_same(tmp_path):
    path = tmp_path / "windows.ply"
    path.write_text(PLY.format("ascii", FACE + "comment C:\\roofs\\\n") + TRIANGLE + "3 0 1 2\n")
    assert fn.Net.read(path).panels == ((0, 1, 2),)
