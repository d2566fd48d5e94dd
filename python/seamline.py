"""Seamline from Python: commands, answers, thresholds and fits as plain structures.

One file, no dependencies, Python 3.9 or later. Copy it beside your script, or add its folder to PYTHONPATH.
The program `seamline` does the work; it is found on the PATH, or where SEAMLINE names it.

    import seamline

    seamline.run("render", "study.toml", out="set")
    seamline.run("study", "set", log="answers.sqlite", observer="threshold", count=20)
    for threshold in seamline.thresholds("answers.sqlite"):
        print(threshold.curve, threshold.quantity, threshold.estimate, threshold.ci95)

What the program refuses is a SeamlineError whose text is the program's own sentence.
"""

from __future__ import annotations

import csv
import json
import os
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

__all__ = ["SeamlineError", "run", "read_table", "answers", "participants", "Threshold", "thresholds",
           "Fit", "Parameter", "fit"]

PathLike = Union[str, "os.PathLike[str]"]


class SeamlineError(RuntimeError):
    """A command ended with a status other than 0. `status` is 1 for wrong input, 2 for a bug, 130 for a stop."""

    def __init__(self, sentence: str, status: int):
        super().__init__(sentence)
        self.status = status


def _words(options: Mapping[str, Any]) -> list[str]:
    """Keyword arguments as options: at=(0, 1, 2) is --at 0 1 2, rest=True is --rest, and None is left out."""
    words: list[str] = []
    for name, value in options.items():
        flag = "--" + name.rstrip("_").replace("_", "-")
        if value is None or value is False:
            continue
        words.append(flag)
        if value is True:
            continue
        values = value if isinstance(value, (list, tuple)) else [value]
        words += [str(one) for one in values]
    return words


def run(command: str, *arguments: PathLike, **options: Any) -> str:
    """Run one command and return what it prints.

    `command` may be two words ("lab convergence"). `arguments` are its positional arguments. Underscores of
    option names are dashes: run("composite", depth_kind="planar"). A name that is a word of Python ends in an
    underscore. Progress is not shown. Ctrl-C stops the command as in a shell; run it again to go on.
    """
    program = os.environ.get("SEAMLINE", "seamline")
    line = [program, *command.split(), *(os.fspath(one) for one in arguments), *_words(options)]
    try:
        process = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8")
    except FileNotFoundError:
        raise SeamlineError(f"{program}: no such program; install Seamline or set SEAMLINE to its path", 1) from None
    with process:
        try:
            printed, said = process.communicate()
        except KeyboardInterrupt:
            process.wait()  # the program had the same signal; it stops after its current piece
            raise
    if process.returncode != 0:
        sentences = [one for one in said.splitlines() if one.startswith("seamline: ")]
        sentence = sentences[-1][len("seamline: "):] if sentences else said.strip()
        raise SeamlineError(sentence or f"{command} ended with status {process.returncode}", process.returncode)
    return printed


# Columns of exported tables that hold numbers. All others are text, codes of participants too: 007 is not 7.
_WHOLE = {"trial_index", "object_index", "chosen_index", "right_index", "correct", "rating", "noticeability",
          "slot", "restarts"}
_YES_NO = {"completed", "excluded", "pilot", "simulated"}
_NUMBERS = {"level", "choice_s", "rating_s", "image_scale"}


def _value(column: str, text: str) -> Any:
    if column in _WHOLE:
        return int(text) if text else None
    if column in _NUMBERS:
        return float(text) if text else None
    if column in _YES_NO:
        return text == "1"
    return text


