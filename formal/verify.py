#!/usr/bin/env python3
"""Does a document of crankstar prove what it says? A second checker: one file, the standard library only.

    python3 formal/verify.py FILE…      answers 0: all verified, 1: one is refused, 2: one is no document of crankstar

Every verdict is about a sum  S = Σ weight · e^(2πi·angle)  with rational weights and angles (in turns). The checker rebuilds S from
the engine that the document names and then believes nothing but arithmetic with whole numbers: it never searches. The format is told
in src/proof/README.md. What it does not check it names, document by document, in lines that begin with "not checked".
"""
import json
import re
import sys
from collections import namedtuple
from contextlib import contextmanager
from fractions import Fraction
from math import comb, gcd, lcm

# ------------------------------------------------------------------------------------------------ reading, strictly


class Refused(Exception):
    """A claim that does not hold; `place` tells where."""
    place = ""


class NoDocument(Exception):
    """A file that is no document of crankstar."""


def demand(holds, why):
    if not holds:
        raise Refused(why)


@contextmanager
def at(place):
    try:
        yield
    except Refused as refused:
        refused.place = f"{place}{'.' if refused.place else ''}{refused.place}"
        raise


def fields(entry, required, optional="", **due):
    """The values of exactly these keys, None for an optional one that is left out; those in `due` have to be what they are there."""
    demand(isinstance(entry, dict), "here stands no object")
    allowed = required.split() + optional.split()
    for key in required.split() + list(due):
        demand(key in entry, f"the key {key} is missing")
    for key, value in entry.items():
        demand(key in allowed or key in due, f"the key {key} is unknown")
        demand(key not in due or value == due[key] and type(value) is type(due[key]), f"{key} is {value!r}, and {due.get(key)!r} is due")
    return [entry.get(key) for key in allowed]


def exact(text):
    """A rational number in lowest terms, which is written as a string."""
    demand(isinstance(text, str) and re.fullmatch("-?[0-9]{1,5000}(/[1-9][0-9]{0,4999})?", text), f"{text!r} is no number")
    number = Fraction(text)
    demand(str(number) == text, f"{text} is not in lowest terms")
    return number


def or_zero(text):
    return Fraction(0) if text is None else exact(text)


def count(number, least=0):
    demand(type(number) is int and number >= least, f"{number!r} is no whole number from {least} on")
    return number


def items(entry):
    demand(isinstance(entry, list), "here stands no list")
    return entry


def in_turn(name, entries, due):
    """Each thing that is due with its entry."""
    demand(len(items(entries)) == len(due), f"{len(entries)} {name} where {len(due)} are due")
    return zip(due, entries)


def one_of(word, words):
    demand(type(word) is str and word in words, f"{word!r} is none of {', '.join(words)}")
    return word


def vectors(entry):
    """Terms as the document writes them: pairs of an angle and a weight."""
    return [(exact(angle) % 1, exact(weight)) for angle, weight in (fields(one, "angle weight") for one in items(entry))]


def no_key_twice(pairs):
    if len(dict(pairs)) < len(pairs):
        raise ValueError("a key stands twice")
    return dict(pairs)


# -------------------------------------------------------------------------------------- sums, and certificates on them


def collect(terms):
    """Like directions added, no weight zero: {angle: weight}."""
    total = {}
    for angle, weight in terms:
        total[angle % 1] = total.get(angle % 1, 0) + weight
    return {angle: weight for angle, weight in total.items() if weight}


def unequal(one, other):
    """|S|² − |R|² as a sum."""
    squared = lambda total, sign: [(t - u, sign * v * w) for t, v in total.items() for u, w in total.items()]
    return squared(collect(one), 1) + squared(collect(other), -1)


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
    total, kind = collect(terms), isinstance(certificate, dict) and certificate.get("kind")
    with at("certificate"):
        check = {"polygons": polygons, "residue": residue, "splitting": splitting}[one_of(kind, ["polygons", "residue", "splitting"])]
        demand(vanishes in (None, check is polygons), "it proves the contrary of the verdict")
        check(total, certificate)
    CHECKED[0] += 1
    return check is polygons


def polygons(total, certificate):
    """The corners of a regular polygon sum to zero, so a sum of polygons is zero."""
    corners, left = [], 100_000
    for polygon in items(fields(certificate, "kind polygons")[1]):
        sides, rotation, weight = fields(polygon, "sides rotation weight")
        left -= count(sides, 2)
        demand(left >= 0, "the polygons have more than 100,000 corners")
        corners += [(exact(rotation) + Fraction(j, sides), exact(weight)) for j in range(sides)]
    demand(collect(corners) == total, "the polygons do not add up to the terms")


