#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lists what makes a build slow: the steps that took longest, and the project's headers that bring most into sources.

usage: build_report.py BUILD_FOLDER

A step's seconds are those of the last time it ran, as Ninja's log has them: beside others, and little where a compiler
cache knew the answer (CCACHE_DISABLE=1). What a header brings is what all the sources that include it have in common.
"""
import functools
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROWS = 25


def steps(build):
    """(seconds, output) of each step, the longest first."""
    seconds = {}
    for line in (build / ".ninja_log").read_text().splitlines()[1:]:
        start, end, _, output, _ = line.split("\t")
        if (build / output).is_file():
            seconds[output] = (int(end) - int(start)) / 1000
    return sorted(((time, output) for output, time in seconds.items()), reverse=True)


def dependencies(build):
    """The files that each source includes."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    included = {}
    for block in listing.split("\n\n"):
        first, *files = block.splitlines() or [""]
        if ".dir/" in first:
            included[first.split(":")[0]] = {(build / file.strip()).resolve() for file in files[1:]}
    return included


@functools.cache
def lines(path):
    return path.read_bytes().count(b"\n") if path.is_file() else 0


def headers(build, root):
    """(lines in all sources together, sources, files brought, header) for each header of the project."""
    brought, sources = {}, defaultdict(int)
    for files in dependencies(build).values():
        for header in files:
            if header.suffix == ".h" and header.is_relative_to(root) and not header.is_relative_to(build):
                brought[header] = brought[header] & files if header in brought else files
                sources[header] += 1
    return sorted(((sources[h] * sum(map(lines, files)), sources[h], len(files), str(h.relative_to(root)))
                   for h, files in brought.items()), reverse=True)


def main():
    build = Path(sys.argv[1]).resolve()
    root = Path(__file__).resolve().parent.parent
    every = steps(build)
    print(f"{len(every)} steps, {sum(seconds for seconds, _ in every) / 60:.0f} minutes one after the other\n")
    print("seconds  step")
    for seconds, output in every[:ROWS]:
        print(f"{seconds:7.1f}  {output}")
    print("\n  lines  sources  files  header (lines: thousands, of what it brings, in all sources together)")
    for total, sources, files, header in headers(build, root)[:ROWS]:
        print(f"{total / 1000:7.0f}  {sources:7}  {files:5}  {header}")


main()
