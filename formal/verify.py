#!/usr/bin/env python3
"""Does a document of crankstar prove what it says? A second checker: two files, the standard library only.

    python3 formal/verify.py FILE…      answers 0: all verified, 1: one is refused, 2: one is no document of crankstar

Every verdict is about a sum  S = Σ weight · e^(2πi·angle)  with rational weights and angles (in turns). The checker rebuilds S
from the engine that the document names, and then believes nothing but arithmetic with whole numbers: it never searches. The
format is told in src/proof/README.md. What is not checked is named, document by document, in lines with "not checked".

The arithmetic is in sums.py beside it, parts 1 to 4: reading, certificates, open angles, arcs. What engines are is here, parts 5 to 10.
To audit it, read parts 1 and 2, and then the part on the kind of document that you hold.
"""
import json
import sys
from fractions import Fraction
from math import comb, prod

sys.dont_write_bytecode = True  # a reader finds two files here, and no third
from sums import (CHECKED, PLACE, Decimal, NoDocument, Refused, certify, check_when, collect, demand, each, equal,  # noqa: E402
                  no_key_twice, primes_of, read, terms_of, unequal)

# ---- 5. From an engine to its terms ----------------------------------------------------------------------------------------

SENSES = {"force": ["direct", "reverse"], "moment": ["direct", "reverse"], "torque": [None], "roll": [None]}
ONE, QUARTER, HALF = ("one",), Fraction(1, 4), Fraction(1, 2)


def rod_of(entry):
    """("unknown",), ("rod", ratio, offset) or ("link", master, knuckle, angle, ratio, correction)."""
    if entry == "unknown":
        return ("unknown",)
    if "known" in entry:
        demand(entry.known.ratio >= 0 and entry.known.ratio + abs(entry.known.offset) < 1, "the rod cannot turn round")
        return ("rod", entry.known.ratio, entry.known.offset)
    link = entry.link
    return ("link", link.master, link.knuckle, link.angle, link.ratio, link.correction or Fraction(0))


def check_engine(cylinders, turning):
    """Rods are known or not, all alike, and nothing is said of a cylinder that is not reckoned with."""
    rods = [rod_of(c.rod) for c in cylinders]
    shafts = [rod_of(mass.coefficient_of) for mass in turning if mass.coefficient_of]
    demand(rods and len({rod == ("unknown",) for rod in rods + shafts}) == 1, "there is no rod, or some are known and some are not")
    demand(all(rod[0] != "link" for rod in shafts), "a shaft takes the number of a link, which has several")
    demand(all(rod[0] == "link" or not c.knuckle_weight for c, rod in zip(cylinders, rods)), "a knuckle weight without a link")
    demand(all(c.speed is None or type(c.speed) is int and c.speed > 1 and rod[0] != "link" for c, rod in zip(cylinders, rods)), "a speed is out of place")
    demand(all(mass.order >= 1 and mass.sense in SENSES["force"] for mass in turning), "a mass turns in no order or sense")


def phase(throw, bank, k, sense):
    """Order k of a cylinder: its force is direct at kβ − (k−1)α, reverse at −kβ + (k+1)α; its torque stands at k(β − α)."""
    return {"direct": k * throw - (k - 1) * bank, "reverse": (k + 1) * bank - k * throw, None: k * (throw - bank)}[sense]


def of_rod(rod, k):
    """The number before order k of a rod on the crankpin, whether it is 0, and the sign of the term."""
    if rod == ("unknown",):
        return (ONE, False, 1) if k == 1 else (("common",), k % 2 == 1, 1)
    _, ratio, offset = rod
    if k == 1:
        return (rod if offset else ONE), False, 1
    return ("rod", ratio, abs(offset)), ratio == 0 or offset == 0 and k % 2 == 1, -1 if offset < 0 and k % 2 else 1


