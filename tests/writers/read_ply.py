# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a PLY file says when it is read as its header tells, with nothing but Python: the
names of the properties of a vertex, a line per vertex, a line per face."""
import struct
import sys

CODES = {"uchar": "B", "int": "i", "uint": "I", "float": "f", "double": "d"}

with open(sys.argv[1], "rb") as file:
    lines = iter(file.readline, b"end_header\n")
    header = [line.decode("ascii").split() for line in lines]
    body = file.read()
assert header[0] == ["ply"]
is_ascii = header[1] == ["format", "ascii", "1.0"]
assert is_ascii or header[1] == ["format", "binary_little_endian", "1.0"]
words = iter(body.split())
offset = 0


def value(kind):
    global offset
    if is_ascii:
        word = next(words)
        return float(word) if kind in ("float", "double") else int(word)
    code = "<" + CODES[kind]
    offset += struct.calcsize(code)
    return struct.unpack_from(code, body, offset - struct.calcsize(code))[0]


elements = []
for line in header:
    if line[0] == "element":
        elements.append((line[1], int(line[2]), []))
    elif line[0] == "property":
        elements[-1][2].append(line[1:])
assert [name for name, _, _ in elements] in (["vertex"], ["vertex", "face"])
print(*(names[-1] for names in elements[0][2]))
for name, count, properties in elements:
    for _ in range(count):
        row = []
        for kind in properties:
            if kind[0] == "list":
                row += [value(kind[2]) for _ in range(value(kind[1]))]
            else:
                row.append(value(kind[0]))
        print(*(repr(x) for x in row))
assert not list(words) if is_ascii else offset == len(body), "bytes are left over"
