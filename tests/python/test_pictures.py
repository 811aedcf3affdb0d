# SPDX-License-Identifier: MIT
import os
import signal
import subprocess
import sys
import threading
import zlib

import barycage as bc
import numpy as np
import pytest


def test_density_counts_points(triangle, maple):
    density = maple.density((60, 80), samples=50_000)
    assert density.shape == (60, 80) and density.dtype == np.uint64 and density.sum() == 50_000
    counts = triangle.density((200, 200), samples=100_000, centre=(.5, .5), scale=180)
    assert counts.sum() == 100_000
    # The hole in the middle of the triangle, what is above its long side, and its lower left corner.
    assert counts[112:122, 78:90].sum() == 0 and counts[60:90, 110:140].sum() == 0 and counts[150:, :50].sum() > 0


def test_the_same_whatever_the_threads(maple):
    one = maple.density((90, 120), samples=300_000, threads=1)
    assert (one == maple.density((90, 120), samples=300_000, threads=3)).all()
    assert (one != maple.density((90, 120), samples=300_000, seed=2)).any()
    assert maple.picture((90, 120), threads=1).hash == maple.picture((90, 120), threads=2).hash


def test_points_follow_the_measure(triangle):
    x, address = triangle.points(100_000, seed=5)
    assert x.flags.owndata is False and x.base is not None  # the memory they were drawn in
    mean, covariance = triangle.moments()
    assert x.mean(axis=0) == pytest.approx(mean, abs=.01)
    assert np.cov(x.T) == pytest.approx(covariance, abs=.01)
    assert ((address >= 1 / 3) & (address < 2 / 3) == (x[:, 0] >= .5)).all()
    assert (triangle.points(100, seed=5)[0] == x[:100]).all()


def test_points_in_space(cube):
    x, _ = cube.points(10_000)
    assert x.shape == (10_000, 3) and x.min() >= 0 and x.max() <= 1


def test_pictures(maple):
    picture = maple.picture((30, 40))
    assert picture.shape == (30, 40, 4) and picture.dtype == np.uint8 and (picture[..., 3] == 255).all()
    clear = maple.picture((30, 40), background=(0, 0, 0, 0), palette=bc.palettes()[3], colour_by="map")
    assert clear[0, 0, 3] == 0 and clear[..., 3].max() > 100 and clear.hash != picture.hash
    with pytest.raises(ValueError, match="palette"):
        maple.picture((30, 40), palette="none of these")
    with pytest.raises(ValueError, match="shape"):
        maple.picture((0, 40))


def test_notebooks_show_pictures(maple, cube):
    picture = maple.picture((30, 40), background=(1, 2, 3, 0))
    png = picture._repr_png_()
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    at = png.index(b"IDAT")
    size = int.from_bytes(png[at - 4:at], "big")
    rows = np.frombuffer(zlib.decompress(png[at + 4:at + 4 + size]), np.uint8).reshape(30, 161)
    assert (rows[:, 1:].reshape(30, 40, 4) == picture).all() and (rows[:, 0] == 0).all()
    assert maple._repr_png_().startswith(b"\x89PNG") and cube._repr_png_().startswith(b"\x89PNG")
    assert picture[0]._repr_png_() is None


def test_solids(cube):
    front = cube.solid((60, 80), azimuth=0, elevation=0, look="depth")
    assert front.shape == (60, 80, 4) and len(np.unique(front[..., 0])) <= 8
    assert front.hash != cube.solid((60, 80), azimuth=30, elevation=20).hash
    with pytest.raises(ValueError, match="look"):
        cube.solid(look="cloud")


def test_volume(cube):
    volume = cube.volume((4, 2, 8), samples=64_000)
    assert volume.counts.shape == (4, 2, 8) and volume.counts.sum() == 64_000
    assert volume.counts.min() > 800 and volume.min == pytest.approx([0, 0, 0]) and volume.max == pytest.approx([1] * 3)


def test_the_wrong_dimension(cube, triangle):
    for call in (lambda: cube.density((8, 8)), lambda: cube.picture((8, 8)), lambda: triangle.solid((8, 8)),
                 lambda: triangle.volume((2, 2, 2))):
        with pytest.raises(ValueError, match="in the plane|in space"):
            call()


