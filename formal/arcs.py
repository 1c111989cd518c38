"""The second checker, verify.py: how often is a sum zero on each arc of a circle?"""
from fractions import Fraction
from math import ceil, isqrt, lcm

from enclosures import bits_of, common_denominator, enclose, turned
from verify import CHECKED, certify, conjugate, demand, each, primes_of, times


def added(vectors):
    return tuple(map(sum, zip(*vectors)))


def stretched(vector, by):
    return vector[0] * by, vector[1] * by, vector[2] * abs(by)


def is_free(curve, low, high, bits):
    """Whether a line keeps the curve Σ C e^(2πi·m·s) away from 0 for all s of the arc; the curve is pairs (2m, C).

    About the middle, r the half-width, it is within ½ (2πr)² Σ m² |C| of its tangent."""
    middle, r = (low + high) / 2, (high - low) / 2
    there = [(twice, turned(vector, twice * middle / 2, bits)) for twice, vector in curve]
    at = added(vector for _, vector in there)
    y, x, doubt = added(stretched(vector, twice) for twice, vector in there)
    along = (-x, y, doubt)  # a quarter turn on: the derivative is πi Σ 2m C e^(…)
    bend = sum(twice**2 * (isqrt(x * x + y * y) + 1 + doubt) for twice, (x, y, doubt) in there)
    reach, bend = r * Fraction(355, 113), 5 * r * r * bend  # π < 355/113, and ½ π² < 5
    for x, y in ((at[0], at[1]), (along[1], -along[0]), (-along[1], along[0])):
        length = isqrt(x * x + y * y) + 1
        if x * at[0] + y * at[1] - length * (at[2] + bend) > reach * (abs(x * along[0] + y * along[1]) + length * along[2]):
            return True
    return False


def circle(claim, polynomial, notes):
    """The arcs make one turn, and P = Σ S x^n, x = e^(2πi·u), has the zeros on each that it says, its ends among it."""
    bits, arcs, degree = bits_of(claim), claim.arcs, polynomial[-1][0]
    totals = [total for _, total in polynomial]
    scale = common_denominator(totals)
    vectors = [(n, enclose(total, scale, bits)) for n, total in polynomial]
    # Turned back by half the degree P stays on one line through 0, if its coefficients are their own mirror image.
    centred = [(2 * n - degree, vector) for n, vector in vectors]
    slope = [(twice, stretched(vector, twice)) for twice, vector in centred]
    rests = any(arc.kind in ("monotone", "crossing") for arc in arcs)
    demand(not rests or all(m + n == degree for (m, _), (n, _) in zip(polynomial, polynomial[::-1])), "the exponents are no mirror image")
    due = [j for j, (n, _) in enumerate(polynomial) if rests and 2 * n <= degree]
    for j, certificate in each("mirrored", claim.mirrored, due):
        certify(times(conjugate(totals[-1 - j]), totals[-1]) + times(conjugate(totals[0]), totals[j], -1), certificate, True)
    # A zero that is a rational turn is a multiple of 1/(M n) for some exponent n (theory, section 16).
    M = lcm(1, *(t.denominator for total in totals for t in total))
    for p in range(2, len(totals) + 1):
        M *= p if primes_of(p) == [p] and M % p else 1
    low = claim["from"]
    for arc in each("arcs", arcs):
        high = arc.to
        demand(low < high, "an arc does not end behind its beginning")
        if arc.kind == "free":
            demand(is_free([(2 * n, vector) for n, vector in vectors], low, high, bits), "no line keeps it away from 0")
        elif arc.kind == "rational":
            demand(low <= arc["at"] <= high, "its zero is not on it")
            count = len(arc.certificates)
            demand(1 <= count < len(totals), f"{count} certificates for a zero of {len(totals)} parts")
            for i, certificate in enumerate(arc.certificates):
                derivative = [(t + n * arc["at"], w * n**i) for n, total in polynomial for t, w in total.items()]
                certify(derivative, certificate, True)
            # Across the line some real function has at most `count` zeros (Rolle), and this one takes all.
            next_one = [(2 * n, stretched(vector, n**count)) for n, vector in vectors]
            demand(is_free(next_one, low, high, bits), "no line keeps its derivative away from 0")
        elif arc.kind in ("monotone", "crossing"):
            demand(is_free(slope, low, high, bits), "no line keeps its slope away from 0")
            (a, b, one), (c, d, other) = (added(turned(vector, twice * end / 2, bits) for twice, vector in centred) for end in (low, high))
            across, doubt = a * c + b * d, (abs(a) + abs(b)) * other + (abs(c) + abs(d)) * one + one * other
            demand((across if arc.kind == "monotone" else -across) > doubt, "its ends are not on these sides of 0")
            may_be = arc.kind == "crossing" and any(ceil(low * M * n) <= high * M * n for n, _ in polynomial[1:])
            demand(not may_be, "a rational turn in it may be the zero")
        else:
            demand(arc.kind == "open", "an arc is of no such kind")
            notes.add("arcs of the circle on which nothing is claimed")
        low = high
    demand(low == claim["from"] + 1, "the arcs do not make one turn")
    CHECKED[1] += 1
