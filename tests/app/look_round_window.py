"""A whole session of a study that looks round, in the window under Xvfb by xdotool, killed twice; what stands on the screen beside
tests/online/panorama_view.py (numpy), and every answer in the log.

    tests/app/look_round_window.py PROGRAM SET WORK [speed]

`speed` measures in place of the session, and asserts no time: from a key to the turned view on the screen, and the program's memory.
SET is tests/online/look.toml, rendered (tests/online/run PROGRAM WORK look_round leaves it in WORK/look-set). Needs Xvfb, xdotool,
python3-numpy and python3-pil. Screens to look at: WORK/window-*.png.
"""
import csv
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from PIL import Image

sys.path.insert(0, str(Path(__file__).parent.parent / "online"))
from panorama_view import view  # noqa: E402

FOV_DEG = 70
CREATURE = (177.9, -13.4)  # behind the start: yaw and pitch
WIDTH, HEIGHT = 1000, 800
program, pictures, work = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
run = work / "window"
shutil.rmtree(run, ignore_errors=True)
(run / "config/seamline").mkdir(parents=True)
screen_key = f"screen {WIDTH}x{HEIGHT} {WIDTH}"
profile = {"mm_per_px": 0.25, "viewing_distance_mm": 600, "gamma_confirmed": True}
(run / "config/seamline/display.json").write_text(json.dumps({"format": "seamline display", "version": 1, "screens": {screen_key: profile}}))
reader, writer = os.pipe()
server = subprocess.Popen(
    ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", str(run), "-nolisten", "tcp", "-noreset"],
    pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
display = ":" + os.read(reader, 16).decode().strip()
environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=str(run / "config"), LIBGL_ALWAYS_SOFTWARE="1")
environment.pop("WAYLAND_DISPLAY", None)
trace, log = run / "trace", run / "log.sqlite"


def start():
    trace.unlink(missing_ok=True)
    command = [program, "study", str(pictures), "--log", str(log), "--participant", "p01", "--pilot", "--trace", str(trace)]
    return subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=open(run / "output", "a"), stderr=subprocess.STDOUT)


def now():
    lines = trace.read_text().split("\n")[:-1] if trace.exists() else []
    return json.loads(lines[-1]) if lines else {}


def wait(wanted, words, seconds=120):
    end = time.time() + seconds
    while time.time() < end:
        line = now()
        if line and wanted(line):
            return line
        time.sleep(0.02)
    raise SystemExit(f"waited for {words}: {now()}")


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], env=environment, check=True, stdout=subprocess.DEVNULL)


def click(rectangle):
    xdotool("mousemove", int(rectangle[0] + 30), int(rectangle[1] + 20), "click", "1")


def screen():
    """The server's own framebuffer, an XWD file."""
    data = (run / "Xvfb_screen0").read_bytes()
    field = struct.unpack(">25I", data[:100])
    begin, row = field[0] + field[19] * 12, field[12]
    rows = np.frombuffer(data[begin:begin + row * HEIGHT], np.uint8).reshape(HEIGHT, row)
    return rows[:, :4 * WIDTH].reshape(HEIGHT, WIDTH, 4)[:, :, 2::-1]


def shot(name):
    Image.fromarray(screen()).save(work / f"window-{name}.png")


differences = []


