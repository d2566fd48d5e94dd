#!/usr/bin/env python3
"""Makes joint_maxima.json: hard sets of answers, and the greatest value of the joint model's likelihood with its
penalty (documentation/explanation/joint_model.md) found independently of the program: written anew from the equations, in
logarithms, derivatives by complex steps, BFGS of SciPy from many starts. usage: joint_maxima.py [PROCESSES]"""
import json, sys
import numpy as np
from multiprocessing import Pool
from pathlib import Path
from scipy.optimize import minimize
from scipy.special import log_ndtr, ndtr

STARTS = 3, 12  # of the first 219 sets, of the others
MOST_LAPSE = 0.1


def log_below(z):
    """log of the normal distribution function, of complex z too."""
    return log_ndtr(z)


def log_between(a, b):
    """log(Phi(a) - Phi(b)), a > b, from the tail in which both are smaller."""
    upper = (a + b).real > 0
    large, small = log_below(np.where(upper, -b, a)), log_below(np.where(upper, -a, b))
    return large + log_less(large - small)


def log_sum(a, b):
    greater = np.where(a.real >= b.real, a, b)
    smaller = np.where(a.real >= b.real, b, a)
    difference = np.where(np.isneginf(smaller.real), -800, smaller - np.where(np.isneginf(greater.real), 0, greater))
    return greater + np.log1p(np.exp(difference))


def log_less(d):
    """log(1 - exp(-d)), d > 0, of complex d with a tiny imaginary part."""
    return np.log(-np.expm1(-d.real)) + 1j * d.imag / np.expm1(np.minimum(d.real, 700))


class Model:
    def __init__(self, data):
        self.K = data["ratings"]
        self.number = data["number"]
        self.curve = np.array([c[0] for c in data["cells"]])
        self.x = np.array([np.inf if c[1] is None else c[1] for c in data["cells"]])
        self.chance = np.array([c[2] for c in data["cells"]])
        self.counts = np.array(data["counts"], float)
        self.references = np.array(data["references"], float)
        self.curves = int(self.curve.max()) + 1
        finite = self.x[np.isfinite(self.x)]
        self.centre, self.range = (finite.min() + finite.max()) / 2, finite.max() - finite.min()
        shared = [c == "1" for c in data["shared"]]  # scale, criteria, lapse, guess ratings
        K, n, at = self.K, self.curves, self.curves
        self.columns = {}  # name: curves x numbers of parameters
        for name, one, width in (("scale", shared[0], 1), ("lapse", shared[2], 1), ("cuts", shared[1], K - 1),
                                 ("spread", shared[1], 1 if K > 1 else 0), ("guess", shared[3], K - 1)):
            rows = []
            for c in range(n):
                first = at if one else at + c * width
                rows.append(list(range(first, first + width)))
            self.columns[name] = np.array(rows, int).reshape(n, width)
            at += width if one else n * width
        self.size = at

    def penalty(self, theta):
        """Of a batch of parameter vectors."""
        def square(v, centre, sd):
            return -((v - centre) / sd) ** 2 / 2
        total = square(theta[:, :self.curves], self.centre, 2 * self.range).sum(1)
        def of(name, k=slice(None)):
            return theta[:, np.unique(self.columns[name][:, k])]
        total = total + square(of("scale"), np.log(self.range / 7), 1.5).sum(1) + square(of("lapse"), -1, 1.5).sum(1)
        if self.K > 1:
            total = total + square(of("cuts", 0), 0, 4).sum(1) + square(of("spread"), 0, 1).sum(1)
            if self.K > 2:
                total = total + square(of("cuts", slice(1, None)), 0, 1.5).sum(1)
            for row in np.unique(self.columns["guess"], axis=0):
                total = total + 0.5 * self.log_guess(theta[:, row]).sum(1)
        return total

    @staticmethod
    def log_guess(h):
        h = np.concatenate([np.zeros((len(h), 1)), h], 1)
        top = h.real.max(1, keepdims=True)
        return h - top - np.log(np.exp(h - top).sum(1, keepdims=True))

    def log_likelihood(self, theta):
        K, c = self.K, self.curve
        def of(name, k=0):
            return theta[:, self.columns[name][c, k]]
        m, s = theta[:, c], np.exp(of("scale"))
        lapse = MOST_LAPSE / (1 + np.exp(-of("lapse")))
        nothing = np.isinf(self.x)
        z = (m - np.where(nothing, 0, self.x)) / s
        log_seen = np.where(nothing, -np.inf, np.log1p(-lapse) + log_below(z))
        log_not = np.where(nothing, 0, log_sum(log_below(-z), np.log(lapse) + log_below(z)))
        if K > 1:
            rho = np.exp(of("spread"))
            t, at = of("cuts"), []
            for k in range(K - 1):
                at.append((z - t) / rho)
                if k + 1 < K - 1:
                    t = t + np.exp(of("cuts", k + 1))
            log_q = [log_below(-at[0])]
            log_q += [log_between(at[k], at[k + 1]) for k in range(K - 2)]
            log_q.append(log_below(at[-1]))
            log_g = np.stack([self.log_guess(theta[:, self.columns["guess"][k]])[:, :] for k in range(self.curves)], 1)[:, c]
        else:
            log_q, log_g = [np.zeros_like(z)], np.zeros(theta.shape[:1] + (len(c), 1))
        total = 0
        for r in range(K):
            guess = log_not + log_g[:, :, r]
            right, wrong = log_sum(log_seen + log_q[r], guess + np.log(self.chance)), guess + np.log1p(-self.chance)
            total = total + (self.counts[:, r] * right + self.counts[:, K + r] * wrong).sum(1)
        if K > 1 and self.references.any():
            total = total + (self.references * self.log_guess(theta[:, self.columns["guess"][0]])).sum(1)
        return total

    def value(self, theta):
        return self.log_likelihood(theta) + self.penalty(theta)

    def value_and_gradient(self, theta):
        h = 1e-30
        value = self.value(theta[None] + 1j * h * np.eye(self.size))
        return -value[0].real, -value.imag / h

    def starts(self, random):
        low, span = self.centre - self.range / 2, self.range
        for i in range(STARTS[self.number >= 219]):
            theta = np.zeros(self.size)
            theta[:self.curves] = low + span * random.uniform(-0.3, 1.3, self.curves)
            theta[self.columns["scale"]] = np.log(span / 12) + random.normal(0, 1)
            theta[self.columns["lapse"]] = random.normal(-1, 1)
            if self.K > 1:
                theta[self.columns["cuts"]] = random.normal(0, 0.7, self.K - 1)
                theta[self.columns["guess"]] = random.normal(-1, 0.5, self.K - 1)
            yield theta