def factors(rod, k):
    """The numbers that order k of a piston stands before: (number, whether it is 0, vectors that its own is multiplied by)."""
    if rod[0] != "link":
        number, is_zero, sign = of_rod(rod, k)
        return [(number, is_zero, [(0, sign)])]
    _, master, knuckle, delta, ratio, eps = rod
    if k > 5000:
        raise NoDocument(f"order {k} of a link is more than this checker expands")
    number, is_zero, _ = of_rod(("rod", master, 0), k)
    apart = lambda angle: min(angle % 1, -angle % 1)
    if eps % 1 == 0:
        if k == 1:
            return [(ONE, False, [(0, 1)])]
        own = [(u * delta, comb(k, u) * (-knuckle) ** u) for u in range(k + 1)]
        own = (("linkage", ratio, knuckle, apart(delta)), ratio == 0, own)
        return [(number, is_zero, [(k * delta, knuckle)])] + [own] * (k % 2 == 0)
    found, half = [], knuckle / 2
    if k == 1:
        found = [(ONE, False, [(0, 1), (delta - eps, half), (delta + eps, -half)])]
    elif k % 2 == 0:
        found = [(number, is_zero, [(k * delta + eps, half), (k * delta - eps, half)])]
    is_far, along = delta % 1 > HALF, delta * 2 % 1 == 0
    sign = -1 if k % 2 and is_far != (eps % 1 > HALF) else 1
    own = ("corrected", ratio, knuckle, master, apart(delta), apart(eps))
    return found + [(own + ("real",), ratio == 0 or along and k % 2 == 1, [(0, sign)]),
                    (own + ("imaginary",), ratio == 0 or along and k % 2 == 0, [(-QUARTER if is_far else QUARTER, sign)])]


def arms(c, rod, is_against):
    """What the axis of a cylinder has for an arm about the middle of the engine: vectors that its force is multiplied by."""
    found = []
    for eta, d in terms_of(c.crankshaft.axis if c.crankshaft else []):
        across = (c.bank - eta - QUARTER) % 1
        if across in (0, HALF):
            found.append((across, d))
        elif across not in (QUARTER, 3 * QUARTER):  # there the axis passes through the middle
            found += [(-across, d / 2), (across, d / 2)]
    if rod[0] == "rod" and rod[2]:
        demand(rod[1] > 0, "an endless rod with an offset has no arm")
        found.append((0, (1 if is_against else -1) * rod[2] * c.crank_radius / rod[1]))
    return found


