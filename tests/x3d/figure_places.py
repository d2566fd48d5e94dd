#!/usr/bin/env python3
"""Where the joints and the skin of a figure are in the page's frame at some moments, by NumPy alone.

    figure_places.py MOVED.glb PLACED.json OUT.json

PLACED: at, look_at, position, rotation_deg (pitch, yaw, roll), scale, times_s: what `seamline export x3d` was asked for. MOVED.glb is of
`tests/sensors/recorded_figure.py` and `seamline animate`. OUT: for each time the joints' places by their names, and the corners of the triangles.
"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "sensors"))
from recorded_figure import matrix, numbers, read_glb  # noqa: E402


def between(times, values, time, turns):
    after = int(np.clip(np.searchsorted(times, time, "right"), 1, len(times) - 1))
    share = np.clip((time - times[after - 1]) / (times[after] - times[after - 1]), 0, 1)
    a, b = values[after - 1], values[after]
    if not turns:
        return a + share * (b - a)
    b = b if a @ b >= 0 else -b
    angle = np.arccos(min(1.0, a @ b / np.linalg.norm(a) / np.linalg.norm(b)))
    if angle < 1e-9:
        return a
    return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


def turned(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {"x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]), "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])}[axis]


def main():
    document, blob = read_glb(sys.argv[1])
    placed = json.load(open(sys.argv[2]))
    nodes, animation = document["nodes"], document["animations"][0]
    keys = {}
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        keys[channel["target"]["node"], channel["target"]["path"]] = (numbers(document, blob, sampler["input"])[:, 0], numbers(document, blob, sampler["output"]))
    parents = {c: n for n, node in enumerate(nodes) for c in node.get("children", [])}
    skin, primitive = document["skins"][0], document["meshes"][0]["primitives"][0]
    points = numbers(document, blob, primitive["attributes"]["POSITION"])
    held = numbers(document, blob, primitive["attributes"]["JOINTS_0"]).astype(int)
    weights = numbers(document, blob, primitive["attributes"]["WEIGHTS_0"])
    corners = numbers(document, blob, primitive["indices"])[:, 0].astype(int)
    binds = numbers(document, blob, skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1)
    back = np.array(placed["at"], float) - placed["look_at"]
    back /= np.linalg.norm(back)
    right = np.cross([0, 1, 0], back)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(back, right), back])
    pitch, yaw, roll = placed["rotation_deg"]
    turn = placed["scale"] * turned("y", yaw) @ turned("x", pitch) @ turned("z", roll)

    def in_page(places):
        return (places @ turn.T + placed["position"] - placed["at"]) @ axes.T

    out = []
    for time in placed["times_s"]:
        def own(n):
            node, m = nodes[n], np.eye(4)
            rotation, translation = (between(*keys[n, p], time, p == "rotation") if (n, p) in keys else np.array(node.get(p, d), float)
                                     for p, d in (("rotation", (0, 0, 0, 1)), ("translation", (0, 0, 0))))
            m[:3, :3], m[:3, 3] = matrix(rotation / np.linalg.norm(rotation)), translation
            return m

        def world(n):
            return world(parents[n]) @ own(n) if n in parents else own(n)

        worlds = [world(n) for n in skin["joints"]]
        joints = np.array([w @ b for w, b in zip(worlds, binds)])
        moved = sum(weights[:, k, None] * np.einsum("vij,vj->vi", joints[held[:, k]], np.c_[points, np.ones(len(points))]) for k in range(4))[:, :3]
        places = in_page(np.array([w[:3, 3] for w in worlds]))
        out.append({"time_s": time, "joints": {nodes[n]["name"]: p.tolist() for n, p in zip(skin["joints"], places)}, "corners": in_page(moved)[corners].round(6).tolist()})
    times = keys[next(iter(keys))][0]
    json.dump({"first_s": times[0], "last_s": times[-1], "moments": out}, open(sys.argv[3], "w"))


if __name__ == "__main__":
    main()