def maximum(data):
    model, random, found = Model(data), np.random.default_rng(data["number"]), []
    scale = max(1.0, model.counts.sum() / 1000)
    def objective(theta):
        value, gradient = model.value_and_gradient(theta)
        return value / scale, gradient / scale
    with np.errstate(all="ignore"):
        for start in model.starts(random):
            step = minimize(objective, start, jac=True, method="BFGS", options=dict(gtol=1e-4, maxiter=300))
            if np.isfinite(step.fun):
                found.append((step.fun, step.x))
        found.sort(key=lambda f: f[0])
        x = found[0][1]
        for _ in range(30):  # Newton, Hessian by differences of the complex-step gradient
            f, g = model.value_and_gradient(x)
            if np.abs(g).max() < 1e-7 * scale:
                break
            H = np.array([(model.value_and_gradient(x + 1e-5 * e)[1] - model.value_and_gradient(x - 1e-5 * e)[1]) / 2e-5
                          for e in np.eye(model.size)])
            w, V = np.linalg.eigh((H + H.T) / 2)
            step = V @ ((V.T @ g) / np.maximum(np.abs(w), 1e-8))
            while not model.value_and_gradient(x - step)[0] < f and np.abs(step).max() > 1e-12:
                step = step / 4
            if not model.value_and_gradient(x - step)[0] < f:
                break
            x = x - step
    value = -model.value_and_gradient(x)[0]
    near = sum(abs(-f * scale - value) < 1e-3 for f, _ in found)
    return dict(maximum=float(value), log_likelihood=float(model.log_likelihood(x[None])[0].real), found_by=near)


def simulated(random, x, curves, answers, K=4, m=None, s=0.5, lapse=0.02, g=(0.8, 0.15, 0.04, 0.01), chance=1 / 3, t=(0, 1, 2)):
    cells, counts = [], []
    g = np.array(g[:K]) / sum(g[:K])
    for c in range(curves):
        at = m[c] if m is not None else random.uniform(min(x), max(x))
        for level in x:
            z = (at - level) / s
            psi = (1 - lapse) * ndtr(z)
            above = [1] + [ndtr(z - v) for v in t[:K - 1]] + [0]
            q = -np.diff(above)
            p = np.concatenate([psi * q + (1 - psi) * chance * g, (1 - psi) * (1 - chance) * g])
            cells.append([c, float(level), chance])
            counts.append(random.multinomial(answers, p / p.sum()).tolist())
    return cells, counts


PAPER = [6.0, 7, 8, 9, 10, 11, 12]
QUICK = [6.0, 8, 9, 10, 12]


