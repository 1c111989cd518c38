"""Is a sum of vectors zero, and for which angles, where some are open? The arithmetic of the second checker, verify.py.

Part 1 reads, part 2 checks certificates of a sum  S = Σ weight · e^(2πi·angle),  parts 3 and 4 what is said of sums that open angles
turn. Nothing here searches: every function takes what is claimed, and refuses it or returns.
"""
import re
from fractions import Fraction
from functools import lru_cache
from math import ceil, gcd, isqrt, lcm

# ---- 1. Reading: every key is known, no key stands twice, every number is exact ------------------------------------------

# What an object may hold; after a bar what may be left out.
SHAPES = [[part.split() for part in (shape + "|").split("|")[:2]] for shape in """
format title masses orders quantities reference_plane cylinders all_orders turning_masses verdicts wholes shapes theorems | recurrences
format title masses orders quantities reference_plane cylinders open_verdicts
format title masses orders quantities reference_plane cylinders turning_masses weights sums | left_out
format title cycle cylinders orders verdicts pattern
name throw bank position reciprocating_mass crank_radius rod | speed knuckle_weight crankshaft
name throw bank position reciprocating_mass crank_radius
throw bank position weight rod | speed knuckle_weight
name throw bank firing_angle crank_radius deflection rod
name order sense position angle mass_radius | coefficient_of axis
order sense position angle mass_radius | coefficient_of
known
link
ratio offset
master knuckle angle ratio | correction
sense axis
angle weight
quantity order sense vanishes terms modulus angle_deg certificate | of
order vanishes terms modulus angle_deg certificate | of
order vanishes certificate
kind polygons
sides rotation weight
kind conductor prime root scale residue
kind steps
class
angle modulus
compare
prime first second
quantity order sense outcome
not-zero-by-enclosure
not-decided
bits
below
quantity order shape | certificate mirror bits
sign certificates
quantity sense period survivors verdicts
order_one modulus residues
quantity order sense sums
symbol parts when
phi delta terms certificate
kind
kind certificate
kind alternatives equal_lengths
conditions certificate
phi delta turn
kind middle phi delta turn cosine multiples
kind phi delta bits mirrored from arcs | divided
without coprime powers equalities
phi delta conductor prime root scale u v
phi delta bits mirrored from arcs
kind to
kind to at certificates
kind shape alternatives
kind bits
kind phi delta second squares circle meetings
kind certificates
kind first turn certificate
kind first
kind groups certificates group firsts
kind phi delta conductor prime root scale u v
order sense position parts
coefficient terms modulus angle_deg
quantity order sense coefficient terms certificate
order sense
rod
linkage
corrected
ratio knuckle apart
ratio knuckle master apart correction part
geared
speed of
period verdicts
quantity sense first even odd
sums | outcome
vanishes certificate
of factors
terms period judged zeros
per_order fixed weight
modulus residues
""".strip().splitlines()]
OPTIONAL = {key for _, more in SHAPES for key in more}
WHOLE = "orders order speed sides bits sign prime first second modulus residues middle period angle_deg below conductor root u v groups".split()  # without quotes
TRUTH = "vanishes all_orders order_one".split()
WORDS = "title name of symbol".split()  # which may look like numbers
# When a sum over open angles is zero, and how many parts of it are then not zero.
WHENS = {"always": [0], "never": [1], "unequal-lengths": [2], "equal-lengths": [2], "where": [2, 3], "cosine": [3],
         "coprime": range(2, 1_000_000), "circle": range(2, 1_000_000), "triangle": [3], "classes": range(2, 1_000_000),
         "product": range(4, 1_000_000), "not-solved": range(3, 1_000_000)}
PLACE = []  # where the checker is, for its answer
CHECKED = [0]  # certificates so far


class Refused(Exception):
    """A claim that does not hold."""


class NoDocument(Exception):
    """A file that is no document of crankstar, or outside of what is checked."""


def demand(holds, why):
    if not holds:
        raise Refused(why)


class Entry(dict):
    """An object of a document: its keys as attributes, None for one that may be left out and is."""
    def __getattr__(self, key):
        return self.get(key) if key in OPTIONAL else self[key]


class Decimal:
    """A number with a point, which is shown and never reckoned with."""
    def __init__(self, text):
        self.is_zero = float(text) == 0


