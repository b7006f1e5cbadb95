# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all readers share: collecting vertices, faces and lines, and saying where something is wrong."""

import numpy as np

from .connectivity import members_of


class Source:
    """What was read so far, and where in the file: so that every complaint can name its place."""

    def __init__(self, path):
        self.path = path
        self.place = None
        self.nodes = []
        self.node_places = []
        self.lines = []
        self.faces = []
        # Where they are asked for: (u, v), and of each face the numbers of its corners' or None.
        self.uvs = []
        self.face_uvs = []

    def error(self, message, place=None):
        place = self.place if place is None else place
        if isinstance(place, int):
            return ValueError(f"{self.path}:{place}: {message}")
        return ValueError(f"{self.path}: {f'{place}: ' if place else ''}{message}")

    def text_lines(self, content, continued=False):
        """The words of each line that has any, comments (#) taken away; `place` follows.

        If `continued`, a backslash at a line's end continues it; its number is then that of its last part.
        """
        begun = ""
        for number, line in enumerate([*content.decode("utf-8-sig", "replace").split("\n"), ""], 1):
            line = begun + line.split("#", 1)[0].rstrip()
            begun = line[:-1] + " " if continued and line.endswith("\\") else ""
            words = line.split()
            if words and not begun:
                self.place = number
                yield words

    def next_row(self, rows, what):
        """The words of the next line; an error if the file ends before it."""
        words = next(rows, None)
        if words is None:
            raise self.error(f"the file ends before {what}")
        return words

    def whole(self, word, what):
        try:
            return int(_plain(word))
        except ValueError:
            raise self.error(f"{what} should be a whole number, not '{word}'") from None

    def count(self, word, what):
        count = self.whole(word, what)
        if count < 0:
            raise self.error(f"{what} is {count}: it cannot be negative")
        return count

    def real(self, word):
        try:
            return float(_plain(word))
        except ValueError:
            raise self.error(f"a coordinate should be a number, not '{word}'") from None

    def add_node(self, words):
        if len(words) < 3:
            raise self.error(f"vertex {len(self.nodes)} has {len(words)} coordinates instead of 3")
        self.nodes.append([self.real(word) for word in words[:3]])
        self.node_places.append(self.place)

    def add_line(self, indices):
        self.lines.extend((self.place, pair) for pair in zip(indices, indices[1:]))

    def add_uv(self, words):
        if len(words) < 2:
            raise self.error(f"texture {len(self.uvs)} has {len(words)} coordinates instead of 2")
        self.uvs.append([self.real(word) for word in words[:2]])

    def add_face(self, indices):
        if len(indices) < 3:
            raise self.error(f"face {len(self.faces)} has {len(indices)} corners: at least 3 are needed")
        self.faces.append((self.place, tuple(indices)))

    def net(self):
        """Check everything that was read and make the net of it."""
        nodes, lines, panels = self.parts()
        return nodes, np.array(members_of(lines, panels), dtype=np.int64).reshape(-1, 2), panels

    def parts(self):
        """Check everything that was read: vertices, lines as pairs of vertices, faces."""
        self.place = None
        if not len(self.nodes):
            raise self.error("there are no vertices in the file")
        if not self.faces and not self.lines:
            raise self.error("there are neither faces nor lines in the file")
        nodes = self.finite_nodes()
        for kind, entries in (("face", self.faces), ("line", self.lines)):
            for number, (place, indices) in enumerate(entries):
                self.check_indices(f"{kind} {number}", place, indices)
        return nodes, [line for _, line in self.lines], [face for _, face in self.faces]

    def textured(self):
        """Check the UV coordinates: (k, 2) of them, and those of each face, by number, or None."""
        uvs = np.array(self.uvs, dtype=np.float64).reshape(-1, 2)
        bad = np.flatnonzero(~np.isfinite(uvs).all(axis=1))
        if bad.size:
            raise self.error(f"texture {bad[0]} has a coordinate that is not finite: {uvs[bad[0]]}")
        for number, ((place, _), corners) in enumerate(zip(self.faces, self.face_uvs)):
            for index in corners or ():
                if index >= len(uvs):
                    raise self.error(
                        f"face {number} names texture {index} (counted from 0), but the file has {len(uvs)}",
                        place,
                    )
        return uvs, self.face_uvs

    def finite_nodes(self):
        nodes = np.array(self.nodes, dtype=np.float64).reshape(-1, 3)
        bad = np.flatnonzero(~np.isfinite(nodes).all(axis=1))
        if bad.size:
            raise self.error(
                f"vertex {bad[0]} has a coordinate that is not finite: {nodes[bad[0]]}",
                self.node_places[bad[0]],
            )
        return nodes

    def check_indices(self, what, place, indices):
        for index in indices:
            if not 0 <= index < len(self.nodes):
                raise self.error(
                    f"{what} names vertex {index} (counted from 0), but the file has {len(self.nodes)}", place
                )
        if len(set(indices)) < len(indices):
            twice = next(index for index in indices if indices.count(index) > 1)
            raise self.error(f"{what} names vertex {twice} (counted from 0) twice", place)


def _plain(word):
    """Python reads 1_000, and the digits of every script: no mesh file means them. Numbers stay."""
    if isinstance(word, str) and ("_" in word or not word.isascii()):
        raise ValueError
    return word
