"""The second checker, verify.py: the numbers of the motion, enclosed. The formulas are those of src/kernel/proof/README.md and docs/theory.md."""
from fractions import Fraction
from functools import lru_cache
from math import isqrt

from enclosures import Interval, interval_of, unit
from verify import ONE, NoDocument, demand

MOST_POINTS = 20_000


def positive_root(number, bits):
    """Of an exact number that may be zero."""
    return Interval.of(number, bits).root() if number > 0 else Interval(0, 0, bits)


def widest(bound, most=Fraction(1)):
    """A q, as large as 20 halvings find it, up to which  bound((q + 1/q)/2) ≤ most:  the width of a strip |Im φ| ≤ log q."""
    low, high = Fraction(1), Fraction(256)
    for _ in range(20):
        middle = (low + high) / 2
        low, high = (middle, high) if bound((middle + 1 / middle) / 2) <= most else (low, middle)
    return low


def points(q, most, k, bits):
    """N with  4M q^−(N−k) ≤ 2^−bits:  a function that is analytic and at most M in the strip has harmonics of at most M q^−|m|, and
    the mean over N points adds those of k ± N, k ± 2N, … to that of k."""
    log = (q.numerator**256 // q.denominator**256).bit_length() - 1  # of q^256, rounded down
    count = k + -(-(bits + int(4 * most).bit_length() + 1) * 256 // log) if log else MOST_POINTS + 1
    if count > MOST_POINTS:
        raise NoDocument("a rod all but reaches over the shaft, which takes more points than this checker computes")
    return count


def harmonic(function, k, count, bits):
    """The mean of f(φ) e^(−ikφ) over so many points, with what they miss; f takes cos φ and sin φ."""
    table = [[interval_of(part, 1 << 13, bits) for part in unit(Fraction(j, count), bits)] for j in range(count)]
    re = im = Interval(0, 0, bits)
    for j in range(count):
        value, (cos, sin) = function(*table[j]), table[j * k % count]
        re, im = re + value * cos, im - value * sin
    return [(part * Fraction(1, count)).wider(1) for part in (re, im)]


def times_power(number, k):
    """(−i)^k times a complex number."""
    re, im = number
    return [(re, im), (im, -re), (-re, -im), (-im, re)][k % 4]


@lru_cache(maxsize=10_000)
def number(of, k, bits):
    """The number `of` (see verify.py) at order k, as real and imaginary part, with so many bits behind the point."""
    kind, *rest = of
    if kind == "geared":
        return number(rest[1], k // rest[0], bits)
    if of == ONE:
        return Interval.of(1, bits), Interval.of(0, bits)
    found = {"rod": of_rod, "quadrature": of_quadrature, "torque": of_torque, "linkage": of_linkage, "corrected": of_corrected}[kind](k, bits, *rest)
    return tuple(part.rounded(bits) for part in found)


def finer(bits, factor):
    """A factor of this size takes bits from those that are asked for, and so does rounding."""
    return bits + 48 + int(factor).bit_length()


def of_rod(k, bits, ratio, offset):
    """c_k = [k = 1] + (−i)^k 2k²/λ · mean(√(1 − y²) e^(−ikφ)), y = λ cos φ − δ. Where |y| ≤ 1 the root is analytic and at most √2."""
    if ratio == 0:  # the endless rod keeps its slope
        slope = Interval.of(1 - offset**2, bits).root().inverse() * offset
        return (Interval.of(1, bits), -slope) if k == 1 else (Interval.of(0, bits), Interval.of(0, bits))
    factor, q = 2 * k * k / ratio, widest(lambda cosh: ratio * cosh + abs(offset))
    fine = finer(bits, factor)

    def root(cos, _):
        y = cos * ratio - offset
        return (Interval.of(1, fine) - y * y).root()

    re, im = times_power([part * factor for part in harmonic(root, k, points(q, 2, k, fine), fine)], k)
    return re + (1 if k == 1 else 0), im


def of_quadrature(k, bits, ratio, offset):
    """y, the imaginary part of c_1: a real number."""
    return of_rod(1, bits, ratio, offset)[1], Interval.of(0, bits)


def of_torque(k, bits, ratio, offset):
    """t_k = k (−i)^(k+1) mean((cos φ − y sin φ/√(1 − y²))² e^(−ikφ)). Where |y| ≤ s < 1 that is at most 2q²/(1 − s²)."""
    s = (1 + ratio + abs(offset)) / 2
    q = widest(lambda cosh: ratio * cosh + abs(offset), s)
    most = 2 * q * q / (1 - s * s)
    fine = finer(bits, k * most)

    def square(cos, sin):
        y = cos * ratio - offset
        speed = cos - y * sin * (Interval.of(1, fine) - y * y).root().inverse()
        return speed * speed

    return times_power([part * k for part in harmonic(square, k, points(q, most, k, fine), fine)], k + 1)


def reach(ratio, knuckle, apart, bits):
    """X = (r/L)² |1 − κ e^(iΔ)|² of a link."""
    cos = interval_of(unit(apart, bits)[0], 1 << 13, bits)
    return (-cos * (2 * knuckle) + (1 + knuckle**2)) * ratio**2


def of_linkage(k, bits, ratio, knuckle, apart):
    """g_k, k = 2m: √(1 − X sin²ψ) is Σ_j C(½,j) (−X)^j sin^(2j) ψ, and the mean of sin^(2j) ψ cos kψ is (−1)^m C(2j,j+m)/4^j. So
    g_k = 2k² (r/L)^(k−1) Σ_{j≥m} a_j X^(j−m),  a_j = (−1)^(j+m) C(½,j) C(2j,j+m)/4^j,  at most 1 in size."""
    m, factor = k // 2, 2 * k * k * ratio ** (k - 1)
    if ratio == 0 or k % 2:
        return Interval.of(0, bits), Interval.of(0, bits)
    fine = finer(bits, factor)
    X, a = reach(ratio, knuckle, apart, fine), Fraction(1)
    for j in range(m):
        a *= (Fraction(1, 2) - j) / (4 * (j + 1))  # C(½,m)/4^m
    term = total = Interval.of(a, fine)
    power = Interval.of(1, fine)
    for j in range(m, m + MOST_POINTS):
        term, power = term * X * Fraction(4 * j * j - 1, 4 * ((j + 1) ** 2 - m * m)), power * X
        total = total + term
        if power.high << fine <= (1 << fine) - X.high << 16:  # power/(1 − X), which the rest is below, is 2^16 units at most
            return total.wider(1 << 16) * factor, Interval.of(0, fine)
    raise NoDocument("a link all but reaches over, which takes more terms than this checker computes")


def bound_of_corrected(ratio, knuckle, master, apart, correction, cosh, bits=128):
    """|Y| in the strip where |sin| ≤ C: there |√(1 − λ²S²)| ≤ 2 − √(1 − λ²C²), so that Y is at most
    r/L (|1 − κ cos ε e^(iΔ)| C + κ/λ |sin ε| (2 − √(1 − λ²C²)))."""
    if master * cosh > 1:
        return 2
    cos, sin = (interval_of(part, 1 << 13, bits) for part in unit(correction, bits))
    ahead, aside = (interval_of(part, 1 << 13, bits) for part in unit(apart, bits))
    across, along = cos * aside * knuckle, -(cos * ahead * knuckle) + 1
    far = isqrt((across * across + along * along).high << bits) + 1
    rod = 2 * 2**bits - positive_root(1 - (master * cosh) ** 2, bits).low
    return ratio * (far * cosh + knuckle / master * sin.high * Fraction(rod, 2**bits)) / 2**bits


def of_corrected(k, bits, ratio, knuckle, master, apart, correction, part):
    """A part of h_k = 2k² L/r · mean(√(1 − Y²) e^(−ikψ)), Y = r/L (sin ψ − κ cos ε S + κ/λ sin ε √(1 − λ²S²)), S = sin(ψ + Δ)."""
    if ratio == 0:
        return Interval.of(0, bits), Interval.of(0, bits)
    factor = 2 * k * k / ratio
    fine = finer(bits, factor)
    q = widest(lambda cosh: bound_of_corrected(ratio, knuckle, master, apart, correction, cosh))
    (cos_e, sin_e), (ahead, aside) = ([interval_of(x, 1 << 13, fine) for x in unit(turn, fine)] for turn in (correction, apart))
    one = Interval.of(1, fine)

    def root(cos, sin):
        S = sin * ahead + cos * aside
        swung = S * master
        Y = (sin - S * cos_e * knuckle + (one - swung * swung).root() * sin_e * (knuckle / master)) * ratio
        return (one - Y * Y).root()

    re, im = harmonic(root, k, points(q, 2, k, fine), fine)
    return (re if part == "real" else im) * factor, Interval.of(0, fine)


@lru_cache(maxsize=1000)
def check_turns_round(link):
    """A link lets the crank turn round."""
    _, master, knuckle, angle, ratio, correction = link
    apart = lambda turn: min(turn % 1, -turn % 1)
    if correction % 1 == 0:
        demand(reach(ratio, knuckle, apart(angle), 128).high < 1 << 128, "the link cannot turn round")
    else:
        near = Fraction(99, 100)
        demand(0 < master <= near, "the master rod is too short")
        far = bound_of_corrected(ratio, knuckle, master, apart(angle), apart(correction), Fraction(1))
        demand(far <= near + Fraction(1, 2**100), "the link is too short")
