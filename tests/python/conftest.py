# SPDX-License-Identifier: MIT
import pathlib

import barycage as bc
import numpy as np
import pytest

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture
def triangle():
    """Of Sierpinski, with right angles."""
    return bc.Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, .5], [0, .5, 0]], [[.5, 0, 0], [0, .5, .5]]],
                    name="triangle")


@pytest.fixture
def maple():
    return bc.open(ROOT / "ifs_library" / "paper.ifs")["maple"]


@pytest.fixture
def cube():
    """Eight of whose maps halve it."""
    corners = [(x, y, z) for x in (0, .5) for y in (0, .5) for z in (0, .5)]
    return bc.Entry([np.column_stack([np.eye(3) / 2, corner]) for corner in corners], name="cube")


@pytest.fixture
def expanding():
    """Its maps contract one by one or not at all, and the first one expands."""
    return bc.Entry([[[1.5, 0, 0], [0, .5, 0]], [[.5, 0, 1], [0, .5, 0]]], name="expanding")
