"""The second checker, verify.py: loads and comparisons, numbers with verdicts as their evidence (src/kernel/proof/README.md)."""
from enclosures import exact
from verify import check_classify, demand, each, equal, read, types

# Beside the evidence of loads and comparisons stand numbers with their labels: no word of what is zero, and no truth.
types("""amplitudes = zero-to-peak; force-unit = N m_r_ω²; moment-unit = N_m N_a m_r_ω²_·_1_m m_r_ω²_a; torque-unit = N_m m_r²_ω²;
    units: force=force-unit moment=moment-unit torque=torque-unit; effect = reciprocating rotating crankshaft counterweights balancers;
    scale: mass_kg=size crank_radius_m=size speed_rpm=size angular_speed_rad_s=size m_r_omega_squared_n=size;
    load-coefficient: order=count re=decimal im=decimal; load-vector: amplitude=size angle_deg=decimal? below=size?;
    load-order: quantity order=count direct=load-vector reverse=load-vector largest=size smallest=size direction_deg=decimal?
        along=size across=size dimensionless=size;
    load-torque: order=count amplitude=size phase_deg=decimal? dimensionless=size;
    largest-load: value=size theta_deg=decimal? error_bound=size; bound: at_most=size part=size?;
    largest-loads: force=largest-load moment=largest-load inertia_torque?=largest-load;
    left-out-loads: force=bound? moment=bound? inertia_torque=bound?;
    peak: value=size crank_angle_deg=decimal? effects=[(effect,decimal)]; peaks: force=peak moment=peak torque?=peak;
    auto: accuracy=size kept=[count] dropped=[count] torque_kept=[count] torque_dropped=[count] looked_at=count;
    loads: format=text title=text amplitudes units scale=scale? effects=[effect] coefficients=[load-coefficient] orders=[load-order]
        torque=[load-torque] roll?=[load-torque] largest=largest-loads left_out=left-out-loads peaks coefficients_computed=count auto? evidence=[document];
    position-unit = m spacing; intervals: intervals_deg=[size]; amount: largest=size?; compared-order: order=count force=amount moment=amount;
    newtons: order=count force=size moment=size; worst: bearings=[count] peak=size unit=force-unit;
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
    scale, effects, peaks = document.scale, document.effects, document.peaks
    demand(all(unit.startswith("N") == (scale is not None) for unit in document.units.values()), "newtons need a scale")
    # In newtons all is 0 of an engine at rest, in multiples of m r ω² it is not.
    at_rest = scale is not None and is_nothing(scale.speed_rpm)
    for key, size in (scale or {}).items():
        demand(is_nothing(size) is (at_rest and key not in ("mass_kg", "crank_radius_m")), f"{key}: no speed makes no force, and nothing else is 0")
    left = {"force": [], "moment": [], "torque": [], "roll": []}  # is anything left in the orders that are listed?
    for entry in each("orders", document.orders):
        zeros = judged[entry.quantity, entry.order]
        for vector, is_zero in zip((entry.direct, entry.reverse), zeros):
            agrees(vector.amplitude, is_zero is True or at_rest)
            demand(is_zero is not True or vector.angle_deg is None, "what is zero has no direction")
            demand(vector.below is None or is_zero is None and is_nothing(vector.below) is at_rest, "what is decided has no bound")
        agrees(entry.largest, zeros == [True, True] or at_rest)
        agrees(entry.dimensionless, zeros == [True, True])
        parts = [entry.smallest, entry.along, entry.across]
        demand(zeros != [True, True] and not at_rest or all(map(is_nothing, parts)), "the evidence differs")
        demand(zeros != [True, True] or entry.direction_deg is None, "what is zero has no direction")
        demand(scale is not None or exact(entry.largest) == exact(entry.dimensionless), "without a scale it is the same multiple")
        left[entry.quantity].append(zeros != [True, True])
    for quantity, entries in (("torque", document.torque), ("roll", document.roll or [])):
        for entry in each(quantity, entries):
            is_zero = judged[quantity, entry.order] == [True]
            agrees(entry.amplitude, is_zero or at_rest)
            agrees(entry.dimensionless, is_zero)
            demand(not is_zero or entry.phase_deg is None, "what is zero has no phase")
            left[quantity].append(not is_zero)
    for quantity, largest in (("force", "force"), ("moment", "moment"), ("torque", "inertia_torque")):
        demand((quantity in peaks) == (quantity in evidence["quantities"]) and (quantity in peaks or largest not in document.largest), "another quantity")
        if quantity in peaks:
            agrees(peaks[quantity].value, not any(left[quantity]) or at_rest)
            demand([name for name, _ in peaks[quantity].effects] == ([] if quantity == "torque" else effects), "the effects differ")
        if largest in document.largest:
            of_all = any(not all(is_zero is True for is_zero in zeros) for (of, _), zeros in judged.items() if of == quantity)
            nothing = is_nothing(document.largest[largest].value)
            demand(nothing if at_rest else not (nothing and of_all), "the largest contradicts the evidence")
    shaking = [entry.order for entry in document.orders if entry.quantity == "force"]
    torque, roll = ([entry.order for entry in entries] for entries in (document.torque, document.roll or []))
    rising = all(one == sorted(set(one)) for one in (shaking, torque, [one.order for one in document.coefficients]))
    due = [(quantity, k) for quantity in ("force", "moment") for k in shaking]
    demand(due == [(entry.quantity, entry.order) for entry in document.orders] and rising and sorted({*shaking, *torque}) == evidence["orders"],
           "these are not the orders of the evidence, force and then moment, each once")
    demand(roll == (torque if "roll" in evidence["quantities"] else []), "the roll moment has the orders of the torque, where it is judged")
    demand(len(set(effects)) == len(effects) and all(one.order in shaking for one in document.coefficients), "an effect twice, or a number of no order")
    demand("reciprocating" in effects and (len(effects) == 1) == (evidence["masses"] == "reciprocating"), "these are not the effects of the masses")
    auto = document.get("auto")
    demand(auto is None or (auto.kept, auto.torque_kept) == (shaking, torque), "these are not the orders that are kept")
    demand(auto is None or not {*auto.dropped} & {*shaking} and not {*auto.torque_dropped} & {*torque}, "an order is kept and dropped")


def check_compared(engine, evidence, shapes):
    equal(engine, title=evidence["title"])
    for entries in [engine.orders] if engine.newtons is None else [engine.orders, engine.newtons]:
        demand([entry.order for entry in entries] == evidence["orders"], "these are not the orders of the evidence")
    is_zero = {about: shape in ("balanced", "does-not-exist") for about, shape in shapes.items()}
    several = {(whole["quantity"], whole["order"]) for whole in evidence["wholes"]}
    for entry in each("orders", engine.orders):
        for quantity in ("force", "moment"):
            about, largest = (quantity, entry.order), entry[quantity].largest
            demand((largest is None) == (about in several and not is_zero[about]), "several sums have no length, and one has")
            agrees(largest, is_zero[about])
    for entry in each("newtons", engine.newtons or []):
        for quantity in ("force", "moment"):
            agrees(entry[quantity], is_zero[quantity, entry.order])
