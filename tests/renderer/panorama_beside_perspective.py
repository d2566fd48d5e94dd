#!/usr/bin/env python3
"""Whether a panorama's view is the picture that a camera takes: panorama_beside_perspective.py PROGRAM WORK

Renders a scene with PROGRAM as a perspective stimulus and as a panorama, both by sunlight alone (no grain) and by the sky too, and
compares the view at yaw and pitch 0, made of the panorama in double precision (tests/online/panorama_view.py), with the perspective
picture. Pixels near edges are left out: where codes change by more than 8 within nine by nine pixels. Needs numpy and Pillow.
Exits with 1 where a pixel by sunlight differs by more than one code."""
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

sys.path.insert(0, str(Path(__file__).parent.parent / "online"))
from panorama_view import view  # noqa: E402

WIDTH, HEIGHT, FOV_DEG = 160, 90, 60
STUDY = """format = "seamline study 1"
name = "view"
isolation = "query"
width_px = {width}
height_px = {height}
samples_per_pixel = {samples}
seed = {seed}
depth_width_px = [128]
{look}
[[scene]]
name = "gazebo"
file = "builtin:gazebo"
artifacts = ["shadow"]
environment_radiance = {sky}
bounces = {bounces}
albedo = 0.5
exposure_ev = 0.55

  [scene.camera]
  {projection}
  position_m = [0.0, 1.7, 0.0]
  look_at_m = [0.0, 1.7, -5.0]
"""
OBJECTS = "".join(
    f'\n  [[scene.object]]\n  name = "{name}"\n  file = "builtin:{name}"\n  position_m = {at}\n  rotation_deg = [0.0, -40.0, 0.0]\n  scale = 1.2\n'
    for name, at in (("beast", [-3.0, 0.0, -7.0]), ("lion", [-0.15, 0.0, -7.45]), ("dragon", [2.5, 0.0, -7.4])))


def render(program, work, name, **keys):
    study = work / (name + ".toml")
    study.write_text(STUDY.format(**keys) + OBJECTS)
    subprocess.run([program, "render", str(study), "--out", str(work / name), "--only", "*lion*", "--threads", "1"], check=True, capture_output=True)
    return np.asarray(Image.open(next((work / name / "stimuli").glob("*.png"))).convert("RGB")).astype(float)


def main(program, work):
    work = Path(work)
    work.mkdir(parents=True, exist_ok=True)
    look = f'[look]\nkind = "fixed"\nview_px = [{WIDTH}, {HEIGHT}]\nhorizontal_fov_deg = {FOV_DEG}\n'
    most = 0
    for light, samples, sky, bounces in (("sun", 64, [0, 0, 0], 0), ("sun and sky", 64, [0.42, 0.46, 0.52], 0)):
        common = {"samples": samples, "sky": sky, "bounces": bounces, "seed": 1}
        flat = render(program, work, f"flat-{bounces}-{samples}", width=WIDTH, height=HEIGHT, look="", projection=f"horizontal_fov_deg = {FOV_DEG}", **common)
        around = render(program, work, f"around-{bounces}-{samples}", width=1024, height=512, look=look, projection='projection = "panorama"', **common)
        seen = view(around, WIDTH, HEIGHT, FOV_DEG, 0, 0)
        apart = np.abs(seen - flat).max(-1)
        padded = np.pad(flat, ((4, 4), (4, 4), (0, 0)), mode="edge")
        windows = np.stack([padded[i : i + HEIGHT, j : j + WIDTH] for i in range(9) for j in range(9)])
        calm = (windows.max(0) - windows.min(0)).max(-1) <= 8
        beyond = apart[calm] > 1.5  # codes are whole, the view is not: within one code after rounding
        print(f"{light}, {samples} samples a pixel: {calm.mean() * 100:.0f} % of the pixels are away from edges; {(1 - beyond.mean()) * 100:.2f} % of them within one code, "
              f"root mean square {np.sqrt((apart[calm] ** 2).mean()):.3f}, at most {apart[calm].max():.2f} codes")
        if light == "sun":
            most = beyond.sum()
    return 1 if most else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