def groups(cylinders, turning, plane, quantity, k):
    """The terms of order k of a quantity by the numbers before them: {number: (whether it is 0, {sense: [(name, angle, weight)]})}."""
    found = {}

    def add(number, is_zero, name, sense, terms, speed=1):
        number = number if number == ONE or speed == 1 else ("geared", speed, number)
        sums = found.setdefault(number, (is_zero, {one: [] for one in SENSES[quantity]}))[1]
        sums[sense].extend((name, Fraction(angle) % 1, weight) for angle, weight in terms)

    lever = lambda one: one.position - plane if quantity == "moment" else 1
    for c in cylinders:
        speed, rod = c.speed or 1, rod_of(c.rod)
        own, size = k // speed, c.weight if "weight" in c else c.reciprocating_mass * c.crank_radius
        if k % speed:
            continue
        if quantity in ("force", "moment"):
            for number, is_zero, parts in factors(rod, own):
                for sense, way in (("direct", 1), ("reverse", -1)):
                    angle = phase(c.throw, c.bank, own, sense)
                    terms = [(angle + way * turned, size * lever(c) * speed**2 * part) for turned, part in parts]
                    add(number, is_zero, c.get("name"), sense, terms, speed)
            continue
        angle, is_against = phase(c.throw, c.bank, own, None), c.crankshaft is not None and c.crankshaft.sense == "reverse"
        axis = arms(c, rod, is_against) if quantity == "roll" else []
        if axis:
            (number, is_zero, [(_, sign)]), = factors(rod, own)
            add(number, is_zero, c.get("name"), None, [(angle + turned, size * speed**2 * sign * arm) for turned, arm in axis], speed)
        times = speed**3 if quantity == "torque" else speed**2 if is_against else -speed**2
        number = ("common torque",) if rod == ("unknown",) else ("torque", *rod[1:])
        add(number, rod[0] == "rod" and rod[1] == 0 and own != 2, c.get("name"), None, [(angle, size * c.crank_radius * times)], speed)
    for c in cylinders if quantity in ("force", "moment") else []:
        if c.knuckle_weight:  # it moves with the master's piston, turned by Δ + ε in either sense
            _, master, knuckle, delta, _, eps = rod_of(c.rod)
            number, is_zero, _ = of_rod(("rod", master, 0), k)
            for sense in SENSES["force"]:
                angle = phase(c.throw, c.bank - delta, k, sense) + delta + eps
                add(number, is_zero, f"knuckle of cylinder {c.get('name')}", sense, [(angle, c.knuckle_weight * knuckle * lever(c))])
    for mass in turning if quantity != "torque" else []:
        if mass.order == k and (quantity != "roll" or mass.axis):
            number, is_zero, sign = of_rod(rod_of(mass.coefficient_of), k) if mass.coefficient_of else (ONE, False, 1)
            if quantity == "roll":
                way, size = 1 if mass.sense == "direct" else -1, k * k * mass.mass_radius * sign
                terms = [(way * (mass.angle - eta - QUARTER), size * d) for eta, d in terms_of(mass.axis)]
                add(number, is_zero, mass.get("name"), None, terms)
            else:
                add(number, is_zero, mass.get("name"), mass.sense, [(mass.angle, 2 * k * k * mass.mass_radius * lever(mass) * sign)])
    return found or {ONE: (False, {sense: [] for sense in SENSES[quantity]})}


def plain(terms):
    return [(angle, weight) for _, angle, weight in terms]


# ---- 6. Verdicts on an engine ----------------------------------------------------------------------------------------------


def check_classify(document, notes):
    """Returns {(quantity, order): [whether the whole is zero, per sense; None if that is not decided]}, and the shapes."""
    cylinders, turning, quantities = document.cylinders, document.turning_masses, document.quantities
    check_asked(document, list(SENSES))
    check_engine(cylinders, turning)
    demand(document.masses in ("reciprocating", "rotating", "counterweights", "all"), "masses are not those of the format")
    demand(document.masses != "reciprocating" or not turning, "the verdicts are about the reciprocating masses alone")
    names = [one.name for one in cylinders + turning] + [f"knuckle of cylinder {c.name}" for c in cylinders if c.knuckle_weight]
    demand(len(set(names)) == len(names), "two sources have the same name")
    demand("roll" in quantities or not any(one.crankshaft or one.axis for one in cylinders + turning), "an axis without roll moment")
    demand(all(c.crankshaft is None or c.crankshaft.sense in SENSES["force"] for c in cylinders), "a crankshaft has no such sense")
    if any("link" in c.rod for c in cylinders if c.rod != "unknown"):
        demand(set(quantities) <= {"force", "moment"}, "torque and roll moment of links are not judged")
        notes.add("that the links can turn round")
    moving = cylinders if document.masses in ("reciprocating", "all") else []
    engine = moving, turning, document.reference_plane
    plan = {(quantity, k): groups(*engine, quantity, k) for k in document.orders for quantity in quantities}
    due = [(*about, number, sense) for about, found in plan.items() for number in found for sense in SENSES[about[0]]]
    zeros = {about: check_verdict(entry, *about, plan[about[:2]]) for about, entry in each("verdicts", document.verdicts, due)}
    # The numbers before sums that are not zero, themselves not zero.
    left = {(*about, sense): [number for number, (is_zero, _) in found.items() if not is_zero and not zeros[(*about, number, sense)]]
            for about, found in plan.items() for sense in SENSES[about[0]]}
    judged = {about: [zeros[(*about, *found, sense)] for sense in SENSES[about[0]]] if len(found) == 1 else []
              for about, found in plan.items()}
    for about, entry in each("wholes", document.wholes, [about for about in left if len(plan[about[:2]]) > 1]):
        judged[about[:2]].append(check_whole(entry, *about, left[about], notes))
    due = [about for about in plan if len(SENSES[about[0]]) == 2]
    for about, entry in each("shapes", document.shapes, due):
        check_shape(entry, *about, judged[about], [left[(*about, sense)] for sense in SENSES["force"]], plan[about], notes)
    asked = [(quantity, sense) for quantity, k in due if k == document.orders[0] for sense in SENSES["force"] if document.all_orders]
    if document.recurrences:
        demand(document.theorems == [], "what is said class by class stands in `recurrences` alone")
        for about, entry in each("recurrences", document.recurrences, asked):
            check_recurrence(entry, *about, *engine, notes)
    else:
        for about, entry in each("theorems", document.theorems, asked):
            check_theorem(entry, *about, *engine)
    return judged, {(entry.quantity, entry.order): entry.shape for entry in document.shapes}