def test_batches(triangle):
    systems = [bc.random(maps=3, seed=seed) for seed in range(6)]
    counts = bc.density_batch(systems, (64, 96), samples=20_000)
    assert counts.shape == (6, 64, 96) and counts.dtype == np.uint32
    assert counts.sum(axis=(1, 2)).tolist() == [20_000] * 6
    again = bc.density_batch(np.stack([each.maps for each in systems]), (64, 96), samples=20_000, threads=1,
                             weights=np.stack([each.probabilities for each in systems]))
    assert (counts == again).all()
    # As large as density() shows it, from the top.
    plain = bc.density_batch([triangle], (100, 100), samples=100_000)[0]
    shown = triangle.density((100, 100), samples=100_000)
    for axis in (0, 1):
        ours, others = np.flatnonzero(plain.sum(axis=axis)), np.flatnonzero(shown.sum(axis=axis))
        assert abs(ours[0] - others[0]) <= 2 and abs(ours[-1] - others[-1]) <= 2
    blocks = (plain.astype(float) - shown).reshape(10, 10, 10, 10).sum(axis=(1, 3))
    assert abs(blocks).sum() < .25 * 100_000


def test_batches_of_many_points_in_parts():
    system = bc.random(maps=3, seed=4)
    counts = bc.density_batch([system], (40, 60), samples=300_001)[0]
    assert counts.sum() == 300_001
    rows, columns = np.flatnonzero(counts.sum(axis=1)), np.flatnonzero(counts.sum(axis=0))
    assert min(rows[0] + 39 - rows[-1], columns[0] + 59 - columns[-1]) in (3, 4, 5, 6)  # a margin of a twentieth
    first = bc.density_batch([system], (40, 60), samples=1 << 17)[0]
    assert not (counts == first).all() and abs(counts / 300_001 - first / (1 << 17)).sum() < .1


def test_batches_of_a_point_and_of_a_line():
    point = [[[.5, 0, 1e6], [0, .5, -3]], [[.5, 0, 1e6], [0, .5, -3]]]
    line = [[[.5, 0, 0], [0, 0, 7]], [[.5, 0, 1], [0, 0, 7]]]
    counts = bc.density_batch([point, line], (50, 50), samples=1000)
    assert (counts.sum(axis=(1, 2)) == 1000).all()
    rows, columns = np.nonzero(counts[0])
    assert abs(rows - 25).max() <= 1 and abs(columns - 25).max() <= 1
    rows, columns = np.nonzero(counts[1])
    assert len(set(rows)) == 1 and columns[0] <= 3 and columns[-1] >= 46


@pytest.mark.parametrize("vectors", ["scalar", "sse4", "avx2", "avx512"])
def test_batches_have_the_same_bits_with_all_vectors(vectors):
    script = ("import barycage as bc, hashlib\n"
              "systems = [bc.random(maps=maps, seed=seed) for maps, seed in ((2, 1), (4, 2))]\n"
              "print(*(hashlib.md5(bc.density_batch([each], (64, 96), samples=20_000).tobytes()).hexdigest()\n"
              "        for each in systems))")
    of = [subprocess.run([sys.executable, "-c", script], env={**os.environ, **chosen}, check=True, capture_output=True,
                         text=True).stdout for chosen in ({}, {"BARYCAGE_SIMD": vectors})]
    assert of[0] == of[1] and len(of[0].split()) == 2


@pytest.mark.parametrize("call", [
    lambda entry: entry.density((400, 400), samples=10 ** 13),
    lambda entry: entry.picture((400, 400), samples=10 ** 13),
])
def test_ctrl_c_stops(maple, call):
    def threads():
        return len(os.listdir("/proc/self/task"))

    def interrupt():  # which happens only while the interpreter is free
        while threads() <= before + 1:  # until the call has begun its work
            os.sched_yield()
        signal.raise_signal(signal.SIGINT)

    before = threads()
    thread = threading.Thread(target=interrupt)
    with pytest.raises(KeyboardInterrupt):
        thread.start()
        call(maple)
    thread.join()
