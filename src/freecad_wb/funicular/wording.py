# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that remarks and errors share: how many, which, whether that is one or several, how long."""


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


def length_text(metres):
    """1 mm, 10 µm, 1 nm."""
    for unit, size in (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9), ("pm", 1e-12)):
        if metres >= 0.9995 * size:
            return f"{metres / size:.3g} {unit}"
    return f"{metres:.0e} m"


def time_text(seconds):
    """12 s, 35 ms, 0.4 ms."""
    if seconds >= 0.9995:
        return f"{seconds:.0f} s" if seconds >= 9.95 else f"{seconds:.2g} s"
    return f"{seconds * 1e3:.0f} ms" if seconds >= 0.00995 else f"{seconds * 1e3:.2g} ms"


def force_text(newtons):
    """184 kN, 3.2 N."""
    return f"{newtons / 1e3:.3g} kN" if abs(newtons) >= 1e3 else f"{newtons:.3g} N"
