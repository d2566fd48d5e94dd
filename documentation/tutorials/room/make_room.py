#!/usr/bin/env python3
"""Writes room.gltf: a small room as any modelling program would export it. Plain Python, nothing of Seamline.

    python3 make_room.py > room.gltf

Metres, +Y up, the camera looks along -Z; one colour a mesh, one camera, one directional light.
"""
import base64
import json
import math
import struct
import sys

meshes = {}  # material name -> list of (positions, normals, triangles)


def add(material, positions, normals, triangles):
    meshes.setdefault(material, []).append((positions, normals, triangles))


def box(material, low, high):
    positions, normals, triangles = [], [], []
    for axis in range(3):
        for side in (0, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            first = len(positions)
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis] = (low, high)[side][axis]
                corner[u] = (low, high)[a][u]
                corner[v] = (low, high)[b][v]
                normal = [0.0, 0.0, 0.0]
                normal[axis] = 2.0 * side - 1.0
                positions.append(corner)
                normals.append(normal)
            order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
            triangles += [first + i for i in order]
    add(material, positions, normals, triangles)


def grid(material, rows, columns, point):
    """A closed surface of revolution or the like: point(row, column) gives a position and a normal."""
    positions, normals, triangles = [], [], []
    for row in range(rows + 1):
        for column in range(columns + 1):
            position, normal = point(row / rows, column / columns)
            length = math.sqrt(sum(n * n for n in normal)) or 1.0
            positions.append(position)
            normals.append([n / length for n in normal])
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            if row > 0:
                triangles += [a, b, a + 1]
            if row < rows - 1:
                triangles += [a + 1, b, b + 1]
    add(material, positions, normals, triangles)


def pillow(material, low, high, roundness=0.3):
    """A box with soft edges: a superellipsoid."""
    centre = [(l + h) / 2 for l, h in zip(low, high)]
    half = [(h - l) / 2 for l, h in zip(low, high)]

    def power(value, exponent):
        return math.copysign(abs(value) ** exponent, value)

    def point(row, column):
        up, around = math.pi * (0.5 - row), 2 * math.pi * column
        unit = [math.cos(up), math.sin(up), math.cos(up)]
        turn = [math.cos(around), 1.0, -math.sin(around)]
        if row in (0.0, 1.0):
            unit[0] = unit[2] = 0.0
        position = [c + h * power(u, roundness) * power(t, roundness) for c, h, u, t in zip(centre, half, unit, turn)]
        normal = [power(u, 2 - roundness) * power(t, 2 - roundness) / h for h, u, t in zip(half, unit, turn)]
        return position, normal

    grid(material, 16, 32, point)


def lathe(material, centre, profile, columns=32):
    """Turned on a lathe: profile holds (radius, height) from top to bottom; each piece has its own flat normals."""
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        positions, normals, triangles = [], [], []
        for column in range(columns + 1):
            angle = 2 * math.pi * column / columns
            c, s = math.cos(angle), -math.sin(angle)
            length = math.hypot(r1 - r0, y0 - y1) or 1.0
            normal = [(y0 - y1) / length * c, (r1 - r0) / length, (y0 - y1) / length * s]
            for r, y in ((r0, y0), (r1, y1)):
                positions.append([centre[0] + r * c, centre[1] + y, centre[2] + r * s])
                normals.append(normal)
        for column in range(columns):
            a = 2 * column
            if r0 > 0:
                triangles += [a, a + 1, a + 2]
            if r1 > 0:
                triangles += [a + 2, a + 1, a + 3]
        add(material, positions, normals, triangles)


# The shell: a floor, a back wall with a window, a wall on the left; open to the sky, as a stage is.
box("floor", (-4.2, -0.1, -7.0), (4.6, 0.0, 2.5))
box("wall", (-4.2, 0.0, -7.0), (0.9, 3.0, -6.8))
box("wall", (2.9, 0.0, -7.0), (4.6, 3.0, -6.8))
box("wall", (0.9, 0.0, -7.0), (2.9, 1.0, -6.8))
box("wall", (0.9, 2.5, -7.0), (2.9, 3.0, -6.8))
box("wall", (-4.4, 0.0, -7.0), (-4.2, 3.0, 2.5))
for low, high in (((0.82, 0.94, -6.84), (2.98, 1.02, -6.70)), ((0.82, 2.48, -6.84), (2.98, 2.56, -6.74)),
                  ((0.82, 1.02, -6.84), (0.92, 2.48, -6.74)), ((2.88, 1.02, -6.84), (2.98, 2.48, -6.74)),
                  ((1.86, 1.02, -6.82), (1.94, 2.48, -6.76)), ((0.92, 1.74, -6.82), (2.88, 1.80, -6.76)),
                  ((-4.2, 0.0, -6.8), (4.6, 0.12, -6.77)), ((-4.2, 0.0, -6.77), (-4.17, 0.12, 2.5))):
    box("white", low, high)
