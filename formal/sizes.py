"""The second checker, verify.py: the decimals of loads and comparisons, which are those of what is left of an order."""
from fractions import Fraction
from math import isqrt

from enclosures import GUARD, exact, unit
from motion import number
from verify import demand
from wholes import Whole, size

# A decimal is off by less than this part of itself, as it is a product of others, and by less than that of terms that cancel.
ACCURACY, OF_TERMS = Fraction(1, 2**44), Fraction(1, 2**80)
SMALLEST = Fraction(1, 2**1000)  # nothing below has all digits of a decimal
BITS, A_MINUTE = 128 + GUARD, Fraction(10471975511965977462, 10**20)  # 2π/60


def slack_of(value):
    return abs(value) * ACCURACY


def is_near(stated, right, slack):
    demand(abs(exact(stated) - right) <= slack + SMALLEST, f"{stated}: the evidence differs")


def root(square):
    """To 64 bits at least: it is no smaller than the inverse of the denominator."""
    bits = square.denominator.bit_length() + 64
    return Fraction(isqrt((square.numerator << 2 * bits) // square.denominator), 1 << bits)


class Length:
    def __init__(self, value, doubt=0):
        self.value, self.slack = value, slack_of(value) + doubt


class Shown:
    """A complex number that decimals stand for; it may be off by `doubt`, and by what its digits are."""

    def __init__(self, re, im, doubt=0):
        self.re, self.im, self.length = re, im, Length(root(re * re + im * im), doubt)

    def times(self, other):
        doubt = self.length.value * other.length.slack + other.length.value * self.length.slack
        return Shown(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re, doubt)

    def has_parts(self, re, im):
        is_near(re, self.re, self.length.slack)
        is_near(im, self.im, self.length.slack)

    def points(self, degrees, full, is_zero):
        """Of so many degrees in a turn, half of them at most; none where it is proved to be zero."""
        if degrees is None:
            return demand(is_zero is not False or self.length.value < SMALLEST, "what is not zero has a direction")
        demand(is_zero is not True, "what is zero has no direction")
        turn = exact(degrees) / full
        near = [abs(Fraction(part, 2**BITS) * self.length.value - right) <= self.length.slack for part, right in zip(unit(turn, BITS), (self.re, self.im))]
        demand(all(near) and -1 < 2 * turn <= 1, "it points elsewhere")


def of_vector(quantity, k, sense, left_of):
    """What is left of an order in a sense, in multiples of m r ω²."""
    left = left_of[quantity, k, sense]
    if not left:
        return Shown(Fraction(0), Fraction(0))
    whole = Whole(k, [left], BITS)
    re, im = (Fraction(part.low + part.high, 2 * whole.scale * 2**whole.bits) for part in whole.sum(left, sense))
    return Shown(re, im, whole.largest * OF_TERMS)


class Swing:
    """What both vectors of an order trace: half of each."""

    def __init__(self, quantity, k, left_of):
        both = [of_vector(quantity, k, sense, left_of) for sense in ("direct", "reverse")]
        direct, reverse = self.sums = [Shown(one.re / 2, one.im / 2, one.length.slack / 2) for one in both]
        self.largest = Length(direct.length.value + reverse.length.value, direct.length.slack + reverse.length.slack)
        self.smallest = abs(direct.length.value - reverse.length.value)
        self.along, self.across = (root((direct.re + way * reverse.re)**2 + (direct.im - way * reverse.im)**2) for way in (1, -1))
        self.axis = direct.times(reverse)  # twice as far round as the longer axis


def of_rod(rod, k):
    """c_k of a rod that is known, offset of either side."""
    of = ("rod", rod.ratio, rod.offset)
    bits = BITS + max(0, int(1 / size(of, k)).bit_length() - 1)
    return Shown(*(Fraction(part.low + part.high, 2 << bits) for part in number(of, k, bits)))


def check_scale(scale):
    """Returns m r ω² and m r² ω², which are 0 of an engine at rest."""
    mass, radius, speed, omega, force = (exact(scale[key]) for key in ("mass_kg", "crank_radius_m", "speed_rpm", "angular_speed_rad_s", "m_r_omega_squared_n"))
    demand(mass > 0 and radius > 0 and (omega == 0) is (speed == 0) is (force == 0), "no speed makes no force, and nothing else is 0")
    is_near(scale.angular_speed_rad_s, A_MINUTE * speed, slack_of(A_MINUTE * speed))
    is_near(scale.m_r_omega_squared_n, mass * radius * omega**2, slack_of(mass * radius * omega**2))
    return force, force * radius
