"""The second checker, verify.py: loads and comparisons, numbers with verdicts as their evidence (src/kernel/proof/README.md)."""
from fractions import Fraction

import verify
from enclosures import exact
from sizes import Swing, check_scale, is_near, of_rod, of_vector, slack_of
from verify import check_classify, demand, each, equal, read, rod_of, types

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
        torque=[load-torque] roll?=[load-torque] largest=largest-loads left_out=left-out-loads peaks coefficients_computed=count auto? not_checked=[text] evidence=[document];
    position-unit = m spacing; intervals: intervals_deg=[size]; amount: largest=size?; compared-order: order=count force=amount moment=amount;
    newtons: order=count force=size moment=size; worst: bearings=[count] peak=size unit=force-unit;
    compared: title=text position_unit=position-unit firing=intervals? orders=[compared-order] scale=scale? newtons=[newtons]? worst_bearings=worst?
        worst_bearing_with_gas?=worst;
    comparison: format=text orders=[count] amplitudes engines=[compared] not_checked=[text] evidence=[document]""")


# What nothing is compared with, but whether peaks and largest values are 0: the document names it itself.
NOT_CHECKED = {"loads": ["units.moment", "largest", "left_out", "peaks", "coefficients_computed", "auto"],
               "compare": ["position_unit", "firing", "worst_bearings", "worst_bearing_with_gas"]}


def check(tree, notes):
    """Of loads and comparisons: the documents of verdicts in them, and what the rest says beside those."""
    kind, proved, evidence = tree["format"].split()[1], [], tree["evidence"]
    document = read(tree, {"loads": "loads", "compare": "comparison"}[kind])
    for one in each("evidence", evidence):
        demand(one["format"] == "crankstar classify 2", "it is no document of verdicts")
        found = check_classify(one, notes)
        proved.append((read(one, "classify"), *found))
    demand(proved and (kind != "loads" or len(proved) == 1), "there is no evidence, or too much")
    equal(document, not_checked=NOT_CHECKED[kind])
    but = ", but whether the values of `peaks` are 0, and that `largest` is not 0 where something is left"
    notes.add("the numbers that the document names in `not_checked`" + (but if kind == "loads" else ""))
    if kind == "loads":
        check_loads(document, *proved[0])
    if kind == "compare":
        for (one, found), engine in each("engines", document.engines, [(one[0], one) for one in proved]):
            demand(document.orders == one.orders, "these are not the orders of the evidence")
            check_compared(engine, *found)


def is_nothing(size):
    return size is not None and exact(size) == 0


def agrees(size, is_zero):
    """0 stands exactly where the evidence proves it."""
    demand(is_nothing(size) is is_zero, "the evidence differs")


def is_size(size, length, unit, is_zero):
    """A length in this unit, 0 exactly where the evidence proves it, and at rest."""
    agrees(size, is_zero or unit == 0)
    is_near(size, length.value * unit, length.slack * unit)


def check_loads(document, evidence, judged, _, left_of):
    equal(document, title=evidence["title"])
    scale, effects, peaks = document.scale, document.effects, document.peaks
    demand(all(unit.startswith("N") == (scale is not None) for unit in document.units.values()), "newtons need a scale")
    # In newtons all is 0 of an engine at rest, in multiples of m r ω² it is not.
    force, of_torque = check_scale(scale) if scale else (Fraction(1), Fraction(1))
    at_rest = force == 0
    left = {"force": [], "moment": [], "torque": [], "roll": []}  # is anything left in the orders that are listed?
    for entry in each("orders", document.orders):
        about = entry.quantity, entry.order
        zeros, swing = judged[about], Swing(*about, left_of)
        demand(len(zeros) == 2, "it has no sense")
        for vector, is_zero, shown in zip((entry.direct, entry.reverse), zeros, swing.sums):
            is_size(vector.amplitude, shown.length, force, is_zero is True)
            shown.points(vector.angle_deg, 360, is_zero)
            demand(vector.below is None or is_zero is None and is_nothing(vector.below) is at_rest, "what is decided has no bound")
        is_zero = zeros == [True, True]
        is_size(entry.largest, swing.largest, force, is_zero)
        is_size(entry.dimensionless, swing.largest, 1, is_zero)
        swing.axis.points(entry.direction_deg, 180, True if True in zeros else None if None in zeros else False)
        for size, right in zip((entry.smallest, entry.along, entry.across), (swing.smallest, swing.along, swing.across)):
            is_near(size, right * force, swing.largest.slack * force)
        left[entry.quantity].append(not is_zero)
    for quantity, entries in (("torque", document.torque), ("roll", document.roll or [])):
        for entry in each(quantity, entries):
            is_zero, shown = judged[quantity, entry.order][0], of_vector(quantity, entry.order, None, left_of)
            is_size(entry.amplitude, shown.length, of_torque, is_zero is True)
            is_size(entry.dimensionless, shown.length, 1, is_zero is True)
            shown.points(entry.phase_deg, 360, is_zero)
            left[quantity].append(is_zero is not True)
    shaking = [entry.order for entry in document.orders if entry.quantity == "force"]
    rods = {(repr(c.rod), c.speed) for c in evidence.cylinders}
    for entry in each("coefficients", document.coefficients):
        c = evidence.cylinders[0]
        demand(len(rods) == 1 and "known" in c.rod and c.speed is None, "the cylinders have no number in common")
        demand(entry.order in shaking, "a number of no order")
        demand(not verify.of_rod(rod_of(c.rod), entry.order)[1], "the motion has no such order")
        of_rod(c.rod.known, entry.order).has_parts(entry.re, entry.im)
    for quantity, largest in (("force", "force"), ("moment", "moment"), ("torque", "inertia_torque")):
        demand((quantity in peaks) == (quantity in evidence["quantities"]) and (quantity in peaks or largest not in document.largest), "another quantity")
        if quantity in peaks:
            agrees(peaks[quantity].value, not any(left[quantity]) or at_rest)
            demand([name for name, _ in peaks[quantity].effects] == ([] if quantity == "torque" else effects), "the effects differ")
        if largest in document.largest:
            of_all = any(not all(is_zero is True for is_zero in zeros) for (of, _), zeros in judged.items() if of == quantity)
            nothing = is_nothing(document.largest[largest].value)
            demand(nothing if at_rest else not (nothing and of_all), "the largest contradicts the evidence")
    torque, roll = ([entry.order for entry in entries] for entries in (document.torque, document.roll or []))
    rising = all(one == sorted(set(one)) for one in (shaking, torque, [one.order for one in document.coefficients]))
    due = [(quantity, k) for quantity in ("force", "moment") for k in shaking]
    demand(due == [(entry.quantity, entry.order) for entry in document.orders] and rising and sorted({*shaking, *torque}) == evidence["orders"],
           "these are not the orders of the evidence, force and then moment, each once")
    demand(roll == (torque if "roll" in evidence["quantities"] else []), "the roll moment has the orders of the torque, where it is judged")
    demand(len(set(effects)) == len(effects), "an effect twice")
    demand("reciprocating" in effects and (len(effects) == 1) == (evidence["masses"] == "reciprocating"), "these are not the effects of the masses")
    auto = document.get("auto")
    demand(auto is None or (auto.kept, auto.torque_kept) == (shaking, torque), "these are not the orders that are kept")
    demand(auto is None or not {*auto.dropped} & {*shaking} and not {*auto.torque_dropped} & {*torque}, "an order is kept and dropped")


def check_compared(engine, evidence, judged, _, left_of):
    equal(engine, title=evidence["title"])
    force = check_scale(engine.scale)[0] if engine.scale else 0
    demand((engine.newtons is not None) is (force > 0), "newtons are those of an engine that moves")
    for entries in [engine.orders] if engine.newtons is None else [engine.orders, engine.newtons]:
        demand([entry.order for entry in entries] == evidence["orders"], "these are not the orders of the evidence")
    several = {(whole.quantity, whole.order) for whole in evidence.wholes}
    for entry in each("orders", engine.orders):
        for quantity in ("force", "moment"):
            about, largest = (quantity, entry.order), entry[quantity].largest
            is_zero = judged[about] == [True, True]
            demand((largest is None) == (about in several and not is_zero), "several sums have no length, and one has")
            if largest is not None:
                moduli = [exact(one.modulus) for one in evidence.verdicts if (one.quantity, one.order) == about and not is_zero]
                agrees(largest, is_zero)
                is_near(largest, sum(moduli) / 2, slack_of(sum(moduli) / 2))
    for entry in each("newtons", engine.newtons or []):
        for quantity in ("force", "moment"):
            about = quantity, entry.order
            is_size(entry[quantity], Swing(*about, left_of).largest, force, judged[about] == [True, True])