box("rug", (-2.3, 0.0, -5.35), (2.3, 0.015, -3.2))
box("rug_border", (-2.42, 0.0, -5.47), (2.42, 0.010, -3.08))

# A sofa under the wall, on which shadows climb.
pillow("sofa", (-2.75, 0.10, -6.55), (0.35, 0.44, -5.62), 0.22)
pillow("sofa", (-2.75, 0.20, -6.72), (0.35, 0.98, -6.38), 0.25)
pillow("sofa", (-3.00, 0.06, -6.70), (-2.66, 0.66, -5.60), 0.25)
pillow("sofa", (0.26, 0.06, -6.70), (0.60, 0.66, -5.60), 0.25)
for x in (-2.62, -1.18):
    pillow("seat", (x, 0.38, -6.42), (x + 1.40, 0.56, -5.60), 0.3)
pillow("cushion", (-2.50, 0.54, -6.44), (-1.96, 1.00, -6.22), 0.45)
pillow("cushion_2", (-0.42, 0.54, -6.44), (0.12, 1.00, -6.22), 0.45)

# A round table, behind it a cushion on the rug: what stands on the table throws its shadow over both.
lathe("wood", (0.1, 0.0, -4.5), ((0.0, 0.355), (0.34, 0.355), (0.36, 0.335), (0.34, 0.315), (0.07, 0.30), (0.06, 0.05), (0.28, 0.03), (0.30, 0.015)))
pillow("cushion", (-0.62, 0.015, -5.50), (-0.12, 0.20, -5.06), 0.45)

# A shelf with books beside the window.
for low, high in (((3.0, 0.0, -6.78), (3.05, 2.1, -6.38)), ((4.25, 0.0, -6.78), (4.3, 2.1, -6.38)),
                  ((3.05, 0.05, -6.78), (4.25, 0.09, -6.38)), ((3.05, 0.70, -6.78), (4.25, 0.74, -6.38)),
                  ((3.05, 1.38, -6.78), (4.25, 1.42, -6.38)), ((3.05, 2.06, -6.78), (4.25, 2.1, -6.38)),
                  ((3.05, 0.09, -6.78), (4.25, 2.06, -6.76))):
    box("wood", low, high)
colours = ("book_red", "book_blue", "book_green", "cream")
for board, height in enumerate((0.09, 0.74, 1.42)):
    x, number = 3.07, board
    while x < (4.15, 3.80, 4.05)[board]:
        thickness, tall = 0.035 + 0.008 * (number * 5 % 4), 0.30 + 0.03 * (number * 7 % 5)
        box(colours[number * 3 % 7 % 4], (x, height, -6.74), (x + thickness, height + tall, -6.52 + 0.01 * (number % 3)))
        x, number = x + thickness + 0.004, number + 1

# A low bench with a step on the right, a floor lamp in the corner, a plant, two pictures.
box("wood", (1.0, 0.34, -6.20), (2.75, 0.40, -5.72))
for x in (1.06, 2.61):
    box("wood", (x, 0.0, -6.16), (x + 0.08, 0.34, -5.76))
lathe("cream", (1.35, 0.40, -5.96), ((0.0, 0.36), (0.05, 0.36), (0.055, 0.30), (0.04, 0.26), (0.11, 0.16), (0.10, 0.05), (0.06, 0.0)))
box("book_blue", (1.95, 0.40, -6.10), (2.35, 0.45, -5.82))
box("book_red", (1.99, 0.45, -6.08), (2.33, 0.49, -5.84))
lathe("dark", (-3.45, 0.0, -6.25), ((0.0, 1.52), (0.02, 1.52), (0.02, 0.04), (0.18, 0.04), (0.18, 0.0)))
lathe("cream", (-3.45, 0.0, -6.25), ((0.0, 1.92), (0.15, 1.92), (0.28, 1.50), (0.0, 1.50)))
lathe("pot", (-3.45, 0.0, -4.55), ((0.0, 0.40), (0.24, 0.40), (0.26, 0.42), (0.26, 0.36), (0.18, 0.0)))
for leaf in range(14):
    angle, lean = leaf * 2.399963, 0.25 + 0.40 * (leaf * 5 % 7) / 7
    reach, top = 0.55 * math.sin(lean), 0.55 + 0.60 * math.cos(lean)

    def blade(row, column, angle=angle, reach=reach, top=top):
        along, across = row, 0.075 * math.sin(math.pi * min(1.0, 0.08 + 0.92 * row)) * math.cos(2 * math.pi * column)
        thick = 0.006 * math.sin(2 * math.pi * column) * math.sin(math.pi * row)
        out = reach * along ** 1.6
        up = 0.38 + (top - 0.38) * math.sin(0.5 * math.pi * along)
        c, s = math.cos(angle), math.sin(angle)
        return ([-3.45 + out * c - across * s, up + thick, -4.55 + out * s + across * c],
                [-0.6 * c, 1.0 if math.sin(2 * math.pi * column) >= 0 else -1.0, -0.6 * s])

    grid("leaf", 8, 6, blade)
