"""The second checker, verify.py: families, engines with open angles and lengths (src/kernel/proof/README.md)."""
from fractions import Fraction
from math import gcd

from arcs import circle
from verify import CHECKED, SENSES, beside, certify, check_asked, collect, demand, each, equal, phase, primes_of, read, terms_of, times, types, unequal

# When a sum over open angles is zero, and how many parts of it are then not zero.
MANY = 1_000_000
WHENS = {"always": [0], "never": [1], "unequal-lengths": [2], "equal-lengths": [2], "where": [2, 3], "cosine": [3], "coprime": range(2, MANY),
         "circle": range(2, MANY), "triangle": [3], "classes": range(2, MANY), "quadratic": range(3, MANY), "product": range(4, MANY), "boxes": range(3, MANY),
         "not-solved": range(3, MANY)}

types("""open-cylinder: name=text throw=linear bank=linear position=linear reciprocating_mass crank_radius;
    part-sum: phi delta terms=[vector] certificate; condition: phi delta turn; turned: conditions=[condition] certificate;
    identity: phi delta conductor=count prime=count root=count scale=integer u=[count] v=[count];
    divided: without=[[vector]] coprime=identity powers=[[[vector]]] equalities=[certificate];
    arc free: to; arc monotone: to; arc crossing: to; arc open: to; arc rational: to at certificates=[certificate];
    circle: phi delta divided? bits=count mirrored=[certificate] from arcs=[arc];
    area never: bits=count; area flat: certificate; area two: bits=count;
    meeting all: certificates=[certificate]; meeting rational: first=certificate turn certificate; meeting once: first=certificate;
    root: turn certificate; roots all: certificates=[certificate]; roots none: certificates=[certificate]; roots one: lengths=certificate at=[root];
    roots mirror: lengths=certificate first=certificate shape=area at=[root]; twist: coefficients=[certificate] signs=[area]; zero: s t reach certificate=certificate?;
    when always:; when never:; when not-solved:; when unequal-lengths: certificate; when equal-lengths: certificate;
    when where: alternatives=[turned] equal_lengths=[certificate]; when cosine: middle=count phi delta turn cosine multiples=[certificate];
    when coprime: phi delta conductor=count prime=count root=count scale=integer u=[count] v=[count];
    when circle: phi delta divided? bits=count mirrored=[certificate] from arcs=[arc]; when triangle: shape=area alternatives=[turned];
    when product: groups=[[count]] certificates=[certificate] group=when firsts=when;
    when classes: phi delta second=[count] squares=[certificate] circle=circle? meetings=[meeting];
    when quadratic: phi delta second=[count] third=[count] coefficients=[certificate] lengths=[certificate] twist? circle=circle? roots=[roots];
    when boxes: phi delta tree=text zeros=[zero];
    open-sum: symbol=text? parts=[part-sum] when; open-verdict: quantity order=count sense sums=[open-sum];
    family: format=text title=text masses orders=[count] quantities=[quantity] reference_plane=linear cylinders=[open-cylinder] open_verdicts=[open-verdict]""")

# ---- 1. The sum taken apart by what is open --------------------------------------------------------------------------------


def check(tree, notes):
    document = read(tree, "family")
    check_asked(document, ["force", "moment"])
    names = {c.name for c in document.cylinders}
    demand(document.masses == "reciprocating" and names and len(names) == len(document.cylinders), "two cylinders have the same name")
    for c in each("cylinders", document.cylinders):
        demand(set(c.throw) | set(c.bank) <= {"1", "phi", "delta"}, "an angle holds another unknown than phi and delta")
        for linear in (c.throw, c.bank, c.position, document.reference_plane):
            demand(all(number for symbol, number in linear.items() if symbol != "1"), "a symbol is taken 0 times")
    due = [(quantity, k, sense) for k in document.orders for quantity in document.quantities for sense in SENSES[quantity]]
    for (quantity, k, sense), entry in each("open_verdicts", document.open_verdicts, due):
        equal(entry, quantity=quantity, order=k, sense=sense)
        expected = open_sums(document, quantity, k, sense)
        lengths = sorted(expected, key=lambda symbol: (symbol is not None, symbol or ""))
        demand([one.symbol for one in entry.sums] == lengths, "the sums are not those of the lengths, the known ones first")
        for one in each("sums", entry.sums):
            check_open(one, expected[one.symbol], notes)
    demand(any(CHECKED), "nothing is proved: no cylinder has a weight")


