#!/usr/bin/env python3
"""Does a document of crankstar prove what it says of an engine? A second checker; it needs the standard library only.

    python3 formal/verify.py [--engine DOCUMENT] FILE…

It answers 0: all verified, 1: one is refused, 2: one is no document of crankstar. With --engine a document about another engine than
that of DOCUMENT is refused (reference.py).

Every verdict is about a sum  S = Σ weight · e^(2πi·angle)  with rational weights and angles (in turns). The checker rebuilds S
from the engine that the document names, and then believes nothing but arithmetic with whole numbers: it never searches. The
format is described in src/kernel/proof/README.md. What is not checked is named, document by document, in lines with "not checked".

This file and reading.py suffice for verdicts on an engine. It loads those beside it (`beside`) where a document calls for them: articulated
rods, several crankshafts, sums before different numbers, every order at once, and the other kinds of documents.
"""
import importlib
import json
import os
import sys
from fractions import Fraction
from math import gcd

from reading import PLACE, Decimal, NoDocument, Refused, demand, each, equal, harmless, no_key_twice, read, types

# ---- 1. What a document on an engine holds ---------------------------------------------------------------------------------

types("""masses = reciprocating rotating counterweights all; quantity = force moment torque roll; sense = direct reverse;
    form = does-not-exist balanced rotating counter-rotating planar elliptical not-decided; vector: angle weight; known: ratio offset;
    link: master knuckle angle ratio correction?; rod = unknown; rod: known; rod: link; crankshaft: sense axis=[vector];
    polygon: sides=count rotation weight; class: angle modulus=integer; compare: prime=count first=count second=count; step: class; step: compare;
    certificate polygons: polygons=[polygon]; certificate splitting: steps=[step];
    certificate residue: conductor=integer prime=integer root=integer scale=integer residue=integer;
    not-zero-by-enclosure: bits=count; not-decided: below=decimal;
    outcome = zero not-zero open; outcome: not-zero-by-enclosure; outcome: not-decided;
    cylinder: name=text throw bank position reciprocating_mass crank_radius rod speed?=count knuckle_weight? crankshaft?;
    mass: name=text order=count sense position angle mass_radius coefficient_of?=rod axis?=[vector];
    verdict: quantity order=count sense=sense? of?=[text] vanishes=truth terms=[vector] modulus=decimal angle_deg=decimal? certificate;
    whole: quantity order=count sense=sense? outcome; shape: quantity order=count shape=form certificate? pairs?=[certificate] bits?=count;
    classify: format=text title=text masses orders=[count] quantities=[quantity] reference_plane cylinders=[cylinder] all_orders=truth
        turning_masses=[mass] verdicts=[verdict] wholes=[whole] shapes=[shape] theorems=[theorem] recurrences?=[recurrence]""")
CHECKED = [0, 0]  # certificates so far, and what is proved without one of its own: arcs, boxes


# ---- 2. Sums and certificates ----------------------------------------------------------------------------------------------

def terms_of(entry):
    """Terms as a document writes them: pairs of an angle and a weight."""
    return [(one.angle, one.weight) for one in entry]

def collect(terms):
    """Like directions added, no weight zero: {angle: weight}."""
    total = {}
    for angle, weight in terms.items() if isinstance(terms, dict) else terms:
        total[angle % 1] = total.get(angle % 1, 0) + weight
    return {angle: weight for angle, weight in total.items() if weight}

def conjugate(total):
    return {-angle: weight for angle, weight in total.items()}

def times(one, other, sign=1):
    """The terms of A·B, or −A·B."""
    return [(t + u, sign * v * w) for t, v in one.items() for u, w in other.items()]

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
    is_zero = certificate.kind == "polygons"
    demand(vanishes is None or vanishes is is_zero, "the certificate proves the contrary of the verdict")
    check = {"polygons": polygons, "residue": residue}.get(certificate.kind) or beside("splitting").check
    check(collect(terms), certificate)
    CHECKED[0] += 1
    return is_zero

def polygons(total, certificate):
    """The corners of a regular polygon sum to zero, so a sum of polygons is zero."""
    corners = []
    for one in certificate.polygons:
        demand(2 <= one.sides <= 100_000 - len(corners), "a polygon has from 2 to 100,000 sides, all together")
        demand(one.weight, "a polygon has no weight")
        corners += [(one.rotation + Fraction(j, one.sides), one.weight) for j in range(one.sides)]
    demand(collect(corners) == total, "the polygons do not add up to the terms")