for x, y, width, height, colour in ((-2.25, 1.45, 0.9, 1.1, "book_green"), (-0.85, 1.60, 0.7, 0.8, "rug_border")):
    box("dark", (x, y, -6.80), (x + width, y + height, -6.76))
    box("white", (x + 0.04, y + 0.04, -6.76), (x + width - 0.04, y + height - 0.04, -6.755))
    box(colour, (x + 0.16, y + 0.18, -6.755), (x + width - 0.16, y + height - 0.18, -6.75))

palette = {
    "floor": (0.42, 0.27, 0.16), "wall": (0.72, 0.66, 0.56), "white": (0.82, 0.81, 0.78), "rug": (0.62, 0.55, 0.44),
    "rug_border": (0.30, 0.13, 0.10), "sofa": (0.16, 0.26, 0.33), "seat": (0.20, 0.32, 0.40), "cushion": (0.70, 0.42, 0.12),
    "cushion_2": (0.62, 0.58, 0.50), "wood": (0.33, 0.19, 0.10), "dark": (0.06, 0.055, 0.05), "cream": (0.76, 0.70, 0.58),
    "book_red": (0.45, 0.10, 0.08), "book_blue": (0.10, 0.18, 0.36), "book_green": (0.14, 0.27, 0.15),
    "pot": (0.55, 0.27, 0.16), "leaf": (0.12, 0.28, 0.08)}

buffer, views, accessors, gltf_meshes, nodes = bytearray(), [], [], [], []


def accessor(data, kind, component, code, count, **extent):
    views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
    buffer.extend(data + b"\0" * (-len(data) % 4))
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": count, **extent})
    return len(accessors) - 1


for number, name in enumerate(palette):
    positions, normals, triangles = [], [], []
    for part in meshes[name]:
        triangles += [len(positions) + i for i in part[2]]
        positions += part[0]
        normals += part[1]
    positions = [[struct.unpack("<f", struct.pack("<f", x))[0] for x in p] for p in positions]
    gltf_meshes.append({"name": name, "primitives": [{
        "attributes": {
            "POSITION": accessor(b"".join(struct.pack("<3f", *p) for p in positions), "VEC3", 5126, "f", len(positions),
                                 min=[min(p[i] for p in positions) for i in range(3)],
                                 max=[max(p[i] for p in positions) for i in range(3)]),
            "NORMAL": accessor(b"".join(struct.pack("<3f", *n) for n in normals), "VEC3", 5126, "f", len(normals))},
        "indices": accessor(struct.pack(f"<{len(triangles)}H", *triangles), "SCALAR", 5123, "H", len(triangles)),
        "material": number}]})
    nodes.append({"name": name, "mesh": number})


def turned(pitch_deg, yaw_deg):
    """Quaternion x y z w: yaw about Y after pitch about X. A camera and a light look along -Z."""
    p, y = math.radians(pitch_deg) / 2, math.radians(yaw_deg) / 2
    return [math.sin(p) * math.cos(y), math.cos(p) * math.sin(y), -math.sin(p) * math.sin(y), math.cos(p) * math.cos(y)]


nodes.append({"name": "camera", "camera": 0, "translation": [0.15, 1.6, 1.1], "rotation": turned(-6, 0)})
nodes.append({"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": turned(-33, 38)})
json.dump({
    "asset": {"version": "2.0", "generator": "make_room.py"},
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"name": "sun", "type": "directional", "color": [1.0, 0.93, 0.82], "intensity": 1500.0}]}},
    "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.62, "aspectRatio": 16 / 9, "znear": 0.05}}],
    "materials": [{"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*colour, 1.0], "metallicFactor": 0.0}}
                  for name, colour in palette.items()],
    "meshes": gltf_meshes, "accessors": accessors, "bufferViews": views,
    "buffers": [{"byteLength": len(buffer),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(bytes(buffer)).decode()}]},
    sys.stdout, indent=1)
print()
