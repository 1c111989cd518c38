"""The second checker, verify.py: orders whose sums stand before different numbers of the motion, as those of rods of different lengths.

Each sum is decided separately, and here the whole: zero or not, and whether both vectors are equally long. `left` are the sums that are
not zero, before numbers that are not: {number: sum}.
"""
from fractions import Fraction

from enclosures import GUARD, Interval, bits_of, common_denominator, enclose, exact, interval_of
from motion import number
from verify import ONE, certify, collect, conjugate, demand, each, plain, times, unequal

DOUBTFUL, BITS_OF_DOUBT = Fraction(1, 10**15), 256


def is_open(of):
    return of[0].startswith("common") or of[0] == "geared" and is_open(of[2])


def check_outcome(outcome, k, sense, left):
    """Whether the whole is zero; None where that is not decided."""
    # That c_k, t_k and g_k are not zero where they are there is a theorem (src/kernel/motion); of the parts of h_k there is none.
    if not left or len(left) == 1 and next(iter(left))[0] != "corrected":
        demand(outcome == ("not-zero" if left else "zero"), f"{len(left)} sums remain, which contradicts {outcome}")
        return not left
    if len(left) > 1 and any(map(is_open, left)):
        return demand(outcome == "open", "a number that is not known is multiplied by what remains: it is open")
    demand(isinstance(outcome, dict), f"{len(left)} sums remain, which takes an enclosure")
    if "not-zero-by-enclosure" in outcome:
        whole = Whole(k, [left], bits_of(outcome["not-zero-by-enclosure"]))
        demand(any(part.excludes_zero() for part in whole.sum(left, sense)), "zero is not excluded by an enclosure with so many bits")
        return False
    below, whole = exact(outcome["not-decided"].below), Whole(k, [left], BITS_OF_DOUBT + 2 * GUARD)
    demand(0 < below <= whole.largest * DOUBTFUL, "`below` is positive, and at most 10^-15 of the terms")
    stated = below * whole.scale * 2**whole.bits
    demand(sum(part.most() ** 2 for part in whole.sum(left, sense)) <= stated**2, "`below` is less than what an enclosure leaves")
    return None


def check_lengths(entry, k, left, found, evidence):
    """Planar: |direct|² − |reverse|² is a quadratic form in real numbers, whose coefficients are zero. Elliptical: an enclosure keeps the
    lengths apart. Or they are too near to tell."""
    is_known = not any(map(is_open, [*left[0], *left[1]]))
    if entry.shape == "planar":
        demand(evidence == ["pairs"], "planar is shown by `pairs`")
        sums = real_sums(found, k, [*left[0], *left[1]])
        pairs = [(a, b) for place, a in enumerate(sums) for b in sums[place:]]
        for (a, b), certificate in each("pairs", entry.pairs, pairs):
            half = times(a[0], conjugate(b[0])) + times(a[1], conjugate(b[1]), -1)
            certify(unequal(*a) if a is b else half + [(-t, w) for t, w in half], certificate, True)
    elif entry.shape == "elliptical":
        demand(evidence == ["bits"] and is_known, "elliptical is shown by `bits`, of rods that are known")
        demand(Whole(k, left, bits_of(entry)).difference(left).excludes_zero(), "equal lengths are not excluded by an enclosure with so many bits")
    else:
        demand(entry.shape == "not-decided" and not evidence, "the shape contradicts the verdicts")
        if is_known:
            whole = Whole(k, left, BITS_OF_DOUBT + GUARD)
            near = whole.difference(left).most() <= (whole.largest * whole.scale) ** 2 * DOUBTFUL * 2**whole.bits
            demand(near, "the two lengths are not so near to each other that it could be left open")


def real_parts(of, k):
    """The real numbers that a number is made of, with the turn that each gives to a direct sum, and the other way to a reverse one."""
    if of[0] == "geared":
        return [(part if part == ONE else ("geared", of[1], part), turn) for part, turn in real_parts(of[2], k // of[1])]
    if of[0] == "rod" and k == 1:
        return [(ONE, 0), (("quadrature", of[1], abs(of[2])), Fraction(1 if of[2] > 0 else -1, 4))]
    return [(of, Fraction(1, 4) if of[0] == "rod" and k % 2 else 0)]


def real_sums(found, k, there):
    """What stands before each real number, in the order of the numbers: the direct and the reverse sum. `there` is what is not zero in either."""
    sums = {}
    for of, (_, (direct, reverse)) in [(of, (zero, both.values())) for of, (zero, both) in found.items() if of in there]:
        for part, turn in real_parts(of, k):
            both = sums.setdefault(part, ([], []))
            both[0].extend((t + turn, w) for t, w in plain(direct))
            both[1].extend((t - turn, w) for t, w in plain(reverse))
    return [(collect(direct), collect(reverse)) for direct, reverse in sums.values()]


class Whole:
    """Several sums of order k, enclosed with so many bits behind the leading one of the largest number, and scaled to whole weights."""

    def __init__(self, k, lefts, bits):
        most = max(size(of, k) for left in lefts for of in left)
        self.k, self.bits = k, bits + max(0, int(1 / most).bit_length() - 1)
        self.scale = common_denominator([total for left in lefts for total in left.values()])
        weights = sum(abs(w) for left in lefts for total in left.values() for w in total.values())
        self.largest = weights * most  # no sum is larger

    def sum(self, left, sense):
        """Real and imaginary part of Σ number · sum; in the reverse sense the numbers are conjugated."""
        re = im = Interval(0, 0, self.bits)
        for of, total in left.items():
            x, y, doubt = enclose(total, self.scale, self.bits)
            x, y = interval_of(x, doubt, self.bits), interval_of(y, doubt, self.bits)
            a, b = number(of, self.k, self.bits)
            b = -b if sense == "reverse" else b
            re, im = re + x * a - y * b, im + x * b + y * a
        return re, im

    def difference(self, left):
        """|direct|² − |reverse|²."""
        squares = [re * re + im * im for re, im in (self.sum(one, sense) for one, sense in zip(left, ("direct", "reverse")))]
        return squares[0] - squares[1]


def size(of, k):
    """A bound of a number, which is not much larger."""
    bits = 64
    while True:
        most = max(part.most() for part in number(of, k, bits))
        if most >> 16 or bits >= 4096:
            return Fraction(2 * most, 2**bits)
        bits *= 2
