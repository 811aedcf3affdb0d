# SPDX-License-Identifier: MIT
"""Many systems at once, systems by chance, and systems for a picture."""
from __future__ import annotations

import math
from typing import Any, Optional, Union

import numpy as np

from . import _core
from .entry import Entry, Shape


def density_batch(systems: Any, shape: Shape = (256, 256), *, samples: int = 100_000, weights: Any = None,
                  seed: int = 1, threads: int = 0) -> np.ndarray:
    """Densities of many systems of the plane with as many maps each: uint32 (systems, rows, columns), for training sets.

    systems  (k, n, 2, 3); entries with as many maps do as well
    weights  (k, n); without them, the determinants, of at least a hundredth of their sum

    Each picture shows all of its points with a margin of a twentieth. Unlike density(), it looks for no certified box:
    that, and not the points, is what takes long of a small picture. System k has the seed `seed` + k.

    >>> systems = np.stack([random(maps=3, seed=seed).maps for seed in range(4)])
    >>> density_batch(systems, (32, 32), samples=1000).sum(axis=(1, 2))
    array([1000, 1000, 1000, 1000], dtype=uint64)
    """
    if isinstance(systems, (list, tuple)) and systems and isinstance(systems[0], Entry):
        if weights is None:
            weights = np.stack([entry.probabilities for entry in systems])
        systems = np.stack([entry.maps for entry in systems])
    return _core.density_batch(np.asarray(systems, np.float64),
                               None if weights is None else np.asarray(weights, np.float64), shape, samples, seed,
                               threads)


def random(*, maps: Optional[int] = None, seed: int, alpha: Optional[float] = None) -> Entry:
    """A system of the plane by chance, of maps that contract.

    Of its N maps, with singular values σ₁ ≥ σ₂, the sum of σ₁ + 2σ₂ is alpha: uniform in [(5 + N)/2, (6 + N)/2] unless it
    is given. Such attractors have good shapes (Anderson and Farrell, Improving Fractal Pre-training, WACV 2022). The
    angles, mirrors and translations are uniform. Two to five maps unless they are given.

    >>> random(maps=3, seed=7) == random(maps=3, seed=7)
    True
    """
    chance = np.random.Generator(np.random.PCG64(seed))
    count = int(chance.integers(2, 6)) if maps is None else maps
    if count < 2:
        raise ValueError("maps: at least 2")
    total = chance.uniform((5 + count) / 2, (6 + count) / 2) if alpha is None else float(alpha)
    if not 0 < total < 3 * count:
        raise ValueError("alpha: above 0, and below 3 for each map")
    # Each map gets what leaves the others something between 0 and 3.
    singular = np.empty((count, 2))
    left = total
    for index in range(count):
        others = count - index - 1
        share = chance.uniform(max(0.0, left - 3 * others), min(3.0, left)) if others else left
        left -= share
        smaller = chance.uniform(max(0.0, (share - 1) / 2), share / 3)
        singular[index] = share - 2 * smaller, smaller
    turns = chance.uniform(0, 2 * math.pi, (count, 2))
    mirrors = chance.choice([-1.0, 1.0], (count, 2))

    def rotation(angle: float) -> np.ndarray:
        return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])

    result = np.empty((count, 2, 3))
    for index in range(count):
        result[index, :, :2] = (rotation(turns[index, 0]) @ np.diag(singular[index] * mirrors[index])
                                @ rotation(turns[index, 1]))
    result[:, :, 2] = chance.uniform(-1, 1, (count, 2))
    return Entry(result, name=f"random_{seed}")


def fit(mask: Any, *, maps: Union[int, tuple[int, int]] = 4, seconds: float = 2, starts: int = 0, seed: int = 0,
        threads: int = 1) -> list[Entry]:
    """Systems whose attractors look like a shape, best first: collages from many random starts.

    mask    (rows, columns), rows from the top: what is not 0 belongs to the shape
    maps    how many, or the least and the most
    starts  how many are made; 0: as many as fit into the time, which is not the same on every machine

    The height of the picture is 1 unit, y is up, and its middle is the origin.
    """
    least_and_most = (maps, maps) if isinstance(maps, int) else maps
    shape = np.ascontiguousarray(np.asarray(mask) != 0, dtype=np.uint8)
    return [Entry(found, weights, name=f"fit_{index}")
            for index, (found, weights) in enumerate(_core.fit(shape, least_and_most, seconds, starts, seed, threads), 1)]
