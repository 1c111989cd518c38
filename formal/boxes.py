"""The second checker, verify.py: where is a sum zero that two open angles turn, told in boxes?

s and t count turns of the two angles, and the parts are at e^(πi(M s + N t)), M and N twice their multiples less the highest, so that
they are as large either way: P = Σ C e^(πi(M s + N t)) up to a factor that is never zero. About a point P is a tangent plane, with its
derivatives a and b by πs and πt, and strays from it by no more than ½ Σ (|M| S + |N| T)² |C|, S and T how far πs and πt are away.
"""
from fractions import Fraction
from math import gcd, isqrt

from arcs import added, stretched
from enclosures import FEWEST_BITS, GUARD, common_denominator, enclose, turned
from families import minus
from verify import CHECKED, certify, demand, each

BITS = 2 * FEWEST_BITS + GUARD
UNDER_PI, ABOVE_PI = Fraction(333, 106), Fraction(355, 113)
MOST_TIMES, FINEST = 512, Fraction(1, 2**40)


def multiples(left, axis, unit):
    """How many whole times each part is turned, the least of them 0."""
    demand(unit > 0, "s and t take the angles a positive number of times")
    found = [minus(turn, left[0][0])[axis] / unit for turn, _ in left]
    demand(all(n.denominator == 1 for n in found), "a part is turned no whole number of times")
    times = [int(n - min(found)) for n in found]
    demand(gcd(*times) == 1 and max(times) <= MOST_TIMES, "the multiples have a common divisor, or are too large")
    return times


def away(one, other):
    """On a circle of one turn."""
    apart = abs(one - other) % 1
    return min(apart, 1 - apart)


def length(vector):
    """No less than that of any vector it may be."""
    return isqrt(vector[0] ** 2 + vector[1] ** 2) + 1 + vector[2]


def ahead(direction, vector):
    """What a vector is along a direction, times the length of that, and how far this is in doubt."""
    return direction[0] * vector[0] + direction[1] * vector[1], (isqrt(direction[0] ** 2 + direction[1] ** 2) + 1) * vector[2]


class Torus:
    def __init__(self, claim, left):
        times = list(zip(multiples(left, 0, claim.phi), multiples(left, 1, claim.delta)))
        highest = [max(of) for of in zip(*times)]
        scale = common_denominator([total for _, total in left])
        self.parts = list(zip(times, (total for _, total in left)))
        self.vectors = [(2 * m - highest[0], 2 * n - highest[1], enclose(total, scale, BITS)) for (m, n), total in self.parts]

    def tangent(self, s, t):
        """P there, and its derivatives by πs and πt, a quarter turn on."""
        there = [(M, N, turned(vector, (M * s + N * t) / 2, BITS)) for M, N, vector in self.vectors]
        along = [(M, N, (-y, x, doubt)) for M, N, (x, y, doubt) in there]
        return added(v for *_, v in there), added(stretched(v, M) for M, _, v in along), added(stretched(v, N) for _, N, v in along)

    def check_free(self, s, t, halves):
        """A line keeps what P may be in the box away from 0."""
        at, *sides = self.tangent(s, t)
        S, T = (ABOVE_PI * half for half in halves)
        bend = sum((abs(M) * S + abs(N) * T) ** 2 * length(vector) for M, N, vector in self.vectors) / 2
        for direction in (at, *((-y, x) for x, y, _ in sides)):
            middle, doubt = ahead(direction, at)
            reach = sum(far * (abs(along) + off) for far, (along, off) in zip((S, T), (ahead(direction, side) for side in sides)))
            if abs(middle) - doubt - (isqrt(direction[0] ** 2 + direction[1] ** 2) + 1) * bend > reach:
                return
        demand(False, f"no line keeps 0 away from the box about ({s}, {t})")

    def check_zero(self, zero):
        """z − K P(z) / det, K the adjugate of the derivative (a, b) in the middle, maps the box into itself, and two of its points nearer to each
        other: it holds one zero (Krawczyk). It is the middle, if P is zero there."""
        demand(0 <= zero.s < 1 and 0 <= zero.t < 1 and 0 < zero.reach <= Fraction(1, 4), "a zero's box is out of range")
        at, a, b = self.tangent(zero.s, zero.t)
        if zero.certificate is not None:
            certify([(t + m * zero.s + n * zero.t, w) for (m, n), total in self.parts for t, w in total.items()], zero.certificate, True)
            at = (0, 0, 0)
        least, most = UNDER_PI * zero.reach, ABOVE_PI * zero.reach
        strays = a[2] + b[2] + sum((abs(M) + abs(N)) ** 2 * most * length(vector) for M, N, vector in self.vectors)
        determinant = abs(a[0] * b[1] - a[1] * b[0])
        for row in ((b[1], -b[0]), (-a[1], a[0])):
            middle, doubt = ahead(row, at)
            moved = abs(middle) + doubt + (isqrt(row[0] ** 2 + row[1] ** 2) + 1) * strays * most
            demand(moved < determinant * least, "the box does not show that it holds one zero")


def check(claim, left, notes):
    """The boxes of the tree make the torus; each is free, within that of a zero, or said to be open."""
    torus, zeros, waiting = Torus(claim, left), claim.zeros, [((Fraction(0), Fraction(0)), (Fraction(1), Fraction(1)))]
    for place, zero in enumerate(each("zeros", zeros)):
        torus.check_zero(zero)
        for other in zeros[:place]:
            near = zero.reach + other.reach
            demand(away(zero.s, other.s) > near or away(zero.t, other.t) > near, "the boxes of two zeros meet")
    for letter in claim.tree:
        demand(waiting, "the tree has a letter too many")
        low, widths = waiting.pop()
        halves = [width / 2 for width in widths]
        middle = [edge + half for edge, half in zip(low, halves)]
        if letter in ("s", "t"):
            axis = "st".index(letter)
            demand(halves[axis] >= FINEST, "a box is too narrow")
            widths = tuple(halves[k] if k == axis else widths[k] for k in (0, 1))
            waiting += [(tuple(middle[k] if k == axis else low[k] for k in (0, 1)), widths), (low, widths)]
        elif letter == "0":
            torus.check_free(*middle, halves)
        elif letter == "1":
            within = (away(zero.s, middle[0]) + halves[0] <= zero.reach and away(zero.t, middle[1]) + halves[1] <= zero.reach for zero in zeros)
            demand(any(within), "a box is not within that of a zero")
        else:
            demand(letter == "?", "a box is of no such kind")
            notes.add("boxes of two open angles in which nothing is claimed")
    demand(not waiting, "the tree ends before all boxes are reported")
    CHECKED[1] += 1
