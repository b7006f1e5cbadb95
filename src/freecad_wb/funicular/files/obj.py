# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ: https://www.loc.gov/preservation/digital/formats/fdd/fdd000507.shtml"""


def read(source, content):
    for keyword, *words in source.text_lines(content, continued=True):
        if keyword == "v":
            source.add_node(words)
        elif keyword == "f":
            source.add_face([_index(source, word) for word in words])
        elif keyword == "l":
            if len(words) < 2:
                raise source.error("a line has at least 2 vertices")
            source.add_line([_index(source, word) for word in words])


def _index(source, word):
    """OBJ counts from 1, and below zero backwards from the latest vertex; of v/vt/vn only v matters."""
    index = source.whole(word.split("/")[0], "a vertex index")
    if index == 0 or index < -len(source.nodes):
        raise source.error(f"vertex index {index} is out of range: OBJ counts from 1, or from -1 backwards")
    return index - 1 if index > 0 else len(source.nodes) + index


def write(path, nodes, members, panels):
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in nodes.tolist()]
    rows += [f"l {a + 1} {b + 1}" for a, b in members]
    rows += ["f " + " ".join(str(corner + 1) for corner in panel) for panel in panels]
    return ("\n".join(rows) + "\n").encode("ascii")