def compare(line):
    """The view on the screen beside the program in numpy; its cross is left out."""
    x, y, width, height = map(int, line["picture"])
    panorama = np.asarray(Image.open(pictures / "stimuli" / (line["stimulus"] + ".png")).convert("RGB"))
    wanted = view(panorama, width, height, line["fov_deg"], *line["pose"])
    smallest = 999.0
    for _ in range(60):  # soon after the swap, however busy the machine is
        apart = np.abs(screen()[y:y + height, x:x + width] - wanted).max(-1)
        apart[height // 2 - 12:height // 2 + 12, width // 2 - 12:width // 2 + 12] = 0
        smallest = min(smallest, apart.max())
        if smallest <= 1:
            break
        time.sleep(0.05)
    differences.append(smallest)


def turn_to(yaw_deg, pitch_deg):
    while True:
        line = now()
        right, up = (yaw_deg - line["pose"][0] + 180) % 360 - 180, pitch_deg - line["pose"][1]
        if max(abs(right), abs(up)) <= 1.6:
            return line
        way, key = (right, ("Left", "Right")) if abs(right) > 1.6 else (up, ("Down", "Up"))
        xdotool("key", ("shift+" if abs(way) > 9 else "") + key[way > 0])
        wait(lambda later: later.get("pose") != line["pose"], "a turn")


def is_turning(line):
    return "turned" in line["stimulus"] or "mouse" in line["stimulus"]


def choose(line):
    turns = is_turning(line)
    if turns:
        if line["screen"] == "trial" and len(differences) < 25:
            for pose in [(0, 0), (75, 30), (-160, -40), (40, 84), (-90, 10)]:
                compare(turn_to(*pose))
            for key, fov_deg in (("minus", FOV_DEG + 5), ("plus", FOV_DEG), ("plus", FOV_DEG - 5)):
                xdotool("key", key)
                compare(wait(lambda later: later.get("fov_deg") == fov_deg, f"a field of {fov_deg} degrees"))
        line = turn_to(*CREATURE)
    compare(line)
    shot("found" if turns else "still")
    xdotool("key", "Return" if turns else "1")
    wait(lambda later: later.get("phase") == "rating", "the rating")


def answer_one():
    """What a person does about what is on the screen."""
    line = now()
    at = line.get("screen")
    if at in ("trial", "training"):
        if line["phase"] == "choosing":
            choose(line)
        elif line["phase"] == "rating":
            shot("rating")
            xdotool("key", "2")
            wait(lambda later: later.get("phase") != "rating" or later["screen"] != at, "the next picture")
    elif at == "form":
        click(line["items"]["age"])
        xdotool("type", "33")
        for name in ("gender", "vision", "technical_background", "submit"):
            click(line["items"][name])
        xdotool("mousemove", 3, 3)
    elif at == "break":
        shot("break")
        click(line["items"]["comfort-2"])
        xdotool("mousemove", 3, 3)
    elif at == "consent":
        xdotool("key", "Tab", "Tab", "Return")
    elif at:
        xdotool("key", "Return")
    time.sleep(0.15)


def answer_until(answered):
    """Until so many trials are answered, or to the end."""
    while True:
        line = now()
        at = line.get("screen")
        if at in ("thanks", "stopped") or at == "trial" and line["answered"] >= answered:
            return line
        answer_one()


def measure_speed():
    """Polls a patch of the server's framebuffer; what xdotool itself takes is told beside it."""
    def run_of(*words):
        begin = time.perf_counter()
        xdotool(*words)
        return time.perf_counter() - begin

    line = wait(lambda later: later.get("phase") == "choosing" and is_turning(later), "a view that turns", 1)
    x, y, width, height = map(int, line["picture"])
    panorama = np.asarray(Image.open(pictures / "stimuli" / (line["stimulus"] + ".png")).convert("RGB"))
    lags = []
    for _ in range(20):
        yaw_deg, pitch_deg = now()["pose"]
        wanted = view(panorama, width, height, line["fov_deg"], yaw_deg + 3, pitch_deg)[40:104, 40:104]
        begin = time.perf_counter()
        xdotool("key", "Right")
        while np.abs(screen()[y + 40:y + 104, x + 40:x + 104] - wanted).max() > 1:
            if time.perf_counter() - begin > 10:
                raise SystemExit("the turned view did not come to the screen")
        lags.append(1000 * (time.perf_counter() - begin))
        time.sleep(0.1)
    own = sorted(1000 * run_of("getmouselocation") for _ in range(11))[5]
    memory = {name: int(value) // 1024 for name, value in re.findall(r"^(VmHWM|VmRSS):\s+(\d+)", Path(f"/proc/{child.pid}/status").read_text(), re.M)}
    lags.sort()
    print(f"panorama {panorama.shape[1]} x {panorama.shape[0]}, view {width} x {height}, software rendering: from before xdotool's start to the right picture on the "
          f"screen median {lags[10]:.0f} ms, longest {lags[-1]:.0f} ms, of which xdotool takes about {own:.0f} ms; memory {memory['VmRSS']} MB, at most {memory['VmHWM']} MB")


child = start()
try:
    if sys.argv[4:] == ["speed"]:
        while not (now().get("phase") == "choosing" and is_turning(now())):
            answer_one()
        measure_speed()
        raise SystemExit(0)
    xdotool("mousemove", 3, 3)
    for answered, rates in ((4, False), (9, True)):  # killed while choosing, then while rating
        answer_until(answered)
        line = wait(lambda later: later.get("phase") == "choosing", "choosing")
        if rates and "still" in line["stimulus"]:
            xdotool("key", "1")
        child.kill()
        child.wait()
        child = start()
        wait(bool, "a first frame")
    end = answer_until(10**6)
    shot("thanks")
finally:
    child.terminate()
    child.wait()
    server.terminate()
assert end["screen"] == "thanks", end
subprocess.run([program, "export", "tables", str(log), str(run / "tables")], check=True, stdout=subprocess.DEVNULL)
answers = list(csv.DictReader(open(run / "tables/answers.csv")))
assert [int(one["trial_index"]) for one in answers] == list(range(12)), "every trial has one answer"
assert all(one["chosen_index"] == ("3" if one["condition"] == "turned" else "1") for one in answers)
assert max(differences) <= 1, differences
comfort = list(csv.DictReader(open(run / "tables/comfort.csv")))
assert [(one["answered"], one["comfort"]) for one in comfort] == [("6", "2")], comfort
found = sum(one["condition"] == "turned" for one in answers)
print(f"12 trials in the window, killed twice, no answer lost; {found} times the object behind the start was found and chosen; "
      f"{len(differences)} poses of 640 x 360: largest difference {max(differences):.3f} codes")