def check_asked(document, allowed):
    orders, quantities = document.orders, document.quantities
    demand(orders and all(type(k) is int and k >= 1 for k in orders) and sorted(set(orders)) == orders, "orders rise from 1 on")
    demand(quantities and quantities == [one for one in allowed if one in quantities], f"quantities stand in the order {allowed}")


def check_shown(entry, vanishes):
    """Of the decimals only whether they say zero."""
    is_zero = entry.modulus.is_zero if isinstance(entry.modulus, Decimal) else entry.modulus == 0
    demand(is_zero == vanishes == (entry.angle_deg is None), "modulus and angle_deg contradict vanishes")


def check_verdict(entry, quantity, k, number, sense, found):
    equal(entry, quantity=quantity, order=k, sense=sense)
    terms = found[number][1][sense]
    demand((entry.of or []) == [name for name, _, _ in terms if len(found) > 1], "`of` does not name the sources of the terms")
    demand(terms_of(entry.terms) == plain(terms), "the terms are not those of the engine")
    check_shown(entry, entry.vanishes)
    return certify(plain(terms), entry.certificate, entry.vanishes)


def is_open(number):
    return number[0].startswith("common") or number[0] == "geared" and is_open(number[2])


def check_whole(entry, quantity, k, sense, left, notes):
    """Whether an order is zero whose sums stand before several numbers; those in `left` are not zero."""
    equal(entry, quantity=quantity, order=k, sense=sense)
    return check_outcome(entry, left, notes)


def check_outcome(entry, left, notes):
    # That c_k, t_k and g_k are not zero where they are there is a theorem (src/motion); of the parts of h_k there is none.
    if not left or len(left) == 1 and left[0][0] != "corrected":
        equal(entry, outcome="not-zero" if left else "zero")
        return not left
    if len(left) > 1 and any(map(is_open, left)):
        return equal(entry, outcome="open")
    (kind, _), = entry.outcome.items()
    demand(kind in ("not-zero-by-enclosure", "not-decided"), f"{len(left)} sums are left, which takes an enclosure")
    notes.add(f"enclosures of several sums before different numbers of the motion ({kind})")
    return False if kind == "not-zero-by-enclosure" else None


