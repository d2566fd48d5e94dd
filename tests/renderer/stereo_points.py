#!/usr/bin/env python3
"""Whether panoramas of two eyes show points where these must see them: stereo_points.py PROGRAM WORK

Makes a room with small glowing balls at known places, renders its study with PROGRAM by both estimators, finds each ball in the
left and the right eye's truth, and compares with the places that plane geometry gives (written without a look at the program):
an eye that stands e to the right of its azimuth a sees a point of azimuth A, distance d and height h at
a = A - asin(e / d) and the elevation atan(h / sqrt(d^2 - e^2)). Then the same for parallax by the depth mesh, fine and coarse, beside a
sheet of our own: distances at the middles of a map's texels, between them bilinear, met by each eye's rays, which bear the photograph's
colour. A coarse map sees no ball, so the ball is painted on the wall behind it and stands where the wall's parallax puts it.
Needs numpy and Pillow. Exits with 1 where a ball of the truth is more than a texel off, a fine mesh is no nearer than a coarse one, or a
ball on the coarse mesh is more than half a texel from where the sheet has it."""
import base64
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

EYE_M = 0.0325
WIDTH, HEIGHT = 512, 256
CAMERA = np.array([0.3, 1.5, -0.2])
COLOURS = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1)]
# Azimuth and elevation in degrees, distance from the axis in metres; the look begins along -Z.
BALLS = [(10, 5, 0.7), (75, -20, 1.5), (140, 30, 1.0), (-170, -10, 2.5), (-100, 15, 0.9), (-40, -35, 2.0)]


def sphere(centre, radius, rings=8):
    vertices, triangles = [], []
    for i in range(rings + 1):
        for j in range(2 * rings):
            t, p = np.pi * i / rings, np.pi * j / rings
            vertices.append(centre + radius * np.array([np.sin(t) * np.cos(p), np.cos(t), np.sin(t) * np.sin(p)]))
    for i in range(rings):
        for j in range(2 * rings):
            a, b = i * 2 * rings + j, i * 2 * rings + (j + 1) % (2 * rings)
            triangles += [(a, b, a + 2 * rings), (b, b + 2 * rings, a + 2 * rings)]
    return np.array(vertices, np.float32), np.array(triangles, np.uint32)


def box(low, high):
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)], np.float32)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))], np.uint32)


def write_gltf(path, meshes):
    """meshes: (vertices, triangles, emission or None)"""
    data, views, accessors, materials, parts, nodes = b"", [], [], [], [], []

    def add(array, kind, type_, target):
        nonlocal data
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes, "target": target})
        one = {"bufferView": len(views) - 1, "componentType": kind, "count": array.size if type_ == "SCALAR" else len(array), "type": type_}
        if type_ == "VEC3":
            one |= {"min": array.min(0).tolist(), "max": array.max(0).tolist()}
        accessors.append(one)
        data += array.tobytes()
        return len(accessors) - 1

    for vertices, triangles, emission in meshes:
        at = add(vertices.astype(np.float32), 5126, "VEC3", 34962)
        indices = add(triangles.astype(np.uint32).ravel(), 5125, "SCALAR", 34963)
        material = {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0}, "doubleSided": True}
        if emission:
            material |= {"emissiveFactor": list(emission)}
        materials.append(material)
        parts.append({"primitives": [{"attributes": {"POSITION": at}, "indices": indices, "material": len(materials) - 1}]})
        nodes.append({"mesh": len(parts) - 1})
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    path.write_text(json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes,
                                "meshes": parts, "materials": materials, "accessors": accessors, "bufferViews": views,
                                "buffers": [{"byteLength": len(data), "uri": uri}]}))


STUDY = """format = "seamline study 1"
name = "points"
isolation = "query"
width_px = {width}
height_px = {height}
samples_per_pixel = 8
seed = 1
depth_width_px = [32, 2048]

[look]
kind = "head"

[[condition]]
name = "own"
view.kind = "omnidirectional"

[[condition]]
name = "mesh"
view.kind = "omnidirectional"
view.parallax = "depth"

[[scene]]
name = "room"
file = "room.gltf"
artifacts = ["receiver"]
environment_radiance = [0, 0, 0]
bounces = 0

  [scene.camera]
  projection = "panorama"
  position_m = [{x}, {y}, {z}]
  look_at_m = [{x}, {y}, {ahead}]
"""


