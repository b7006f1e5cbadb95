# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run clang-tidy over units of the core, several of them in one go, and say what it finds.

    tidy.py build/release unit.cpp …

Nearly all that clang-tidy reads is Eigen's headers: units that are read together cost little more than one.
Names that are private to a unit may meet another's there, and a group that does not pass is looked at unit by
unit: what is said is what clang-tidy says of each alone.
"""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

GROUPS = 5


def main(build, units):
    root = pathlib.Path.cwd()
    folder = root / build / "tidy"
    folder.mkdir(parents=True, exist_ok=True)
    # Neighbours by name are of one family, whose private names are alike: they go to different groups.
    groups = [units[first::GROUPS] for first in range(min(GROUPS, len(units)))]
    known = json.loads((root / build / "compile_commands.json").read_text("utf-8"))
    unit = next(each for each in known if each["file"] == str(root / units[0]))
    files, commands = [], []
    for number, group in enumerate(groups):
        files.append(folder / f"group{number}.cpp")
        files[-1].write_text("".join(f'#include "{root / each}"\n' for each in group), "utf-8")
        command = unit["command"].replace(unit["file"], str(files[-1]))
        commands.append({**unit, "file": str(files[-1]), "command": command})
    (folder / "compile_commands.json").write_text(json.dumps(commands), "utf-8")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = list(pool.map(lambda file: tidy(folder, file), files))
        doubtful = [each for group, run in zip(groups, runs) if run.returncode for each in group]
        alone = list(pool.map(lambda each: tidy(build, each), doubtful))
    for run in alone:
        sys.stdout.write(run.stdout)
    return any(run.returncode for run in alone)


def tidy(build, file):
    return subprocess.run(
        ["clang-tidy", "--quiet", "-p", str(build), str(file)], capture_output=True, text=True
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