def check_shape(entry, quantity, k, zeros, left, found, notes):
    """What both vectors of an order leave together."""
    equal(entry, quantity=quantity, order=k)
    evidence = [key for key in ("certificate", "mirror", "bits") if key in entry]
    right = {(True, True): "balanced", (False, True): "rotating", (True, False): "counter-rotating",
             (False, False): None}.get(tuple(zeros), "not-decided")
    if right:
        equal(entry, shape=right)
        return demand(not evidence, "no lengths are compared, so no evidence belongs here")
    alone = list(found) if len(found) == 1 else left[0] if len(left[0]) == 1 and left[0] == left[1] else []
    if alone:  # one sum each, before the same number
        demand(evidence == ["certificate"] and entry.shape in ("planar", "elliptical"), "a certificate compares the two lengths")
        certify(unequal(*(collect(plain(one)) for one in found[alone[0]][1].values())), entry.certificate, entry.shape == "planar")
    elif entry.shape == "planar":  # direct = ± conj(reverse), sum by sum
        there = [sums for is_zero, sums in found.values() if not is_zero]
        demand(evidence == ["mirror"] and entry.mirror.sign in (1, -1), "planar is shown by `mirror`")
        for sums, certificate in each("certificates", entry.mirror.certificates, there):
            image = [(-t, -entry.mirror.sign * w) for t, w in plain(sums["reverse"])]
            certify(plain(sums["direct"]) + image, certificate, True)
    elif entry.shape == "elliptical":
        demand(evidence == ["bits"] and not any(map(is_open, left[0] + left[1])), "elliptical is shown by `bits`, of rods that are known")
        notes.add("enclosures of the lengths of both vectors (elliptical)")
    else:
        demand(entry.shape == "not-decided" and not evidence, "the shape contradicts the verdicts")


def check_theorem(entry, quantity, sense, cylinders, turning, plane):
    """Every angle is a multiple of 1/period and order k multiplies it, so the verdicts of one period hold for every order."""
    equal(entry, quantity=quantity, sense=sense)
    rods, period = {rod_of(c.rod) for c in cylinders}, entry.period
    demand(len(rods) <= 1 and all(rod[0] == "unknown" or rod[0] == "rod" and rod[2] == 0 for rod in rods), "rods are not equal and centric")
    demand(not any(c.speed for c in cylinders) and all(mass.order == 1 for mass in turning), "something turns faster than the crank")
    demand(period > 0 and period % 2 == 0, "the period is positive and even")
    demand(all((angle * period).denominator == 1 for c in cylinders for angle in (c.throw, c.bank)), "an angle is not whole in it")
    demand(2 * len(entry.verdicts) == period + 2, "there is not one verdict for each order of the period")
    modulus, residues = entry.survivors.modulus, entry.survivors.residues
    check_residues(period, modulus, residues, 0)
    for k, verdict in each("verdicts", entry.verdicts, [1, *range(2, int(period) + 1, 2)]):
        equal(verdict, order=k)
        is_left = entry.survivors.order_one if k == 1 else k % modulus in residues
        demand(verdict.vanishes is not is_left, "the statement contradicts the verdict")
        (_, sums), = groups(cylinders, turning, plane, quantity, k).values()
        certify(plain(sums[sense]), verdict.certificate, verdict.vanishes)