def open_sums(document, quantity, k, sense):
    """{length: {(multiple of φ, of δ): terms}}, with the lengths that some cylinder has a weight for; None is for known ones."""
    terms, plane = [], document.reference_plane
    for c in document.cylinders:
        known, phi, delta = (phase(c.throw.get(one, 0), c.bank.get(one, 0), k, sense) for one in ("1", "phi", "delta"))
        arm = {one: c.position.get(one, 0) - plane.get(one, 0) for one in {**c.position, **plane}} if quantity == "moment" else {"1": 1}
        weights = {one: c.reciprocating_mass * c.crank_radius * length for one, length in arm.items()}
        terms.append(((phi, delta), Fraction(known) % 1, weights))
    found = {}
    for length in {one for _, _, weights in terms for one, weight in weights.items() if weight}:
        parts = found[None if length == "1" else length] = {}
        for turned, angle, weights in terms:
            parts.setdefault(turned, []).append((angle, weights.get(length, 0)))
    return found


def check_open(entry, expected, notes):
    """When a sum over open angles is zero follows from its parts that are not: Σ e^i(phi·φ + delta·δ) S."""
    parts = [((part.phi, part.delta), terms_of(part.terms)) for part in entry.parts]
    demand(parts == sorted(expected.items()), "the parts are not those of the cylinders, by rising multiples of φ and δ")
    left = [(turned, collect(terms)) for (turned, terms), part in zip(parts, entry.parts) if not certify(terms, part.certificate)]
    check_when(entry.when, left, notes)


# ---- 2. When a sum is zero that open angles turn ---------------------------------------------------------------------------


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def check_when(when, left, notes):
    """`left` are the parts that are not zero: pairs of the multiples of (φ, δ) that turn a part, and its sum {angle: weight}."""
    demand(len(left) in WHENS[when.kind], f"{len(left)} parts do not vanish, which contradicts {when.kind}")
    if when.kind in ("not-solved", "equal-lengths"):
        notes.add("the sums that are said to be `not-solved` or `equal-lengths`: no angles are claimed for them")
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
        demand(gcd(*exponents) == 1, "the exponents have a common divisor")
        polynomial = list(zip(exponents, (total for _, total in left)))
        if when.kind == "coprime":
            coprime(when, polynomial)
        else:
            circle(when, divided(when, polynomial) if when.divided else polynomial, notes)
    elif when.kind == "boxes":
        beside("boxes").check(when, left, notes)
    elif when.kind in ("triangle", "product", "classes", "quadratic"):
        beside("two_angles").check(when, left, notes)


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
    demand(all(n.denominator == 1 and abs(n) <= 4096 for n in found), "the unknown enters no whole times, or too many")
    return [int(n) for n in found]


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
    CHECKED[1] += 1


def divided(when, polynomial):
    """The sum is Q F_1 F_2² F_3³ …, coefficient by coefficient, and Q is never zero: so it is zero where F_1 F_2 F_3 … is, which is returned.
    Its constant coefficient is not zero, as that of the sum is not."""
    claim = when.divided
    demand((claim.coprime.phi, claim.coprime.delta) == (when.phi, when.delta), "the factor without zeros is not one in u")
    Q, *F = ([collect(terms_of(one)) for one in factor] for factor in [claim.without, *claim.powers])
    demand(all(len(total) == len(one) for total, one in zip(sum([Q, *F], []), sum(claim.powers, claim.without))), "terms are not collected")
    demand(F and all(factor and factor[-1] == {0: 1} for factor in F) and len(F[-1]) > 1, "a factor has another leading coefficient than 1")
    degree = len(Q) - 1 + sum(n * (len(factor) - 1) for n, factor in enumerate(F, 1))
    demand(Q and degree == polynomial[-1][0], "the factors do not have the degree of the sum")
    coprime(claim.coprime, [(n, total) for n, total in enumerate(Q) if total])
    whole, once = Q, [{0: 1}]
    for n, factor in enumerate(F, 1):
        once = multiplied(once, factor)
        for _ in range(n if len(factor) > 1 else 0):
            whole = multiplied(whole, factor)
    due = [(total, dict(polynomial).get(n, {})) for n, total in enumerate(whole)]
    for (total, of_sum), certificate in each("equalities", claim.equalities, due):
        certify([*of_sum.items(), *((t, -w) for t, w in total.items())], certificate, True)
    return [(n, total) for n, total in enumerate(once) if total]


def multiplied(one, other):
    """The product of two polynomials, coefficients from the constant one on."""
    found = [[] for _ in one[1:] + other]
    for m, a in enumerate(one):
        for n, b in enumerate(other):
            found[m + n] += times(a, b)
    return [collect(terms) for terms in found]
