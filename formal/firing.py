"""The second checker, verify.py: the firing stars of an engine (src/kernel/proof/README.md)."""
from fractions import Fraction

from enclosures import check_shown
from verify import certify, check_masters, collect, demand, each, equal, read, rod_of, terms_of, types

types("""cycle = two-stroke four-stroke; firing-cylinder: name=text throw bank firing_angle crank_radius deflection rod;
    star: order of?=[text] vanishes=truth terms=[vector] modulus=decimal angle_deg=decimal? certificate; pattern-star: order vanishes=truth certificate;
    pattern: period=count verdicts=[pattern-star];
    firing: format=text title=text cycle cylinders=[firing-cylinder] orders=[exact] verdicts=[star] pattern=pattern?""")


def check(tree, notes):
    document = read(tree, "firing")
    turns, stars = {"two-stroke": 1, "four-stroke": 2}[document.cycle], {}
    cylinders, orders, rods = document.cylinders, document.orders, []
    centre = lambda c: (c.firing_angle - c.bank + c.throw) % 1
    for c in each("cylinders", cylinders):
        demand(0 <= c.firing_angle < turns and centre(c) == centre(cylinders[0]), "it does not fire in the cycle, at a dead centre of its own")
        rods.append(rod := rod_of(c.rod))
        stars.setdefault(rod, []).append(c)
    check_masters(cylinders, rods)
    demand(len({rod[2] for rod in rods if rod[:2] == ("rod", 0)}) <= 1, "infinitely long rods have several offsets, and no stars of their own")
    demand(all(c.crank_radius > 0 for c in cylinders), "a crank radius is not above 0")
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
        check_shown(entry, collect(star(of, k)), entry.vanishes)
        certify(star(of, k), entry.certificate, entry.vanishes)
    if document.pattern is not None:
        period, verdicts = document.pattern.period, document.pattern.verdicts
        demand(1 <= period <= len(verdicts), "pattern: verdicts are missing")
        demand(all(c.firing_angle * period / turns % 1 == 0 for c in cylinders), "a star does not repeat after the period")
        due = [(Fraction(index, turns), of) for index in range(1, period + 1) for of in stars.values()]
        for (k, of), entry in each("pattern.verdicts", verdicts, due):
            equal(entry, order=k)
            certify(star(of, k), entry.certificate, entry.vanishes)
