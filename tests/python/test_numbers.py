# SPDX-License-Identifier: MIT
import math
import pickle

import barycage as bc
import numpy as np
import pytest


def test_known_numbers(triangle):
    assert triangle.dimension == pytest.approx(math.log(3, 2), abs=1e-12)
    assert triangle.dimension.kind == "similarity" and 0 <= triangle.dimension.error < 1e-6
    mean, covariance = triangle.moments()
    assert mean == pytest.approx([1 / 3, 1 / 3], abs=1e-15)
    assert covariance == pytest.approx(np.array([[2, -1], [-1, 2]]) / 27, abs=1e-15)
    assert triangle.moments().mean_error < 1e-12
    assert triangle.classify() == ("hyperbolic", .5, 1, triangle.classify().witness)


def test_certified_numbers_are_numbers(triangle):
    number = triangle.dimension
    assert number + 1 == float(number) + 1
    again = pickle.loads(pickle.dumps(number))
    assert (again, again.error, again.kind) == (number, number.error, number.kind)


def test_hull(triangle, cube):
    hull = triangle.hull(1e-9)
    assert sorted(map(tuple, hull.vertices.round(9).tolist())) == [(0, 0), (0, 1), (1, 0)]
    assert hull.facets is None and hull.size == pytest.approx(.5) and hull.error <= 1e-9
    solid = cube.hull(1e-6)
    assert len(solid.vertices) == 8 and solid.facets.shape[1] == 3 and solid.size == pytest.approx(1)
    with pytest.raises(ValueError):
        triangle.hull(0)


def test_the_attractor_lies_in_its_box_and_hull(maple):
    x, _ = maple.points(20_000, seed=3)
    box = maple.box
    assert (x >= box.min - box.error).all() and (x <= box.max + box.error).all()
    vertices = maple.hull(1e-6).vertices
    edges = np.roll(vertices, -1, axis=0) - vertices
    inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
    heights = np.einsum("nd,md->nm", x, inward) - (vertices * inward).sum(axis=1)
    assert heights.min() > -1e-5


def test_support_and_address(maple):
    support = maple.support([0, 1])
    assert float(support) == pytest.approx(maple.box.max[1], abs=1e-9) and support.error >= 0
    assert support.point[1] == pytest.approx(float(support), abs=1e-9)
    address = maple.address(support.point)
    assert address[:5] == support.address[:5] and address.distance < 1e-3
    assert maple.address([1e3, 0]) is None


def test_affinity_dimension(maple):
    assert maple.dimension == 2 and maple.dimension.kind == "affinity"  # 2.036 by the formula
    # Falconer's formula by hand: of φ(A) = ab^(t − 1), two maps of half the width and a third of the height.
    brush = bc.Entry([[[1 / 2, 0, 0], [0, 1 / 3, 0]], [[1 / 2, 0, .5], [0, 1 / 3, .5]], [[1 / 2, 0, 0], [0, 1 / 3, .5]]])
    assert brush.dimension == pytest.approx(1 + math.log(3 / 2, 3), abs=2e-6) and brush.dimension.error == 1e-6


def test_no_dimension_in_space():
    flat = bc.Entry([np.column_stack([np.diag([.5, .4, .3]), [0, 0, 0]]),
                     np.column_stack([np.diag([.3, .5, .4]), [1, 0, 0]])])
    with pytest.raises(ValueError, match="dimension"):
        flat.dimension


@pytest.mark.parametrize("ask", [lambda e: e.box, lambda e: e.hull(), lambda e: e.dimension, lambda e: e.points(10),
                                 lambda e: e.density((8, 8)), lambda e: e.picture((8, 8)),
                                 lambda e: e.support([1, 0]), lambda e: e.moments()])
def test_without_an_attractor_the_witness_is_named(expanding, ask):
    assert expanding.classify().verdict == "none" and expanding.classify().witness == (1,)
    with pytest.raises(ValueError, match="order 1 "):
        ask(expanding)


def test_the_witness_counts_as_the_list_does():
    entry = bc.Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, 0], [0, .5, 1]], [[1.5, 0, 0], [0, .5, 0]]], [0, 1, 1])
    with pytest.raises(ValueError, match="order 3 "):
        entry.box
