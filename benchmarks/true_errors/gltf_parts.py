"""Small scenes as glTF files, pictures as PNG, HDR and PGM: nothing but Python's own library."""
import base64
import json
import math
import os
import struct
import zlib


def quad(a, b, c, d):
    """Positions, normal by the right hand, texture coordinates: corners counter-clockwise."""
    u, v = [b[i] - a[i] for i in range(3)], [d[i] - a[i] for i in range(3)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    length = math.sqrt(sum(x * x for x in n))
    return {"positions": [a, b, c, d], "normals": [[x / length for x in n]] * 4, "texcoords": [[0, 1], [1, 1], [1, 0], [0, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]}


def joined(shapes):
    out = {"positions": [], "normals": [], "texcoords": [], "triangles": []}
    for shape in shapes:
        first = len(out["positions"])
        for key in ("positions", "normals", "texcoords"):
            out[key] += shape[key]
        out["triangles"] += [[first + i for i in t] for t in shape["triangles"]]
    return out


def box(low, high):
    (x, y, z), (X, Y, Z) = low, high
    return joined([quad([x, y, Z], [X, y, Z], [X, Y, Z], [x, Y, Z]), quad([X, y, z], [x, y, z], [x, Y, z], [X, Y, z]),
                   quad([x, y, z], [x, y, Z], [x, Y, Z], [x, Y, z]), quad([X, y, Z], [X, y, z], [X, Y, z], [X, Y, Z]),
                   quad([x, Y, Z], [X, Y, Z], [X, Y, z], [x, Y, z]), quad([x, y, z], [X, y, z], [X, y, Z], [x, y, Z])])


def turned(ring, rows, columns, outside):
    """A surface of rows and columns: `ring(i, j)` is a place, `outside(i, j)` its normal."""
    out = {"positions": [], "normals": [], "texcoords": [], "triangles": []}
    for i in range(rows + 1):
        for j in range(columns + 1):
            out["positions"].append(ring(i / rows, j / columns))
            out["normals"].append(outside(i / rows, j / columns))
            out["texcoords"].append([j / columns, i / rows])
    for i in range(rows):
        for j in range(columns):
            a = i * (columns + 1) + j
            b = a + columns + 1
            out["triangles"] += [[a, b, a + 1], [a + 1, b, b + 1]]
    return out


def ball(radius, centre=(0, 0, 0), rows=16, columns=32):
    def direction(i, j):
        up, around = math.pi * i, 2 * math.pi * j
        return [math.sin(up) * math.sin(around), math.cos(up), math.sin(up) * math.cos(around)]
    return turned(lambda i, j: [centre[k] + radius * direction(i, j)[k] for k in range(3)], rows, columns, direction)


def ring_band(radius, height):
    """An upright band: the inside of a ring focuses light onto what it stands on."""
    def direction(j, sign):
        return [sign * math.sin(2 * math.pi * j), 0, sign * math.cos(2 * math.pi * j)]
    def at(i, j, r):
        d = direction(j, 1)
        return [r * d[0], height * i, r * d[2]]
    return joined([turned(lambda i, j: at(1 - i, j, radius), 1, 48, lambda i, j: direction(j, 1)),
                   turned(lambda i, j: at(i, j, 0.97 * radius), 1, 48, lambda i, j: direction(j, -1))])


def png(width, height, rgba):
    """`rgba(x, y)`: four bytes."""
    raw = b"".join(b"\0" + bytes(v for x in range(width) for v in rgba(x, y)) for y in range(height))
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b"")


def read_png(path):
    """Width, height and RGB codes of a picture of 8 bits a channel."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        (length,), kind = struct.unpack(">I", data[at:at + 4]), data[at + 4:at + 8]
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    assert depth == 8
    raw, stride = zlib.decompress(packed), width * channels
    rows, before = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = (line[i - channels] if i >= channels else 0), before[i], (before[i - channels] if i >= channels else 0)
            if kind == 1:
                line[i] = (line[i] + a) & 255
            elif kind == 2:
                line[i] = (line[i] + b) & 255
            elif kind == 3:
                line[i] = (line[i] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                line[i] = (line[i] + (a if abs(p - a) <= abs(p - b) and abs(p - a) <= abs(p - c) else b if abs(p - b) <= abs(p - c) else c)) & 255
        rows.append(line)
        before = line
    codes = [rows[y][x * channels + min(c, channels - 1)] for y in range(height) for x in range(width) for c in range(3)]
    return width, height, codes


def hdr(path, width, height, radiance):
    """`radiance(x, y)`: three numbers."""
    with open(path, "wb") as file:
        file.write(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode())
        for y in range(height):
            for x in range(width):
                rgb = radiance(x, y)
                most = max(rgb)
                if most < 1e-32:
                    file.write(bytes(4))
                    continue
                mantissa, exponent = math.frexp(most)
                file.write(bytes([int(v * mantissa * 256 / most) for v in rgb] + [exponent + 128]))


def write_gltf(path, parts, camera=None, lights=()):
    """Parts are (shape, material); `camera`: its place and vertical field of view; `lights`: of KHR_lights_punctual with a translation."""
    buffer, views, accessors, meshes, nodes, materials, images = bytearray(), [], [], [], [], [], []
    def add(values, form, component, kind):
        flat = [v for value in values for v in value]
        views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": 4 * len(flat)})
        buffer.extend(struct.pack(f"<{len(flat)}{form}", *flat))
        count = len(flat) if kind == "SCALAR" else len(values)
        accessor = {"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind}
        if kind == "VEC3" and component == 5126:
            accessor |= {"min": [min(v[k] for v in values) for k in range(3)], "max": [max(v[k] for v in values) for k in range(3)]}
        accessors.append(accessor)
        return len(accessors) - 1
    def texture(data):
        images.append({"uri": "data:image/png;base64," + base64.b64encode(data).decode()})
        return {"index": len(images) - 1}
    for shape, look in parts:
        material = {"pbrMetallicRoughness": {"baseColorFactor": list(look.get("colour", (0.7, 0.68, 0.62))) + [1], "metallicFactor": look.get("metallic", 0), "roughnessFactor": look.get("roughness", 1)}, "doubleSided": True}
        if "picture" in look:
            material["pbrMetallicRoughness"]["baseColorTexture"] = texture(look["picture"])
        if "emits" in look:
            most = max(look["emits"])
            material["emissiveFactor"] = [v / most for v in look["emits"]]
            material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": most}}
        if "emits_picture" in look:
            material["emissiveTexture"] = texture(look["emits_picture"])
        if "alpha" in look:
            material |= {"alphaMode": look["alpha"], "alphaCutoff": 0.5}
        materials.append(material)
        attributes = {"POSITION": add(shape["positions"], "f", 5126, "VEC3"), "NORMAL": add(shape["normals"], "f", 5126, "VEC3"), "TEXCOORD_0": add(shape["texcoords"], "f", 5126, "VEC2")}
        meshes.append({"primitives": [{"attributes": attributes, "indices": add(shape["triangles"], "I", 5125, "SCALAR"), "material": len(materials) - 1}]})
        nodes.append({"mesh": len(meshes) - 1})
    scene = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_materials_emissive_strength"]}
    if camera:
        place, fov = camera
        scene["cameras"] = [{"type": "perspective", "perspective": {"yfov": fov, "znear": 0.01}}]
        nodes.append({"camera": 0, "translation": list(place)})
    if images:
        scene |= {"images": images, "samplers": [{"magFilter": 9728, "minFilter": 9728}], "textures": [{"source": i, "sampler": 0} for i in range(len(images))]}
    scene |= {"scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes, "materials": materials, "accessors": accessors, "bufferViews": views,
              "buffers": [{"byteLength": len(buffer), "uri": "data:application/octet-stream;base64," + base64.b64encode(bytes(buffer)).decode()}]}
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as file:
        json.dump(scene, file)
