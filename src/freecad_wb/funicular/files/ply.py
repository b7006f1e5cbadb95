# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLY: https://www.loc.gov/preservation/digital/formats/fdd/fdd000501.shtml"""

import re
import struct

_TYPES = {
    **dict.fromkeys(("char", "int8"), "b"),
    **dict.fromkeys(("uchar", "uint8"), "B"),
    **dict.fromkeys(("short", "int16"), "h"),
    **dict.fromkeys(("ushort", "uint16"), "H"),
    **dict.fromkeys(("int", "int32"), "i"),
    **dict.fromkeys(("uint", "uint32"), "I"),
    **dict.fromkeys(("float", "float32"), "f"),
    **dict.fromkeys(("double", "float64"), "d"),
}


def read(source, content):
    end = re.search(rb"^end_header[ \t]*\r?\n", content, re.MULTILINE)
    if not content.startswith(b"ply") or not end:
        raise source.error("the file does not start with 'ply' and a header that ends with 'end_header'")
    form, elements = _header(source, content[: end.end()])
    takers = [_taker(source, element, properties) for element, _, properties in elements]
    if form == "ascii":
        items = _Text(source, content)
    else:
        items = _Binary(source, content, end.end(), "<" if form == "binary_little_endian" else ">")
    for take, (element, count, properties) in zip(takers, elements):
        if not properties:
            continue  # its items have nothing to read, however many it says there are
        for number in range(count):
            take(items.next(f"{element} {number}", properties))


def _header(source, header):
    """The format; and of each element its name, count and properties (name, type of a list's count, type)."""
    form, elements = None, []
    for words in source.text_lines(header):
        try:
            if words[0] == "format" and words[1] in ("ascii", "binary_little_endian", "binary_big_endian"):
                form = words[1]
            elif words[0] == "element":
                elements.append((words[1], source.count(words[2], "the number of elements"), []))
            elif words[0] == "property" and words[1] == "list":
                if _TYPES[words[2]] in "fd":
                    raise KeyError(words[2])
                elements[-1][2].append((words[4], _TYPES[words[2]], _TYPES[words[3]]))
            elif words[0] == "property":
                elements[-1][2].append((words[2], None, _TYPES[words[1]]))
            elif words[0] not in ("ply", "comment", "obj_info", "end_header"):
                raise KeyError(words[0])
        except (IndexError, KeyError):
            raise source.error(f"this line of the header is not understood: {' '.join(words)}") from None
    if form is None:
        raise source.error("the header does not state the format")
    return form, elements


def _taker(source, element, properties):
    """What to do with an item of this element: a function of its values by name."""

    def name_of(*choices, is_list=False, kinds="bBhHiI"):
        for name, count, kind in properties:
            if name not in choices:
                continue
            if (count is not None) != is_list or kind not in kinds:
                wanted = "a list of integers" if is_list else "one number" if "d" in kinds else "one integer"
                raise source.error(f"property '{name}' of element '{element}' should be {wanted}")
            return name
        raise source.error(f"the header's element '{element}' has no property '{choices[0]}'")

    if element == "vertex":
        xyz = [name_of(name, kinds="bBhHiIfd") for name in "xyz"]
        return lambda values: source.add_node([values[name] for name in xyz])
    if element == "face":
        corners = name_of("vertex_indices", "vertex_index", is_list=True)
        return lambda values: source.add_face(values[corners])
    if element == "edge":
        ends = [name_of("vertex1"), name_of("vertex2")]
        return lambda values: source.add_line([values[name] for name in ends])
    if element == "tristrips":
        raise source.error("triangle strips are not read: save the mesh with faces")
    return lambda values: None


class _Text:
    def __init__(self, source, content):
        self.source = source
        self.rows = source.text_lines(content)
        while next(self.rows)[0] != "end_header":
            pass

    def next(self, what, properties):
        words = self.source.next_row(self.rows, what)
        values = {}
        for name, count, kind in properties:
            length = 1 if count is None else self.source.count(words.pop(0) if words else "", "a count")
            if len(words) < length:
                raise self.source.error(f"{what} has too few values")
            numbers = [self.number(word, kind) for word in words[:length]]
            del words[:length]
            values[name] = numbers[0] if count is None else numbers
        return values

    def number(self, word, kind):
        return self.source.real(word) if kind in "fd" else self.source.whole(word, "an index")


class _Binary:
    def __init__(self, source, content, offset, order):
        self.source, self.content, self.offset, self.order = source, content, offset, order

    def next(self, what, properties):
        self.source.place = what
        try:
            return {
                name: self.unpack(kind)[0] if count is None else self.unpack(kind, self.unpack(count)[0])
                for name, count, kind in properties
            }
        except struct.error:
            raise self.source.error("the file ends before or within it") from None

    def unpack(self, kind, count=1):
        if count < 0:
            raise self.source.error(f"a list of {count} values: their number cannot be negative")
        layout = f"{self.order}{count}{kind}"
        values = struct.unpack_from(layout, self.content, self.offset)
        self.offset += struct.calcsize(layout)
        return values


def write(path, nodes, members, panels):
    count_type, count_code = ("uchar", "B") if all(len(panel) < 256 for panel in panels) else ("uint", "I")
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(nodes)}"]
    header += [f"property double {name}" for name in "xyz"]
    header += [f"element face {len(panels)}", f"property list {count_type} int vertex_indices"]
    header += [
        f"element edge {len(members)}",
        "property int vertex1",
        "property int vertex2",
        "end_header",
        "",
    ]
    parts = ["\n".join(header).encode("ascii"), nodes.astype("<f8").tobytes()]
    parts += [struct.pack(f"<{count_code}{len(panel)}i", len(panel), *panel) for panel in panels]
    parts += [struct.pack("<2i", a, b) for a, b in members]
    return b"".join(parts)
