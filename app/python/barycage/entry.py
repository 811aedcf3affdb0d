# SPDX-License-Identifier: MIT
"""One iterated function system, and what can be drawn and computed of it."""
from __future__ import annotations

import struct
import zlib
from fractions import Fraction
from typing import Any, Callable, NamedTuple, Optional, Union

import numpy as np

from . import _core, page

Shape = tuple[int, int]
Word = Union[str, "tuple[int, ...]", "list[int]"]


class Certified(float):
    """A number with a proved bound of its error: the exact one is no farther away than `error`."""

    error: float
    kind: str

    def __new__(cls, value: float, error: float, kind: str = ""):
        number = super().__new__(cls, value)
        number.error = error
        number.kind = kind
        return number

    def __getnewargs__(self):
        return float(self), self.error, self.kind


class Box(NamedTuple):
    """The attractor lies within `error` of the box, and reaches each face within it."""

    min: np.ndarray
    max: np.ndarray
    error: float


class Hull(NamedTuple):
    """The convex hull: the attractor lies within `error` of it, and every vertex is on the attractor.

    vertices  (n, d) float64, counter-clockwise in the plane
    facets    in space (m, 3) indices of vertices, counter-clockwise seen from outside; None in the plane
    size      area or volume, Certified
    """

    vertices: np.ndarray
    facets: Optional[np.ndarray]
    size: Certified
    error: float


class Classification(NamedTuple):
    """Whether the maps have an attractor.

    verdict        'hyperbolic', 'eventually contractive', 'none', 'undecided', or 'empty' without maps
    contractivity  a factor by which they contract; of 'none', at least 1
    word_length    all words of so many maps contract
    witness        numbers of maps, outermost first: of 'none', a word whose spectral radius is proved to be at least 1
    """

    verdict: str
    contractivity: float
    word_length: int
    witness: tuple[int, ...]


class Moments(tuple):
    """(mean, covariance) of the invariant measure, with proved bounds of what rounding has cost."""

    mean_error: float
    covariance_error: float
    long_run_covariance: np.ndarray

    @property
    def mean(self) -> np.ndarray:
        """(d,) float64."""
        return self[0]

    @property
    def covariance(self) -> np.ndarray:
        """(d, d) float64."""
        return self[1]


class Support(Certified):
    """max ⟨u, x⟩ over the attractor, with the `point` where it is reached, and its `address` as far as it is known."""

    point: np.ndarray
    address: tuple[int, ...]


class Address(tuple):
    """The numbers of the maps, outermost first, of a point within `distance`."""

    distance: float


class Volume(NamedTuple):
    """How many points lie in each cell: `counts` is uint32 (z, y, x), over the box from `min` to `max`."""

    counts: np.ndarray
    min: np.ndarray
    max: np.ndarray


class Animation(NamedTuple):
    """How an entry moves: `frames` to draw, from frame 0, so many of which pass in a second (`rate`).

    loop  'off', 'cycle' (the frame after the last one looks like frame 0) or 'there-and-back'
    last  the last frame that at() knows
    """

    frames: int
    rate: Fraction
    loop: str
    last: int


def _map(matrix: Any, translation: Any) -> np.ndarray:
    matrix = np.asarray(matrix, dtype=np.float64)
    if translation is None:
        return matrix
    return np.column_stack([matrix, np.asarray(translation, dtype=np.float64)])


def _word(word: Word) -> list[int]:
    if isinstance(word, str):
        parts = word.split() if " " in word.strip() else list(word.strip())
        if not all(part.isdecimal() for part in parts):
            raise ValueError("word: numbers of maps, such as '12' or '1 12'")
        return [int(part) for part in parts]
    return [int(number) for number in word]


def _png(rgba: np.ndarray) -> bytes:
    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    height, width, _ = rgba.shape
    rows = np.zeros((height, 1 + 4 * width), np.uint8)  # each behind its filter
    rows[:, 1:] = rgba.reshape(height, 4 * width)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))


class Picture(np.ndarray):
    """RGBA, uint8 (rows, columns, 4), straight (not premultiplied); a notebook shows it.

    `hash` is FNV-1a of the premultiplied pixels: the same on every machine for one `pixel_version`.
    """

    hash: Optional[int] = None  # of a whole picture

    def _repr_png_(self) -> Optional[bytes]:
        return _png(self) if self.ndim == 3 and self.shape[2] == 4 and self.dtype == np.uint8 else None


