# SPDX-License-Identifier: MIT
"""The pictures and certified numbers of tests/data/hashes.txt, which are those of the window and of web pages."""
import json
import re
import struct

import barycage as bc
import numpy as np
import pytest

from conftest import ROOT

DATA = ROOT / "tests" / "data"
GROUPS = {0: "none", 1: "mirror", 2: "c{}", 3: "d{}", 4: "tetrahedral", 5: "octahedral", 6: "icosahedral"}


def entry_of(system):
    """An entry of hash_systems.json, which is that of a web page."""
    dimension = system["dimension"]
    rows = [row + [np.nan] * (dimension * (dimension + 1) + 1 - len(row)) for row in system["maps"]]
    rows = np.array(rows, np.float64)
    linear = rows[:, :dimension ** 2].reshape(-1, dimension, dimension)
    maps = np.concatenate([linear, rows[:, dimension ** 2:-1, None]], axis=2)
    symmetry = "none"
    if "symmetry" in system:
        given = system["symmetry"]
        symmetry = GROUPS[given["group"]].format(given["order"]) + "@" + ",".join(map(repr, given["centre"]))
    entry = bc.Entry(maps, rows[:, -1], name=system["name"], symmetry=symmetry, links=system.get("links"))
    for branch in system.get("branches", []):
        change = np.array(branch["change"])
        entry = entry.branch([symbol + 1 for symbol in branch["word"]],
                             change[:dimension ** 2].reshape(dimension, dimension), change[dimension ** 2:])
    appearance = system.get("appearance", {})
    if appearance.get("mapColours"):
        lines = ["; barycage: colour-by map"] * (appearance.get("colourBy") == 1)
        for index, colour in appearance["mapColours"]:
            lines.append(f"; barycage: map-colour {index + 1} #{bytes(colour).hex()}")
        head, _, rest = str(entry).partition("\n")
        entry = bc.parse("\n".join([head, *lines, rest]))[0]
    if "cage" in system:
        entry = entry.caged(system["cage"]["rest"], system["cage"]["current"], bend=system["cage"]["bends"])
    return entry


def expected():
    """(entry, size, samples, lines) of every picture in the list."""
    systems = {each["entry"]["name"]: each["entry"] for each in json.loads((DATA / "hash_systems.json").read_text())}
    blocks = []
    for line in (DATA / "hashes.txt").read_text().splitlines():
        if not line.startswith(" "):
            blocks.append([])
        blocks[-1].append(line.split())
    for head, *lines in blocks:
        found = re.match(r"(.+) (\d+)x(\d+) (\d+) samples ", " ".join(head))
        if found and found[1] in systems:
            width, height, samples = map(int, found.groups()[1:])
            yield pytest.param(systems[found[1]], (height, width), samples, [head, *lines],
                               id=f"{found[1]} {width}x{height}")


def number(word):
    return struct.unpack(">d", bytes.fromhex(word))[0]


def the_hash(lines, first):
    return next(int(line[-1], 16) for line in lines if line[0] == first)


CASES = list(expected())


def test_the_list_is_read():
    assert len(CASES) > 20


@pytest.mark.parametrize("system, shape, samples, lines", CASES)
def test_certified_numbers(system, shape, samples, lines):
    bits = [number(line[2]) for line in lines if line[0] == "box"]
    box = entry_of(system).box
    ours = [*box.min, *box.max, box.error][:len(bits)]
    assert [float(each).hex() for each in ours] == [each.hex() for each in bits]


@pytest.mark.parametrize("system, shape, samples, lines",
                         [case for case in CASES if case.values[0]["dimension"] == 2])
def test_pictures(system, shape, samples, lines):
    height, width = shape
    box = [number(line[2]) for line in lines if line[0] == "box"]
    centre = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    scale = min(.9 * width / (box[2] - box[0]), .9 * height / (box[3] - box[1]))
    if "view" in system:
        *centre, scale = system["view"]
    look = {"samples": samples, "centre": tuple(centre), "scale": scale}
    entry = entry_of(system)
    assert entry.picture(shape, **look).hash == int(lines[0][-1], 16)

    corners = np.array([number(line[2]) for line in lines if line[0] == "tri"]).reshape(3, 2)
    rest, current = entry.cage or (corners, corners)
    dragged = current.copy().reshape(-1)
    dragged[[0, 2, 5]] += .1, .7, -.4
    assert entry.caged(rest, dragged.reshape(-1, 2)).picture(shape, **look).hash == the_hash(lines, "dragged")