def place(azimuth_deg, elevation_deg, distance_m):
    a, e = np.radians([azimuth_deg, elevation_deg])
    return np.array([distance_m * np.sin(a), distance_m * np.tan(e), -distance_m * np.cos(a)])


def seen_by(eye_m, azimuth_deg, elevation_deg, distance_m):
    """Column and row."""
    height_m = distance_m * np.tan(np.radians(elevation_deg))
    azimuth = np.radians(azimuth_deg) - np.arcsin(eye_m / distance_m)
    elevation = np.arctan2(height_m, np.sqrt(distance_m**2 - eye_m**2))
    return ((azimuth / (2 * np.pi) + 0.5) % 1) * WIDTH, (0.5 - elevation / np.pi) * HEIGHT


def found(picture, colour):
    """Middle of the pixels of a colour, by solid angle."""
    codes = np.asarray(picture).astype(float) / 255
    mask = np.ones(codes.shape[:2])
    for channel in range(3):
        mask *= codes[..., channel] if colour[channel] else 1 - codes[..., channel]
    mask = np.where(mask > 0.3, mask, 0)
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    azimuth, elevation = ((x + 0.5) / WIDTH - 0.5) * 2 * np.pi, (0.5 - (y + 0.5) / HEIGHT) * np.pi
    weight = mask * np.cos(elevation)
    if weight.sum() == 0:
        return None
    v = [(weight * part).sum() for part in (np.cos(elevation) * np.sin(azimuth), np.sin(elevation), np.cos(elevation) * np.cos(azimuth))]
    return (np.arctan2(v[0], v[2]) / (2 * np.pi) + 0.5) * WIDTH, (0.5 - np.arctan2(v[1], np.hypot(v[0], v[2])) / np.pi) * HEIGHT


def off(picture, eye_m):
    """Of each ball, in columns and rows."""
    out = []
    for ball, colour in zip(BALLS, COLOURS):
        at = found(picture, colour)
        if at is None:
            out.append((np.nan, np.nan))
            continue
        x, y = seen_by(eye_m, *ball)
        out.append(((at[0] - x + WIDTH / 2) % WIDTH - WIDTH / 2, at[1] - y))
    return np.array(out)


ROOM = np.array([[-4, 0, -4], [4, 3.2, 4]]) - CAMERA


def true_distance(directions):
    """From the axis to what stands there: the box from inside, and the balls."""
    with np.errstate(divide="ignore"):
        far = np.maximum(ROOM[0] / directions, ROOM[1] / directions).min(-1)
    for ball in BALLS:
        centre = place(*ball)
        along, radius = directions @ centre, 0.02 * np.linalg.norm(centre)
        inside = along**2 - centre @ centre + radius**2
        far = np.where((inside > 0) & (along > 0), along - np.sqrt(np.maximum(inside, 0)), far)
    return far


def direction(azimuth, elevation):
    return np.stack([np.sin(azimuth) * np.cos(elevation), np.sin(elevation), -np.cos(azimuth) * np.cos(elevation)], -1)


