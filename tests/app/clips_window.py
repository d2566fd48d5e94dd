"""Clips in the window under Xvfb: what stands on the screen, watched as fast as it can be read, beside the clip's file as Python's zlib
reads it; once more with the program held up; and what the log says.

    tests/app/clips_window.py PROGRAM SET WORK [held]

SET is a set of clips that are played once (tests/online/run PROGRAM WORK clips leaves one in WORK/clips-set). Needs Xvfb, xdotool and
python3-numpy. Exits with 1 where a frame is missing, comes twice or out of order, or has other codes than the file, in a session that
nothing held up; with `held`, where the log does not know of late or dropped frames."""
import hashlib
import json
import os
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import threading
import time
import zlib
from pathlib import Path

import numpy as np

WIDTH, HEIGHT, TRIALS = 1000, 800, 4
program, pictures, work = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
held_up = sys.argv[4:] == ["held"]
run = work / "window"
shutil.rmtree(run, ignore_errors=True)
(run / "config/seamline").mkdir(parents=True)
profile = {"mm_per_px": 0.25, "viewing_distance_mm": 600, "gamma_confirmed": True}
(run / "config/seamline/display.json").write_text(json.dumps(
    {"format": "seamline display", "version": 1, "screens": {f"screen {WIDTH}x{HEIGHT} {WIDTH}": profile}}))
reader, writer = os.pipe()
server = subprocess.Popen(
    ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", str(run), "-nolisten", "tcp", "-noreset"],
    pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
display = ":" + os.read(reader, 16).decode().strip()
environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=str(run / "config"), LIBGL_ALWAYS_SOFTWARE="1")
environment.pop("WAYLAND_DISPLAY", None)
trace, log = run / "trace", run / "log.sqlite"


def frames_of(name):
    data = (pictures / "clips" / f"{name}.clip").read_bytes()
    end = data.index(b"\n", 16)
    header = json.loads(data[16:end])
    at, codes, out = end + 1, np.zeros(3 * header["width_px"] * header["height_px"], np.uint8), []
    for frame in header["frames"]:
        codes = codes + np.frombuffer(zlib.decompress(data[at:at + frame["bytes"]]), np.uint8)
        at += frame["bytes"]
        assert hashlib.sha256(codes.tobytes()).hexdigest() == frame["sha256"]
        out.append(codes.reshape(header["height_px"], header["width_px"], 3))
    return out, header["frames_per_s"]


buffer = None


def screen(x, y, width, height):
    """A part of the server's own framebuffer, an XWD file."""
    global buffer
    if buffer is None:
        buffer = np.memmap(run / "Xvfb_screen0", np.uint8, "r")
    field = struct.unpack(">25I", bytes(buffer[:100]))
    begin, row = field[0] + field[19] * 12, field[12]
    rows = buffer[begin + row * y:begin + row * (y + height)].reshape(height, row)
    return np.array(rows[:, 4 * x:4 * (x + width)].reshape(height, width, 4)[:, :, 2::-1])


def now():
    lines = trace.read_text().split("\n")[:-1] if trace.exists() else []
    return json.loads(lines[-1]) if lines else {}


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], env=environment, check=True, stdout=subprocess.DEVNULL)


def click(rectangle):
    xdotool("mousemove", int(rectangle[0] + 30), int(rectangle[1] + 20), "click", "1")


class Watcher(threading.Thread):
    """Reads a rectangle of the screen again and again; of what it sees, numbers of a clip's frames as they change. What is neither is
    a frame that was just being drawn."""

    def __init__(self, rectangle):
        super().__init__(daemon=True)
        self.rectangle, self.seen, self.ends = rectangle, [], False

    def run(self):
        last = None
        while not self.ends:
            found = codes.get(screen(*self.rectangle).tobytes())
            if found and found != last:
                self.seen.append(found)
                last = found


codes = {}
for clip in sorted((pictures / "clips").glob("*.clip")):
    if not clip.stem.endswith("-ids"):
        for number, frame in enumerate(frames_of(clip.stem)[0]):
            codes.setdefault(frame.tobytes(), []).append((clip.stem, number))
count, rate = len(frames_of(next((pictures / "clips").glob("reference-*.clip")).stem)[0]), frames_of(clip.stem)[1]


def trial_of(seen):
    """Whether these are all frames of one clip in their order."""
    clips = set.intersection(*[{name for name, _ in one} for one in seen]) if seen else set()
    return any([dict(one)[name] for one in seen] == list(range(count)) for name in clips)


command = [program, "study", str(pictures), "--log", str(log), "--participant", "p01", "--pilot", "--trace", str(trace)]
window = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=open(run / "output", "a"), stderr=subprocess.STDOUT)
watched, wrong, end = [], 0, time.time() + 240
watcher, done, held = None, set(), set()
try:
    while time.time() < end and len(watched) < TRIALS and window.poll() is None:
        line = now()
        on = line.get("screen") in ("trial", "training")
        if on and watcher is None and "picture" in line:  # during practice, which is not watched
            watcher = Watcher(list(map(int, line["picture"])))
            watcher.start()
        if on and line["phase"] == "viewing" and held_up and line["screen"] == "trial" and line["trial"] not in held:
            held.add(line["trial"])
            window.send_signal(signal.SIGSTOP)
            time.sleep(0.5)
            window.send_signal(signal.SIGCONT)
        if line.get("screen") == "trial" and line["phase"] == "rating" and line["trial"] not in done:
            done.add(line["trial"])
            good = trial_of(watcher.seen)
            if line["kind"] == "attention":  # made for the trial, in no file
                watcher.seen = []
                continue
            watched.append(good)
            wrong += not good
            print(f"{line['stimulus']}: {rate} frames/s, {len(watcher.seen)} frames of {count}, "
                  + ("all in order, none twice" if good else "not whole: " + str([one[0][1] for one in watcher.seen])), flush=True)
            watcher.seen = []
        if line.get("screen") == "training" and line["phase"] == "rating":
            watcher.seen = []
        if line.get("screen") in ("trial", "training") and line.get("phase") == "rating":
            xdotool("key", "3")
        elif line.get("screen") in ("trial", "training") and line.get("phase") == "choosing":
            xdotool("key", "1")
        elif line.get("screen") == "form":
            click(line["items"]["age"])
            xdotool("type", "33")
            for name in ("gender", "vision", "technical_background", "submit"):
                click(line["items"][name])
            xdotool("mousemove", 3, 3)
        elif line.get("screen") == "consent":
            xdotool("key", "Tab", "Tab", "Return")
        elif line:
            xdotool("key", "Return")
        time.sleep(0.1)
finally:
    if watcher:
        watcher.ends = True
        watcher.join()
    if window.poll() is None:
        window.kill()
    window.wait()
    server.terminate()
rows = sqlite3.connect(log).execute("select kind, detail from events where kind = 'clip'").fetchall()
late = 0
for kind, detail in rows:
    print("log:", detail)
    words = detail.split()
    late += int(words[words.index("late") + 1]) + int(words[words.index("dropped") + 1])
print(f"{len(watched)} trials watched, {wrong} of them not whole; the log has {late} late or dropped frames")
sys.exit(0 if len(watched) == TRIALS and (late > 0 if held_up else wrong == 0) else 1)
