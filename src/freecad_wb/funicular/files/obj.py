# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ: https://www.loc.gov/preservation/digital/formats/fdd/fdd000507.shtml"""


def read(source, content, with_uv=False):
    """Reads vertices, lines and faces, and UV coordinates where they are asked for: else no care is taken."""
    for keyword, *words in source.text_lines(content, continued=True):
        if keyword == "v":
            source.add_node(words)
        elif keyword == "vt" and with_uv:
            source.add_uv(words)
        elif keyword == "f":
            source.add_face([_index(source, word) for word in words])
            if with_uv:
                source.face_uvs.append(_uv_indices(source, words))
        elif keyword == "l":
            if len(words) < 2:
                raise source.error("a line has at least 2 vertices")
            source.add_line([_index(source, word) for word in words])


def _index(source, word):
    """The vertex of v/vt/vn."""
    return _counted(source, word.split("/")[0], "vertex", len(source.nodes))


def _uv_indices(source, words):
    """The UV coordinates of a face, None unless all of its corners have some."""
    named = [word.split("/")[1:2] for word in words]
    if not all(each and each[0] for each in named):
        return None
    return tuple(_counted(source, each[0], "texture", len(source.uvs)) for each in named)


def _counted(source, word, what, count):
    """OBJ counts from 1, and below zero backwards from the latest."""
    index = source.whole(word, f"a {what} index")
    if index == 0 or index < -count:
        raise source.error(f"{what} index {index} is out of range: OBJ counts from 1, or from -1 backwards")
    return index - 1 if index > 0 else count + index


def write(path, nodes, members, panels):
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in nodes.tolist()]
    rows += [f"l {a + 1} {b + 1}" for a, b in members]
    rows += ["f " + " ".join(str(corner + 1) for corner in panel) for panel in panels]
    return ("\n".join(rows) + "\n").encode("ascii")
