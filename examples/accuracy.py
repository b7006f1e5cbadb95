# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs on a flat net of 33 by 25 nodes that rises on its border. Needs no FreeCAD.

    python3 examples/accuracy.py build/gallery/accuracy.png
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "src" / "freecad_wb"))

import funicular as fn  # noqa: E402


def main(path):
    net = fn.Net.grid(16.0, 12.0, 0.5)
    scene = fn.Scene(
        net,
        [fn.Fixed(net.border)],
        [fn.AxialStiffness(100e3), fn.MemberWeight(12.0), fn.CoveringWeight(30.0)],
    )
    study = fn.accuracy_study(
        scene,
        on_progress=lambda row: print(f"{row['method']:10} {row['accuracy']:.0e} m  {row['seconds']:.3f} s"),
    )
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    study.plot(path, chosen=1e-3, method="auto")
    print(f"drawn: {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
