# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coverage-guided fuzzing of the mesh readers: libFuzzer's options, by atheris.

The first byte of an input chooses the format, the rest is the file. What must hold is
`mesh_bytes.check_reading`.
With --seeds FOLDER writes the seed corpus there and ends.
"""

import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/freecad_wb"), str(ROOT / "tests/python")]


def write_seeds(folder):
    from mesh_bytes import SUFFIXES, seeds

    for number, (suffix, content) in enumerate(seeds()):
        (folder / f"seed-{number}").write_bytes(bytes([SUFFIXES.index(suffix)]) + content)


def fuzz():
    import atheris

    with atheris.instrument_imports(include=["funicular.files"]):
        from mesh_bytes import SUFFIXES, check_reading

    with tempfile.TemporaryDirectory() as folder:

        def test_one_input(data):
            if data:
                check_reading(pathlib.Path(folder) / f"net.{SUFFIXES[data[0] % len(SUFFIXES)]}", data[1:])

        atheris.Setup(sys.argv, test_one_input)
        atheris.Fuzz()


if __name__ == "__main__":
    if sys.argv[1:2] == ["--seeds"]:
        write_seeds(pathlib.Path(sys.argv[2]))
    else:
        fuzz()