def _picture(rgba: np.ndarray, picture_hash: int) -> Picture:
    picture = rgba.view(Picture)
    picture.hash = picture_hash
    return picture


class Entry:
    """A system of affine maps of the plane or of space: an entry of an .ifs file.

    maps      (n, 2, 3), or (n, 3, 4) in space: of each map the linear part, and the translation as the last column
    weights   (n,); NaN or None where none is given: then the determinants say how often each map is applied
    symmetry  'none', 'mirror', 'c2' … 'c24', 'd2' … 'd24', in space 'tetrahedral', 'octahedral', 'icosahedral'; with
              an angle and a centre as in 'd3:30@1,0'
    links     (n, n) in the plane: factor of the weight of map j just after map i

    >>> dragon = Entry([[[.5, -.5, 0], [.5, .5, 0]], [[-.5, -.5, 1], [.5, -.5, 0]]], name="dragon")
    >>> print(dragon)
    dragon {
    ; barycage: version 1
    ; barycage: unweighted all
       0.5 -0.5 0.5  0.5 0 0 0.5
      -0.5 -0.5 0.5 -0.5 1 0 0.5
    }
    <BLANKLINE>
    >>> dragon == Entry(dragon.maps, name="dragon")
    True
    """

    _entry: _core.Entry

    def __init__(self, maps: Any, weights: Any = None, *, name: str = "unnamed", symmetry: str = "none",
                 links: Any = None):
        self._entry = _core.Entry(np.asarray(maps, np.float64),
                                  None if weights is None else np.asarray(weights, np.float64), name, symmetry,
                                  None if links is None else np.asarray(links, np.float64))

    @classmethod
    def _of(cls, entry: _core.Entry) -> Entry:
        self = cls.__new__(cls)
        self._entry = entry
        return self

    # What it consists of

    @property
    def name(self) -> str:
        return self._entry.name

    @property
    def space_dimension(self) -> int:
        """2 or 3."""
        return self._entry.dimension

    @property
    def maps(self) -> np.ndarray:
        """(n, 2, 3) or (n, 3, 4) float64: the linear parts, and the translations as the last column."""
        return self._entry.maps

    @property
    def weights(self) -> np.ndarray:
        """(n,) float64 as given: NaN where there is none, 0 for a map that is off."""
        return self._entry.weights

    @property
    def probabilities(self) -> np.ndarray:
        """(n,) float64, sum 1: how often the chaos game applies each map, if none are linked."""
        return self._entry.probabilities

    @property
    def links(self) -> Optional[np.ndarray]:
        """(n, n) float64: the weight of map j just after map i is multiplied by this; None without links."""
        return self._entry.links

    @property
    def symmetry(self) -> str:
        return self._entry.symmetry

    @property
    def cage(self) -> Optional[tuple[np.ndarray, np.ndarray]]:
        """(rest, current), each (corners, d) float64; None without a cage."""
        return self._entry.cage

    @property
    def animation(self) -> Optional[Animation]:
        """None where nothing moves. Raises ValueError where the lines of an animation are not understood."""
        found = _core.animation_facts(self._entry)
        if found is None:
            return None
        frames, last, rate, seconds, loop = found
        return Animation(frames, Fraction(rate, seconds), loop, last)

    def __str__(self) -> str:
        return self._entry.text()

    __repr__ = __str__

    def __eq__(self, other: object) -> bool:
        return self._entry == other._entry if isinstance(other, Entry) else NotImplemented

    def __hash__(self) -> int:
        return hash(str(self))

    def __copy__(self) -> Entry:
        return self  # it never changes

    def __deepcopy__(self, memo: dict) -> Entry:
        return self

    def __reduce__(self):
        return _from_text, (str(self),)

    # What is drawn: with its cage, and branches that are shown elsewhere

    def points(self, count: int, *, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
        """Points of the chaos game as (x, address): float64 (count, d), and (count,).

        They follow the invariant measure; the first 14 are left out. Of maps w₁ … w_N, the last of which was w_i, the
        address coordinate lies in [(i−1)/N, i/N]: it is Σ (σ_k − 1) N^−k, the newest map first.

        >>> x, address = Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, 1], [0, .5, 0]]]).points(1000)
        >>> x.shape, bool(((x[:, 0] > 1) == (address > .5)).all())
        ((1000, 2), True)
        """
        return _core.points(self._entry, count, seed)

    def density(self, shape: Shape, *, samples: int = 10_000_000, seed: int = 1,
                centre: Optional[tuple[float, float]] = None, scale: Optional[float] = None,
                threads: int = 0) -> np.ndarray:
        """How many of so many points of the invariant measure lie in each pixel: uint64 (rows, columns), from the top.

        centre   in the middle of the picture; with
        scale    pixels per unit; without them, all of the attractor is shown, with a margin of a twentieth
        samples  all of them lie in the view, however small it is: parts of the attractor outside take none
        threads  0: as many as the machine has; the result is the same

        Where a scale is given, a system without a certified extent can be drawn as well.
        """
        return _core.density(self._entry, _core.View(shape, centre, scale), samples, seed, threads)

    def picture(self, shape: Shape = (600, 800), *, samples: int = 1_000_000, seed: int = 1,
                centre: Optional[tuple[float, float]] = None, scale: Optional[float] = None, threads: int = 0,
                colour_by: Optional[str] = None, palette: Optional[str] = None, brightness: Optional[float] = None,
                gamma: Optional[float] = None, background: Optional[tuple[int, int, int, int]] = None) -> Picture:
        """The picture of `barycage-cli render`, in the colours of the entry where no others are given, without shadow.

        colour_by   'density', 'map', 'address', 'plain' or 'blend'
        palette     one of palettes()
        background  red, green, blue, opacity up to 255
        The other arguments are those of density().

        >>> Entry([[[.5, 0, 0], [0, .5, 0]], [[.5, 0, 1], [0, .5, 1]]]).picture((30, 40)).shape
        (30, 40, 4)
        """
        entry = _core.coloured(self._entry, colour_by, palette, brightness, gamma, background)
        return _picture(*_core.picture(entry, _core.View(shape, centre, scale), samples, seed, threads))

    def solid(self, shape: Shape = (600, 800), *, azimuth: float = 30, elevation: float = 20, look: str = "stone",
              field_of_view: float = 0, threads: int = 0) -> Picture:
        """An entry in space as a solid without noise, lit from the upper left.

        azimuth, elevation  of the eye, in degrees: from +z towards +x, and upwards
        look                'stone', 'ink', 'depth' (near is white) or 'normals'
        field_of_view       degrees; 0: parallel rays
        """
        return _picture(*_core.solid(self._entry, shape, (azimuth, elevation, field_of_view), look, threads))

    def volume(self, shape: tuple[int, int, int], *, samples: int = 1_000_000, seed: int = 1) -> Volume:
        """Points of the attractor of an entry in space, without its cage, counted in cells of its certified box."""
        return Volume(*_core.volume(self._entry, shape, samples, seed))

    def _repr_png_(self) -> bytes:
        picture = self.picture if self.space_dimension == 2 else self.solid
        return _png(picture((300, 400)))

    def _repr_html_(self) -> Optional[str]:
        """The attractor in its cage, to be dragged, in a frame of its own; None for what only the window can show."""
        text = str(self)
        if len(self.maps) > page.MOST_MAPS or "; barycage: branch 0 " in text:
            return None
        return page.frame(text, self.name, self.space_dimension, self._repr_png_())

    # What is certain of the attractor of the maps, without the cage

    def classify(self) -> Classification:
        """Whether the maps have an attractor, with the proof."""
        *numbers, witness = _core.classify(self._entry)
        return Classification(*numbers, tuple(witness))

    @property
    def box(self) -> Box:
        """The smallest box with sides parallel to the axes."""
        return Box(*_core.box(self._entry))

    def hull(self, tolerance: float = 1e-6) -> Hull:
        """The convex hull, to a tolerance in units of the plane, or of space."""
        vertices, facets, size, size_error, error = _core.hull(self._entry, tolerance)
        return Hull(vertices, facets, Certified(size, size_error), error)

    @property
    def dimension(self) -> Certified:
        """The dimension of Moran where all maps are similarities (kind 'similarity'), else that of Falconer ('affinity').

        An upper bound of the box dimension, and so not above that of the plane or of space; under the open set condition, the similarity dimension is that. Raises
        ValueError where none is known, as in space for maps that are no similarities.
        """
        found = _core.dimension(self._entry)
        if found is None:
            raise ValueError("no dimension is known of this system")
        return Certified(*found)

    def moments(self) -> Moments:
        """(mean, covariance) of the invariant measure, (d,) and (d, d) float64: solved, not sampled."""
        mean, covariance, long_run, mean_error, covariance_error = _core.moments(self._entry)
        moments = Moments((mean, covariance))
        moments.mean_error, moments.covariance_error = mean_error, covariance_error
        moments.long_run_covariance = long_run
        return moments

    def support(self, direction: Any, tolerance: float = 0) -> Support:
        """max ⟨direction, x⟩ over the attractor: its value is attained, and the error says how much may be missing."""
        value, error, point, address = _core.support(self._entry, np.asarray(direction, np.float64), tolerance)
        support = Support(value, error)
        support.point, support.address = point, tuple(address)
        return support

    def address(self, point: Any, *, reach: float = 1e-3, width: float = 1e-6) -> Optional[Address]:
        """An address of the point of the attractor nearest to a point, as far as pieces are larger than `width`.

        None where none lies within `reach`. Both are shares of the diameter of a ball around the attractor.
        """
        found = _core.address(self._entry, np.asarray(point, np.float64), reach, width)
        if found is None:
            return None
        address = Address(found[0])
        address.distance = found[1]
        return address

    # What becomes of it

    def conjugated(self, matrix: Any, translation: Any = None) -> Entry:
        """The maps M∘w∘M⁻¹, whose attractor is the image of this one under M: x ↦ matrix·x + translation.

        A (d, d + 1) matrix has the translation as its last column. Raises ValueError where M can hardly be inverted.
        """
        return Entry._of(_core.conjugated(self._entry, _map(matrix, translation)))

    def caged(self, rest: Any, current: Any, *, bend: bool = True) -> Entry:
        """Held by a cage: what lies at the corners `rest` is shown at `current`, each (corners, d).

        d + 1 corners move it by an affine map. More of them bend it by generalized coordinates, or with bend=False move
        it by the affine map that misses them least.
        """
        return Entry._of(_core.caged(self._entry, np.asarray(rest, np.float64), np.asarray(current, np.float64), bend))

    def branch(self, word: Word, matrix: Any, translation: Any = None) -> Entry:
        """With what has an address that begins with `word` shown elsewhere: through x ↦ matrix·x + translation.

        The word is numbers of maps, outermost first: '12', or '1 12' where there are more than nine.
        """
        return Entry._of(_core.with_branch(self._entry, _word(word), _map(matrix, translation)))

    def at(self, frame: Union[int, float, Fraction]) -> Entry:
        """As the animation of the entry shows it at a frame, which may be a fraction: with maps, cage, branches and
        colours where keys and motions have brought them, and without an animation.

        Keys of the camera, and motions of it in space, are left out: an entry has no camera. One that does not move is
        the same at every frame. Like weights and colours, keys belong to the maps of the file: they do not follow
        conjugated().

        >>> from barycage import parse
        >>> turning = parse('''dust {
        ... ; barycage: animation 48 24/1 cycle
        ... ; barycage: motion orbit
        ... ; barycage: count 1
        ... ; barycage: pivot 0 0
        ...  .4 0 0 .4 0 0 1
        ...  .4 0 0 .4 1 0 1
        ... }''')[0]
        >>> turning.animation
        Animation(frames=48, rate=Fraction(24, 1), loop='cycle', last=48)
        >>> x, _ = turning.at(24).points(1000)
        >>> x.round(6).min() < -1
        True
        """
        animation = self.animation
        if animation is None:
            return self
        if not 0 <= frame <= animation.last:
            raise ValueError(f"frame: from 0 to {animation.last}")
        exact = frame if isinstance(frame, Fraction) else Fraction(float(frame))
        moment = exact.limit_denominator(10 ** 9)
        return Entry._of(_core.at(self._entry, moment.numerator, moment.denominator))

    def morph(self, other: Entry, share: float) -> Entry:
        """Between this one (share 0) and another (1): the maps correspond by optimal transport of their weights."""
        return Entry._of(_core.morphed(self._entry, other._entry, share))

    def top(self, other: Entry) -> Callable[[Any], np.ndarray]:
        """The fractal transformation to another entry with as many maps: a function of points (n, 2) of this attractor.

        It gives the points with the same top address in the other attractor, and NaN for what is on no attractor. Of
        the addresses of a point, the top one comes first in the order of the maps.
        """
        return lambda points: _core.tops(self._entry, other._entry, np.asarray(points, np.float64))


def _from_text(text: str) -> Entry:
    from .collection import parse

    return parse(text)[0]