def residue(total, certificate):
    """e^(2πi/N) ↦ g maps sums to numbers modulo ℓ, so that a sum with an image other than 0 is not zero.

    It respects products where Φ_N(g) ≡ 0: g^N − 1 is the product of all Φ_d(g), d | N, and those with d < N divide some g^(N/q) − 1,
    which has no factor in common with ℓ."""
    N, modulus, g, scale, claimed = [exact(text) for text in fields(certificate, "kind conductor prime root scale residue")[1:]]
    demand(all(x.denominator == 1 for x in (N, modulus, g, scale, claimed)), "these are whole numbers")
    N, modulus, g, scale, claimed = map(int, (N, modulus, g, scale, claimed))
    demand(1 <= N <= 1_000_000 and modulus >= 2 and scale >= 1, "conductor, modulus or scale is out of range")
    demand(pow(g, N, modulus) == 1, "the root to the conductor is not 1")
    for q in primes_of(N):
        demand(gcd(pow(g, N // q, modulus) - 1, modulus) == 1, f"the root has a smaller order: see {N}/{q}")
    demand(all((t * N).denominator == 1 == (w * scale).denominator for t, w in total.items()), "an angle or a weight is not whole")
    image = sum(int(w * scale) * pow(g, int(t * N), modulus) for t, w in total.items()) % modulus
    demand(image == claimed and image != 0, f"the sum is {image} modulo {modulus}, not {claimed}, or it is 0")


def splitting(total, certificate):
    """Each step keeps a part that would be zero if the whole were; one vector that is left at the end is not zero."""
    for step in items(fields(certificate, "kind steps")[1]):
        N = lcm(1, *(t.denominator for t in total))
        if "class" in step:
            angle, modulus = map(exact, fields(fields(step, "class")[0], "angle modulus"))
            demand(modulus.denominator == 1 and modulus > 0, "the modulus of a class is whole and positive")
            # x^p − ζ is irreducible where p² | N, and n < p terms leave a class empty: the classes vanish one by one.
            forced = [p for p in range(2, len(total) + 1) if N % p == 0 and modulus % p and primes_of(p) == [p]]
            demand(not forced, f"{forced} divide the conductor and not the modulus")
            total = collect((t - angle, w) for t, w in total.items() if ((t - angle) * modulus).denominator == 1)
        else:
            p, first, second = (count(n) for n in fields(fields(step, "compare")[0], "prime first second"))
            demand(p <= 1_000_000 and primes_of(p) == [p] and first != second and max(first, second) < p, "no two classes of a prime")
            rest = N // gcd(N, p)
            demand(rest % p, "the prime divides the conductor twice")
            # t = u/p + x, the denominator of x prime to p: times rest, u·rest ≡ t·p·rest (mod p).
            inverse = pow(rest, -1, p)
            class_of = {t: int(t * p * rest) * inverse % p for t in total}
            # 1 + x + … + x^(p−1) is irreducible over the rest: the classes of a vanishing sum are equal.
            part = lambda u, sign: [(t - Fraction(u, p), sign * w) for t, w in total.items() if class_of[t] == u]
            total = collect(part(first, 1) + part(second, -1))
    demand(len(total) == 1, f"{len(total)} vectors are left instead of one")


# --------------------------------------------------------------------------------------------- the engine and its terms

Cylinder = namedtuple("Cylinder", "name throw bank position size radius rod speed knuckle against axis")  # size: mass times radius
Turning = namedtuple("Turning", "name order sense position angle size rod axis")
Group = namedtuple("Group", "is_zero sums")  # of the sources before one number: whether that is 0, and {sense: [(name, angle, weight)]}
QUANTITIES = ["force", "moment", "torque", "roll"]
SENSES = {"force": ["direct", "reverse"], "moment": ["direct", "reverse"], "torque": [None], "roll": [None]}
MASSES = ["reciprocating", "rotating", "counterweights", "all"]
ONE, QUARTER, HALF = ("one",), Fraction(1, 4), Fraction(1, 2)


def read_rod(entry):
    if entry == "unknown":
        return ("unknown",)
    if "known" in entry:
        ratio, offset = map(exact, fields(fields(entry, "known")[0], "ratio offset"))
        demand(ratio >= 0 and ratio + abs(offset) < 1, "the rod cannot turn round")
        return ("rod", ratio, offset)
    *link, correction = fields(fields(entry, "link")[0], "master knuckle angle ratio", "correction")
    return ("link", *map(exact, link), or_zero(correction))


def read_turning(entry, free=""):
    """The masses that turn; each may hold the keys `free` too."""
    found = []
    for place, mass in enumerate(items(entry)):
        with at(f"turning_masses[{place}]"):
            order, sense, position, angle, size, name, rod, axis = \
                fields(mass, "order sense position angle mass_radius" + free, ("" if free else "name ") + "coefficient_of axis")
            rod = None if rod is None else read_rod(rod)
            demand(rod is None or rod[0] != "link", "a shaft takes the number of a link, which has several")
            sense = one_of(sense, SENSES["force"])
            found.append(Turning(name, count(order, 1), sense, exact(position), exact(angle), exact(size), rod, vectors(axis or [])))
    return found


def check_rods(cylinders, shafts=()):
    rods = [c.rod for c in cylinders] + [mass.rod for mass in shafts if mass.rod]
    demand(cylinders, "an engine has one cylinder at least")
    demand(len({rod == ("unknown",) for rod in rods}) == 1, "some rods are known and some are not")
    demand(all(c.rod[0] == "link" or c.knuckle == 0 for c in cylinders), "a knuckle weight without a link")
    demand(all(c.rod[0] != "link" or c.speed == 1 for c in cylinders), "a link on a faster crankshaft")


def phase(throw, bank, k, sense):
    """Order k of a cylinder: its force is direct at kβ − (k−1)α, reverse at −kβ + (k+1)α; its torque at k(β − α)."""
    return {"direct": k * throw - (k - 1) * bank, "reverse": (k + 1) * bank - k * throw, None: k * (throw - bank)}[sense]


def of_rod(rod, k):
    """The number before order k of a rod on the crankpin, whether it is 0, and the sign of the term."""
    if rod == ("unknown",):
        return (ONE, False, 1) if k == 1 else (("common",), k % 2 == 1, 1)
    _, ratio, offset = rod
    if k == 1:
        return (rod if offset else ONE), False, 1
    return ("rod", ratio, abs(offset)), ratio == 0 or offset == 0 and k % 2 == 1, -1 if offset < 0 and k % 2 else 1


def apart(angle):
    return min(angle % 1, -angle % 1)


def factors(rod, k):
    """The numbers that order k of a piston stands before: (number, whether it is 0, vectors that its own is multiplied by)."""
    if rod[0] != "link":
        number, is_zero, sign = of_rod(rod, k)
        return [(number, is_zero, [(0, sign)])]
    _, master, knuckle, delta, ratio, eps = rod
    if k > 5000:
        raise NoDocument(f"order {k} of a link is more than this checker expands")
    number, is_zero, _ = of_rod(("rod", master, 0), k)
    if eps % 1 == 0:
        if k == 1:
            return [(ONE, False, [(0, 1)])]
        own = ("linkage", ratio, knuckle, apart(delta)), ratio == 0, [(u * delta, comb(k, u) * (-knuckle) ** u) for u in range(k + 1)]
        return [(number, is_zero, [(k * delta, knuckle)])] + [own] * (k % 2 == 0)
    found = []
    if k == 1:
        found = [(ONE, False, [(0, 1), (delta - eps, knuckle / 2), (delta + eps, -knuckle / 2)])]
    elif k % 2 == 0:
        found = [(number, is_zero, [(k * delta + eps, knuckle / 2), (k * delta - eps, knuckle / 2)])]
    sign = -1 if k % 2 and (delta % 1 > HALF) != (eps % 1 > HALF) else 1
    own, along = ("corrected", ratio, knuckle, master, apart(delta), apart(eps)), delta * 2 % 1 == 0
    real = (own + ("real",), ratio == 0 or along and k % 2 == 1, [(0, sign)])
    return found + [real, (own + ("imaginary",), ratio == 0 or along and k % 2 == 0, [(-QUARTER if delta % 1 > HALF else QUARTER, sign)])]


def arms(cylinder):
    """What the axis of a cylinder has for an arm about the middle of the engine: vectors that its force is multiplied by."""
    found = []
    for eta, d in cylinder.axis:
        across = (cylinder.bank - eta - QUARTER) % 1
        if across in (0, HALF):
            found.append((across, d))
        elif across not in (QUARTER, 3 * QUARTER):  # there the axis passes through the middle
            found += [(-across, d / 2), (across, d / 2)]
    if cylinder.rod[0] == "rod" and cylinder.rod[2]:
        demand(cylinder.rod[1] > 0, "an endless rod with an offset has no arm")
        found.append((0, (1 if cylinder.against else -1) * cylinder.rod[2] * cylinder.radius / cylinder.rod[1]))
    return found


def groups(cylinders, turning, plane, quantity, k):
    """The terms of order k of a quantity, by the numbers that they stand before: {number: Group}."""
    found = {}

    def add(number, is_zero, name, sense, terms, speed=1):
        number = number if number == ONE or speed == 1 else ("geared", speed, number)
        group = found.setdefault(number, Group(is_zero, {one: [] for one in SENSES[quantity]}))
        group.sums[sense].extend((name, Fraction(angle) % 1, weight) for angle, weight in terms)

    lever = lambda position: position - plane if quantity == "moment" else 1
    for c in cylinders:
        if k % c.speed:
            continue
        own, faster = k // c.speed, c.speed**2
        if quantity in ("force", "moment"):
            for number, is_zero, parts in factors(c.rod, own):
                for sense, way in (("direct", 1), ("reverse", -1)):
                    angle = phase(c.throw, c.bank, own, sense)
                    terms = [(angle + way * turned, c.size * lever(c.position) * faster * part) for turned, part in parts]
                    add(number, is_zero, c.name, sense, terms, c.speed)
            continue
        angle, weight = phase(c.throw, c.bank, own, None), c.size * c.radius
        force = arms(c) if quantity == "roll" else []
        if force:
            (number, is_zero, [(_, sign)]), = factors(c.rod, own)
            add(number, is_zero, c.name, None, [(angle + turned, c.size * faster * sign * arm) for turned, arm in force], c.speed)
        weight *= c.speed**3 if quantity == "torque" else faster if c.against else -faster
        number = ("common torque",) if c.rod == ("unknown",) else ("torque", *c.rod[1:])
        add(number, len(number) > 1 and c.rod[1] == 0 and own != 2, c.name, None, [(angle, weight)], c.speed)
    for c in cylinders if quantity in ("force", "moment") else []:
        if c.knuckle:  # a mass at the knuckle pin moves with the master's piston, turned by Δ + ε in either sense
            _, master, knuckle, delta, _, eps = c.rod
            number, is_zero, _ = of_rod(("rod", master, 0), k)
            for sense in SENSES["force"]:
                angle = phase(c.throw, c.bank - delta, k, sense) + delta + eps
                add(number, is_zero, f"knuckle of cylinder {c.name}", sense, [(angle, c.knuckle * knuckle * lever(c.position))])
    for mass in turning if quantity != "torque" else []:
        if mass.order == k and (quantity != "roll" or mass.axis):
            number, is_zero, sign = of_rod(mass.rod, k) if mass.rod else (ONE, False, 1)
            if quantity == "roll":
                way = 1 if mass.sense == "direct" else -1
                terms = [(way * (mass.angle - eta - QUARTER), k * k * mass.size * d * sign) for eta, d in mass.axis]
                add(number, is_zero, mass.name, None, terms)
            else:
                add(number, is_zero, mass.name, mass.sense, [(mass.angle, 2 * k * k * mass.size * lever(mass.position) * sign)])
    return found or {ONE: Group(False, {sense: [] for sense in SENSES[quantity]})}


def plain(terms):
    return [(angle, weight) for _, angle, weight in terms]


# ------------------------------------------------------------------------------------------------- verdicts on an engine


def check_classify(document, notes):
    """Returns {(quantity, order): [whether the whole is zero, per sense; None where it is not decided]} and the shapes."""
    _, title, masses, orders, quantities, plane, cylinders, all_orders, turning, verdicts, wholes, shapes, theorems = fields(
        document, "format title masses orders quantities reference_plane cylinders all_orders turning_masses verdicts wholes shapes theorems")
    one_of(masses, MASSES)
    check_asked(orders, quantities, QUANTITIES)
    plane, listed = exact(plane), []
    for place, entry in enumerate(items(cylinders)):
        with at(f"cylinders[{place}]"):
            name, throw, bank, position, mass, radius, rod, speed, knuckle, crank = fields(
                entry, "name throw bank position reciprocating_mass crank_radius rod", "speed knuckle_weight crankshaft")
            sense, axis = fields(crank, "sense axis") if crank else ("direct", [])
            demand(not crank or "roll" in quantities, "a crankshaft is named with the roll moment alone")
            speed = 1 if speed is None else count(speed, 2)
            listed.append(Cylinder(name, exact(throw), exact(bank), exact(position), exact(mass) * exact(radius), exact(radius),
                                   read_rod(rod), speed, or_zero(knuckle), one_of(sense, SENSES["force"]) == "reverse", vectors(axis)))
    check_rods(listed)
    turning = read_turning(turning, " name")
    names = [c.name for c in listed] + [mass.name for mass in turning] + [f"knuckle of cylinder {c.name}" for c in listed if c.knuckle]
    demand(len(set(names)) == len(names), "two sources have the same name")
    demand(masses != "reciprocating" or not turning, "the verdicts are about the reciprocating masses alone")
    demand("roll" in quantities or not any(mass.axis for mass in turning), "an axis is named with the roll moment alone")
    if any(c.rod[0] == "link" for c in listed):
        demand(set(quantities) <= {"force", "moment"}, "torque and roll moment of links are not judged")
        notes.add("that the links can turn round")
    moving = listed if masses in ("reciprocating", "all") else []
    plan = {(quantity, k): groups(moving, turning, plane, quantity, k) for k in orders for quantity in quantities}
    due = [(quantity, k, number, sense) for (quantity, k), found in plan.items() for number in found for sense in SENSES[quantity]]
    zeros = {}
    for about, entry in in_turn("verdicts", verdicts, due):
        zeros[about] = check_verdict(entry, *about, plan[about[:2]])
    left = {(quantity, k, sense): [n for n, group in found.items() if not group.is_zero and not zeros[quantity, k, n, sense]]
            for (quantity, k), found in plan.items() for sense in SENSES[quantity]}  # the numbers whose sums are not zero
    judged = {about: [zeros[*about, *found, sense] for sense in SENSES[about[0]]] if len(found) == 1 else []
              for about, found in plan.items()}
    for about, entry in in_turn("wholes", wholes, [about for about in left if len(plan[about[:2]]) > 1]):
        judged[about[:2]].append(check_whole(entry, *about, left[about], notes))
    told = {}
    for about, entry in in_turn("shapes", shapes, [about for about in plan if len(SENSES[about[0]]) == 2]):
        told[about] = check_shape(entry, *about, judged[about], [left[*about, sense] for sense in SENSES["force"]], plan[about], notes)
    demand(type(all_orders) is bool, "all_orders is true or false")
    due = [(quantity, sense) for quantity in quantities if len(SENSES[quantity]) == 2 for sense in SENSES[quantity] if all_orders]
    for about, entry in in_turn("theorems", theorems, due):
        with at(f"theorems ({', '.join(about)})"):
            check_theorem(entry, *about, moving, turning, plane)
    return judged, told


def check_asked(orders, quantities, allowed):
    demand(items(orders) and all(count(k, 1) for k in orders) and sorted(set(orders)) == orders, "orders rise from 1 on")
    demand(items(quantities) and quantities == [q for q in allowed if q in quantities], f"quantities stand in the order {allowed}")


def check_zero(vanishes, modulus, degrees):
    demand(type(vanishes) is bool and type(modulus) in (int, float), "vanishes is true or false, and modulus a decimal")
    demand((modulus == 0) == vanishes == (degrees is None), "modulus and angle_deg contradict vanishes")


def check_verdict(entry, quantity, k, number, sense, found):
    with at(f"verdicts ({quantity}, order {k}, {sense})"):
        vanishes, terms, modulus, degrees, certificate, of = fields(
            entry, "vanishes terms modulus angle_deg certificate", "of", quantity=quantity, order=k, sense=sense)
        due = found[number].sums[sense]
        demand((of or []) == [name for name, _, _ in due if len(found) > 1], "`of` does not name the sources of the terms")
        demand(vectors(terms) == plain(due), "the terms are not those of the engine")
        check_zero(vanishes, modulus, degrees)
        return certify(plain(due), certificate, vanishes)


def is_open(number):
    return number[0].startswith("common") or number[0] == "geared" and is_open(number[2])


def check_whole(entry, quantity, k, sense, left, notes):
    """Whether all of an order is zero, the sums of which stand before several numbers; those in `left` are not zero."""
    with at(f"wholes ({quantity}, order {k}, {sense})"):
        outcome, = fields(entry, "outcome", quantity=quantity, order=k, sense=sense)
        # That c_k, t_k and g_k are not zero where they are there is a theorem (src/motion); of the parts of h_k there is none.
        if not left:
            right, answer = "zero", True
        elif len(left) == 1 and left[0][0] != "corrected":
            right, answer = "not-zero", False
        elif len(left) > 1 and any(map(is_open, left)):
            right, answer = "open", None
        else:
            kind = one_of(next(iter(outcome)), ["not-zero-by-enclosure", "not-decided"]) if isinstance(outcome, dict) else None
            demand(kind, f"{len(left)} sums are left, which takes an enclosure")
            key, = fields(outcome, kind)
            number, = fields(key, "bits" if kind == "not-zero-by-enclosure" else "below")
            notes.add(f"enclosures of several sums before different numbers of the motion ({kind})")
            return False if kind == "not-zero-by-enclosure" else None
        demand(outcome == right, f"it is {right}")
        return answer


def check_shape(entry, quantity, k, zeros, left, found, notes):
    """What both vectors of an order leave together."""
    with at(f"shapes ({quantity}, order {k})"):
        shape, certificate, mirror, bits = fields(entry, "shape", "certificate mirror bits", quantity=quantity, order=k)
        right = {(True, True): "balanced", (False, True): "rotating", (True, False): "counter-rotating",
                 (False, False): None}.get(tuple(zeros), "not-decided")
        if right:
            demand(shape == right and certificate is mirror is bits is None, f"the shape is {right}, without a certificate")
            return shape
        direct, reverse = left
        alone = list(found) if len(found) == 1 else direct if len(direct) == 1 and direct == reverse else []
        for number in alone:  # one sum each, before the same number
            one_of(shape, ["planar", "elliptical"])
            demand(mirror is bits is None, "a certificate compares the lengths of single sums")
            certify(unequal(*(plain(terms) for terms in found[number].sums.values())), certificate, shape == "planar")
        if alone:
            return shape
        if shape == "planar":
            sign, certificates = fields(mirror, "sign certificates")
            there = [group for group in found.values() if not group.is_zero]
            demand(certificate is bits is None and sign in (1, -1) and len(certificates) == len(there), "the mirror does not fit the sums")
            for group, proof in zip(there, certificates):
                away = plain(group.sums["direct"]) + [(-t, -sign * w) for t, w in plain(group.sums["reverse"])]
                certify(away, proof, True)
        elif shape == "elliptical":
            demand(certificate is mirror is None and count(bits, 32), "an ellipse of several sums is told by `bits`")
            demand(not any(map(is_open, direct + reverse)), "the rods are not known")
            notes.add("enclosures of the lengths of both vectors (elliptical)")
        else:
            demand(shape == "not-decided" and certificate is mirror is bits is None, "not-decided is told by nothing")
        return shape


def check_theorem(entry, quantity, sense, cylinders, turning, plane):
    """Every angle is a multiple of 1/period and order k multiplies it, so the verdicts of one period hold for every order."""
    period, survivors, verdicts = fields(entry, "period survivors verdicts", quantity=quantity, sense=sense)
    rods = {c.rod for c in cylinders}
    demand(len(rods) <= 1 and all(rod[0] == "unknown" or rod[0] == "rod" and rod[2] == 0 for rod in rods), "the rods are not equal and centric")
    demand(all(c.speed == 1 for c in cylinders) and all(mass.order == 1 for mass in turning), "something turns faster than the crank")
    period = exact(period)
    demand(period.denominator == 1 and period > 0 and period % 2 == 0, "the period is positive and even")
    demand(all((angle * period).denominator == 1 for c in cylinders for angle in (c.throw, c.bank)), "an angle is not whole in it")
    demand(2 * len(items(verdicts)) == period + 2, "there is not one verdict for each order of the period")
    order_one, modulus, residues = fields(survivors, "order_one modulus residues")
    demand(type(order_one) is bool and count(modulus, 2) % 2 == 0 and period % modulus == 0, "the modulus is no even divisor of the period")
    demand(residues == [r for r in range(0, modulus, 2) if r in residues], "the residues are even numbers below the modulus, rising")
    for q in primes_of(modulus // 2):
        demand({(r + modulus // q) % modulus for r in residues} != set(residues), "a smaller modulus says the same")
    for k, verdict in zip([1, *range(2, int(period) + 1, 2)], verdicts):
        with at(f"order {k}"):
            vanishes, certificate = fields(verdict, "vanishes certificate", order=k)
            group, = groups(cylinders, turning, plane, quantity, k).values()
            demand(type(vanishes) is bool and vanishes is not (order_one if k == 1 else k % modulus in residues), "the statement contradicts the verdict")
            certify(plain(group.sums[sense]), certificate, vanishes)


# ------------------------------------------------------------------------------------- families: open angles and lengths


def check_family(document, notes):
    _, title, masses, orders, quantities, plane, cylinders, verdicts = fields(
        document, "format title masses orders quantities reference_plane cylinders open_verdicts")
    one_of(masses, ["reciprocating"])
    check_asked(orders, quantities, ["force", "moment"])
    plane, listed = linear(plane), []
    for place, entry in enumerate(items(cylinders)):
        with at(f"cylinders[{place}]"):
            name, throw, bank, position, mass, radius = fields(entry, "name throw bank position reciprocating_mass crank_radius")
            listed.append((name, linear(throw, True), linear(bank, True), linear(position), exact(mass) * exact(radius)))
    demand(listed and len({name for name, *_ in listed}) == len(listed), "cylinders are missing, or two have the same name")
    due = [(quantity, k, sense) for k in orders for quantity in quantities for sense in SENSES[quantity]]
    for (quantity, k, sense), entry in in_turn("open_verdicts", verdicts, due):
        with at(f"open_verdicts ({quantity}, order {k}, {sense})"):
            sums, = fields(entry, "sums", quantity=quantity, order=k, sense=sense)
            check_open(sums, open_sums(listed, plane, quantity, k, sense), notes)


def linear(entry, is_angle=False):
    """A linear expression: {symbol: coefficient}, the known part under "1"."""
    demand(isinstance(entry, dict) and "1" in entry, 'the known part, under "1", is missing')
    demand(not is_angle or set(entry) <= {"1", "phi", "delta"}, "an angle holds another unknown than phi and delta")
    found = {symbol: exact(number) for symbol, number in entry.items()}
    demand(all(number for symbol, number in found.items() if symbol != "1"), "a symbol is taken 0 times")
    return found


def open_sums(cylinders, plane, quantity, k, sense):
    """{length: {(multiple of φ, of δ): terms}}, with the lengths that some cylinder has a weight for; None is for known ones."""
    terms = []
    for _, throw, bank, position, size in cylinders:
        known, phi, delta = (phase(throw.get(one, 0), bank.get(one, 0), k, sense) for one in ("1", "phi", "delta"))
        arm = {one: position.get(one, 0) - plane.get(one, 0) for one in {**position, **plane}} if quantity == "moment" else {"1": 1}
        terms.append(((phi, delta), Fraction(known) % 1, {one: size * length for one, length in arm.items()}))
    found = {}
    for length in {one for _, _, weights in terms for one, weight in weights.items() if weight}:
        parts = found[None if length == "1" else length] = {}
        for turned, angle, weights in terms:
            parts.setdefault(turned, []).append((angle, weights.get(length, 0)))
    return found


def check_open(sums, expected, notes):
    """When a sum over open angles is zero follows from its parts that are not zero: Σ e^i(phi·φ + delta·δ) S."""
    demand({one.get("symbol") for one in items(sums)} == set(expected) and len(sums) == len(expected), "the sums are not those of the lengths")
    for entry in sums:
        symbol, parts, when = fields(entry, "symbol parts when")
        with at(f"sum of {symbol or 'known lengths'}"):
            left, seen = [], {}
            for phi, delta, terms, certificate in (fields(part, "phi delta terms certificate") for part in items(parts)):
                turned, terms = (exact(phi), exact(delta)), vectors(terms)
                seen[turned] = terms
                if not certify(terms, certificate):
                    left.append((turned, terms))
            demand(seen == expected[symbol] and len(seen) == len(parts), "the parts are not those of the cylinders")
            with at("when"):
                check_when(when, left, notes)


def check_when(when, left, notes):
    kind, against = when.get("kind"), lambda a, b: tuple(x - y for x, y in zip(a[0], b[0]))
    of_parts = {"always": [0], "never": [1], "unequal-lengths": [2], "equal-lengths": [2], "where": [2, 3], "cosine": [3],
                "not-solved": range(3, len(left) + 1)}
    if one_of(kind, [kind]) not in of_parts:
        return notes.add(f"when a sum vanishes, where it is told as {kind!r}")
    demand(len(left) in of_parts[kind], f"{len(left)} parts do not vanish, which contradicts {kind}")
    if kind in ("always", "never", "not-solved"):
        fields(when, "kind")
    elif kind in ("unequal-lengths", "equal-lengths"):
        certify(unequal(*(terms for _, terms in left)), fields(when, "kind certificate")[1], kind == "equal-lengths")
    elif kind == "where":
        # Two parts cancel at one turn against each other; three of equal length where they stand 120° apart, either way round.
        _, alternatives, equal = fields(when, "kind alternatives equal_lengths")
        demand((len(alternatives), len(equal)) == ((1, 0) if len(left) == 2 else (2, 2)), "there are too few alternatives, or too many")
        for part, certificate in zip(left[1:], equal):
            certify(unequal(left[0][1], part[1]), certificate, True)
        turns = []
        for conditions, certificate in (fields(one, "conditions certificate") for one in alternatives):
            told = [tuple(map(exact, fields(condition, "phi delta turn"))) for condition in conditions]
            demand([one[:2] for one in told] == [against(part, left[0]) for part in left[1:]], "a condition is about other parts")
            turns.append([one[2] % 1 for one in told])
            certify(left[0][1] + [(t + turn, w) for part, turn in zip(left[1:], turns[-1]) for t, w in part[1]], certificate, True)
        demand(len(turns) == 1 or all(a != b for a, b in zip(*turns)), "the two alternatives are the same")
    else:
        # S (1 + 2q cos x) with q = −1/(2 cosine) vanishes exactly where cos x is the cosine.
        _, middle, phi, delta, turn, cosine, multiples = fields(when, "kind middle phi delta turn cosine multiples")
        phi, delta, turn, cosine = map(exact, (phi, delta, turn, cosine))
        demand(0 < abs(cosine) < 1 and middle in (0, 1, 2) and len(multiples) == 2, "the cosine, or the part in the middle, is out of range")
        others = left[:middle] + left[middle + 1:]
        for part, sign, certificate in zip(others, (1, -1), multiples):
            demand(against(part, left[middle]) == (sign * phi, sign * delta), "the parts do not turn against the middle one so")
            certify([(t - sign * turn, w) for t, w in part[1]] + [(t, w / (2 * cosine)) for t, w in left[middle][1]], certificate, True)


# -------------------------------------------------------------------------------- remedies, firing stars, numbers, files


def read_number(entry):
    """A coefficient as a remedy names it."""
    if entry in ("one", "common"):
        return (entry,)
    (kind, value), = entry.items() if isinstance(entry, dict) and len(entry) == 1 else demand(False, f"{entry!r} is no coefficient")
    if kind == "geared":
        speed, number = fields(value, "speed of")
        return ("geared", count(speed, 2), read_number(number))
    keys = {"rod": "ratio offset", "linkage": "ratio knuckle apart", "corrected": "ratio knuckle master apart correction"}
    *told, part = fields(value, keys[one_of(kind, keys)], "part" if kind == "corrected" else "") + [None] * (kind != "corrected")
    return (kind, *map(exact, told)) + ((one_of(part, ["real", "imaginary"]),) if part else ())


def check_remedy(document, notes):
    _, title, masses, orders, quantities, plane, cylinders, turning, weights, sums, left_out = fields(
        document, "format title masses orders quantities reference_plane cylinders turning_masses weights sums", "left_out")
    one_of(masses, ["all"])
    check_asked(orders, quantities, QUANTITIES)
    demand(quantities == ["force", "moment"], "a remedy is about force and moment")
    plane, listed, found = exact(plane), [], {}
    for place, entry in enumerate(items(cylinders)):
        with at(f"cylinders[{place}]"):
            *numbers, rod, speed, knuckle = fields(entry, "throw bank position weight rod", "speed knuckle_weight")
            speed = 1 if speed is None else count(speed, 2)
            listed.append(Cylinder(place, *map(exact, numbers), None, read_rod(rod), speed, or_zero(knuckle), False, []))
    turning = read_turning(turning)
    check_rods(listed, turning)
    may_stay = [tuple(fields(one, "order sense")) for one in items(left_out or [])]
    for entry in items(sums):
        quantity, k, sense, number, terms, certificate = fields(entry, "quantity order sense coefficient terms certificate")
        key = quantity, k, sense, read_number(number)
        demand(key not in found, f"sums: {key} stands twice")
        found[key] = vectors(terms), certificate
    added = []
    for place, entry in enumerate(items(weights)):
        with at(f"weights[{place}]"):
            k, sense, position, parts = fields(entry, "order sense position parts")
            demand(k in orders and sense in SENSES["force"], "it turns at an order or in a sense that is not asked for")
            for number, terms, modulus, degrees in (fields(part, "coefficient terms modulus angle_deg") for part in items(parts)):
                check_zero(False, modulus, degrees)
                added.append((k, sense, exact(position), read_number(number), vectors(terms)))
    for k in orders:
        for quantity in quantities:
            of_order = groups(listed, turning, plane, quantity, k)
            for sense in SENSES[quantity]:
                terms = {number: plain(group.sums[sense]) for number, group in of_order.items() if not group.is_zero}
                for order, way, position, number, parts in added:
                    if (order, way) == (k, sense):
                        share = 2 * k * k * (position - plane if quantity == "moment" else 1)
                        terms[number] = terms.get(number, []) + [(t, w * share) for t, w in parts]
                terms = {number: collect(of) for number, of in terms.items() if collect(of)} or {ONE: {}}
                for number, total in terms.items():
                    with at(f"sums ({quantity}, order {k}, {sense}, {number[0]})"):
                        demand((quantity, k, sense, number) in found, "this sum is missing")
                        told, certificate = found.pop((quantity, k, sense, number))
                        demand(told == sorted(total.items()), "the terms are not those of the engine and the weights, collected")
                        certify(told, certificate, None if (k, sense) in may_stay else True)
    demand(not found, f"sums: {list(found)} are none of the engine")


def check_firing(document, notes):
    _, title, cycle, cylinders, orders, verdicts, pattern = fields(document, "format title cycle cylinders orders verdicts pattern")
    turns, stars, listed = {"two-stroke": 1, "four-stroke": 2}[one_of(cycle, ["two-stroke", "four-stroke"])], {}, []
    for place, entry in enumerate(items(cylinders)):
        with at(f"cylinders[{place}]"):
            name, throw, bank, firing, radius, deflection, rod = fields(entry, "name throw bank firing_angle crank_radius deflection rod")
            firing, rod = exact(firing), read_rod(rod)
            listed.append(((firing - exact(bank) + exact(throw)) % 1, name, rod, firing))
            demand(0 <= firing < turns and listed[-1][0] == listed[0][0], "it does not fire in the cycle, at a top dead centre of its own")
            alike = "endless" if rod[:2] == ("rod", 0) else rod
            stars.setdefault(alike, []).append((name, firing, exact(radius) * exact(deflection)))
    demand(any(one[3] == 0 for one in listed), "no cylinder fires at 0")
    demand(len({one[1] for one in listed}) == len(listed), "two cylinders have the same name")
    demand(len({one[2] == ("unknown",) for one in listed}) == 1, "some rods are known and some are not")
    star = lambda of, order: [(-order * firing % 1, weight) for _, firing, weight in of]
    orders = [exact(order) for order in items(orders)]
    demand((orders or pattern) and sorted(set(orders)) == orders and all(k > 0 and k * turns % 1 == 0 for k in orders), "orders rise, of the cycle")
    for (k, of), entry in in_turn("verdicts", verdicts, [(k, of) for k in orders for of in stars.values()]):
        with at(f"verdicts (order {k})"):
            vanishes, terms, modulus, degrees, certificate, names = fields(
                entry, "vanishes terms modulus angle_deg certificate", "of", order=str(k))
            demand((names or []) == [one[0] for one in of if len(stars) > 1], "`of` does not name the cylinders of the star")
            demand(vectors(terms) == star(of, k), "the terms are not those of the star")
            check_zero(vanishes, modulus, degrees)
            certify(star(of, k), certificate, vanishes)
    if pattern is not None:
        period, verdicts = fields(pattern, "period verdicts")
        demand(all(firing * count(period, 1) / turns % 1 == 0 for *_, firing in listed), "a star does not repeat after the period")
        demand(period <= len(items(verdicts)), "pattern: verdicts are missing")
        due = [(Fraction(index, turns), of) for index in range(1, period + 1) for of in stars.values()]
        for (k, of), entry in in_turn("pattern.verdicts", verdicts, due):
            with at(f"pattern.verdicts (order {k})"):
                vanishes, certificate = fields(entry, "vanishes certificate", order=str(k))
                demand(type(vanishes) is bool, "vanishes is true or false")
                certify(star(of, k), certificate, vanishes)


def check_evidence(document, notes):
    """Of loads, comparisons and sweeps: the documents of verdicts in them, and what the rest repeats of those."""
    notes.add("all numbers outside of `evidence`")
    proved, kind = [], document["format"].split()[1]
    for place, one in enumerate(items(document.get("evidence"))):
        with at(f"evidence[{place}]"):
            demand(isinstance(one, dict) and one.get("format") == "crankstar classify 2", "it is no document of verdicts")
            proved.append(check_classify(one, notes))
    demand(proved, "there is no evidence")
    if kind == "loads":
        demand(len(proved) == 1, "loads are those of one engine")
        for entry in document["orders"]:
            both = proved[0][0].get((entry["quantity"], entry["order"]), "nothing")
            whole = True if both == [True, True] else False if False in both else None
            told = [entry["direct"]["vanishes"], entry["reverse"]["vanishes"]], entry["vanishes"]
            demand(told == (both, whole), f"orders: order {entry['order']} is not what the evidence says")
        for entry in document["torque"]:
            demand([entry["vanishes"]] == proved[0][0].get(("torque", entry["order"])), f"torque: order {entry['order']} differs")
    if kind == "compare":
        demand(len(document["engines"]) == len(proved), "there is one document of evidence for each engine")
        for engine, (_, shapes) in zip(document["engines"], proved):
            for entry in engine["orders"]:
                for quantity in ("force", "moment"):
                    demand(entry[quantity]["shape"] == shapes.get((quantity, entry["order"])), f"engines: order {entry['order']} differs")


CHECKS = {"classify 2": check_classify, "family 2": check_family, "remedy 2": check_remedy, "firing 1": check_firing,
          "loads 2": check_evidence, "compare 2": check_evidence, "sweep 2": check_evidence}
CHECKED = [0]  # certificates so far


def verify(path):
    """Returns how many certificates hold, and what is not checked."""
    with open(path, encoding="utf-8") as file:
        try:
            document = json.load(file, object_pairs_hook=no_key_twice)
        except (ValueError, RecursionError) as error:
            raise NoDocument(f"not read as JSON: {error}")
    name = document.get("format") if isinstance(document, dict) else None
    if not isinstance(name, str) or name.removeprefix("crankstar ") not in CHECKS:
        raise NoDocument("it has no `format` that this checker knows")
    notes = {"titles and other names", "decimals (modulus, angle_deg), but that they are 0 where the verdict is"}
    CHECKED[0] = 0
    try:
        CHECKS[name.removeprefix("crankstar ")](document, notes)
    except (KeyError, TypeError, AttributeError, ValueError, ZeroDivisionError) as error:
        raise Refused(f"it is not as the format says: {error!r}")
    return CHECKED[0], sorted(notes)


def main(paths):
    answer = 0 if paths else 2
    for path in paths:
        try:
            certificates, notes = verify(path)
            print(f"{path}: verified, {certificates} certificates", *(f"not checked: {note}" for note in notes), sep="\n  ")
        except Refused as refused:
            answer = max(answer, 1)
            print(f"{path}: refused at {refused.place or 'the document'}: {refused}")
        except (NoDocument, OSError, UnicodeDecodeError) as error:
            answer = 2
            print(f"{path}: {error}")
    return answer


if __name__ == "__main__":
    sys.set_int_max_str_digits(0)
    sys.exit(main(sys.argv[1:]))
