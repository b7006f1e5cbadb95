# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that remarks and errors share: how many, which, and whether that is one or several."""


def counted(number, one, several=None):
    return f"{number} {one if number == 1 else several or one + 's'}"


def is_or_are(things):
    return "is" if len(things) == 1 else "are"


def and_more(count):
    return f", and {count} more" if count else ""


def listed(numbers, last=", ", most=8):
    """The first of the numbers with commas, `last` before the last one."""
    words = [str(number) for number in numbers[:most]]
    if len(numbers) > most:
        words.append(f"{len(numbers) - most} more")
    return last.join([", ".join(words[:-1]), words[-1]]) if len(words) > 1 else "".join(words)