def read(value, key=""):
    """The value with exact numbers as fractions; refused if it is written in another way than the format has it."""
    if isinstance(value, dict):
        if key in ("when", "group", "firsts") and value.get("kind") not in WHENS:
            return Entry(value)
        if "1" in value:  # a linear expression: symbols with their coefficients
            return {symbol: read(number) for symbol, number in value.items()}
        known = any(set(needed) <= set(value) <= set(needed + more) for needed, more in SHAPES)
        demand(known, f"{key or 'it'} has the keys {', '.join(value)}, or lacks one")
        return Entry((inner, read(entry, inner)) for inner, entry in value.items())
    if isinstance(value, list):
        return [read(one, key) for one in value]
    if isinstance(value, str) and key not in WORDS and re.match("[-+0-9]", value):
        demand(re.fullmatch("-?[0-9]{1,5000}(/[1-9][0-9]{0,4999})?", value), f"{value!r} is no number")
        demand(str(Fraction(value)) == value, f"{value} is not in lowest terms")
        return Fraction(value)
    fits = type(value) is bool if key in TRUTH else key in WHOLE if type(value) is int else type(value) is not bool
    demand(fits and (key not in ("title", "name") or type(value) is str), f"{key} is {value!r}")
    return value


def each(name, entries, due=None):
    """The entries of a list, or each thing that is due with its entry; keeps the place."""
    due = entries if due is None else due
    demand(type(entries) is list and len(entries) == len(due), f"{len(entries)} {name} where {len(due)} are due")
    PLACE.append("")
    for index, (one, entry) in enumerate(zip(due, entries)):
        PLACE[-1] = f"{name}[{index}]"
        yield entry if due is entries else (one, entry)
    PLACE.pop()


def equal(entry, **due):
    for key, value in due.items():
        demand(entry[key] == value, f"{key} is {entry[key]}, and {value} is due")


def no_key_twice(pairs):
    if len(dict(pairs)) < len(pairs):
        raise ValueError("a key stands twice")
    return dict(pairs)


# ---- 2. Sums and certificates ----------------------------------------------------------------------------------------------


def terms_of(entry):
    """Terms as a document writes them: pairs of an angle and a weight."""
    return [(one.angle % 1, one.weight) for one in entry]


def collect(terms):
    """Like directions added, no weight zero: {angle: weight}."""
    total = {}
    for angle, weight in terms.items() if isinstance(terms, dict) else terms:
        total[angle % 1] = total.get(angle % 1, 0) + weight
    return {angle: weight for angle, weight in total.items() if weight}


def unequal(one, other):
    """|S|² − |R|² as a sum."""
    return times(one, conjugate(one)) + times(other, conjugate(other), -1)


def primes_of(number):
    found, p = [], 2
    while p * p <= number:
        if number % p == 0:
            found.append(p)
            while number % p == 0:
                number //= p
        p += 1
    return found + [number] * (number > 1)


def certify(terms, certificate, vanishes=None):
    """Checks the certificate of a sum and returns whether it is zero, which has to be `vanishes` where that is given."""
    kinds = {"polygons": polygons, "residue": residue, "splitting": splitting}
    demand(isinstance(certificate, Entry) and certificate.kind in kinds, "a certificate is missing")
    is_zero = certificate.kind == "polygons"
    demand(vanishes is None or vanishes is is_zero, "the certificate proves the contrary of the verdict")
    kinds[certificate.kind](collect(terms), certificate)
    CHECKED[0] += 1
    return is_zero


def polygons(total, certificate):
    """The corners of a regular polygon sum to zero, so a sum of polygons is zero."""
    corners = []
    for one in certificate.polygons:
        demand(2 <= one.sides <= 100_000 - len(corners), "a polygon has from 2 to 100,000 sides, all together")
        corners += [(one.rotation + Fraction(j, one.sides), one.weight) for j in range(one.sides)]
    demand(collect(corners) == total, "the polygons do not add up to the terms")


