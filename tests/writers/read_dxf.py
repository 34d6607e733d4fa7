# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what ezdxf finds in a DXF file: its complaints, the number of polyface meshes, the number
of triangles, three corners of each, the number of points, the points, the number of curves, and a
line for each: whether it is closed, how many points, the points."""
import sys

import ezdxf

document = ezdxf.readfile(sys.argv[1])
audit = document.audit()
triangles = []
points = []
curves = []
meshes = 0
for entity in document.modelspace():
    kind = entity.dxftype()
    if kind == "3DFACE":
        a, b, c, d = (entity.dxf.get(f"vtx{i}") for i in range(4))
        assert c == d, "not a triangle"
        triangles.append((a, b, c))
    elif kind == "POLYLINE" and entity.is_poly_face_mesh:
        meshes += 1
        triangles += [tuple(v.dxf.location for v in face[:-1]) for face in entity.faces()]
    elif kind == "POLYLINE" and entity.is_3d_polyline:
        curves.append((entity.is_closed, [vertex.dxf.location for vertex in entity.vertices]))
    elif kind == "POINT":
        points.append(entity.dxf.location)
    else:
        audit.errors.append(kind)
print(len(audit.errors) + len(audit.fixes), meshes)
print(len(triangles))
for triangle in triangles:
    assert len(triangle) == 3
    print(*(repr(x) for corner in triangle for x in corner))
print(len(points))
for point in points:
    print(*(repr(x) for x in point))
print(len(curves))
for is_closed, places in curves:
    print(int(is_closed), len(places), *(repr(x) for place in places for x in place))
