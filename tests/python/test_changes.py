# SPDX-License-Identifier: MIT
from fractions import Fraction

import barycage as bc
import numpy as np
import pytest

from conftest import ROOT


def test_conjugation_moves_the_attractor(triangle):
    moved = triangle.conjugated([[2, 1], [0, 3]], [5, 7])
    corners = moved.hull(1e-9).vertices.round(6).tolist()
    assert sorted(corners) == [[5, 7], [6, 10], [7, 7]]
    assert moved == triangle.conjugated([[2, 1, 5], [0, 3, 7]])
    with pytest.raises(ValueError, match="inverted"):
        triangle.conjugated([[1, 0], [0, 0]])


def test_cages(triangle):
    rest = [[0, 0], [1, 0], [0, 1]]
    held = triangle.caged(rest, [[0, 0], [3, 0], [0, 1]])
    assert held.points(2000)[0][:, 0].max() > 2 and (held.maps == triangle.maps).all()
    assert held.cage[1].tolist() == [[0, 0], [3, 0], [0, 1]]
    assert (held.points(100)[0] == triangle.points(100)[0] * [3, 1]).all()
    assert bc.parse(str(held))[0] == held
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    bent = triangle.caged(square, [[0, 0], [1, 0], [2, 2], [0, 1]])
    assert bent.density((40, 40), samples=1000).sum() == 1000
    with pytest.raises(ValueError, match="cage"):
        triangle.caged([[0, 0], [1, 0], [2, 0]], rest)


def test_branches(triangle):
    moved = triangle.branch("2", np.eye(2), [10, 0])
    x, address = moved.points(3000)
    first = (address >= 1 / 3) & (address < 2 / 3)
    assert (x[first, 0] > 10).all() and (x[~first, 0] <= 1).all()
    assert bc.parse(str(moved))[0] == moved == triangle.branch([2], np.eye(2), [10, 0])
    assert moved.density((20, 80), samples=1000)[:, 70:].sum() > 0
    for word in ("4", "", "x", "0"):
        with pytest.raises(ValueError):
            triangle.branch(word, np.eye(2))


def test_morphs(triangle):
    other = triangle.conjugated([[0, -1], [1, 0]], [3, 0])
    for share, end in ((0, triangle), (1, other)):
        hull, wanted = (np.sort(entry.hull(1e-9).vertices.round(6), axis=0) for entry in
                        (triangle.morph(other, share), end))
        assert hull == pytest.approx(wanted, abs=1e-6)
    middle = triangle.morph(other, .5)
    assert middle.classify().verdict == "hyperbolic" and middle.hull().size == pytest.approx(.5, abs=.5)
    with pytest.raises(ValueError, match="share"):
        triangle.morph(other, 1.5)


def test_moments_between_keys():
    fern = bc.open(ROOT / "ifs_library" / "motion.ifs")["fern_unfolding"]
    assert fern.animation == (192, Fraction(24), "there-and-back", 192)
    first, last = fern.at(0), fern.at(96)
    assert first.maps[1].tolist() == [[.63, .42, 0], [-.42, .63, 1.6]] and last.maps[1].tolist() == fern.maps[1].tolist()
    assert (fern.at(192).maps == first.maps).all() and fern.at(16).maps[3] == pytest.approx(first.maps[3])
    assert (fern.at(48.5).maps == fern.at(Fraction(97, 2)).maps).all()
    assert not (fern.at(48.5).maps == fern.at(48).maps).all()
    assert first.animation is None and first.at(1000) is first and "animation" not in str(first)
    assert bc.parse(str(first))[0] == first
    for frame in (-1, 192.5, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="from 0 to 192"):
            fern.at(frame)


def test_every_motion_of_the_collection():
    moving = [entry for entry in bc.open(ROOT / "ifs_library" / "motion.ifs") if entry.animation]
    assert len(moving) == 15
    for entry in moving:
        middle = entry.at(entry.animation.frames // 3)
        lines = [line for line in str(entry).splitlines() if "barycage: track" in line or "barycage: motion" in line]
        only_looks = lines == ["; barycage: track camera"] or (entry.space_dimension == 3 and lines == ["; barycage: motion orbit"])
        assert middle.animation is None and (middle != entry.at(0)) != only_looks, entry.name
        assert len(middle.maps) == len(entry.maps)


def test_an_animation_that_does_not_fit():
    entry = bc.parse("a {\n; barycage: animation 10 24/1 off\n; barycage: track map 2\n; barycage: key 0 linear\n"
                     "; barycage: value 1 0 0 1 0 0\n .5 0 0 .5 0 0 1\n}")[0]
    with pytest.raises(ValueError, match="not understood"):
        entry.at(1)
    with pytest.raises(ValueError, match="not understood"):
        entry.animation


def test_tops(triangle):
    other = triangle.conjugated([[2, 0], [0, 2]], [1, 1])
    x, _ = triangle.points(200)
    assert triangle.top(triangle)(x) == pytest.approx(x, abs=1e-8)
    assert triangle.top(other)(x) == pytest.approx(2 * x + 1, abs=1e-7)
    assert np.isnan(triangle.top(other)([[9., 9.]])).all()
    with pytest.raises(ValueError, match="same number"):
        triangle.top(bc.random(maps=2, seed=1))(x)


@pytest.mark.parametrize("maps", [2, 3, 5, 8])
def test_random_systems_follow_the_rule(maps):
    for seed in range(20):
        entry = bc.random(maps=maps, seed=seed)
        singular = np.linalg.svd(entry.maps[:, :, :2], compute_uv=False)
        assert (singular < 1).all()
        assert (5 + maps) / 2 <= (singular @ [1, 2]).sum() <= (6 + maps) / 2
        assert entry.classify().verdict == "hyperbolic"
    assert bc.random(maps=maps, seed=1) != bc.random(maps=maps, seed=2)
    given = np.linalg.svd(bc.random(maps=maps, seed=1, alpha=2.5).maps[:, :, :2], compute_uv=False)
    assert (given @ [1, 2]).sum() == pytest.approx(2.5)


def test_fits(triangle):
    mask = triangle.density((64, 64), samples=200_000) > 0
    found = bc.fit(mask, maps=3, starts=20, seconds=600)
    assert found and found[0].maps.shape == (3, 2, 3)
    assert found[0] == bc.fit(mask, maps=3, starts=20, seconds=600, threads=2)[0]
    with pytest.raises(ValueError, match="mask"):
        bc.fit(np.zeros((8, 8)))
