"""The second checker, verify.py: remedies, the weights that balance an engine (src/proof/README.md)."""
from enclosures import check_shown
from verify import ONE, SENSES, certify, check_asked, check_engine, collect, demand, each, groups, keys, plain, read, terms_of

keys("""format title masses orders quantities reference_plane cylinders turning_masses weights sums | left_out;
        throw bank position weight rod | speed knuckle_weight; order sense position angle mass_radius | coefficient_of;
        order sense position parts; coefficient terms modulus angle_deg; quantity order sense coefficient terms certificate;
        order sense; rod; quadrature; linkage; corrected; ratio knuckle apart; ratio knuckle master apart correction part; geared; speed of""")


def number_of(coefficient):
    """The number that a remedy names."""
    if coefficient in ("one", "common"):
        return (coefficient,)
    (kind, value), = coefficient.items()
    if kind == "geared":
        return ("geared", value.speed, number_of(value.of))
    keys = {"rod": "ratio offset", "quadrature": "ratio offset", "linkage": "ratio knuckle apart", "corrected": "ratio knuckle master apart correction part"}
    return (kind, *(value[key] for key in keys[kind].split()))


def check(tree, notes):
    document = read(tree)
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
            demand(terms_of(part.terms) == sorted(collect(terms_of(part.terms)).items()), "its terms are not collected, at rising angles")
            check_shown(part, collect(terms_of(part.terms)), False)
    for quantity, k, sense in [(q, k, s) for k in document.orders for q in document.quantities for s in SENSES[q]]:
        of_order = groups((cylinders, turning, plane), quantity, k)
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
