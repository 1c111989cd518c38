"""The second checker, verify.py: vectors and numbers enclosed in whole numbers, and the decimals beside a verdict.

Units are 2^−bits. An enclosed vector is (x, y, doubt), three whole numbers: it is no farther than `doubt` from x + iy.
"""
from fractions import Fraction
from functools import lru_cache
from math import isqrt, lcm

from verify import Decimal, NoDocument, demand

GUARD, UNIT_DOUBT = 64, 1 << 13
FEWEST_BITS, MOST_BITS = 32, 512  # that a claim may name
FINEST = 1 << 14  # more bits are not computed


def arctangent_of(whole, bits):
    """arctan(1/whole), by its series; off by less than one for each term."""
    total, power, n = 0, (1 << bits) // whole, 0
    while power:
        total += (-1) ** n * power // (2 * n + 1)
        power, n = power // whole**2, n + 1
    return total


@lru_cache(maxsize=None)
def two_pi(bits):
    """2π, off by less than one, by Machin's formula."""
    if bits > FINEST:
        raise NoDocument("it takes more bits than this checker computes")
    return (32 * arctangent_of(5, bits + GUARD) - 8 * arctangent_of(239, bits + GUARD)) >> GUARD


@lru_cache(maxsize=100_000)
def unit(turn, bits):
    """e^(2πi·turn): the quarter turns at once, and the rest, x < π/2, by Σ (ix)^n / n!. Its terms, fewer than 2,000, are each off by
    what the ones before are, at most e^x times as much and some units more: together by less than UNIT_DOUBT."""
    quarters, rest = divmod(turn % 1, Fraction(1, 4))
    x = two_pi(bits) * rest.numerator // rest.denominator
    term, n, sums = 1 << bits, 0, [0, 0, 0, 0]
    while term:
        sums[n % 4] += term
        n += 1
        term = term * x // n >> bits
    cos, sin = sums[0] - sums[2], sums[1] - sums[3]
    return [(cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos)][int(quarters)]


def bits_of(claim):
    demand(FEWEST_BITS <= claim.bits <= MOST_BITS, f"an enclosure has {FEWEST_BITS} to {MOST_BITS} bits")
    return claim.bits + GUARD


def common_denominator(totals):
    return lcm(1, *(weight.denominator for total in totals for weight in total.values()))


def enclose(total, scale, bits):
    """A sum times `scale`, which makes its weights whole."""
    vectors = [(*unit(t, bits), int(w * scale)) for t, w in total.items()]
    return sum(w * x for x, _, w in vectors), sum(w * y for _, y, w in vectors), UNIT_DOUBT * sum(abs(w) for *_, w in vectors)


def turned(vector, turn, bits):
    (x, y, doubt), (cos, sin) = vector, unit(turn, bits)
    return x * cos - y * sin >> bits, x * sin + y * cos >> bits, doubt + ((abs(x) + abs(y)) * UNIT_DOUBT >> bits) + 3


class Interval:
    """A number from `low` to `high`, whole numbers of units; everything is rounded outwards."""
    __slots__ = ("low", "high", "bits")

    def __init__(self, low, high, bits):
        self.low, self.high, self.bits = low, high, bits

    @classmethod
    def of(cls, number, bits):
        return number if isinstance(number, Interval) else cls(*outwards(number << bits if type(number) is int else number * 2**bits), bits)

    def __add__(self, other):
        other = Interval.of(other, self.bits)
        return Interval(self.low + other.low, self.high + other.high, self.bits)

    def __neg__(self):
        return Interval(-self.high, -self.low, self.bits)

    def __sub__(self, other):
        return self + -Interval.of(other, self.bits)

    def __mul__(self, other):
        if not isinstance(other, Interval):  # a rational number, exactly
            ends = sorted((self.low * other, self.high * other))
            return Interval(outwards(ends[0])[0], outwards(ends[1])[1], self.bits)
        ends = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return Interval(min(ends) >> self.bits, -(-max(ends) >> self.bits), self.bits)

    def root(self):
        demand(self.low > 0, "the root of what may not be positive")
        return Interval(isqrt(self.low << self.bits), isqrt(self.high << self.bits) + 1, self.bits)

    def inverse(self):
        """Of a positive number."""
        demand(self.low > 0, "the inverse of what may not be positive")
        return Interval((1 << 2 * self.bits) // self.high, -(-(1 << 2 * self.bits) // self.low), self.bits)

    def wider(self, by):
        return Interval(self.low - by, self.high + by, self.bits)

    def rounded(self, bits):
        """In coarser units."""
        return Interval(self.low >> self.bits - bits, -(-self.high >> self.bits - bits), bits)

    def most(self):
        """No size is larger."""
        return max(abs(self.low), abs(self.high))

    def excludes_zero(self):
        return self.low > 0 or self.high < 0


def outwards(number):
    """The whole numbers next to a rational one."""
    number = Fraction(number)
    return number.numerator // number.denominator, -(-number.numerator // number.denominator)


def interval_of(middle, doubt, bits):
    return Interval(middle - doubt, middle + doubt, bits)


# ---- Decimals --------------------------------------------------------------------------------------------------------------


def exact(number):
    """The fraction that a number with a point is as a double; one without a point is whole."""
    return Fraction(float(number.text)) if isinstance(number, Decimal) else Fraction(number)


def check_shown(entry, total, vanishes):
    """|S| and its direction in degrees, each to 2^−50 of itself (or the direction to 2^−150), however much the terms cancel."""
    modulus, angle = exact(entry.modulus), entry.angle_deg
    demand((modulus == 0) == vanishes == (angle is None), "modulus and angle_deg contradict vanishes")
    if vanishes:
        return
    angle, scale, bits = exact(angle), common_denominator([total]), 256
    demand(modulus > 0 and -180 < angle <= 180, "modulus is positive, angle_deg between −180 and 180")
    while True:
        x, y, doubt = vector = enclose(total, scale, bits)
        stated, length = modulus * scale * 2**bits, isqrt(x * x + y * y)
        slack = stated / 2**50
        demand(length + 1 + doubt >= stated - slack and length - doubt <= stated + slack, "modulus does not fit the terms")
        # Turned back by the angle it points along 0. The tangent of what it may be off: 7/400 is above π/180.
        along, across, doubt = turned(vector, -angle / 360, bits)
        tangent = abs(angle) * Fraction(7, 400) / 2**50 + Fraction(1, 2**150)
        demand(along + doubt > 0 and abs(across) - doubt <= (along + doubt) * tangent, "angle_deg does not fit the terms")
        fits = length - doubt >= stated - slack and length + 1 + doubt <= stated + slack
        if fits and along > doubt and abs(across) + doubt <= (along - doubt) * tangent:
            return
        bits *= 2
