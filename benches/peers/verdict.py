"""Which of the sums seem to vanish, by NumPy: all 28 at once in floats, with a tolerance, which proves nothing."""

import sys
import time

import numpy

SUMS = 28
lines = [[int(number) for number in line.split()] for line in open(sys.argv[1], encoding="utf-8")]
for first in range(0, len(lines), SUMS):
    some = numpy.array(lines[first : first + SUMS], dtype=numpy.int64)
    conductor, exponents, weights = int(some[0, 0]), some[:, 1::2], some[:, 2::2].astype(float)

    def verdicts():
        return abs((weights * numpy.exp(2j * numpy.pi / conductor * exponents)).sum(axis=1)) < 1e-9

    times = []
    for _ in range(2000):
        start = time.perf_counter()
        zeros = verdicts()
        times.append(time.perf_counter() - start)
    name = f"NumPy {numpy.__version__}, floats and a tolerance"
    print(f"{name}; seems zero; {conductor}; {min(times) * 1e9 / SUMS:.1f}; {int(zeros.sum())}")