def check_residues(period, modulus, residues, parity):
    demand(modulus >= 2 and modulus % 2 == 0 and period % modulus == 0, "the modulus is no even divisor of the period")
    demand(residues == [r for r in range(parity, modulus, 2) if r in residues], f"residues are {['even', 'odd'][parity]} numbers below the modulus, rising")
    for q in primes_of(modulus // 2):
        demand({(r + modulus // q) % modulus for r in residues} != set(residues), "a smaller modulus says the same")


def check_recurrence(entry, quantity, sense, cylinders, turning, plane, notes):
    """Every order class by class: the cylinders before one number, even and odd orders apart. From order 2 on, order k of a cylinder
    stands at k·per_order + fixed, and its weight depends on the parity of k alone."""
    equal(entry, quantity=quantity, sense=sense)
    demand(all(rod_of(c.rod)[0] != "link" and not c.speed for c in cylinders), "a link, or something turns faster than the crank")
    demand(all(mass.order == 1 for mass in turning), "something turns faster than the crank")
    found, left = groups(cylinders, turning, plane, quantity, 1), []
    for (number, (is_zero, sums)), one in each("first.sums", entry.first.sums, list(found.items())):
        if not certify(plain(sums[sense]), one.certificate, one.vanishes) and not is_zero:
            left.append(number)
    demand((entry.first.outcome is None) == (len(found) == 1), "`outcome` belongs to several sums")
    if len(found) > 1:
        check_outcome(entry.first, left, notes)
    named = {c.name: c for c in cylinders}
    for parity, k, name in ((0, 2, "even"), (1, 3, "odd")):
        there = [sums[sense] for is_zero, sums in groups(cylinders, turning, plane, quantity, k).values() if not is_zero and sums[sense]]
        for terms, one in each(name, entry[name], there):
            demand(one.of == [cylinder for cylinder, _, _ in terms], "the class has other cylinders")
            way, total = 1 if sense == "direct" else -1, {}
            for cylinder, _, weight in terms:
                c = named[cylinder]
                add_ray(total, way * (c.throw - c.bank), c.bank, weight)
            product = {(Fraction(0), Fraction(0)): 1}
            for factor in each("factors", one.factors):
                rays = check_factor(factor, parity, k)
                pairs, product = [(a, b) for a in product.items() for b in rays], {}
                for ((s, t), v), ((u, x), w) in pairs:
                    add_ray(product, s + u, t + x, v * w)
            demand(one.factors and without_zeros(product) == without_zeros(total), "the factors multiplied out are not the terms of the class")


def add_ray(rays, per_order, fixed, weight):
    rays[per_order % 1, fixed % 1] = rays.get((per_order % 1, fixed % 1), 0) + weight


def without_zeros(rays):
    return {ray: weight for ray, weight in rays.items() if weight}


def check_factor(factor, parity, first):
    """Which orders of a parity make it zero: judged are those of one period, or of these all that may be zero; returns its rays."""
    rays, period = [((one.per_order, one.fixed), one.weight) for one in factor.terms], factor.period
    angles = [ray for ray, _ in rays]
    demand(angles == sorted(set(angles)) and all(0 <= x < 1 for ray in angles for x in ray) and all(w for _, w in rays), "the terms are not collected")
    demand(period.denominator == 1 and 2 <= period <= 1_000_000 and period % 2 == 0, "the period is even, at most 1,000,000")
    demand(all((s - angles[0][0]) * period % 1 == 0 for s, _ in angles), "an angle is not whole in the period")
    due = range(first, first + int(period), 2)
    if len(factor.judged) != len(due):
        # In a vanishing sum of n vectors each has another at R·(angle − angle) whole, R the product of the primes up to n (the lemma
        # of src/proof/README.md): R (k s + t) = (k p + r)/q, so that k is one number modulo q, or none.
        R = prod(p for p in range(2, len(rays) + 1) if primes_of(p) == [p])
        for place, (s, t) in enumerate(angles):
            partners = set()
            for u, x in angles[:place] + angles[place + 1:]:
                q, r = (R * (s - u)).denominator, R * (t - x) * (R * (s - u)).denominator
                if r.denominator == 1:
                    partners.add((q, int(-r) * pow((R * (s - u)).numerator, -1, q) % q))
            due = [k for k in due if any(k % q == r for q, r in partners)]
    zeros, modulus, residues = [], factor.zeros.modulus, factor.zeros.residues
    check_residues(period, modulus, residues, parity)
    for k, one in each("judged", factor.judged, list(due)):
        equal(one, order=k)
        demand(one.vanishes is (k % modulus in residues), "the statement contradicts the verdict")
        certify([(k * s + t, w) for (s, t), w in rays], one.certificate, one.vanishes)
        zeros += [k] * one.vanishes
    demand(len(zeros) == len(residues) * (period // modulus), "there are zeros among the orders that are left out")
    return rays


# ---- 7. Families: open angles and lengths ----------------------------------------------------------------------------------


def check_family(document, notes):
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
        demand({one.symbol for one in entry.sums} == set(expected), "the sums are not those of the lengths")
        demand(len(entry.sums) == len(expected), "the sum of a length stands twice")
        for one in each("sums", entry.sums):
            check_open(one, expected[one.symbol], notes)


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
    demand(dict(parts) == expected and len(parts) == len(expected), "the parts are not those of the cylinders")
    left = [(turned, collect(terms)) for (turned, terms), part in zip(parts, entry.parts) if not certify(terms, part.certificate)]
    check_when(entry.when, left, notes)


# ---- 8. Remedies -----------------------------------------------------------------------------------------------------------


def number_of(coefficient):
    """The number that a remedy names."""
    if coefficient in ("one", "common"):
        return (coefficient,)
    (kind, value), = coefficient.items()
    if kind == "geared":
        return ("geared", value.speed, number_of(value.of))
    keys = {"rod": "ratio offset", "linkage": "ratio knuckle apart", "corrected": "ratio knuckle master apart correction part"}
    return (kind, *(value[key] for key in keys[kind].split()))


def check_remedy(document, notes):
    cylinders, turning, plane = document.cylinders, document.turning_masses, document.reference_plane
    check_asked(document, ["force", "moment"])
    check_engine(cylinders, turning)
    demand(document.masses == "all" and len(document.quantities) == 2, "a remedy is about force and moment of all masses")
    may_stay = [(one.order, one.sense) for one in document.left_out or []]
    found = {(one.quantity, one.order, one.sense, number_of(one.coefficient)): one for one in document.sums}
    demand(len(found) == len(document.sums), "sums: one stands twice")
    for weight in each("weights", document.weights):
        demand(weight.order in document.orders and weight.sense in SENSES["force"], "it turns in an order or sense not asked for")
        for part in weight.parts:
            check_shown(part, False)
    for quantity, k, sense in [(q, k, s) for k in document.orders for q in document.quantities for s in SENSES[q]]:
        of_order = groups(cylinders, turning, plane, quantity, k)
        terms = {number: plain(sums[sense]) for number, (is_zero, sums) in of_order.items() if not is_zero}
        for weight in document.weights:
            share = 2 * k * k * (weight.position - plane if quantity == "moment" else 1)
            for part in weight.parts if (weight.order, weight.sense) == (k, sense) else []:
                terms.setdefault(number_of(part.coefficient), []).extend((t, w * share) for t, w in terms_of(part.terms))
        totals = {number: collect(of) for number, of in terms.items() if collect(of)} or {ONE: {}}
        for number, total in totals.items():
            about = quantity, k, sense, number
            demand(about in found, f"sums: the one of {about} is missing")
            entry = found.pop(about)
            demand(terms_of(entry.terms) == sorted(total.items()), f"sums: the terms of {about} are not those of the engine and the weights")
            certify(terms_of(entry.terms), entry.certificate, None if (k, sense) in may_stay else True)
    demand(not found, f"sums: {list(found)} are none of the engine")


# ---- 9. Firing stars -------------------------------------------------------------------------------------------------------


def check_firing(document, notes):
    turns, stars = {"two-stroke": 1, "four-stroke": 2}[document.cycle], {}
    cylinders, orders = document.cylinders, document.orders
    centre = lambda c: (c.firing_angle - c.bank + c.throw) % 1
    for c in each("cylinders", cylinders):
        demand(0 <= c.firing_angle < turns and centre(c) == centre(cylinders[0]), "it does not fire in the cycle, at a dead centre of its own")
        rod = rod_of(c.rod)
        stars.setdefault("endless" if rod[:2] == ("rod", 0) else rod, []).append(c)
    demand(any(c.firing_angle == 0 for c in cylinders), "no cylinder fires at 0")
    demand(len({c.name for c in cylinders}) == len(cylinders), "two cylinders have the same name")
    demand(len({c.rod == "unknown" for c in cylinders}) == 1, "some rods are known and some are not")
    star = lambda of, k: [(-k * c.firing_angle % 1, c.crank_radius * c.deflection) for c in of]
    demand(orders or document.pattern, "there is nothing to check")
    demand(sorted(set(orders)) == orders and all(k > 0 and k * turns % 1 == 0 for k in orders), "orders rise, and are those of the cycle")
    for (k, of), entry in each("verdicts", document.verdicts, [(k, of) for k in orders for of in stars.values()]):
        equal(entry, order=k)
        demand((entry.of or []) == [c.name for c in of if len(stars) > 1], "`of` does not name the cylinders of the star")
        demand(terms_of(entry.terms) == star(of, k), "the terms are not those of the star")
        check_shown(entry, entry.vanishes)
        certify(star(of, k), entry.certificate, entry.vanishes)
    if document.pattern is not None:
        period, verdicts = document.pattern.period, document.pattern.verdicts
        demand(1 <= period <= len(verdicts), "pattern: verdicts are missing")
        demand(all(c.firing_angle * period / turns % 1 == 0 for c in cylinders), "a star does not repeat after the period")
        due = [(Fraction(index, turns), of) for index in range(1, period + 1) for of in stars.values()]
        for (k, of), entry in each("pattern.verdicts", verdicts, due):
            equal(entry, order=k)
            certify(star(of, k), entry.certificate, entry.vanishes)


# ---- 10. Numbers with verdicts as their evidence, and files ----------------------------------------------------------------


def check_evidence(document, notes):
    """Of loads, comparisons and sweeps: the documents of verdicts in them, and what the rest repeats of those."""
    notes.add("all numbers outside of `evidence`")
    proved, kind = [], document["format"]
    for one in each("evidence", document["evidence"]):
        demand(one["format"] == "crankstar classify 2", "it is no document of verdicts")
        proved.append(check_classify(read(one), notes))
    demand(proved and (kind != "crankstar loads 2" or len(proved) == 1), "there is no evidence, or too much")
    if kind == "crankstar loads 2":
        judged = proved[0][0]
        for entry in each("orders", document["orders"]):
            both = judged[entry["quantity"], entry["order"]]
            whole = True if both == [True, True] else False if False in both else None
            demand([entry["direct"]["vanishes"], entry["reverse"]["vanishes"], entry["vanishes"]] == [*both, whole], "the evidence differs")
        for entry in each("torque", document["torque"]):
            demand([entry["vanishes"]] == judged["torque", entry["order"]], "the evidence differs")
    if kind == "crankstar compare 2":
        for (_, shapes), engine in each("engines", document["engines"], proved):
            for entry in each("orders", engine["orders"]):
                for quantity in ("force", "moment"):
                    demand(entry[quantity]["shape"] == shapes[quantity, entry["order"]], "the evidence differs")


CHECKS = {"classify 2": check_classify, "family 2": check_family, "remedy 2": check_remedy, "firing 1": check_firing,
          "loads 2": check_evidence, "compare 2": check_evidence, "sweep 2": check_evidence}


def verify(path):
    """Returns how many certificates hold, and what is not checked."""
    CHECKED[0] = 0
    PLACE.clear()
    with open(path, encoding="utf-8") as file:
        try:
            document = json.load(file, object_pairs_hook=no_key_twice, parse_float=Decimal, parse_constant=Decimal)
        except (ValueError, RecursionError) as error:
            raise NoDocument(f"not read as JSON: {error}")
    name = document.get("format") if isinstance(document, dict) else None
    if type(name) is not str or name.removeprefix("crankstar ") not in CHECKS:
        raise NoDocument("it has no `format` that this checker knows")
    check, notes = CHECKS[name.removeprefix("crankstar ")], {"titles and names", "decimals, but for whether they say zero"}
    try:
        check(document if check is check_evidence else read(document), notes)
    except (KeyError, IndexError, TypeError, AttributeError, ValueError, ZeroDivisionError) as error:
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
            print(f"{path}: refused at {'.'.join(PLACE) or 'the document'}: {refused}")
        except (NoDocument, OSError, UnicodeDecodeError) as error:
            answer = 2
            print(f"{path}: {error}")
    return answer


if __name__ == "__main__":
    getattr(sys, "set_int_max_str_digits", lambda _: None)(0)  # numbers have up to 5,000 digits
    sys.exit(main(sys.argv[1:]))
