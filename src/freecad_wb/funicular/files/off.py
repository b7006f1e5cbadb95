# SPDX-License-Identifier: LGPL-2.1-or-later
"""OFF: http://www.geomview.org/docs/html/OFF.html"""

import re

from .connectivity import check_members_on_panels


def read(source, content):
    rows = source.text_lines(content)
    words = source.next_row(rows, "the header")
    # The prefixes add columns behind the three coordinates; 4 and n would change the coordinates themselves.
    if re.fullmatch(r"(ST)?C?N?OFF", words[0]):
        words = words[1:] or source.next_row(rows, "the numbers of vertices and faces")
    if words[:1] == ["BINARY"]:
        raise source.error("binary OFF files are not read")
    if len(words) < 2:
        raise source.error("the file does not start with 'OFF' and the numbers of vertices and faces")
    vertices = source.count(words[0], "the number of vertices")
    faces = source.count(words[1], "the number of faces")
    for number in range(vertices):
        source.add_node(source.next_row(rows, f"vertex {number} of {vertices}"))
    for number in range(faces):
        words = source.next_row(rows, f"face {number} of {faces}")
        corners = source.count(words[0], "the number of corners")
        if len(words) <= corners:
            raise source.error(f"face {number} has {len(words) - 1} corners instead of {corners}")
        source.add_face([source.whole(word, "a vertex index") for word in words[1 : corners + 1]])


def write(path, nodes, members, panels):
    check_members_on_panels(path, members, panels)
    rows = ["OFF", f"{len(nodes)} {len(panels)} {len(members)}"]
    rows += [f"{x!r} {y!r} {z!r}" for x, y, z in nodes.tolist()]
    rows += [" ".join(map(str, (len(panel), *panel))) for panel in panels]
    return ("\n".join(rows) + "\n").encode("ascii")
