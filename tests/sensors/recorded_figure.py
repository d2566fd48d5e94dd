#!/usr/bin/env python3
"""A skinned figure and a recorded walk for `seamline animate`, and a check of what it made, by NumPy alone.

    recorded_figure.py write FOLDER           figure.glb, walk.csv (joints of planted angles), planted.npz
    recorded_figure.py check FOLDER MOVED.glb  prints how far joints and skin are from the planted ones
"""
import json
import struct
import sys

import numpy as np

BONES = [  # name, parent, offset from it (m), radius of its limb
    ("pelvis", None, (0, 0.95, 0)), ("chest", "pelvis", (0, 0.35, 0)), ("head", "chest", (0, 0.35, 0)),
    ("left_shoulder", "chest", (0.19, 0.13, 0)), ("left_elbow", "left_shoulder", (0.28, 0, 0)),
    ("left_hand", "left_elbow", (0.26, 0, 0)), ("right_shoulder", "chest", (-0.19, 0.13, 0)),
    ("right_elbow", "right_shoulder", (-0.28, 0, 0)), ("right_hand", "right_elbow", (-0.26, 0, 0)),
    ("left_hip", "pelvis", (0.1, -0.05, 0)), ("left_knee", "left_hip", (0, -0.43, 0)),
    ("left_foot", "left_knee", (0, -0.42, 0)), ("right_hip", "pelvis", (-0.1, -0.05, 0)),
    ("right_knee", "right_hip", (0, -0.43, 0)), ("right_foot", "right_knee", (0, -0.42, 0))]
NAMES = [b[0] for b in BONES]
PARENTS = [-1 if b[1] is None else NAMES.index(b[1]) for b in BONES]
OFFSETS = np.array([b[2] for b in BONES], float)
REST = np.zeros_like(OFFSETS)
for i, p in enumerate(PARENTS):
    REST[i] = OFFSETS[i] + (REST[p] if p >= 0 else 0)
# How each node's own axes lie at rest: turned, so that a reader who forgets them is found out.
AXES = [np.array(q) / np.linalg.norm(q) for q in np.random.default_rng(7).normal(size=(len(BONES), 4))]


def matrix(q):
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def quaternion(m):
    values, vectors = np.linalg.eigh(np.array(
        [[m[0, 0] - m[1, 1] - m[2, 2], 0, 0, 0], [m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], 0, 0],
         [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1], 0],
         [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]]]) / 3)
    return vectors[:, np.argmax(values)]


def about(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def planted(t):
    """Turns of the joints and the place of the pelvis, 2 s of greeting while walking on the spot."""
    step = np.sin(2 * np.pi * t)
    turns = {n: np.eye(3) for n in NAMES}
    turns["pelvis"] = about((0, 1, 0), 0.5 + 0.2 * np.sin(np.pi * t)) @ about((1, 0, 0), 0.05 * step)
    turns["chest"] = about((0, 0, 1), 0.1 * step)
    turns["left_shoulder"] = about((0, 0, 1), -1.3 + 2.2 * np.clip(t, 0, 1))
    turns["left_elbow"] = about((0, 0, 1), 0.3 + 0.5 * np.sin(6 * t))
    turns["right_shoulder"] = about((0, 0, 1), 1.3) @ about((1, 0, 0), 0.2 * step)
    turns["right_elbow"] = about((0, 1, 0), 0.4)
    for side, sign in (("left", 1), ("right", -1)):
        turns[side + "_hip"] = about((1, 0, 0), -0.45 * sign * step)
        turns[side + "_knee"] = about((1, 0, 0), 0.35 * (1 - sign * step))
    return turns, np.array([0.0, 0.95 + 0.02 * step, 0.1 * t])


def place(turns, root):
    at, turned = np.zeros_like(REST), [None] * len(NAMES)
    for i, p in enumerate(PARENTS):
        before = np.eye(3) if p < 0 else turned[p]
        at[i] = root if p < 0 else at[p] + before @ OFFSETS[i]
        turned[i] = before @ turns[NAMES[i]]
    return at, turned


def figure_mesh():
    """A ring of eight points at both ends and the middle of each bone; the middle hangs on both joints."""
    points, held, weights, faces = [], [], [], []
    for i, p in enumerate(PARENTS):
        if p < 0 or NAMES[i] in ("left_shoulder", "right_shoulder", "left_hip", "right_hip"):
            ends = None if p < 0 else (REST[p], REST[i], p, p)
        else:
            above = PARENTS[p] if PARENTS[p] >= 0 else p
            ends = (REST[p], REST[i], p, above)
        if ends is None:
            continue
        a, b, own, above = ends
        along = (b - a) / np.linalg.norm(b - a)
        side = np.cross(along, (0.3, 0.2, 1.0))
        side /= np.linalg.norm(side)
        up = np.cross(along, side)
        radius = 0.11 if NAMES[i] in ("chest", "head") else 0.055
        first = len(points)
        for share, half in ((-0.06, 0.5), (0.12, 1.0), (0.88, 1.0), (1.06, 1.0)):
            size = radius * (0.75 if share in (-0.06, 1.06) else 1)
            for k in range(8):
                turn = 2 * np.pi * k / 8
                points.append(a + share * (b - a) + size * (np.cos(turn) * side + np.sin(turn) * up))
                held.append((own, above, 0, 0))
                weights.append((half, 1 - half, 0, 0))
        for ring in range(3):
            for k in range(8):
                q = first + 8 * ring + k
                r = first + 8 * ring + (k + 1) % 8
                faces += [(q, r, q + 8), (r, r + 8, q + 8)]
        for ring, order in ((0, (0, 2, 1)), (3, (0, 1, 2))):
            for k in range(1, 7):
                tri = [first + 8 * ring + j for j in (0, k, k + 1)]
                faces.append(tuple(tri[o] for o in order))
    return np.array(points), np.array(held), np.array(weights), np.array(faces)


def write(folder):
    points, held, weights, faces = figure_mesh()
    blob, views, accessors = b"", [], []

    def add(array, kind, component):
        nonlocal blob
        data = array.tobytes()
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind})
        if kind == "VEC3":
            accessors[-1].update(min=array.min(0).tolist(), max=array.max(0).tolist())
        blob += data + b"\0" * (-len(data) % 4)
        return len(accessors) - 1

    inverse = []
    nodes = [{"name": "body", "mesh": 0, "skin": 0}]
    for i, p in enumerate(PARENTS):
        own = AXES[i] if p < 0 else quaternion(matrix(AXES[p]).T @ matrix(AXES[i]))
        at = REST[i] if p < 0 else matrix(AXES[p]).T @ OFFSETS[i]
        nodes.append({"name": NAMES[i], "rotation": own.tolist(), "translation": at.tolist(),
                      "children": [k + 1 for k, q in enumerate(PARENTS) if q == i]})
        if not nodes[-1]["children"]:
            del nodes[-1]["children"]
        bind = np.eye(4)
        bind[:3, :3], bind[:3, 3] = matrix(AXES[i]).T, -matrix(AXES[i]).T @ REST[i]
        inverse.append(bind.T.reshape(16))
    attributes = {"POSITION": add(points.astype("<f4"), "VEC3", 5126),
                  "JOINTS_0": add(held.astype("<u2"), "VEC4", 5123), "WEIGHTS_0": add(weights.astype("<f4"), "VEC4", 5126)}
    indices = add(faces.astype("<u4").reshape(-1), "SCALAR", 5125)
    binds = add(np.array(inverse).astype("<f4"), "MAT4", 5126)
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}], "nodes": nodes,
                "meshes": [{"primitives": [{"attributes": attributes, "indices": indices}]}],
                "skins": [{"joints": list(range(1, len(NAMES) + 1)), "inverseBindMatrices": binds}],
                "buffers": [{"byteLength": len(blob)}], "bufferViews": views, "accessors": accessors}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(folder + "/figure.glb", "wb") as out:
        out.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob)))
        out.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob)
    with open(folder + "/walk.csv", "w") as out:
        out.write("time_s,joint,x_m,y_m,z_m\n")
        for frame in range(48):
            at, _ = place(*planted(frame / 24))
            for name, (x, y, z) in zip(NAMES, at):
                out.write(f"{frame / 24!r},{name},{x!r},{y!r},{z!r}\n")


