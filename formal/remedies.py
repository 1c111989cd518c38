"""The second checker, verify.py: remedies, the weights that balance an engine (src/kernel/proof/README.md)."""
from fractions import Fraction
from math import isqrt

from enclosures import check_shown, common_denominator, enclose
from verify import ONE, SENSES, certify, check_asked, check_engine, collect, demand, each, equal, groups, note_idle, plain, read, terms_of, types
from wholes import Whole, is_open

SLIGHT, BITS = Fraction(1, 10**6), 256

types("""rod-cylinder: throw bank position weight rod speed?=count knuckle_weight?;
    turning-mass: order=count sense position angle mass_radius coefficient_of?=rod;
    linkage: ratio knuckle apart; part = real imaginary; corrected: ratio knuckle master apart correction part;
    geared: speed=count of=coefficient; coefficient = one common; coefficient: rod=known; coefficient: quadrature=known; coefficient: linkage; coefficient: corrected; coefficient: geared;
    weight-part: coefficient terms=[vector] modulus=decimal angle_deg=decimal; turning-weight: order=count sense position parts=[weight-part];
    left-out: order=count sense; corrected-sum: quantity order=count sense coefficient terms=[vector] certificate;
    remedy: format=text title=text masses orders=[count] quantities=[quantity] reference_plane cylinders=[rod-cylinder] turning_masses=[turning-mass]
        weights=[turning-weight] sums=[corrected-sum] left_out?=[left-out]""")


def number_of(coefficient):
    """The number that a remedy names."""
    if coefficient in ("one", "common"):
        return (coefficient,)
    (kind, value), = coefficient.items()
    if kind == "geared":
        return ("geared", value.speed, number_of(value.of))
    keys = {"rod": "ratio offset", "quadrature": "ratio offset", "linkage": "ratio knuckle apart", "corrected": "ratio knuckle master apart correction part"}
    return (kind, *(value[key] for key in keys[kind].split()))


def rank(number):
    """Where a number stands among others."""
    kind, *rest = number
    at = ["one", "common", "rod", "quadrature", "linkage", "corrected", "geared"].index(kind)
    return {"corrected": lambda: (at, *rest[:-1], rest[-1] == "imaginary"), "geared": lambda: (at, rest[0], rank(rest[1]))}.get(kind, lambda: (at, *rest))()


def check(tree, notes):
    document = read(tree, "remedy")
    cylinders, turning, plane = document.cylinders, document.turning_masses, document.reference_plane
    check_asked(document, ["force", "moment"])
    check_engine(cylinders, turning)
    note_idle(document, notes)
    demand(document.masses == "all" and len(document.quantities) == 2, "a remedy is about force and moment of all masses")
    for weight in each("weights", document.weights):
        demand(weight.order in document.orders, "it turns in an order not asked for")
        ranks = [rank(number_of(part.coefficient)) for part in weight.parts]
        demand(ranks and ranks == sorted(set(ranks)), "it has parts, rising by their coefficients, each once")
        for part in weight.parts:
            demand(terms_of(part.terms) == sorted(collect(terms_of(part.terms)).items()), "its terms are not collected, at rising angles")
            check_shown(part, collect(terms_of(part.terms)), False)
    due = []  # each sum of the corrected engine, and the numbers that the engine has there
    for about in [(q, k, s) for k in document.orders for q in document.quantities for s in SENSES[q]]:
        quantity, k, sense = about
        of_order = groups((cylinders, turning, plane), quantity, k)
        terms = {number: plain(sums[sense]) for number, (is_zero, sums) in of_order.items() if not is_zero}
        own = {ONE, *terms}
        for weight in document.weights:
            share = 2 * k * k * (weight.position - plane if quantity == "moment" else 1)
            for part in weight.parts if (weight.order, weight.sense) == (k, sense) else []:
                terms.setdefault(number_of(part.coefficient), []).extend((t, w * share) for t, w in terms_of(part.terms))
        totals = {number: collect(of) for number, of in terms.items() if collect(of)} or {ONE: {}}
        due += [(about, number, total, number in own) for number, total in sorted(totals.items(), key=lambda one: rank(one[0]))]
    may_stay = [(one.order, one.sense) for one in document.left_out or []]
    left = {}  # {(order, sense): {quantity: {number: sum that is not zero}}}
    for ((quantity, k, sense), number, total, is_own), entry in each("sums", document.sums, due):
        equal(entry, quantity=quantity, order=k, sense=sense)
        demand(number_of(entry.coefficient) == number, "another sum is due")
        demand(terms_of(entry.terms) == sorted(total.items()), "the terms are not those of the engine and the weights")
        if not certify(terms_of(entry.terms), entry.certificate, None if (k, sense) in may_stay else True):
            demand(is_own, "what is left is multiplied by a number that the engine does not have")
            left.setdefault((k, sense), {}).setdefault(quantity, {})[number] = total
    demand(len(set(may_stay)) == len(may_stay) and set(may_stay) == set(left), "left_out names orders and senses in which nothing is left, or one twice")
    check_slight(document, left)
    if left:
        notes.add("that the sums in `left_out` are zero: they are not, and all of an order together are below a millionth of the load")


def check_slight(document, left):
    """What is left in an order, both senses end to end, is less than a millionth of the load: of the force of all pistons at order 1,
    end to end; for the moment, of that force of each times its distance from the centre of mass of all. A vector S is a force of half its length."""
    cylinders = document.cylinders
    load = sum(c.weight for c in cylinders)
    centre = sum(c.weight * c.position for c in cylinders) / load if load else 0
    of_moment = sum(c.weight * abs(c.position - centre) for c in cylinders)
    for k in sorted({k for k, _ in left}):
        for quantity, unit in (("force", load), ("moment", of_moment)):
            most = sum(longest(of[quantity], k, sense) for (order, sense), of in left.items() if order == k and quantity in of)
            demand(most < 2 * SLIGHT * unit or most == 0, f"order {k}: the {quantity} that is left is no less than a millionth of the load")


def longest(sums, k, sense):
    """No vector of this order is longer. The number of rods that are not known counts as 2: c_k rises with λ in size, to that of |cos|
    at λ = 1, which is at most 16/(3π)."""
    length = 0
    for total in (total for number, total in sums.items() if is_open(number)):
        scale = common_denominator([total])
        x, y, doubt = enclose(total, scale, BITS)
        length += 2 * Fraction(isqrt(x * x + y * y) + 1 + doubt, scale * 2**BITS)
    known = {number: total for number, total in sums.items() if not is_open(number)}
    if known:
        whole = Whole(k, [known], BITS)
        re, im = whole.sum(known, sense)
        length += Fraction(isqrt(re.most() ** 2 + im.most() ** 2) + 1, whole.scale * 2**whole.bits)
    return length
