#!/usr/bin/env python3
# Writes a glTF file whose animation moves six nodes in all ways that glTF has: animations.py SEED FILE
# (animations.gltf: seed 5). What it comes to is said by three.js: animations.mjs.
import base64
import json
import sys

import numpy as np

random = np.random.default_rng(int(sys.argv[1]))
buffer, views, accessors = b"", [], []


def add(values, kind, component=5126, normalised=False):
    global buffer
    data = values.tobytes()
    views.append({"buffer": 0, "byteOffset": len(buffer), "byteLength": len(data)})
    buffer += data + b"\0" * (-len(data) % 4)
    accessor = {"bufferView": len(views) - 1, "componentType": component, "type": kind, "count": len(values)}
    if normalised:
        accessor["normalized"] = True
    if kind == "SCALAR" and component == 5126:
        accessor.update(min=[float(values.min())], max=[float(values.max())])
    if kind == "VEC3":
        accessor.update(min=values.min(0).tolist(), max=values.max(0).tolist())
    accessors.append(accessor)
    return len(accessors) - 1


def turns(count):
    values = random.normal(size=(count, 4))
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


vertices = 9
position = add(random.normal(size=(vertices, 3)).astype(np.float32), "VEC3")
index = add(np.arange(vertices, dtype=np.uint32), "SCALAR", 5125)
targets = [add(random.normal(size=(vertices, 3)).astype(np.float32), "VEC3") for _ in range(2)]
nodes = []
for i in range(6):
    scale = random.uniform(0.5, 1.5, 3).tolist() if i == 5 else [1, 1, 1]
    nodes.append({"name": f"n{i}", "translation": random.normal(size=3).tolist(), "rotation": turns(1)[0].tolist(), "scale": scale})
    if i in (2, 5):  # below neither of them is the other: three.js gives morph weights to all nodes below
        nodes[i]["mesh"] = 0
for parent, children in ((0, [1, 2]), (1, [3]), (3, [4]), (4, [5])):
    nodes[parent]["children"] = children
channels, samplers = [], []
for i in range(6):
    for path in ("translation", "rotation", "scale") + (("weights",) if "mesh" in nodes[i] else ()):
        by = str(random.choice(["LINEAR", "STEP", "CUBICSPLINE"]))
        spline = by == "CUBICSPLINE"
        keys = int(random.integers(2 if spline else 1, 6))
        times = np.cumsum(random.uniform(0.1, 0.8, keys)).astype(np.float32)
        count = keys * (3 if spline else 1)
        if path == "rotation":
            values = turns(count)
            if spline:
                values[0::3] *= 0.5
                values[2::3] *= 0.5
            if spline or random.random() < 0.5:
                output = add(values.astype(np.float32), "VEC4")
            else:
                output = add(np.round(values * 32767).astype(np.int16), "VEC4", 5122, True)
        elif path == "weights":
            output = add(random.uniform(0, 1, 2 * count).astype(np.float32), "SCALAR")
        else:
            output = add((random.normal(size=(count, 3)) * 0.3 + (path == "scale")).astype(np.float32), "VEC3")
        samplers.append({"input": add(times, "SCALAR"), "output": output, "interpolation": by})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": i, "path": path}})
file = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes, "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(buffer), "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": position}, "indices": index, "targets": [{"POSITION": t} for t in targets]}], "weights": [0.1, 0.2]}],
    "animations": [{"name": "All", "channels": channels, "samplers": samplers}],
}
with open(sys.argv[2], "w") as out:
    json.dump(file, out)