def residue(total, certificate):
    """e^(2πi/N) ↦ g maps sums to numbers modulo ℓ, so that a sum with an image other than 0 is not zero.

    It respects products where Φ_N(g) ≡ 0: g^N − 1 is the product of all Φ_d(g), d | N, and those with d < N divide some
    g^(N/q) − 1, which has no factor in common with ℓ."""
    N, modulus, g, scale, claimed = (certificate[key] for key in ("conductor", "prime", "root", "scale", "residue"))
    demand(1 <= N <= 1_000_000 and 2 <= modulus < 2**64 and scale >= 1, "conductor, modulus or scale is out of range")
    demand(pow(g, N, modulus) == 1, "the root to the conductor is not 1")
    for q in primes_of(N):
        demand(gcd(pow(g, N // q, modulus) - 1, modulus) == 1, f"the root has a smaller order: see {N}/{q}")
    demand(all((t * N).denominator == 1 == (w * scale).denominator for t, w in total.items()), "an angle or weight is not whole")
    image = sum(int(w * scale) * pow(g, int(t * N), modulus) for t, w in total.items()) % modulus
    demand((image - claimed) % modulus == 0 != image, f"the sum is {image} modulo {modulus}, not {claimed}, or it is 0")


# ---- 3. From an engine to its terms ----------------------------------------------------------------------------------------

SENSES = {"force": ["direct", "reverse"], "moment": ["direct", "reverse"], "torque": [None], "roll": [None]}
ONE = ("one",)

def rod_of(entry):
    """("unknown",), ("rod", ratio, offset) or ("link", master, knuckle, angle, ratio, correction)."""
    if entry == "unknown":
        return ("unknown",)
    if "link" in entry:
        return beside("links").link_of(entry.link)
    demand(entry.known.ratio >= 0 and entry.known.ratio + abs(entry.known.offset) < 1, "the rod cannot turn round")
    return ("rod", entry.known.ratio, entry.known.offset)

def check_masters(cylinders, rods):
    """A link hangs on a master rod of the engine, on the same crankpin, with its axis at the angle that is said."""
    place = lambda c, bank: (c.throw % 1, bank % 1, c.get("crank_radius"), c.get("position"))
    masters = {(*place(c, c.bank), rod[1]) for c, rod in zip(cylinders, rods) if rod[0] == "rod" and rod[2] == 0 and not c.get("speed")}
    links = [(*place(c, c.bank - rod[3]), rod[1]) for c, rod in zip(cylinders, rods) if rod[0] == "link"]
    demand(masters.issuperset(links), "a link hangs on no master rod of the engine")

def check_engine(cylinders, turning):
    """Rods are known or not, all alike, and nothing is said of a cylinder that is not computed with."""
    rods = [rod_of(c.rod) for c in cylinders]
    check_masters(cylinders, rods)
    shafts = [rod_of(mass.coefficient_of) for mass in turning if mass.coefficient_of]
    demand(rods and len({rod == ("unknown",) for rod in rods + shafts}) == 1, "there is no rod, or some are known and some are not")
    demand(all(rod[0] != "link" for rod in shafts), "a shaft takes the number of a link, which has several")
    demand(all(rod[0] == "link" or not c.knuckle_weight for c, rod in zip(cylinders, rods)), "a knuckle weight without a link")
    demand(all(c.speed is None or c.speed > 1 and rod[0] != "link" for c, rod in zip(cylinders, rods)), "a speed is out of place")
    demand(all(mass.order >= 1 for mass in turning), "a mass turns in no order")
    sizes = [c.get(key) or 0 for c in cylinders for key in ("weight", "reciprocating_mass", "knuckle_weight")]
    demand(min(sizes) >= 0 < min(c.get("crank_radius", 1) for c in cylinders), "a mass is below 0, or a crank radius not above it")

def phase(throw, bank, k, sense):
    """Order k of a cylinder: its force is direct at kβ − (k−1)α, reverse at −kβ + (k+1)α; its torque is at k(β − α)."""
    return {"direct": k * throw - (k - 1) * bank, "reverse": (k + 1) * bank - k * throw, None: k * (throw - bank)}[sense]

def of_rod(rod, k):
    """The number before order k of the force, whether it is 0, and the sign of the term."""
    if rod == ("unknown",):
        return (ONE, False, 1) if k == 1 else (("common",), k % 2 == 1, 1)
    _, ratio, offset = rod
    if k == 1:
        return (rod if offset else ONE), False, 1
    return ("rod", ratio, abs(offset)), ratio == 0 or offset == 0 and k % 2 == 1, -1 if offset < 0 and k % 2 else 1

def of_force(rod, k, do_rods_differ):
    """The numbers before order k of the force, whether each is 0, and the angle and the part of its vector, turned the other way in the
    reverse sum. c_1 = 1 + iy of an offset is taken apart where the engine has several rods; y changes its sign with the offset."""
    if do_rods_differ and k == 1 and rod[0] == "rod" and rod[2]:
        return [(ONE, False, 0, 1), (("quadrature", rod[1], abs(rod[2])), False, Fraction(1, 4), 1 if rod[2] > 0 else -1)]
    number, is_zero, sign = of_rod(rod, k)
    return [(number, is_zero, 0, sign)]

def of_torque(rod, k):
    """The number before order k of the torque, and whether it is 0."""
    return ("common torque",) if rod == ("unknown",) else ("torque", *rod[1:]), rod[0] == "rod" and rod[1] == 0 and k != 2

def groups(engine, quantity, k):
    """The terms of order k of a quantity by the numbers before them: {number: (whether it is 0, {sense: [(name, angle, weight)]})}.
    A crankshaft that turns ν times has the order k/ν of its own, ν² times as large; its torque has a speed once more."""
    (cylinders, turning, plane), found = engine, {}

    def add(number, is_zero, name, sense, angle, weight, speed=1):
        number = number if number == ONE or speed == 1 else ("geared", speed, number)
        sums = found.setdefault(number, (is_zero, {one: [] for one in SENSES[quantity]}))[1]
        sums[sense].append((name, Fraction(angle) % 1, weight))

    lever = lambda one: one.position - plane if quantity == "moment" else 1
    do_rods_differ = len({rod_of(c.rod) for c in cylinders}) > 1
    for c in cylinders:
        speed, rod = c.speed or 1, rod_of(c.rod)
        own, size = k // speed, (c.weight if "weight" in c else c.reciprocating_mass * c.crank_radius) * speed**2
        if k % speed:
            continue
        if quantity == "roll":
            for number, is_zero, angle, weight in beside("roll").of_cylinder(c, rod, own, size, do_rods_differ):
                add(number, is_zero, c.get("name"), None, angle, weight, speed)
        elif quantity == "torque":
            add(*of_torque(rod, own), c.get("name"), None, phase(c.throw, c.bank, own, None), size * c.crank_radius * speed, speed)
        elif rod[0] == "link":
            for number, is_zero, sense, angle, weight in beside("links").of_piston(c, rod, own):
                add(number, is_zero, c.get("name"), sense, angle, weight * size * lever(c))
        else:
            for number, is_zero, turned, sign in of_force(rod, own, do_rods_differ):
                for sense, way in zip(SENSES["force"], (1, -1)):
                    add(number, is_zero, c.get("name"), sense, phase(c.throw, c.bank, own, sense) + way * turned, sign * size * lever(c), speed)
    for c in cylinders if quantity in ("force", "moment") else []:
        if c.knuckle_weight:
            for number, is_zero, sense, angle, weight in beside("links").of_knuckle(c, rod_of(c.rod), k):
                add(number, is_zero, f"knuckle of cylinder {c.get('name')}", sense, angle, weight * lever(c))
    for mass in turning if quantity != "torque" else []:
        if mass.order == k:
            parts = of_force(rod_of(mass.coefficient_of), k, do_rods_differ) if mass.coefficient_of else [(ONE, False, 0, 1)]
            for number, is_zero, turned, sign in parts:
                way = 1 if mass.sense == "direct" else -1
                if quantity != "roll":
                    add(number, is_zero, mass.get("name"), mass.sense, mass.angle + way * turned, 2 * k * k * mass.mass_radius * lever(mass) * sign)
                elif mass.axis:
                    for angle, weight in beside("roll").of_mass(mass, k):
                        add(number, is_zero, mass.get("name"), None, angle + turned, weight * sign)
    return found or {ONE: (True, {sense: [] for sense in SENSES[quantity]})}

def plain(terms):
    return [(angle, weight) for _, angle, weight in terms]


# ---- 4. Verdicts on an engine ----------------------------------------------------------------------------------------------

def check_classify(tree, notes):
    """Returns {(quantity, order): [whether it is zero, per sense; None if that is not decided]}, the shapes, and what is left."""
    if any(tree.get(key) for key in ("all_orders", "theorems", "recurrences")):
        beside("every_order")
    document = read(tree, "classify")
    cylinders, turning, quantities = document.cylinders, document.turning_masses, document.quantities
    check_asked(document, list(SENSES))
    check_engine(cylinders, turning)
    note_idle(document, notes)
    demand(document.masses != "reciprocating" or not turning, "the verdicts are about the reciprocating masses alone")
    names = [one.name for one in cylinders + turning] + [f"knuckle of cylinder {c.name}" for c in cylinders if c.knuckle_weight]
    demand(len(set(names)) == len(names), "two sources have the same name")
    rods = [rod_of(c.rod) for c in cylinders]
    if "roll" in quantities:
        demand(not any(rod[0] == "rod" and rod[1] == 0 != rod[2] for rod in rods), "an endless rod with an offset has no arm")
    else:
        demand(not any(one.crankshaft or one.axis for one in cylinders + turning), "an axis without roll moment")
    is_linked = any(rod[0] == "link" for rod in rods)
    demand(not is_linked or set(quantities) <= {"force", "moment"}, "torque and roll moment of links are not judged")
    engine = cylinders if document.masses in ("reciprocating", "all") else [], turning, document.reference_plane
    plan = {(quantity, k): groups(engine, quantity, k) for k in document.orders for quantity in quantities}
    due = [(*about, number, sense) for about, found in plan.items() for number in found for sense in SENSES[about[0]]]
    zeros = {about: check_verdict(entry, *about, plan[about[:2]]) for about, entry in each("verdicts", document.verdicts, due)}
    # What is left: the sums that are not zero, before numbers that are not.
    left = {(*about, sense): {number: collect(plain(sums[sense])) for number, (is_zero, sums) in found.items()
                              if not is_zero and not zeros[(*about, number, sense)]}
            for about, found in plan.items() for sense in SENSES[about[0]]}
    judged = {about: [zeros[(*about, *found, sense)] for sense in SENSES[about[0]]] if len(found) == 1 else []
              for about, found in plan.items()}
    for about, entry in each("wholes", document.wholes, [about for about in left if len(plan[about[:2]]) > 1]):
        quantity, k, sense = about
        equal(entry, quantity=quantity, order=k, sense=sense)
        judged[quantity, k].append(beside("wholes").check_outcome(entry.outcome, k, sense, left[about]))
    for about, entry in each("shapes", document.shapes, [about for about in plan if len(SENSES[about[0]]) == 2]):
        check_shape(entry, *about, judged[about], [left[(*about, sense)] for sense in SENSES["force"]], plan[about])
    if document.all_orders:
        beside("every_order").check(document, engine)
    else:
        demand(not document.theorems and not document.recurrences, "nothing was asked of every order")
    # An order whose numbers are all zero is zero, whatever its sums are.
    whole = {about: [True] * len(zero) if all(is_zero for is_zero, _ in plan[about].values()) else zero for about, zero in judged.items()}
    return whole, {(entry.quantity, entry.order): entry.shape for entry in document.shapes}, left

def check_asked(document, allowed):
    orders, quantities = document.orders, document.quantities
    demand(orders and orders[0] >= 1 and sorted(set(orders)) == orders, "orders rise from 1 on")
    demand(quantities and quantities == [one for one in allowed if one in quantities], f"quantities are in the order {allowed}")

def note_idle(document, notes):
    idle = [mass for mass in document.turning_masses if mass.order not in document.orders]
    if idle and (not document.get("all_orders") or any(mass.get("axis") for mass in idle)):
        notes.add("the masses that turn at orders not asked for: no sum of the document is about them")

def check_verdict(entry, quantity, k, number, sense, found):
    equal(entry, quantity=quantity, order=k, sense=sense)
    terms = found[number][1][sense]
    demand((entry.of or []) == [name for name, _, _ in terms if len(found) > 1], "`of` does not name the sources of the terms")
    demand(terms_of(entry.terms) == plain(terms), "the terms are not those of the engine")
    beside("enclosures").check_shown(entry, collect(plain(terms)), entry.vanishes)
    return certify(plain(terms), entry.certificate, entry.vanishes)

def check_shape(entry, quantity, k, zeros, left, found):
    """What both vectors of an order leave together: one, the other, or two that are equally long, or not."""
    equal(entry, quantity=quantity, order=k)
    evidence = [key for key in ("certificate", "pairs", "bits") if key in entry]
    right = "does-not-exist" if all(is_zero for is_zero, _ in found.values()) else {(True, True): "balanced", (False, True): "rotating", (True, False): "counter-rotating",
             (False, False): None}.get(tuple(zeros), "not-decided")
    if right:
        equal(entry, shape=right)
        return demand(not evidence, "no lengths are compared, so no evidence belongs here")
    alone = list(found) if len(found) == 1 else list(left[0]) if len(left[0]) == 1 and [*left[0]] == [*left[1]] else []
    if not alone:
        return beside("wholes").check_lengths(entry, k, left, found, evidence)
    # One sum each, before the same number.
    demand(evidence == ["certificate"] and entry.shape in ("planar", "elliptical"), "a certificate compares the two lengths")
    certify(unequal(*(collect(plain(one)) for one in found[alone[0]][1].values())), entry.certificate, entry.shape == "planar")


# ---- 5. Files --------------------------------------------------------------------------------------------------------------

def beside(name):
    """A file beside this one, loaded where a document calls for it."""
    return importlib.import_module(name)


LARGEST = 4 << 20  # bytes
CHECKS = {"classify 2": None, "family 2": "families", "remedy 2": "remedies", "firing 1": "firing",
          "loads 4": "evidence", "compare 4": "evidence"}

def integer_of(text):
    if len(text) > 5000:
        raise ValueError("a whole number has more than 5,000 digits")
    return Decimal(text) if text == "-0" else int(text)

def opened(path):
    """What a file holds, as JSON has it."""
    try:
        with open(path, "rb") as file:
            text = file.read(LARGEST + 1)
        demand_document(len(text) <= LARGEST, "it is larger than 4 MiB, which is not read")
        tree = json.loads(text.decode("utf-8"), object_pairs_hook=no_key_twice, parse_float=Decimal, parse_int=integer_of, parse_constant=Decimal)
    except (ValueError, RecursionError) as error:
        raise NoDocument(f"not read as JSON: {error}")
    name = tree.get("format") if isinstance(tree, dict) else None
    demand_document(type(name) is str and name[:10] == "crankstar " and name[10:] in CHECKS, "it has no `format` that this checker knows")
    return tree

def demand_document(holds, why):
    if not holds:
        raise NoDocument(why)

def verify(path, references):
    """Returns how many certificates hold, and what is not checked."""
    CHECKED[:] = 0, 0
    PLACE.clear()
    tree, notes = opened(path), {"titles and names"}
    file = CHECKS[tree["format"][10:]]
    try:
        beside(file).check(tree, notes) if file else check_classify(tree, notes)
        if references:
            beside("reference").compare(tree, references, notes)
        else:
            notes.add("whether the engine is yours; --engine compares it")
    except (KeyError, IndexError, TypeError, AttributeError, ValueError, ArithmeticError) as error:
        raise Refused(f"it is not as the format says: {error!r}")
    return CHECKED[0], sorted(notes)

def main(arguments):
    paths, references = [], []
    while arguments:
        one = arguments.pop(0)
        if one == "--engine" and arguments:
            references.append(arguments.pop(0))
        else:
            paths.append(one)
    answer = 0 if paths else 2
    for path in paths:
        try:
            certificates, notes = verify(path, references)
            said = [f"{path}: verified, {certificates} certificates", *(f"  not checked: {note}" for note in notes)]
        except Refused as refused:
            answer = max(answer, 1)
            said = [f"{path}: refused at {'.'.join(PLACE) or 'the document'}: {refused}"]
        except (NoDocument, OSError) as error:
            answer = 2
            said = [f"{path}: {error}"]
        print(*map(harmless, said), sep="\n", flush=True)
    return answer


if __name__ == "__main__":
    sys.modules["verify"] = sys.modules["__main__"]  # the files beside this one take it for what it is
    sys.dont_write_bytecode = True
    getattr(sys, "set_int_max_str_digits", lambda _: None)(0)  # numbers have up to 5,000 digits
    try:
        sys.exit(main(sys.argv[1:]))
    except BrokenPipeError:  # who reads has enough, and the rest is not to be written at the end
        os._exit(1)