def sheet(width):
    """The distance in directions, of a map of so many columns."""
    column, row = np.meshgrid(np.arange(width) + 0.5, np.arange(width // 2) + 0.5)
    far = true_distance(direction((column / width - 0.5) * 2 * np.pi, (0.5 - row / (width // 2)) * np.pi))

    def at(points):
        x, y, z = np.moveaxis(points, -1, 0)
        u = (np.arctan2(x, -z) / (2 * np.pi) + 0.5) * width - 0.5
        v = np.clip((0.5 - np.arctan2(y, np.hypot(x, z)) / np.pi) * (width // 2) - 0.5, 0, width // 2 - 1)
        i, j = np.floor(u).astype(int), np.minimum(np.floor(v).astype(int), width // 2 - 2)
        s, t = u - i, v - j
        return (far[j, i % width] * (1 - s) + far[j, (i + 1) % width] * s) * (1 - t) + (far[j + 1, i % width] * (1 - s) + far[j + 1, (i + 1) % width] * s) * t

    return at


def column_on_sheet(ball, eye_m, far):
    """Where an eye sees the middle of a ball that a photograph from the axis painted on the sheet; nan: nowhere."""
    x0, y0 = seen_by(0, *ball)
    columns, rows = np.meshgrid(np.arange(np.floor(x0) - 12, x0 + 12, 0.25), np.arange(np.floor(y0) - 5, y0 + 5, 0.25))
    azimuth, elevation = (columns / WIDTH - 0.5) * 2 * np.pi, (0.5 - rows / HEIGHT) * np.pi
    eye = eye_m * np.stack([np.cos(azimuth), 0 * azimuth, np.sin(azimuth)], -1)
    ahead = direction(azimuth, elevation)
    hit = np.full(azimuth.shape, 20.0)
    for step in np.geomspace(8, 0.3, 1500):  # the nearest place where a ray goes through the sheet
        points = eye + step * ahead
        hit = np.where(np.linalg.norm(points, axis=-1) >= far(points), step, hit)
    points = eye + hit[..., None] * ahead
    points /= np.linalg.norm(points, axis=-1)[..., None]
    centre = place(*ball)
    on_ball = points @ (centre / np.linalg.norm(centre)) > np.cos(np.arcsin(0.02))
    return (columns * on_ball).sum() / on_ball.sum() if on_ball.any() else np.nan


def main(program, work):
    work = Path(work)
    work.mkdir(parents=True, exist_ok=True)
    balls = [sphere(CAMERA + place(*ball), 0.02 * ball[2] / np.cos(np.radians(ball[1]))) + (colour,) for ball, colour in zip(BALLS, COLOURS)]
    write_gltf(work / "room.gltf", [box((-4, 0, -4), (4, 3.2, 4)) + (None,)] + balls)
    text = STUDY.format(width=WIDTH, height=HEIGHT, x=CAMERA[0], y=CAMERA[1], z=CAMERA[2], ahead=CAMERA[2] - 3)
    for name, at in (("a", (-2.5, 0, -2.5)), ("b", (2.5, 0, -2.0)), ("c", (0.5, 0, 2.8))):
        text += f'\n  [[scene.object]]\n  name = "{name}"\n  file = "builtin:statue"\n  position_m = {list(at)}\n  scale = 0.5\n'
    (work / "study.toml").write_text(text)
    worst = 0
    for estimator in ("fast", "path"):
        out = work / estimator
        subprocess.run([program, "render", str(work / "study.toml"), "--out", str(out), "--estimator", estimator, "--threads", "1"], check=True, capture_output=True)
        manifest = json.loads((out / "manifest.json").read_text())
        for reference in manifest["references"]:
            right = Image.open(out / reference["more_eyes"][0]["image"])
            left = Image.open(out / reference["image"])
            errors = np.abs(np.stack([off(left, -EYE_M), off(right, EYE_M)]))
            worst = max(worst, errors.max())
            print(f"{estimator}, truth {reference['scene']}: both eyes, {len(BALLS)} balls: at most {errors[..., 0].max():.3f} columns, {errors[..., 1].max():.3f} rows off")
        off_by_width = {}
        for stimulus in manifest["stimuli"]:
            if "mesh" != stimulus["condition"]["name"] or stimulus["object_index"] != 1:
                continue
            pictures = [Image.open(out / stimulus["image"]), Image.open(out / stimulus["more_eyes"][0]["image"])]
            errors = np.abs(np.stack([off(pictures[0], -EYE_M), off(pictures[1], EYE_M)]))
            width = stimulus["condition"]["depth_width_px"]
            print(f"{estimator}, parallax by a mesh of {width}: at most {np.nanmax(errors[..., 0]):.2f} columns, {np.nanmax(errors[..., 1]):.2f} rows off; by ball {np.round(errors[..., 0].max(0), 2).tolist()}")
            off_by_width[width] = errors[..., 0].max()
            far, apart = sheet(width), []
            for picture, eye_m in zip(pictures, (-EYE_M, EYE_M)):
                for ball, colour in zip(BALLS, COLOURS):
                    at = found(picture, colour)
                    apart.append(np.nan if at is None else (at[0] - column_on_sheet(ball, eye_m, far) + WIDTH / 2) % WIDTH - WIDTH / 2)
            print(f"{estimator}, mesh of {width} beside the sheet: at most {np.nanmax(np.abs(apart)):.2f} columns off; by ball {np.round(np.abs(apart).reshape(2, -1).max(0), 2).tolist()}")
            if width == 32 and not np.max(np.abs(apart)) <= 0.5:
                worst = np.inf
        if not off_by_width[2048] < off_by_width[32]:
            worst = np.inf
    expected = max(abs(seen_by(EYE_M, *ball)[0] - seen_by(-EYE_M, *ball)[0]) for ball in BALLS)
    print(f"the largest disparity is {expected:.1f} columns")
    return 1 if not worst <= 1 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
