# SPDX-License-Identifier: MIT
import copy
import pickle

import barycage as bc
import numpy as np
import pytest

from conftest import ROOT


def test_the_collection_opens():
    files = sorted((ROOT / "ifs_library").glob("*.ifs"))
    assert len(files) > 5
    for path in files:
        for entry in bc.open(path):
            text = str(entry)
            assert bc.parse(text)[0] == entry, path
            assert entry.maps.shape == (len(entry.weights), entry.space_dimension, entry.space_dimension + 1)


def test_by_name_and_by_index(maple):
    paper = bc.open(ROOT / "ifs_library" / "paper.ifs")
    assert paper["MAPLE"] == maple == paper[paper.names.index("maple")]
    assert "maple" in paper and maple in paper and "none of these" not in paper
    assert [entry.name for entry in paper[:2]] == paper.names[:2]
    with pytest.raises(KeyError):
        paper["none of these"]


def test_values(maple):
    assert maple.maps.shape == (4, 2, 3) and maple.maps.dtype == np.float64
    assert maple.maps[0].tolist() == [[-.04, 0, -.08], [-.23, -.65, .26]]
    assert maple.probabilities.sum() == pytest.approx(1, abs=1e-15)
    assert copy.deepcopy(maple) is maple and pickle.loads(pickle.dumps(maple)) == maple
    assert hash(maple) == hash(pickle.loads(pickle.dumps(maple)))
    other = bc.Entry(maple.maps, maple.weights, name="maple")
    assert other != bc.Entry(maple.maps * .9, maple.weights, name="maple")
    array = maple.maps
    array[:] = 0  # a copy
    assert maple.maps[0, 0, 0] == -.04


def test_typed_coefficients_are_read():
    entry = bc.parse("a {\n; barycage: exact 1 a 1/3\n; barycage: exact 1 e sqrt(3)/6\n"
                     " 0.3333333333333333 0 0 .5 .28867513459481287 0 1\n}")[0]
    assert "exact 1 a 1/3" in str(entry) and "exact 1 e sqrt(3)/6" in str(entry)


@pytest.mark.parametrize("text, line, column, words", [
    ("a {\n.5 0 0 .5 0 0 1\n.5 0 x .5 0 0 1\n}", 3, 6, "“x”"),
    ("a {\n\t1/3 0 0 1 0 0 1\n}", 2, 2, "“1/3”"),
    ("a {\n.5 0 0 .5 0 0 1\n.5 0 0\n}", 3, 1, "Numbers are missing"),
    ("b { .5 0 0 .5 0 0 1", 1, 3, "closing"),
    ("", 1, 1, "No iterated function system"),
])
def test_errors_say_where(text, line, column, words):
    with pytest.raises(ValueError) as caught:
        bc.parse(text)
    assert (caught.value.line, caught.value.column) == (line, column)
    assert f"line {line}, column {column}" in str(caught.value) and words in str(caught.value)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_files_that_cannot_be_opened(tmp_path):
    with pytest.raises(FileNotFoundError):
        bc.open(tmp_path / "nothing.ifs")
    with pytest.raises(OSError):
        bc.open(tmp_path)


def test_a_damaged_entry_leaves_the_others(tmp_path):
    path = tmp_path / "two.ifs"
    path.write_text("bad {\n 1 2 three\n}\ngood {\n .5 0 0 .5 0 0 1\n}\n")
    two = bc.open(path)
    assert two["good"].maps.shape == (1, 2, 3) and two.names == ["bad", "good"]
    with pytest.raises(bc.ParseError, match="line 2, column 6"):
        two["bad"]


@pytest.mark.parametrize("maps", [[], [[1, 2, 3]], [[[1, 2], [3, 4]]], [[[np.nan, 0, 0], [0, 1, 0]]],
                                  np.zeros((2, 4, 5))])
def test_maps_of_another_shape(maps):
    with pytest.raises(ValueError):
        bc.Entry(maps)


def test_symmetry_and_links():
    flower = bc.Entry([[[.4, 0, .5], [0, .4, 0]]], symmetry="c5@0.1,-0.2")
    assert flower.symmetry == "c5" and bc.parse(str(flower))[0] == flower
    with pytest.raises(ValueError, match="c99"):
        bc.Entry([[[.4, 0, .5], [0, .4, 0]]], symmetry="c99")
    matrix = [[0, 1], [1, 1]]
    linked = bc.Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, .5], [0, .5, 0]]], links=matrix)
    assert linked.links.tolist() == matrix
    _, address = linked.points(1000)
    first = address < .5  # the last map applied was the first one
    assert 200 < first.sum() < 500 and not (first[:-1] & first[1:]).any()
