"""The second checker, verify.py: loads and comparisons, numbers with verdicts as their evidence (src/proof/README.md)."""
from enclosures import exact
from verify import check_classify, demand, each, equal, read, types

# Beside the evidence of loads and comparisons stand numbers with their labels: no word of what is zero, and no truth.
types("""amplitudes = zero-to-peak; force-unit = N m_r_ω²; moment-unit = N_m N_a m_r_ω²_·_1_m m_r_ω²_a; torque-unit = N_m m_r²_ω²;
    units: force=force-unit moment=moment-unit torque=torque-unit; effect = reciprocating rotating crankshaft counterweights balancers;
    scale: mass_kg=decimal crank_radius_m=decimal speed_rpm=decimal angular_speed_rad_s=decimal m_r_omega_squared_n=decimal;
    load-coefficient: order=count re=decimal im=decimal; load-vector: amplitude=decimal angle_deg=decimal? below=decimal?;
    load-order: quantity order=count direct=load-vector reverse=load-vector largest=decimal smallest=decimal direction_deg=decimal?
        along=decimal across=decimal dimensionless=decimal;
    load-torque: order=count amplitude=decimal phase_deg=decimal? dimensionless=decimal;
    largest-load: value=decimal theta_deg=decimal? error_bound=decimal; bound: at_most=decimal part=decimal?;
    largest-loads: force=largest-load moment=largest-load inertia_torque?=largest-load;
    left-out-loads: force=bound? moment=bound? inertia_torque=bound?;
    peak: value=decimal crank_angle_deg=decimal? effects=[(effect,decimal)]; peaks: force=peak moment=peak torque?=peak;
    auto: accuracy=decimal kept=[count] dropped=[count] torque_kept=[count] torque_dropped=[count] looked_at=count;
    loads: format=text title=text amplitudes units scale=scale? effects=[effect] coefficients=[load-coefficient] orders=[load-order]
        torque=[load-torque] roll?=[load-torque] largest=largest-loads left_out=left-out-loads peaks coefficients_computed=count auto? evidence=[document];
    position-unit = m spacing; intervals: intervals_deg=[decimal]; amount: largest=decimal?; compared-order: order=count force=amount moment=amount;
    newtons: order=count force=decimal moment=decimal; worst: bearings=[count] peak=decimal unit=force-unit;
    compared: title=text position_unit=position-unit firing=intervals? orders=[compared-order] newtons=[newtons]? worst_bearings=worst?
        worst_bearing_with_gas?=worst;
    comparison: format=text orders=[count] amplitudes engines=[compared] evidence=[document]""")


def check(tree, notes):
    """Of loads and comparisons: the documents of verdicts in them, and what the rest says beside those."""
    kind, proved, evidence = tree["format"].split()[1], [], tree["evidence"]
    document = read(tree, {"loads": "loads", "compare": "comparison"}[kind])
    for one in each("evidence", evidence):
        demand(one["format"] == "crankstar classify 2", "it is no document of verdicts")
        proved.append(check_classify(one, notes))
    demand(proved and (kind != "loads" or len(proved) == 1), "there is no evidence, or too much")
    notes.add("the numbers outside of `evidence`, but whether the size of an order is 0")
    if kind == "loads":
        check_loads(document, evidence[0], proved[0][0])
    if kind == "compare":
        for (one, (_, shapes)), engine in each("engines", document.engines, list(zip(evidence, proved))):
            demand(document.orders == one["orders"], "these are not the orders of the evidence")
            check_compared(engine, one, shapes)


def is_nothing(size):
    return size is not None and exact(size) == 0


def agrees(size, is_zero):
    """0 stands exactly where the evidence proves it."""
    demand(is_nothing(size) is is_zero, "the evidence differs")


def check_loads(document, evidence, judged):
    equal(document, title=evidence["title"])
    # In newtons all is 0 of an engine at rest, in multiples of m r ω² it is not.
    at_rest = document.scale is not None and is_nothing(document.scale.m_r_omega_squared_n)
    for entry in each("orders", document.orders):
        direct, reverse = (is_zero is True for is_zero in judged[entry.quantity, entry.order])
        agrees(entry.direct.amplitude, direct or at_rest)
        agrees(entry.reverse.amplitude, reverse or at_rest)
        agrees(entry.largest, direct and reverse or at_rest)
        agrees(entry.dimensionless, direct and reverse)
    for entry in each("torque", document.torque):
        is_zero = judged["torque", entry.order] == [True]
        agrees(entry.amplitude, is_zero or at_rest)
        agrees(entry.dimensionless, is_zero)
    shaking = [entry.order for entry in document.orders if entry.quantity == "force"]
    torque = [entry.order for entry in document.torque]
    rising = all(one == sorted(set(one)) for one in (shaking, torque))
    due = [(quantity, k) for quantity in ("force", "moment") for k in shaking]
    demand(due == [(entry.quantity, entry.order) for entry in document.orders] and rising and sorted({*shaking, *torque}) == evidence["orders"],
           "these are not the orders of the evidence, force and then moment, each once")


def check_compared(engine, evidence, shapes):
    equal(engine, title=evidence["title"])
    for entries in [engine.orders] if engine.newtons is None else [engine.orders, engine.newtons]:
        demand([entry.order for entry in entries] == evidence["orders"], "these are not the orders of the evidence")
    for entry in each("orders", engine.orders):
        for quantity in ("force", "moment"):
            agrees(entry[quantity].largest, shapes[quantity, entry.order] in ("balanced", "does-not-exist"))
