# SPDX-License-Identifier: MIT
"""Iterated function systems: exact pictures, certified numbers, and files of Barycage and Fractint.

>>> import barycage as bc
>>> triangle = bc.Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, .5], [0, .5, 0]], [[.5, 0, 0], [0, .5, .5]]])
>>> triangle.dimension
1.584962500721156
>>> triangle.box
Box(min=array([0., 0.]), max=array([1., 1.]), error=...)
>>> triangle.density((64, 64), samples=10_000).sum()
10000

An entry is a value: it never changes, and what changes one returns another. Coordinates are those of the files: x to
the right, y up. Arrays of pictures have their rows from the top. Maps count from 1 in addresses, as in the window.
Whatever is random has a seed, and the same seed gives the same arrays on every machine, with any number of threads.

What cannot be parsed raises ValueError with line and column (ParseError), what cannot be opened OSError, and what asks
for the attractor of maps that have none a ValueError that names a word of them which does not contract. Calls that take
long release the interpreter's lock, and Ctrl+C stops them.
"""
from ._core import pixel_version
from .collection import Collection, ParseError, open, parse
from .entry import Address, Animation, Box, Certified, Classification, Entry, Hull, Moments, Support, Volume
from .making import density_batch, fit, random
from ._core import palettes

__all__ = [
    "Address", "Animation", "Box", "Certified", "Classification", "Collection", "Entry", "Hull", "Moments", "ParseError",
    "Support", "Volume", "density_batch", "fit", "open", "palettes", "parse", "pixel_version", "random",
]
