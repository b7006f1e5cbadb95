# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every file of ours has in common. Each rule is first shown to catch what breaks it."""

import rules

WITH_SPDX = (".py", ".cpp", ".hpp", ".h", ".sh", ".cmake", "CMakeLists.txt", "Makefile", ".toml", ".xml")
WITH_SPDX += (".clang-format", ".clang-tidy", ".flake8", ".gitignore", ".ci/run")
READ_BY_PEOPLE = (".py", ".cpp", ".hpp", ".h", ".sh", ".cmake", "CMakeLists.txt", "Makefile", ".md")


def broken(suffixes, rule):
    files = list(rules.sources(*suffixes))
    assert len(files) >= 30
    return [
        f"{path.relative_to(rules.ROOT)} {fault}" for path in files for fault in rule(path.read_text("utf-8"))
    ]


def test_a_missing_licence_line_is_caught():
    assert rules.licence_missing('"""A module."""\n\nimport os\n')
    assert rules.licence_missing("\n\n\n# SPDX-License-Identifier: LGPL-2.1-or-later\n")
    assert not rules.licence_missing("#!/bin/bash\n# SPDX-License-Identifier: LGPL-2.1-or-later\n")


def test_every_source_states_its_licence():
    faults = broken(WITH_SPDX, rules.licence_missing)
    assert not faults, "\n".join(faults)


def test_a_long_file_is_caught():
    assert rules.too_long("x\n" * (rules.MOST_LINES + 1))
    assert not rules.too_long("x\n" * rules.MOST_LINES)


def test_no_file_is_too_long():
    faults = broken(READ_BY_PEOPLE, rules.too_long)
    assert not faults, "\n".join(faults)


def test_an_unfinished_mark_is_caught():
    assert rules.unfinished("// FIX" + "ME: later")
    assert rules.unfinished("# TO" + "DO")
    assert not rules.unfinished("todo lists and fixme in prose")


def test_nothing_is_left_for_later():
    faults = broken(READ_BY_PEOPLE, rules.unfinished)
    assert not faults, "\n".join(faults)


def test_the_licence_is_the_one_that_is_named():
    text = (rules.ROOT / "LICENSE").read_text("utf-8")
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in text and "Version 2.1, February 1999" in text
