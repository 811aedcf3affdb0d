# SPDX-License-Identifier: MIT
"""How many times as fast density_batch() is, with one thread, as a plain loop in C, both measured in this run.

    PYTHONPATH=build/python/package python3 tests/python/batch_ratio.py
"""
import ctypes
import pathlib
import subprocess
import tempfile
import time

import barycage as bc
import numpy as np

# One orbit in doubles, as one writes it: two passes over stored points, for their extent and their cells.
PLAIN = r"""
#include <stdint.h>
#include <stdlib.h>
void paint(const double* systems, const double* weights, int count, int maps, int side, int points, uint32_t* counts) {
    double* x = malloc(points * sizeof *x), * y = malloc(points * sizeof *y);
    for (int k = 0; k < count; ++k, systems += 6 * maps, weights += maps, counts += side * side) {
        uint64_t state = k + 1;
        double px = 0, py = 0, x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
        for (int j = -20; j < points; ++j) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            double left = (state >> 11) * 0x1p-53;
            int i = 0;
            while (i + 1 < maps && left >= weights[i]) left -= weights[i++];
            const double* m = systems + 6 * i;
            const double next = m[0] * px + m[1] * py + m[2];
            py = m[3] * px + m[4] * py + m[5];
            px = next;
            if (j < 0) continue;
            x[j] = px, y[j] = py;
            if (px < x0) x0 = px;
            if (px > x1) x1 = px;
            if (py < y0) y0 = py;
            if (py > y1) y1 = py;
        }
        const double width = x1 - x0, height = y1 - y0, scale = .9 * side / (width > height ? width : height);
        for (int j = 0; j < points; ++j)
            ++counts[(int)(side / 2. - scale * (y[j] - (y0 + y1) / 2)) * side + (int)(side / 2. + scale * (x[j] - (x0 + x1) / 2))];
    }
    free(x);
    free(y);
}
"""
COUNT, MAPS, SIDE, POINTS = 200, 4, 256, 100_000


def plain_loop():
    with tempfile.TemporaryDirectory() as folder:
        library = pathlib.Path(folder) / "plain.so"
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-x", "c", "-", "-o", str(library)], input=PLAIN, text=True,
                       check=True)
        return ctypes.CDLL(str(library)).paint


def seconds(*works):
    """Of the fastest of seven runs of each, in turn."""
    def once(work):
        begin = time.process_time()
        work()
        return time.process_time() - begin
    return [min(times) for times in zip(*([once(work) for work in works] for _ in range(7)))]


def main():
    entries = [bc.random(maps=MAPS, seed=seed) for seed in range(COUNT)]
    systems = np.stack([entry.maps for entry in entries])
    weights = np.stack([entry.probabilities for entry in entries])
    paint = plain_loop()

    def plainly():
        counts = np.zeros((COUNT, SIDE, SIDE), np.uint32)
        paint(*(ctypes.c_void_p(array.ctypes.data) for array in (systems, weights)), COUNT, MAPS, SIDE, POINTS,
              ctypes.c_void_p(counts.ctypes.data))
        return counts

    assert (plainly().sum(axis=(1, 2)) == POINTS).all()
    ours, plain = seconds(
        lambda: bc.density_batch(systems, (SIDE, SIDE), samples=POINTS, weights=weights, threads=1), plainly)
    print(f"density_batch {COUNT / ours:.0f} systems/s, plain loop {COUNT / plain:.0f} systems/s, ratio {plain / ours:.1f}")


if __name__ == "__main__":
    main()