def hard_set(number):
    random = np.random.default_rng([42, number])
    kinds = ["ordinary", "step", "two levels", "empty cells", "all guess", "all right", "few", "huge", "extreme levels",
             "beyond the levels", "ratings", "noise", "own parameters", "chance and references", "nothing to see"]
    kind = kinds[number % len(kinds)]
    data = dict(number=number, kind=kind, people=int(random.choice([5, 10, 20])), ratings=4, shared="1111", references=[0] * 4)
    x = list(random.choice([0, 1]) and PAPER or QUICK)
    curves = int(random.choice([1, 2, 4]))
    answers = 3 * data["people"]
    if kind == "step":
        cells, counts = [], []
        for c in range(curves):
            step = random.integers(1, len(x))
            for i, level in enumerate(x):
                cells.append([c, level, 1 / 3])
                third = answers // 3
                high = int(random.integers(0, 4))
                row = [0] * 8
                if i < step:
                    row[high if number % 2 else 3] = answers
                else:
                    row[0], row[4] = third, answers - third
                counts.append(row)
    elif kind == "two levels":
        cells, counts = simulated(random, [x[1], x[-2]], curves, answers, s=random.uniform(0.2, 2))
    elif kind == "empty cells":
        cells, counts = simulated(random, x, curves, answers)
        for i in range(len(counts)):
            if random.random() < 0.4:
                counts[i] = [0] * 8
    elif kind == "all guess":
        cells, counts = simulated(random, x, curves, answers, m=[-50] * curves)
    elif kind == "all right":
        cells, counts = simulated(random, x, curves, answers, m=random.uniform(x[0], x[-1], curves))
        for row in counts:
            for k in range(4):
                row[k], row[4 + k] = row[k] + row[4 + k], 0
    elif kind == "few":
        data["people"] = int(random.choice([2, 3]))
        cells, counts = simulated(random, x, curves, data["people"] * int(random.choice([1, 3])))
    elif kind == "huge":
        cells, counts = simulated(random, x, curves, int(random.choice([10**4, 10**6])), s=random.uniform(0.1, 1.5))
    elif kind == "extreme levels":
        a, b = [(1e-3, 0), (200.0, 0), (1.0, 1e4), (1.0, -40), (30.0, 5000)][number // len(kinds) % 5]
        cells, counts = simulated(random, x, curves, answers)
        cells = [[c, a * (v - 9) + b, p] for c, v, p in cells]
    elif kind == "beyond the levels":
        cells, counts = simulated(random, x, curves, answers, m=random.choice([x[0] - 1.5, x[-1] + 1, x[-1] + 3], curves))
    elif kind == "ratings":
        K = int(random.choice([1, 2, 3]))
        data["ratings"], data["references"] = K, [0] * K
        cells, counts = simulated(random, x, curves, answers, K=K)
        if number % 2:  # one rating only
            counts = [[sum(r[:K])] + [0] * (K - 1) + [sum(r[K:])] + [0] * (K - 1) for r in counts]
    elif kind == "noise":
        cells, counts = simulated(random, x, curves, 1)
        counts = [random.multinomial(answers, random.dirichlet(np.full(8, 0.5))).tolist() for _ in counts]
    elif kind == "own parameters":
        curves = 2
        data["shared"] = str(random.choice(["0111", "1011", "1101", "1110", "0000", "0011"]))
        cells, counts = simulated(random, x, curves, answers, s=random.uniform(0.3, 1))
    elif kind == "chance and references":
        cells, counts = simulated(random, x, curves, answers, chance=float(random.choice([0.5, 0.25, 0.1])))
        data["references"] = random.multinomial(30, [0.6, 0.2, 0.15, 0.05]).tolist()
    elif kind == "nothing to see":
        cells, counts = simulated(random, x, 1, answers)
        cells.append([0, None, 1 / 3])
        counts.append(random.multinomial(answers, [0.3, 0.03, 0, 0, 0.6, 0.07, 0, 0]).tolist())
    else:
        cells, counts = simulated(random, x, curves, answers, s=random.uniform(0.1, 1.5))
    data["cells"], data["counts"] = cells, counts
    return data


def solved(number):
    data = hard_set(number)
    return data | maximum(data)


if __name__ == "__main__":
    with Pool(int(sys.argv[1]) if len(sys.argv) > 1 else None) as pool:
        sets = []
        for one in pool.imap(solved, range(300)):
            sets.append(one)
            print(one["number"], one["kind"], one["maximum"], one["found_by"], flush=True)
    meta = dict(made_by="joint_maxima.py", model="documentation/explanation/joint_model.md", numpy=np.__version__,
                objective="log likelihood without multinomial coefficients, plus penalty",
                counts="a row a cell: right rated 1..K, wrong rated 1..K", cells="curve, x (null: nothing to see), chance",
                shared="scale, criteria, lapse, guess ratings")
    lines = ",\n".join(json.dumps(s, separators=(",", ":"), default=int) for s in sets)
    Path(__file__).with_suffix(".json").write_text('{"meta": ' + json.dumps(meta) + ',\n"sets": [\n' + lines + "\n]}\n")
