"""Running the program, and how far a picture of codes is from two truths."""
import math
import re
import resource
import signal
import subprocess


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, folder, longest_s=3600):
    """Status, lines and processor seconds, of which a command may take `longest_s`, so that other work on the machine changes nothing."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(longest_s), math.ceil(longest_s) + 1))

    before = processor_s()
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, preexec_fn=limit)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return 1, [f"took longer than {longest_s} s of processor time"], processor_s() - before
    lines = [line for line in done.stdout.splitlines() if not re.match(r"(rendering|true errors).*%", line)]
    return done.returncode, lines, processor_s() - before


def difference(shown, first, second, panorama):
    """Root mean square of shown less truth, its standard error over squares of 8 x 8 pixels, and the truth's own error."""
    width, height, codes = shown
    a, b = first[2], second[2]
    squares, weights, own = {}, {}, 0.0
    for y in range(height):
        weight = math.sin(math.pi * (y + 0.5) / height) if panorama else 1.0
        for x in range(width):
            key = (x // 8, y // 8)
            for c in range(3):
                i = (y * width + x) * 3 + c
                squares[key] = squares.get(key, 0.0) + weight * (codes[i] - a[i]) * (codes[i] - b[i]) / 65025
                weights[key] = weights.get(key, 0.0) + weight
                own += weight * (a[i] - b[i]) ** 2 / 65025
    total = sum(weights.values())
    mean = sum(squares.values()) / total
    spread = math.sqrt(sum((squares[k] - mean * weights[k]) ** 2 for k in squares)) / total
    rms = math.sqrt(max(0.0, mean))
    return rms, spread / (2 * rms) if rms > 0 else math.sqrt(spread), math.sqrt(own / total) / 2
