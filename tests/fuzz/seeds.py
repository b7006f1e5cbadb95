# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeds for fuzz_scene: usage seeds.py FOLDER.

Any bytes are a scene to it (see bytes.hpp), but most are refused at once. These are the first random ones of
several lengths, and lattices, which are nets whatever the rest says.
"""

import pathlib
import random
import sys


def seeds():
    bits = random.Random(1)
    for length in (8, 32, 128, 400):
        for _ in range(8):
            yield bits.randbytes(length)
    # Scale 1 at the origin, a lattice, its cells; closed, poles and positions as they fall.
    for cells in range(1, 5):
        for _ in range(8):
            yield bytes([20, 0, 1, cells, cells]) + bits.randbytes(200)


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    for number, seed in enumerate(seeds()):
        (folder / f"seed-{number}").write_bytes(seed)
