#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Changes one sign, comparison or constant of the model at a time and sees whether a test notices.

What docs/testing.md lists as making no difference to any result is not counted: a mutant that nobody could catch. A
copy of the tree is built below build/mutate; the tree itself is not touched. A mutant is caught when a test fails,
crashes or takes far too long. The tests of the library are asked, until one fails: first the test of the file's own
name, then those of its folder, then the others, the quick ones before the slow ones.
"""
import argparse
import dataclasses
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutate"
BUILD = COPY / "build" / "release"  # as in the tree, so that a compiler cache serves both
# Of the sources, of their tests.
FOLDERS = {"model/ifs": ["ifs"], "model/attractor": ["attractor"], "model/animation": ["animation"],
           "model/collage": ["collage"], "model/document": ["document"], "model/io": ["io", "app"]}

NEGATED = {"<": ">=", ">=": "<", ">": "<=", "<=": ">", "==": "!=", "!=": "=="}
SIGNS = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
# clang-format puts blanks around binary operators and none around what is unary or a template's.
OPERATOR = re.compile(r"(?<= )(<=|>=|==|!=|<|>|\+=|-=|\+|-)(?= )")
NEGATION = re.compile(r"(?<=[(\[{, ])-(?=[A-Za-z_(])")
NUMBER = re.compile(r"(?<![\w.'<])(\d[\d']*\.?\d*(?:e-?\d+)?)(?![\w.'>])")
TRUTH = re.compile(r"\b(true|false)\b")
SKIPPED = re.compile(r"^\s*(#|static_assert|template\b|extern template|using |namespace |//)|BARYCAGE_INSTANTIATE")


def bare(text):
    """The text with comments, strings and characters blanked out, every place the same."""
    blank = lambda match: re.sub(r"[^\n]", "\0", match.group())
    pattern = r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9])\'(?:\\.|[^\'\\\n])+\''
    return re.sub(pattern, blank, text, flags=re.S)


def constant(text):
    if "." in text or "e" in text:
        return text + " + 1" if float(text.replace("'", "")) < 0.5 else "0.5 * " + text
    return {"0": "1", "1": "0"}.get(text, str(int(text.replace("'", "")) + 1))


def mutants(path):
    """(place, length, replacement) for everything that can be flipped in a file."""
    text = path.read_text()
    found = []
    start = 0
    for line in bare(text).splitlines(keepends=True):
        if not SKIPPED.search(line):
            for m in OPERATOR.finditer(line):
                found.append((start + m.start(), len(m.group()), {**NEGATED, **SIGNS}[m.group()]))
            for m in NEGATION.finditer(line):
                found.append((start + m.start(), 1, ""))
            for m in NUMBER.finditer(line):
                found.append((start + m.start(), len(m.group()), "(" + constant(m.group()) + ")"))
            for m in TRUTH.finditer(line):
                found.append((start + m.start(), len(m.group()), {"true": "false", "false": "true"}[m.group()]))
        start += len(line)
    return found


def examined():
    """(file, line as it was, line as it became) of the mutants listed in the documentation."""
    table = (ROOT / "docs" / "testing.md").read_text()
    rows = re.findall(r"^\| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \| [^|]+ \|$", table, flags=re.M)
    return {tuple(cell.replace("\\|", "|") for cell in row) for row in rows}


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **options).returncode


def prepare():
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in files.split():
        source, target = ROOT / name, COPY / name
        if source.is_file() and not (target.is_file() and target.read_bytes() == source.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)
    os.environ.update(CCACHE_BASEDIR=str(COPY), CCACHE_NOHASHDIR="1")
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "--preset", "release", "-DBARYCAGE_GUI=OFF", "-DBARYCAGE_TESTS=ON", *launcher], cwd=COPY,
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD], check=True, stdout=subprocess.DEVNULL)  # ctest lists what is there


@dataclasses.dataclass(frozen=True)
class Test:
    name: str
    command: tuple  # the program and its arguments


def tests_in(folder):
    """The tests that are quick enough to be run for every mutant."""
    listing = subprocess.run(["ctest", "--show-only=json-v1"], cwd=BUILD / "tests" / folder, check=True,
                             capture_output=True, text=True).stdout
    slow = {"name": "LABELS", "value": ["slow"]}
    return [Test(test["name"], tuple(test["command"])) for test in json.loads(listing)["tests"]
            if slow not in test["properties"] and test["command"][0].startswith(str(BUILD))]


class Judge:
    """Builds and runs the tests of some folders against the copy as it is."""

    def __init__(self, folders):
        self.tests = [test for folder in folders for test in tests_in(folder)]
        self.seconds = {}
        self.environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
        if self.build() != 0:
            sys.exit(f"the tests of {folders} cannot be built")
        for test in self.tests:
            began = time.monotonic()
            if not self.passes(test, 600):
                sys.exit(f"{test.name} fails already")
            self.seconds[test] = time.monotonic() - began

    def build(self):
        programs = {Path(test.command[0]).name for test in self.tests}
        return run(["cmake", "--build", BUILD, "--target", *programs])

    def passes(self, test, limit):
        try:
            return run(test.command, cwd=Path(test.command[0]).parent, timeout=limit, env=self.environment) == 0
        except subprocess.TimeoutExpired:
            return False

    def verdict(self, name):
        source = Path(name)
        near = {path.stem for path in (ROOT / "tests").rglob(f"{source.parent.name}/*_test.cpp")}
        nearest = lambda test: (test.name != source.stem + "_test", test.name not in near, self.seconds[test])
        if self.build() != 0:
            return "does not compile"
        for test in sorted(self.tests, key=nearest):
            if not self.passes(test, 20 + 10 * self.seconds[test]):
                return "caught"
        return "survived"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", help="sources (all of model/ without)")
    parser.add_argument("--sample", type=int, help="so many mutants, chosen at random")
    parser.add_argument("--minutes", type=float, default=math.inf, help="begin no mutant after that")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--report", type=Path, help="write the survivors to this file")
    arguments = parser.parse_args()

    files = arguments.files or [str(path.relative_to(ROOT)) for folder in FOLDERS
                                for path in sorted((ROOT / folder).rglob("*.cpp"))]
    all_mutants = [(name, mutant) for name in files for mutant in mutants(ROOT / name)]
    random.Random(arguments.seed).shuffle(all_mutants)  # so that what comes first is a fair sample
    all_mutants = all_mutants[:arguments.sample]
    prepare()
    end = time.monotonic() + 60 * arguments.minutes
    judges = {}
    counts = {"caught": 0, "survived": 0, "makes no difference": 0, "does not compile": 0}
    harmless = examined()
    survivors = []
    for number, (name, (place, length, replacement)) in enumerate(all_mutants, 1):
        if time.monotonic() > end:
            break
        folder = next(folder for folder in FOLDERS if name.startswith(folder + "/"))
        judge = judges.get(folder) or judges.setdefault(folder, Judge(FOLDERS[folder]))
        text = (ROOT / name).read_text()
        line = text.count("\n", 0, place) + 1
        changed = text[:place] + replacement + text[place + length:]
        was, shown = (version.splitlines()[line - 1].strip() for version in (text, changed))
        try:
            (COPY / name).write_text(changed)
            verdict = "makes no difference" if (name, was, shown) in harmless else judge.verdict(name)
        finally:
            (COPY / name).write_text(text)
        counts[verdict] += 1
        print(f"{number}/{len(all_mutants)} {verdict}: {name}:{line}: {shown}", flush=True)
        if verdict == "survived":
            survivors.append(f"| `{name}` | `{was}` | `{shown}` |".replace("||", r"\|\|"))
    judged = counts["caught"] + counts["survived"]
    share = f"{counts['caught']} of {judged} mutants were caught"
    share += f" ({100 * counts['caught'] / judged:.0f} %)" if judged else ""
    print(f"{share}; {counts['makes no difference']} make no difference, {counts['does not compile']} did not compile")
    if arguments.report:
        arguments.report.write_text("\n".join([share + ".", "", "| where | was | became |", "|---|---|---|",
                                               *sorted(survivors)]) + "\n")


if __name__ == "__main__":
    main()
