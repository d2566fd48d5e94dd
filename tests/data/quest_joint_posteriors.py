#!/usr/bin/env python3
"""Makes quest_joint_posteriors.json: three sessions of one QUEST+ track that learns by the joint model, and what is
known after their last answer, written from the equations of documentation/how-to/adaptive_placement.md with numpy
alone: every point of the grid at once, in logarithms."""
import json
from pathlib import Path
import numpy as np
from math import erf, sqrt

WIDTHS = [64, 128, 256, 512, 1024, 2048, 4096]
F = np.vectorize(lambda z: 0.5 * (1 + erf(z / sqrt(2))))
AXES = [np.linspace(5, 13, 41), 2 ** np.linspace(-3, 1, 7), np.linspace(0, 0.04, 3), np.array([1 / 3]),
        2 ** np.linspace(-2.5, 0, 4), np.linspace(-2, 2, 6), np.array([0.05, 0.2])]
NAMES = ["threshold", "scale", "lapse", "guess", "rating step", "first rating", "guess rating"]
T, S, L, G, R, C, Q = np.meshgrid(*AXES, indexing="ij", sparse=True)


def outcomes(width):
    z = (T - np.log2(width)) / S
    psi = (1 - L) * F(z)
    above = [1] + [F(z - C - (k - 2) * R / S) for k in (2, 3, 4)] + [0]
    total = 1 + Q + Q ** 2 + Q ** 3
    rows = [(1 - psi) * (1 - G) + 0 * R * C * Q]
    rows += [psi * np.maximum(0, above[k] - above[k + 1]) + (1 - psi) * G * Q ** k / total for k in range(4)]
    return [np.log(np.maximum(r, 1e-300)) for r in rows]


LOG_P = {w: outcomes(w) for w in WIDTHS}


def session(seed, threshold, scale, first, step, answers):
    """A person who sees with a logistic function: not the model that learns."""
    random, trials = np.random.default_rng(seed), []
    log_mass = np.zeros(np.broadcast_shapes(*(a.shape for a in (T, S, L, G, R, C, Q))))
    for _ in range(answers):
        width = int(random.choice(WIDTHS))
        z = (threshold - np.log2(width)) / scale
        seen = 1 / (1 + np.exp(-z))
        if random.random() < seen:
            score = 1 + sum(random.random() < 1 / (1 + np.exp(-(z - first - k * step))) for k in range(3))
        else:
            score = int(random.random() < 1 / 3)
        trials.append([width, int(score)])
        log_mass = log_mass + LOG_P[width][score]
    mass = np.exp(log_mass - log_mass.max())
    mass /= mass.sum()
    means, sds = {}, {}
    for axis, name in enumerate(NAMES):
        marginal = mass.sum(axis=tuple(i for i in range(7) if i != axis))
        means[name] = float(marginal @ AXES[axis])
        sds[name] = float(np.sqrt(marginal @ (AXES[axis] - means[name]) ** 2))
    return {"trials": trials, "mean": means, "sd": sds, "entropy_nats": float(-(mass[mass > 0] * np.log(mass[mass > 0])).sum())}


if __name__ == "__main__":
    sessions = [session(1, 8.3, 0.5, -1, 0.7, 40), session(2, 11.1, 0.2, 0, 0.3, 40), session(3, 6.2, 0.9, 1, 1.0, 120)]
    path = Path(__file__).with_suffix(".json")
    path.write_text(json.dumps({"made_by": "quest_joint_posteriors.py", "numpy": np.__version__, "sessions": sessions}, separators=(",", ":")) + "\n")
    print([s["mean"]["threshold"] for s in sessions], sessions[0]["entropy_nats"])
