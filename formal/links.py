"""The second checker, verify.py: articulated rods, links on a master rod, as src/kernel/proof/README.md tells them."""
from fractions import Fraction
from math import comb

from motion import check_turns_round
from verify import ONE, SENSES, NoDocument, demand, of_rod, phase

QUARTER, HALF = Fraction(1, 4), Fraction(1, 2)


def link_of(link):
    eps = link.correction or Fraction(0)
    demand(0 <= link.master < 1 and link.ratio >= 0 and link.knuckle > 0 and apart(eps) < QUARTER, "the link is out of range")
    rod = ("link", link.master, link.knuckle, link.angle, link.ratio, eps)
    check_turns_round(rod)
    return rod


def apart(angle):
    """The angle or its opposite: the one up to a half turn."""
    return min(angle % 1, -angle % 1)


def factors(rod, k):
    """The numbers that order k of its piston is multiplied by: (number, whether it is 0, vectors that its own is multiplied by)."""
    _, master, knuckle, delta, ratio, eps = rod
    if k > 5000:
        raise NoDocument(f"order {k} of a link is more than this checker expands")
    number, is_zero, _ = of_rod(("rod", master, 0), k)
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


def of_piston(c, rod, k):
    """(number, whether it is 0, sense, angle, part of the weight): the vectors are turned the other way in the reverse sum."""
    for number, is_zero, parts in factors(rod, k):
        for sense, way in zip(SENSES["force"], (1, -1)):
            for turned, part in parts:
                yield number, is_zero, sense, phase(c.throw, c.bank, k, sense) + way * turned, part


def of_knuckle(c, rod, k):
    """A mass at the knuckle pin moves with the master's piston, turned by Δ + ε in either sense."""
    _, master, knuckle, delta, _, eps = rod
    number, is_zero, _ = of_rod(("rod", master, 0), k)
    for sense in SENSES["force"]:
        yield number, is_zero, sense, phase(c.throw, c.bank - delta, k, sense) + delta + eps, c.knuckle_weight * knuckle
