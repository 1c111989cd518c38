"""The force and the moment of a V8 in orders 1, 2, 4 and 6 at 720 crank angles, as plain NumPy sums.

Prints the median time of one evaluation in microseconds, then the largest force and moment, for comparison.
Arguments: 16 vectors (direct and reverse of each order, first of the force, then of the moment), real part first.
"""

import statistics
import sys
import time

import numpy

ORDERS = numpy.array([1, 2, 4, 6])
numbers = [float(text) for text in sys.argv[1:]]
vectors = numpy.array([complex(*numbers[j : j + 2]) for j in range(0, len(numbers), 2)]).reshape(2, 4, 2)
theta = numpy.arange(720) * (2 * numpy.pi / 720)
ahead = numpy.exp(1j * numpy.outer(ORDERS, theta))
behind = ahead.conj()


def with_ready_angles():
    """e^{ikθ} is at hand, as it is for the program beside which this is timed."""
    return [part[:, 0] @ ahead + part[:, 1] @ behind for part in vectors]


def from_angles():
    """The cosines and sines are computed, too."""
    turning = numpy.exp(1j * numpy.outer(ORDERS, theta))
    return [part[:, 0] @ turning + part[:, 1] @ turning.conj() for part in vectors]


def median_microseconds(function):
    times = []
    for _ in range(300):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return statistics.median(times) * 1e6


force, moment = with_ready_angles()
print(median_microseconds(with_ready_angles), median_microseconds(from_angles), abs(force).max(), abs(moment).max())
