"""The second checker, verify.py: the roll moment of an engine with several crankshafts, as src/kernel/proof/README.md tells it."""
from fractions import Fraction

from verify import demand, of_force, of_torque, phase, terms_of

QUARTER, HALF = Fraction(1, 4), Fraction(1, 2)


def arms(c, rod, is_against):
    """What the axis of a cylinder has for an arm about the middle of the engine: vectors that its force is multiplied by."""
    for eta, d in terms_of(c.crankshaft.axis if c.crankshaft else []):
        across = (c.bank - eta - QUARTER) % 1
        if across in (0, HALF):
            yield across, d
        elif across not in (QUARTER, 3 * QUARTER):  # there the axis passes through the middle
            yield from ((-across, d / 2), (across, d / 2))
    if rod[0] == "rod" and rod[2]:
        demand(rod[1] > 0, "an endless rod with an offset has no arm")
        yield 0, (1 if is_against else -1) * rod[2] * c.crank_radius / rod[1]


def of_cylinder(c, rod, k, size, do_rods_differ):
    """(number, whether it is 0, angle, weight): the force by its arm, and the torque, which turns the engine the other way."""
    angle, is_against = phase(c.throw, c.bank, k, None), c.crankshaft is not None and c.crankshaft.sense == "reverse"
    for turned, arm in arms(c, rod, is_against):
        for number, is_zero, ahead, sign in of_force(rod, k, do_rods_differ):
            yield number, is_zero, angle + ahead + turned, size * sign * arm
    yield (*of_torque(rod, k), angle, size * c.crank_radius * (1 if is_against else -1))


def of_mass(mass, k):
    way = 1 if mass.sense == "direct" else -1
    return [(way * (mass.angle - eta - QUARTER), k * k * mass.mass_radius * d) for eta, d in terms_of(mass.axis)]