def read_glb(path):
    data = open(path, "rb").read()
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


def numbers(document, blob, index):
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    parts = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
    kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[accessor["componentType"]]
    return np.frombuffer(blob, kind, accessor["count"] * parts, view["byteOffset"]).reshape(-1, parts).astype(float)


def check(moved):
    document, blob = read_glb(moved)
    animation = document["animations"][-1]
    primitive = document["meshes"][0]["primitives"][0]["attributes"]
    points = numbers(document, blob, primitive["POSITION"])
    held = numbers(document, blob, primitive["JOINTS_0"]).astype(int)
    weights = numbers(document, blob, primitive["WEIGHTS_0"])
    binds = numbers(document, blob, document["skins"][0]["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
    parents = {c: n for n, node in enumerate(document["nodes"]) for c in node.get("children", [])}
    keys = {}
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        keys[channel["target"]["node"], channel["target"]["path"]] = numbers(document, blob, sampler["output"])
        times = numbers(document, blob, sampler["input"])[:, 0]
    worst_joint = worst_skin = 0
    for t, time in enumerate(times):
        world = {}
        for node in range(1, len(NAMES) + 1):  # parents stand before their children
            rest = document["nodes"][node]
            own = np.eye(4)
            own[:3, :3] = matrix(keys[node, "rotation"][t] if (node, "rotation") in keys else rest["rotation"])
            own[:3, 3] = keys[node, "translation"][t] if (node, "translation") in keys else rest["translation"]
            world[node] = world[parents[node]] @ own if node in parents else own
        at, turned = place(*planted(time))
        found = np.array([world[n + 1][:3, 3] for n in range(len(NAMES))])
        worst_joint = max(worst_joint, np.abs(found - at).max())
        # The axes of limbs: where the skin's rings have their middles, whatever a limb turns about itself.
        joints = [world[j + 1] @ binds[j] for j in range(len(NAMES))]
        truth = [np.block([[turned[j], (at[j] - turned[j] @ REST[j])[:, None]], [np.zeros(3), 1]]) for j in range(len(NAMES))]
        homogeneous = np.c_[points, np.ones(len(points))]
        skins = [sum(weights[:, k, None] * np.einsum("vij,vj->vi", np.array(m)[held[:, k]], homogeneous)
                     for k in range(2))[:, :3].reshape(-1, 8, 3).mean(1) for m in (joints, truth)]
        worst_skin = max(worst_skin, np.abs(skins[0] - skins[1]).max())
    print(f"moments {len(times)}, joints off by at most {1000 * worst_joint:.3f} mm, middles of the skin's rings by "
          f"{1000 * worst_skin:.3f} mm")
    return worst_joint < 0.002 and worst_skin < 0.01


if __name__ == "__main__":
    if sys.argv[1] == "write":
        write(sys.argv[2])
    else:
        sys.exit(0 if check(sys.argv[3] if len(sys.argv) > 3 else sys.argv[2]) else 1)
