"""The second checker, verify.py: statements on every order at once, as theorems or as recurrences (src/kernel/proof/README.md)."""
from fractions import Fraction
from math import prod

from verify import SENSES, beside, certify, collect, demand, each, equal, groups, plain, primes_of, rod_of, types

types("""order-verdict: order=count vanishes=truth certificate; survivors: order_one=truth modulus=count residues=[count];
    theorem: quantity sense period=integer survivors verdicts=[order-verdict];
    sum-verdict: vanishes=truth certificate; first-order: sums=[sum-verdict] outcome?; ray: per_order fixed weight; zeros: modulus=count residues=[count];
    factor: terms=[ray] period=integer judged=[order-verdict] zeros; order-class: of=[text] factors=[factor];
    recurrence: quantity sense first=first-order even=[order-class] odd=[order-class]""")


def check(document, engine):
    """Four theorems, or recurrences in their place. Cylinders that the verdicts are not about are held to the same."""
    rods = {rod_of(c.rod) for c in document.cylinders}
    asked = [(quantity, sense) for quantity in document.quantities for sense in SENSES[quantity] if len(SENSES[quantity]) == 2]
    turns_faster = any(c.speed for c in document.cylinders) or any(mass.order > 1 for mass in document.turning_masses)
    demand(not asked or not turns_faster and all(rod[0] != "link" for rod in rods), "a link, or something turns faster than the crank")
    if document.recurrences:
        demand(document.theorems == [], "what is said class by class is in `recurrences` alone")
        for about, entry in each("recurrences", document.recurrences, asked):
            check_recurrence(entry, *about, engine)
    else:
        for about, entry in each("theorems", document.theorems, asked):
            check_theorem(entry, *about, engine, document.cylinders, rods)


def check_theorem(entry, quantity, sense, engine, cylinders, rods):
    """Every angle is a multiple of 1/period and order k multiplies it, so the verdicts of one period hold for every order."""
    equal(entry, quantity=quantity, sense=sense)
    period = entry.period
    demand(len(rods) == 1 and all(rod[0] == "unknown" or rod[2] == 0 for rod in rods), "rods are not equal and centric")
    demand(period > 0 and period % 2 == 0, "the period is positive and even")
    demand(all((angle * period).denominator == 1 for c in cylinders for angle in (c.throw, c.bank)), "an angle is not whole in it")
    demand(2 * len(entry.verdicts) == period + 2, "there is not one verdict for each order of the period")
    modulus, residues = entry.survivors.modulus, set(entry.survivors.residues)
    check_residues(period, modulus, entry.survivors.residues, 0)
    for k, verdict in each("verdicts", entry.verdicts, [1, *range(2, int(period) + 1, 2)]):
        equal(verdict, order=k)
        is_left = entry.survivors.order_one if k == 1 else k % modulus in residues
        demand(verdict.vanishes is not is_left, "the statement contradicts the verdict")
        (_, sums), = groups(engine, quantity, k).values()
        certify(plain(sums[sense]), verdict.certificate, verdict.vanishes)


def check_residues(period, modulus, residues, parity):
    demand(modulus >= 2 and modulus % 2 == 0 and period % modulus == 0, "the modulus is no even divisor of the period")
    there = set(residues)
    demand(residues == [r for r in range(parity, modulus, 2) if r in there], f"residues are {['even', 'odd'][parity]} numbers below the modulus, rising")
    for q in primes_of(modulus // 2):
        demand({(r + modulus // q) % modulus for r in residues} != there, "a smaller modulus says the same")


def check_recurrence(entry, quantity, sense, engine):
    """Every order class by class: the cylinders before one number, even and odd orders apart. From order 2 on, order k of a cylinder
    is at k·per_order + fixed, and its weight depends on the parity of k alone."""
    equal(entry, quantity=quantity, sense=sense)
    cylinders, _, _ = engine
    found, left = groups(engine, quantity, 1), {}
    for (number, (is_zero, sums)), one in each("first.sums", entry.first.sums, list(found.items())):
        if not certify(plain(sums[sense]), one.certificate, one.vanishes) and not is_zero:
            left[number] = collect(plain(sums[sense]))
    demand((entry.first.outcome is None) == (len(found) == 1), "`outcome` belongs to several sums")
    if len(found) > 1:
        beside("wholes").check_outcome(entry.first.outcome, 1, sense, left)
    named = {c.name: c for c in cylinders}
    for parity, k, name in ((0, 2, "even"), (1, 3, "odd")):
        there = [sums[sense] for is_zero, sums in groups(engine, quantity, k).values() if not is_zero and sums[sense]]
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
    demand(2 <= period <= 1_000_000 and period % 2 == 0, "the period is even, at most 1,000,000")
    demand(all((s - angles[0][0]) * period % 1 == 0 for s, _ in angles), "an angle is not whole in the period")
    due = range(first, first + int(period), 2)
    if len(factor.judged) != len(due):
        # In a vanishing sum of n vectors each has another at R·(angle − angle) whole, R the product of the primes up to n (the lemma
        # of src/kernel/proof/README.md): R (k s + t) = (k p + r)/q, so that k is one number modulo q, or none.
        R = prod(p for p in range(2, len(rays) + 1) if primes_of(p) == [p])
        for place, (s, t) in enumerate(angles):
            partners = set()
            for u, x in angles[:place] + angles[place + 1:]:
                q, r = (R * (s - u)).denominator, R * (t - x) * (R * (s - u)).denominator
                if r.denominator == 1:
                    partners.add((q, int(-r) * pow((R * (s - u)).numerator, -1, q) % q))
            due = [k for k in due if any(k % q == r for q, r in partners)]
    zeros, modulus, residues = [], factor.zeros.modulus, set(factor.zeros.residues)
    check_residues(period, modulus, factor.zeros.residues, parity)
    for k, one in each("judged", factor.judged, list(due)):
        equal(one, order=k)
        demand(one.vanishes is (k % modulus in residues), "the statement contradicts the verdict")
        certify([(k * s + t, w) for (s, t), w in rays], one.certificate, one.vanishes)
        zeros += [k] * one.vanishes
    demand(len(zeros) == len(residues) * (period // modulus), "there are zeros among the orders that are omitted")
    return rays
