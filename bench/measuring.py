# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the Python benchmarks measure and keep what they measured. The standard library alone."""

import csv
import statistics
import time

MOST_RUNS, ENOUGH_SECONDS = 5, 5.0


def timed(work):
    """(what it gives, CPU seconds of this process). CPU time, as other programs may run beside."""
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def repeated(work):
    """(what the last run gives, first time, median of the later times, how many those are).

    The first run pays for what is made once, such as compilation. What takes long is run once.
    """
    result, first = timed(work)
    times = []
    while len(times) < MOST_RUNS and first + sum(times) < ENOUGH_SECONDS:
        result, seconds = timed(work)
        times.append(seconds)
    return result, first, statistics.median(times or [first]), max(len(times), 1)


class Rows:
    """A CSV file that has every row as soon as it is there, so that a run broken off leaves what it has."""

    def __init__(self, path, columns, mode="w"):
        self.file = open(path, mode, newline="", encoding="utf-8")
        self.table = csv.DictWriter(self.file, columns)
        if mode == "w":
            self.table.writeheader()

    def add(self, row):
        """Writes a row, a dict, and prints it."""
        self.table.writerow(row)
        self.file.flush()
        told = (f"{value:.3g}" if isinstance(value, float) else str(value) for value in row.values())
        print("  ".join(word for word in told if word), flush=True)
