"""The second checker, verify.py: when sums are zero that two open angles turn on their own: triangles, products, classes of parts."""
from arcs import circle, is_free
from enclosures import bits_of, common_denominator, enclose
from families import alternative, check_when, divided, minus, multiples
from verify import CHECKED, certify, collect, conjugate, demand, each, times, unequal


def check(when, left, notes):
    {"triangle": triangle, "product": product, "classes": classes, "quadratic": quadratic}[when.kind](when, left, notes)


def triangle(claim, left, notes):
    """Three vectors that turn freely close a triangle: 2(ab + bc + ca) − a² − b² − c², 16 times its squared area by Heron, decides
    whether there is none, one that is flat, or two. a, b, c are the squared sides."""
    (a, b), (c, d) = (minus(turned, left[0][0]) for turned, _ in left[1:])
    demand(a * d != b * c, "the parts are not turned against each other by two angles on their own")
    squares = [collect(times(conjugate(total), total)) for _, total in left]
    area = [term for a in squares for b in squares for term in times(a, b, -1 if a is b else 1)]
    most = sign_of(claim["shape"], area)
    demand(len(claim.alternatives) <= most, f"{len(claim.alternatives)} triangles are named, and there are {most}")
    turns = [alternative(one, left) for one in each("alternatives", claim.alternatives)]
    demand(len(turns) < 2 or turns[0] != turns[1], "the two triangles are the same")
    CHECKED[1] += 1


def sign_of(shape, number):
    """The sign of a real sum: how many solutions it leaves."""
    demand(shape.kind in ("never", "flat", "two"), "it is of no such shape")
    if shape.kind == "flat":
        certify(number, shape.certificate, True)
    else:
        number = collect(number)
        size, _, doubt = enclose(number, common_denominator([number]), bits_of(shape))
        demand((size if shape.kind == "two" else -size) > doubt, "the number does not have this sign, or the bits leave it open")
    return ["never", "flat", "two"].index(shape.kind)


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


def split(claim, left, others):
    """The parts in classes: the places in `others`, and before them those that are left. The first part of the second class is turned
    against that of the first by an angle v on its own, class n as a whole by n·v, and its parts by whole multiples of u: {multiple: sum}."""
    for places in others:
        demand(places == sorted(set(places)) and all(0 <= place < len(left) for place in places), "a class is no rising list of parts")
    others = [[place for place in range(len(left)) if not any(place in one for one in others)]] + others
    demand(all(others) and sum(map(len, others)) == len(left), "a class is empty, or a part is in two")
    start = left[others[0][0]][0]
    v = minus(left[others[1][0]][0], start)
    demand(v[0] * claim.delta != v[1] * claim.phi, "the classes are not turned against each other by an angle on its own")
    turned = [[minus(left[place][0], [x + n * y for x, y in zip(start, v)]) for place in places] for n, places in enumerate(others)]
    return [dict(zip(multiples(claim, angles), (left[place][1] for place in places))) for angles, places in zip(turned, others)]


def laurent(products):
    """Σ ± conj(A) B of polynomials in y = e^(iu): {power: sum}."""
    found = {}
    for one, other, sign in products:
        for low, a in one.items():
            for high, b in other.items():
                found.setdefault(high - low, []).extend(times(conjugate(a), b, sign))
    return {power: collect(terms) for power, terms in found.items()}


def at(polynomial, turn, more=0):
    """Its terms where u is the turn, turned by more."""
    return [(t + n * turn + more, w) for n, total in polynomial.items() for t, w in total.items()]


def not_zero(name, certificates, powers):
    """The coefficients that are not zero, by their powers, as the certificates show."""
    return {m: total for (m, total), certificate in each(name, certificates, sorted(powers.items())) if not certify(total, certificate)}


def half(powers):
    """A real polynomial Σ P_m y^m has P_−m = conj(P_m)."""
    return {m: total for m, total in powers.items() if m >= 0}


def zeros(claim, there, notes, twist=None):
    """Where a real polynomial is zero of which these coefficients are not zero: has the circle checked, which is there unless the
    polynomial is constant. Returns the zeros that are rational turns. `twist` has the same zeros on the circle, be it once or several times."""
    if not any(there):
        demand(claim.circle is None, "the polynomial is constant, so there is no circle")
        return []
    demand(claim.circle is not None, "where the polynomial is zero is not said")
    demand((claim.circle.phi, claim.circle.delta) == (claim.phi, claim.delta), "the circle is not that of u")
    demand(twist or claim.circle.divided is None, "here a crossing has to be a simple zero of the polynomial itself")
    whole = from_zero(twist or {**{-m: conjugate(total) for m, total in there.items()}, **there})
    circle(claim.circle, divided(claim.circle, whole) if claim.circle.divided else whole, notes)
    return [arc["at"] for arc in claim.circle.arcs if arc.kind == "rational"]