def read_table(path: PathLike) -> list[dict[str, str]]:
    """A CSV file of a report or an export: one dictionary of text a row. data_dictionary.csv explains columns."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _exported(log: PathLike, name: str) -> list[dict[str, Any]]:
    with tempfile.TemporaryDirectory() as folder:
        run("export", "tables", log, str(Path(folder) / "tables"))
        rows = read_table(Path(folder) / "tables" / name)
    return [{column: _value(column, text) for column, text in row.items()} for row in rows]


def answers(log: PathLike) -> list[dict[str, Any]]:
    """Every answer to a stimulus in a log, also of people who are excluded or trial runs.

    Keys are the columns of `seamline export tables`: participant, stimulus_id, scene, artifact, object,
    condition, level, correct, rating, noticeability, choice_s, rating_s, ...
    """
    return _exported(log, "answers.csv")


def participants(log: PathLike) -> list[dict[str, Any]]:
    """Everybody in a log, with their answers to the form."""
    return _exported(log, "participants.csv")


@dataclass(frozen=True)
class Threshold:
    """A threshold of the joint model, as `seamline analyze` states it first."""

    artifact: str
    condition: str  #: empty where the study has one
    quantity: str  #: "PT", "SN", "IP", "PT corrected", "SN corrected" or "detection"
    estimate: Optional[float]  #: in `unit`; None: see `reason`
    ci95: tuple[Optional[float], Optional[float]]  #: over participants; None at an open end
    simultaneous_ci95: tuple[Optional[float], Optional[float]]  #: holds together with all other curves'
    unit: str  #: of the study's level, for example "px"
    reason: str  #: why there is no estimate
    paper_way: Optional[float]  #: the same threshold by straight lines between the tested levels
    source: str  #: whether people or simulated observers answered

    @property
    def curve(self) -> str:
        return f"{self.artifact}, {self.condition}" if self.condition else self.artifact


def _number(text: Optional[str]) -> Optional[float]:
    return float(text) if text else None


def thresholds(log: PathLike, out: Optional[PathLike] = None, **options: Any) -> list[Threshold]:
    """Analyze a log, and return the thresholds of its report.

    `out` keeps the report's folder; without it the report is not kept. Options are those of
    `seamline analyze`, for example exclude_inattentive=True.
    """
    with tempfile.TemporaryDirectory() as folder:
        report = Path(out) if out is not None else Path(folder) / "report"
        run("analyze", log, out=str(report), **options)
        rows = read_table(report / "thresholds_joint.csv")
    found = []
    for row in rows:
        estimate = next(name for name in row if name.startswith("estimate"))
        unit = estimate[len("estimate"):].lstrip("_")
        suffix = "_" + unit if unit else ""

        def pair(name: str) -> tuple[Optional[float], Optional[float]]:
            return _number(row[f"{name}_low{suffix}"]), _number(row[f"{name}_high{suffix}"])

        found.append(Threshold(artifact=row["artifact"], condition=row.get("condition") or "",
                               quantity=row["quantity"], estimate=_number(row[estimate]), ci95=pair("ci95"),
                               simultaneous_ci95=pair("simultaneous"), unit=unit, reason=row["reason"],
                               paper_way=_number(row.get(f"paper_way{suffix}")), source=row["source"]))
    return found


@dataclass(frozen=True)
class Parameter:
    estimate: Optional[float]  #: None: see `reason`
    ci95: tuple[Optional[float], Optional[float]]
    reason: Optional[str] = None


@dataclass(frozen=True)
class Fit:
    """A psychometric function fitted to counts."""

    verdict: str  #: "identified", or why the data do not say where the threshold is
    threshold: Parameter  #: on the axis of the levels
    width: Parameter
    lapse: Parameter
    guess: Parameter
    deviance: Optional[float]
    deviance_p: Optional[float]
    warnings: list[str] = field(default_factory=list)
    json: dict[str, Any] = field(default_factory=dict, repr=False)  #: everything that `seamline fit --json` says


def fit(counts: Iterable[Sequence[float]], alternatives: int, **options: Any) -> Fit:
    """Fit a psychometric function to rows of level, number of correct answers, and number of trials.

    `alternatives` of the forced choice; 1 is yes/no. Options are those of `seamline fit`, for example
    sigmoid="logistic", axis="linear", lapse="free:0.05".
    """
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "counts.csv"
        with open(data, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["level", "correct", "trials"])
            writer.writerows([repr(float(level)), int(correct), int(trials)] for level, correct, trials in counts)
        found = json.loads(run("fit", data, alternatives=alternatives, json=True, **options))

    def parameter(name: str) -> Parameter:
        one = found.get(name) or {}
        low, high = one.get("ci95") or (None, None)
        return Parameter(estimate=one.get("estimate"), ci95=(low, high), reason=one.get("reason"))

    return Fit(verdict=found["verdict"], threshold=parameter("threshold"), width=parameter("width"),
               lapse=parameter("lapse"), guess=parameter("guess"), deviance=found.get("deviance"),
               deviance_p=found.get("deviance_p"), warnings=found.get("warnings", []), json=found)
