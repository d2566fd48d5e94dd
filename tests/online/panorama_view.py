"""Views of a panorama in double precision, written without a look at the program: FOLDER/poses.json says which, FOLDER/N.rgba
holds what was drawn (lowest row first). With "base" the panorama is the sum of both files' codes, modulo 256. Prints the largest difference in codes, and how many pixels differ by more than one."""
import json
import sys
from pathlib import Path

import numpy as np
from PIL import Image


def rotation(yaw_deg, pitch_deg):
    a, p = np.radians([yaw_deg, pitch_deg])
    yaw = np.array([[np.cos(a), 0, -np.sin(a)], [0, 1, 0], [np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(p), -np.sin(p)], [0, np.sin(p), np.cos(p)]])
    return yaw @ pitch


def view(panorama, width, height, fov_deg, yaw_deg, pitch_deg):
    """Perspective view of a pinhole."""
    t = np.tan(np.radians(fov_deg) / 2)
    return frustum(panorama, width, height, (t, t * height / width), (0, 0), yaw_deg, pitch_deg)


def frustum(panorama, width, height, half, middle, yaw_deg, pitch_deg):
    """Bilinear interpolation of codes; columns go round, rows end at the poles. Tangents of half the view, and of its middle."""
    rows, columns = panorama.shape[:2]
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, (np.arange(height) + 0.5) / height * 2 - 1)
    rays = np.stack([x * half[0] + middle[0], -y * half[1] + middle[1], -np.ones_like(x)], -1) @ rotation(yaw_deg, pitch_deg).T
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    longitude, latitude = np.arctan2(rays[..., 0], -rays[..., 2]), np.arcsin(np.clip(rays[..., 1], -1, 1))
    u = (longitude / (2 * np.pi) + 0.5) * columns - 0.5
    v = (0.5 - latitude / np.pi) * rows - 0.5
    left, top = np.floor(u).astype(int), np.floor(v).astype(int)
    s, r = (u - left)[..., None], (v - top)[..., None]
    at = lambda i, j: panorama[np.clip(j, 0, rows - 1), i % columns].astype(float)
    return (at(left, top) * (1 - s) + at(left + 1, top) * s) * (1 - r) + (at(left, top + 1) * (1 - s) + at(left + 1, top + 1) * s) * r


def check_eyes(panorama, folder):
    """That panoramas which stand one above the other are those of the set's files, the left eye's on top."""
    rows = panorama.shape[1] // 2
    if len(panorama) == rows:
        return
    codes = lambda path: np.asarray(Image.open(folder / path).convert("RGB"))
    records = [one for one in json.loads((folder / "manifest.json").read_text())["stimuli"] if "more_eyes" in one]
    of_left = [one for one in records if np.array_equal(codes(one["image"]), panorama[:rows])]
    assert any(
        all(np.array_equal(codes(eye["image"]), panorama[(k + 1) * rows :][:rows]) for k, eye in enumerate(one["more_eyes"])) for one in of_left
    ), "no stimulus of the set has these panoramas"


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    asked = json.loads((folder / "poses.json").read_text())
    panorama = np.asarray(Image.open(asked["panorama"]).convert("RGB"))
    if asked.get("base"):
        panorama = panorama + np.asarray(Image.open(asked["base"]).convert("RGB"))
    if "set" in asked:
        check_eyes(panorama, Path(asked["set"]))
    worst, beyond = 0.0, 0
    for i, pose in enumerate(asked["poses"]):
        at = (pose["yaw_deg"], pose["pitch_deg"])
        width, height = pose["size"] if "size" in pose else asked["view_px"]
        if "size" in pose:
            # The eyes' panoramas stand one above the other, each twice as wide as high.
            rows = panorama.shape[1] // 2
            eye = panorama[pose.get("panorama", 0) * rows :][:rows]
            wanted = frustum(eye, width, height, pose["half"], pose["middle"], *at)
        else:
            wanted = view(panorama, width, height, asked["horizontal_fov_deg"], *at)
        drawn = np.fromfile(folder / f"{i}.rgba", np.uint8).reshape(height, width, 4)[::-1, :, :3]
        difference = np.abs(drawn - wanted).max(-1)
        worst, beyond = max(worst, difference.max()), beyond + int((difference > 1).sum())
    print(f"{len(asked['poses'])} poses of {width} x {height}: largest difference {worst:.3f} codes, {beyond} pixels beyond one")