def from_zero(powers):
    """The polynomial up to a power of y, as pairs, exponents from 0 on."""
    return [(m - min(powers), total) for m, total in sorted(powers.items())]


def classes(claim, left, notes):
    """A(y) + B(y) x with y = e^(iu), x = e^(iv): zero where both are equally long, for one x, and for every x where both are zero. There
    |A|² − |B|², which is real, has a double zero, so that it is no crossing."""
    A, B = split(claim, left, [claim.second])
    demand(min(A) == min(B) == 0, "u enters a part a negative number of times")
    turns = zeros(claim, not_zero("squares", claim.squares, half(laurent([(A, A, 1), (B, B, -1)]))), notes)
    for turn, meeting in each("meetings", claim.meetings, turns):
        demand(meeting.kind in ("all", "rational", "once"), "a meeting is of no such kind")
        if meeting.kind == "all":
            for of, certificate in each("certificates", meeting.certificates, [A, B]):
                certify(at(of, turn), certificate, True)
        else:
            certify(at(A, turn), meeting["first"], False)
            if meeting.kind == "rational":
                certify(at(A, turn) + at(B, turn, meeting.turn), meeting.certificate, True)


def quadratic(claim, left, notes):
    """f = A(y) + B(y) x + C(y) x². With D = |A|² − |C|² and E = conj(A) B − conj(B) C it is conj(A) f − C x² conj(f) = D + E x, so that
    f = 0 needs D² = |E|². There, if D ≠ 0, x = −D/E alone leaves |A||f| = |C||f|, so f = 0; at a simple zero D is not 0. If D = E = 0 and
    A ≠ 0, f/x turned is real, 2|A| cos ξ ± |B|. If D = 0 for every y, D² − |E|² is −|E|², and the arcs are about E (`twist`): on a crossing
    4|A|² − |B|² keeps its sign, so that x is one of two (A is then not zero) or there is none, be A zero or not."""
    A, B, C = split(claim, left, [claim.second, claim.third])
    D, E = laurent([(A, A, 1), (C, C, -1)]), laurent([(A, B, 1), (B, C, -1)])
    there = not_zero("coefficients", claim.coefficients, half(laurent([(D, D, 1), (E, E, -1)])))
    demand(claim.twist is None or any(there), "the polynomial is constant, so that no twist belongs here")
    # On a curve, where D² = |E|² for every y, the certificates tell for which of them D is zero.
    lengths = not_zero("lengths", claim.lengths, half(D) if claim.twist or not there else {})
    if claim.twist:
        demand(not lengths, "first and third class are not equally long for every y")
        turns = zeros(claim, there, notes, not_zero("coefficients", claim.twist.coefficients, E))
        signs(claim, laurent([(A, A, 4), (B, B, -1)]))
    else:
        turns = zeros(claim, there, notes)
    for turn, roots in each("roots", claim.roots, turns):
        a, b, c = (collect(at(of, turn)) for of in (A, B, C))
        demand(roots.kind in ("all", "none", "one", "mirror"), "roots are of no such kind")
        if roots.kind in ("all", "none"):
            for (of, is_zero), certificate in each("certificates", roots.certificates, [(a, True), (b, roots.kind == "all"), (c, True)]):
                certify(of, certificate, is_zero)
            continue
        certify(unequal(a, c), roots.lengths, roots.kind == "mirror")
        most = 1
        if roots.kind == "mirror":
            certify(a, roots["first"], False)
            most = sign_of(roots["shape"], unequal({t: 2 * w for t, w in a.items()}, b))
        found = [root.turn % 1 for root in roots["at"]]
        demand(len(found) <= most and len(set(found)) == len(found), f"{len(found)} turns are named where there are {most}, or one twice")
        for x, root in zip(found, roots["at"]):
            certify([(t + n * x, w) for n, of in enumerate((a, b, c)) for t, w in of.items()], root.certificate, True)


def signs(claim, number):
    """On every crossing a real polynomial has the sign that is said: where the arc begins, and it is zero nowhere on it."""
    arcs, bits = claim.circle.arcs, bits_of(claim.circle)
    starts = [claim.circle["from"], *(arc.to for arc in arcs)]
    scale = common_denominator(list(number.values()))
    curve = [(2 * m, enclose(total, scale, bits)) for m, total in from_zero(number)]
    due = [(low, arc.to) for low, arc in zip(starts, arcs) if arc.kind == "crossing"]
    for (low, high), sign in each("signs", claim.twist.signs, due):
        demand(sign.kind != "flat", "at an irrational turn no sum is shown to be zero")
        sign_of(sign, at(number, low))
        demand(is_free(curve, low, high, bits), "no line keeps the number away from 0")