def residue(total, certificate):
    """e^(2πi/N) ↦ g maps sums to numbers modulo ℓ, so that a sum with an image other than 0 is not zero.

    It respects products where Φ_N(g) ≡ 0: g^N − 1 is the product of all Φ_d(g), d | N, and those with d < N divide some
    g^(N/q) − 1, which has no factor in common with ℓ."""
    numbers = [certificate[key] for key in ("conductor", "prime", "root", "scale", "residue")]
    demand(all(type(x) is Fraction and x.denominator == 1 for x in numbers), "a residue is told by whole numbers")
    N, modulus, g, scale, claimed = map(int, numbers)
    demand(1 <= N <= 1_000_000 and modulus >= 2 and scale >= 1, "conductor, modulus or scale is out of range")
    demand(pow(g, N, modulus) == 1, "the root to the conductor is not 1")
    for q in primes_of(N):
        demand(gcd(pow(g, N // q, modulus) - 1, modulus) == 1, f"the root has a smaller order: see {N}/{q}")
    demand(all((t * N).denominator == 1 == (w * scale).denominator for t, w in total.items()), "an angle or weight is not whole")
    image = sum(int(w * scale) * pow(g, int(t * N), modulus) for t, w in total.items()) % modulus
    demand(image == claimed and image != 0, f"the sum is {image} modulo {modulus}, not {claimed}, or it is 0")


def splitting(total, certificate):
    """Each step keeps a part that would be zero if the whole were; one vector that is left at the end is not zero."""
    for step in certificate.steps:
        N = lcm(1, *(t.denominator for t in total))
        if "class" in step:
            angle, modulus = step["class"].angle, step["class"].modulus
            demand(modulus.denominator == 1 and modulus > 0, "the modulus of a class is whole and positive")
            # x^p − ζ is irreducible where p² | N, and n < p terms leave a class empty: the classes vanish one by one.
            forced = [p for p in range(2, len(total) + 1) if N % p == 0 and modulus % p and primes_of(p) == [p]]
            demand(not forced, f"{forced} divide the conductor and not the modulus")
            total = collect((t - angle, w) for t, w in total.items() if ((t - angle) * modulus).denominator == 1)
        else:
            p, first, second = step.compare.prime, step.compare.first, step.compare.second
            demand(p <= 1_000_000 and primes_of(p) == [p] and 0 <= min(first, second) < max(first, second) < p,
                   "these are no two classes of a prime")
            rest = N // gcd(N, p)
            demand(rest % p, "the prime divides the conductor twice")
            # t = u/p + x, the denominator of x prime to p: times p·rest, u·rest ≡ t·p·rest (mod p).
            class_of = {t: int(t * p * rest) * pow(rest, -1, p) % p for t in total}
            # 1 + x + … + x^(p−1) is irreducible over the rest: the classes of a vanishing sum are equal.
            part = lambda u, sign: [(t - Fraction(u, p), sign * w) for t, w in total.items() if class_of[t] == u]
            total = collect(part(first, 1) + part(second, -1))
    demand(len(total) == 1, f"{len(total)} vectors are left instead of one")


# ---- 3. When a sum is zero that open angles turn ---------------------------------------------------------------------------


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def conjugate(total):
    return {-angle: weight for angle, weight in total.items()}


def times(one, other, sign=1):
    """The terms of A·B, or −A·B."""
    return [(t + u, sign * v * w) for t, v in one.items() for u, w in other.items()]


def check_when(when, left, notes):
    """`left` are the parts that are not zero: pairs of the multiples of (φ, δ) that turn a part, and its sum {angle: weight}."""
    if when.kind not in WHENS:
        demand(type(when.kind) is str, "`when` is of no kind")
        return notes.add(f"when a sum vanishes, where it is told as {when.kind!r}")
    demand(len(left) in WHENS[when.kind], f"{len(left)} parts do not vanish, which contradicts {when.kind}")
    if when.kind in ("unequal-lengths", "equal-lengths"):
        certify(unequal(left[0][1], left[1][1]), when.certificate, when.kind == "equal-lengths")
    elif when.kind == "where":
        # Two parts cancel at one turn against each other; three of equal length where they stand 120° apart, either way round.
        for part, certificate in each("equal_lengths", when.equal_lengths, left[1:] if len(left) == 3 else []):
            certify(unequal(left[0][1], part[1]), certificate, True)
        turns = [alternative(one, left) for _, one in each("alternatives", when.alternatives, left[1:])]
        demand(len(turns) == 1 or all(a != b for a, b in zip(*turns)), "the two alternatives are the same")
    elif when.kind == "cosine":
        # S (1 + 2q cos x) with q = −1/(2 cosine) vanishes exactly where cos x is the cosine.
        demand(0 < abs(when.cosine) < 1 and when.middle in (0, 1, 2), "the cosine, or the part in the middle, is out of range")
        turned, middle = left[when.middle]
        others = left[:when.middle] + left[when.middle + 1:]
        for ((other, part), sign), certificate in each("multiples", when.multiples, list(zip(others, (1, -1)))):
            demand(minus(other, turned) == [sign * when.phi, sign * when.delta], "the parts do not turn against the middle one so")
            away = [(t, w / (2 * when.cosine)) for t, w in middle.items()]
            certify([(t - sign * when.turn, w) for t, w in part.items()] + away, certificate, True)
    elif when.kind in ("coprime", "circle"):
        exponents = multiples(when, [minus(turned, left[0][0]) for turned, _ in left])
        demand(exponents == sorted(set(exponents)), "the unknown enters no rising whole times")
        demand(gcd(*exponents) == 1, "the exponents have a common divisor, or are too large")
        polynomial = list(zip(exponents, (total for _, total in left)))
        if when.kind == "coprime":
            coprime(when, polynomial)
        else:
            circle(when, divided(when, polynomial) if when.divided else polynomial, notes)
    elif when.kind in ("triangle", "product", "classes"):
        {"triangle": triangle, "product": product, "classes": classes}[when.kind](when, left, notes)


def alternative(one, left):
    """The parts after the first, turned as the conditions say, cancel the first; returns the turns."""
    due = [tuple(minus(turned, left[0][0])) for turned, _ in left[1:]]
    demand([(c.phi, c.delta) for c in one.conditions] == due, "it is about other parts")
    turns = [c.turn % 1 for c in one.conditions]
    moved = [(t + turn, w) for (_, part), turn in zip(left[1:], turns) for t, w in part.items()]
    certify([*left[0][1].items(), *moved], one.certificate, True)
    return turns


def multiples(claim, turned):
    """How many times each angle (a·φ + b·δ) is the unknown u = phi·φ + delta·δ."""
    phi, delta = claim.phi, claim.delta
    demand(phi > 0 or phi == 0 < delta, "the unknown has no direction")
    found = [a / phi if phi else b / delta for a, b in turned]
    demand([[phi * n, delta * n] for n in found] == turned, "a part turns otherwise than the unknown")
    demand(all(n.denominator == 1 and 0 <= n for n in found), "the unknown enters no rising whole times")
    demand(all(n <= 4096 for n in found), "the exponents have a common divisor, or are too large")
    return [int(n) for n in found]


def triangle(claim, left, notes):
    """Three vectors that turn freely close a triangle: 2(ab + bc + ca) − a² − b² − c², 16 times its squared area by Heron, decides
    whether there is none, one that is flat, or two. a, b, c are the squared sides."""
    (a, b), (c, d) = (minus(turned, left[0][0]) for turned, _ in left[1:])
    demand(a * d != b * c, "the parts are not turned against each other by two angles on their own")
    squares = [collect(times(conjugate(total), total)) for _, total in left]
    area = collect(term for a in squares for b in squares for term in times(a, b, -1 if a is b else 1))
    kind = claim["shape"].kind
    demand(kind in ("never", "flat", "two"), "the triangle is of no such shape")
    if kind == "flat":
        certify(area, claim["shape"].certificate, True)
    else:
        size, _, doubt = enclose(area, common_denominator([area]), bits_of(claim["shape"]))
        demand((size if kind == "two" else -size) > doubt, "the squared area does not have this sign, or the bits leave it open")
    most = ["never", "flat", "two"].index(kind)
    demand(len(claim.alternatives) <= most, f"{len(claim.alternatives)} triangles are named, and there are {most}")
    turns = [alternative(one, left) for one in each("alternatives", claim.alternatives)]
    demand(len(turns) < 2 or turns[0] != turns[1], "the two triangles are the same")
    CHECKED[0] += 1


def product(claim, left, notes):
    """Where S_gj S_00 = S_g0 S_0j, and each group turns within itself as the first, the sum times S_00 is the product of both factors."""
    groups = claim.groups
    demand(sorted(place for group in groups for place in group) == list(range(len(left))), "the groups do not hold each part once")
    demand(len(groups) >= 2 and len(groups[0]) >= 2 and {len(group) for group in groups} == {len(groups[0])}, "the groups are not alike")
    first, start = groups[0], left[groups[0][0]]
    due = [(left[group[0]], left[place], left[like]) for group in groups[1:] for place, like in list(zip(group, first))[1:]]
    for (base, part, like), certificate in each("certificates", claim.certificates, due):
        demand(minus(part[0], base[0]) == minus(like[0], start[0]), "a group is not turned within itself as the first")
        certify(times(part[1], start[1]) + times(base[1], like[1], -1), certificate, True)
    check_when(claim.group, [left[place] for place in first], notes)
    check_when(claim.firsts, [left[group[0]] for group in groups], notes)


def classes(claim, left, notes):
    """A(y) + e^(iv) B(y) with v on its own: zero where both are equally long, for one v, and for every v where both are zero. There
    |A|² − |B|², which is real, has a double zero, so that it is no crossing."""
    second = claim.second
    demand(second == sorted(set(second)) and all(0 <= place < len(left) for place in second), "the second class is no rising list of parts")
    both = [[part for place, part in enumerate(left) if (place in second) is is_second] for is_second in (False, True)]
    demand(all(both), "a class is empty")
    a, b = minus(both[1][0][0], both[0][0][0])
    demand(a * claim.delta != b * claim.phi, "the classes are not turned against each other by an angle on its own")
    both = [list(zip(multiples(claim, [minus(turned, of[0][0]) for turned, _ in of]), (total for _, total in of))) for of in both]
    squares = {}
    for of, sign in zip(both, (1, -1)):
        for low, one in of:
            for high, other in of:
                if high >= low:
                    squares.setdefault(high - low, []).extend(times(conjugate(one), other, sign))
    due = sorted((m, collect(terms)) for m, terms in squares.items())
    there = {m: total for (m, total), certificate in each("squares", claim.squares, due) if not certify(total, certificate)}
    if not any(there):
        return demand(claim.circle is None and claim.meetings == [], "the squares differ by a constant, so there is no circle")
    demand(claim.circle is not None, "where the classes are equally long is not said")
    demand((claim.circle.phi, claim.circle.delta) == (claim.phi, claim.delta), "the circle is not that of u")
    degree = max(there)
    whole = {degree - m: conjugate(total) for m, total in there.items()}
    whole.update({degree + m: total for m, total in there.items()})
    circle(claim.circle, sorted(whole.items()), notes)
    at = lambda of, turn, more=0: [(t + n * turn + more, w) for n, total in of for t, w in total.items()]
    rational = [arc["at"] for arc in claim.circle.arcs if arc.kind == "rational"]
    for turn, meeting in each("meetings", claim.meetings, rational):
        demand(meeting.kind in ("all", "rational", "once"), "a meeting is of no such kind")
        if meeting.kind == "all":
            for of, certificate in each("certificates", meeting.certificates, both):
                certify(at(of, turn), certificate, True)
        else:
            certify(at(both[0], turn), meeting["first"], False)
            if meeting.kind == "rational":
                certify(at(both[0], turn) + at(both[1], turn, meeting.turn), meeting.certificate, True)


def coprime(when, polynomial):
    """The sum is P = Σ S x^n with x = e^(iu). On the circle P = 0 gives P* = x^d conj(P) = 0: then their resultant is zero,
    and so is its image modulo a prime. But there P keeps its leading coefficient, and U P + V P* = 1 leaves no common factor."""
    N, p, g, scale = when.conductor, when.prime, when.root, when.scale
    demand(1 <= N <= 1_000_000 and p <= 2**32 and primes_of(p) == [p], "conductor or prime is out of range")
    demand(scale.denominator == 1 and scale >= 1, "the scale is whole and positive")
    demand(0 <= g < p and pow(g, N, p) == 1 and all(pow(g, N // q, p) != 1 for q in primes_of(N)), "the root has another order than the conductor")
    straight, mirrored = [0] * (polynomial[-1][0] + 1), [0] * (polynomial[-1][0] + 1)
    for n, total in polynomial:
        demand(all((t * N).denominator == 1 == (w * scale).denominator for t, w in total.items()), "an angle or weight is not whole")
        straight[n] = sum(int(w * scale) * pow(g, int(t * N), p) for t, w in total.items()) % p
        mirrored[-1 - n] = sum(int(w * scale) * pow(g, int(-t * N) % N, p) for t, w in total.items()) % p
    demand(straight[-1] != 0, "the leading coefficient is 0 modulo the prime")
    demand(all(type(one) is list and len(one) <= len(straight) and all(type(x) is int for x in one) for one in (when.u, when.v)), "u or v is too long")
    demand(all(0 <= x < p for x in when.u + when.v), "a coefficient is not below the prime")
    whole = [0] * (2 * len(straight))
    for factor, of in ((when.u, straight), (when.v, mirrored)):
        for i, a in enumerate(factor):
            for j, b in enumerate(of):
                whole[i + j] = (whole[i + j] + a * b) % p
    demand(whole == [1] + [0] * (len(whole) - 1), "U P + V P* is not 1 modulo the prime")
    CHECKED[0] += 1


def divided(when, polynomial):
    """The sum is Q F_1 F_2² F_3³ …, and Q vanishes nowhere on the circle: so it vanishes there where F_1 F_2 F_3 … does, which is
    returned. As the constant coefficient of the sum is not zero, that of no F is."""
    claim = when.divided
    demand((claim.coprime.phi, claim.coprime.delta) == (when.phi, when.delta), "the factor without zeros is not one in u")
    without, *powers = ([collect(terms_of(one)) for one in of] for of in [claim.without, *claim.powers])
    demand(powers and all(power and power[-1] == {0: 1} for power in powers) and len(powers[-1]) > 1, "a factor does not begin with 1")
    degree = len(without) + sum(n * (len(power) - 1) for n, power in enumerate(powers, 1)) - 1
    demand(without and degree == polynomial[-1][0], "the factors do not have the degree of the sum")
    coprime(claim.coprime, list(enumerate(without)))
    whole, once = without, [{0: 1}]
    for n, power in enumerate(powers, 1):
        once = multiplied(once, power)
        for _ in range(n if len(power) > 1 else 0):
            whole = multiplied(whole, power)
    for (of_sum, of_product), certificate in each("equalities", claim.equalities, [(dict(polynomial).get(n, {}), total) for n, total in enumerate(whole)]):
        certify([*of_sum.items()] + times(of_product, {0: 1}, -1), certificate, True)
    return [(n, total) for n, total in enumerate(once) if total]


def multiplied(one, other):
    """The product of two polynomials, coefficients from the constant one on."""
    terms = [[] for _ in range(len(one) + len(other) - 1)]
    for m, a in enumerate(one):
        for n, b in enumerate(other):
            terms[m + n] += times(a, b)
    return [collect(of) for of in terms]


# ---- 4. Arcs of the circle -------------------------------------------------------------------------------------------------
#
# An enclosed vector is (x, y, doubt) in units of 2^−bits: it is no farther than `doubt` from x + iy. All three are whole.

GUARD, UNIT_DOUBT = 64, 1 << 12


def arctangent_of(whole, bits):
    """arctan(1/whole), by its series; off by less than one for each term."""
    total, power, n = 0, (1 << bits) // whole, 0
    while power:
        total += (-1) ** n * power // (2 * n + 1)
        power, n = power // whole**2, n + 1
    return total


MOST_BITS = 512
TWO_PI = (32 * arctangent_of(5, MOST_BITS + 2 * GUARD) - 8 * arctangent_of(239, MOST_BITS + 2 * GUARD)) >> GUARD  # Machin


@lru_cache(maxsize=100_000)
def unit(turn, bits):
    """e^(2πi·turn): the quarter turns at once, and the rest, x < π/2, by Σ (ix)^n / n!. Its fewer than 200 terms are each off by what
    the ones before are, at most e^x times as much and some units more: together by less than UNIT_DOUBT."""
    quarters, rest = divmod(turn % 1, Fraction(1, 4))
    x = (TWO_PI >> MOST_BITS + GUARD - bits) * rest.numerator // rest.denominator
    term, n, sums = 1 << bits, 0, [0, 0, 0, 0]
    while term:
        sums[n % 4] += term
        n += 1
        term = term * x // n >> bits
    cos, sin = sums[0] - sums[2], sums[1] - sums[3]
    return [(cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos)][int(quarters)]


def bits_of(claim):
    demand(32 <= claim.bits <= MOST_BITS, f"an enclosure has 32 to {MOST_BITS} bits")
    return claim.bits + GUARD


def common_denominator(totals):
    return lcm(1, *(weight.denominator for total in totals for weight in total.values()))


def enclose(total, scale, bits):
    """A sum times `scale`, which makes its weights whole."""
    vectors = [(*unit(t, bits), int(w * scale)) for t, w in total.items()]
    return sum(w * x for x, _, w in vectors), sum(w * y for _, y, w in vectors), UNIT_DOUBT * sum(abs(w) for *_, w in vectors)


def added(vectors):
    return tuple(map(sum, zip(*vectors)))


def stretched(vector, by):
    return vector[0] * by, vector[1] * by, vector[2] * abs(by)


def turned(vector, turn, bits):
    (x, y, doubt), (cos, sin) = vector, unit(turn, bits)
    return x * cos - y * sin >> bits, x * sin + y * cos >> bits, doubt + ((abs(x) + abs(y)) * UNIT_DOUBT >> bits) + 3


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
            notes.add("arcs of the circle that are said to be open")
        low = high
    demand(low == claim["from"] + 1, "the arcs do not make one turn")
    CHECKED[0] += 1
