"""The second checker, verify.py: loads, comparisons and sweeps, numbers with verdicts as their evidence (src/proof/README.md)."""
from enclosures import exact
from verify import Decimal, check_classify, demand, each

NUMBER, CHECKED = "a number or null", "checked elsewhere"
EFFECT = {"reciprocating", "rotating", "crankshaft", "counterweights", "balancers"}


def numbers(names):
    """An object of numbers; a key that ends in ? may be left out."""
    return {name: NUMBER for name in names.split()}


VECTOR = numbers("amplitude angle_deg below?")
TORQUE = [numbers("order amplitude phase_deg dimensionless")]
LARGEST, BOUND = numbers("value theta_deg error_bound"), ("null or", numbers("at_most part"))
PEAK = {**numbers("value crank_angle_deg"), "effects": [("pair", EFFECT, NUMBER)]}
WORST = {"bearings": [NUMBER], "peak": NUMBER, "unit": {"N", "m r ω²"}}
HEAD = {"format": CHECKED, "amplitudes": {"zero-to-peak"}, "evidence": CHECKED}
LOADS = {
    **HEAD, "title": CHECKED, "coefficients": [numbers("order re im")], "coefficients_computed": NUMBER,
    "units": {"force": {"N", "m r ω²"}, "moment": {"N m", "N a", "m r ω² · 1 m", "m r ω² a"}, "torque": {"N m", "m r² ω²"}},
    "scale": ("null or", numbers("mass_kg crank_radius_m speed_rpm angular_speed_rad_s m_r_omega_squared_n")), "effects": [EFFECT],
    "orders": [{**numbers("order largest smallest direction_deg along across dimensionless"), "quantity": {"force", "moment"}, "direct": VECTOR, "reverse": VECTOR}],
    "torque": TORQUE, "roll?": TORQUE, "largest": {"force": LARGEST, "moment": LARGEST, "inertia_torque?": LARGEST},
    "peaks": {"force": PEAK, "moment": PEAK, "torque?": PEAK}, "left_out": {"force": BOUND, "moment": BOUND, "inertia_torque": BOUND},
    "auto?": {**numbers("accuracy looked_at"), **{name: [NUMBER] for name in ("kept", "dropped", "torque_kept", "torque_dropped")}},
}
COMPARE = {
    **HEAD, "orders": [NUMBER],
    "engines": [{
        "title": CHECKED, "position_unit": {"m", "spacing"}, "firing": ("null or", {"intervals_deg": [NUMBER]}),
        "orders": [{"order": NUMBER, "force": numbers("largest"), "moment": numbers("largest")}],
        "newtons": ("null or", [numbers("order force moment")]), "worst_bearings": ("null or", WORST), "worst_bearing_with_gas?": WORST,
    }],
}


def fits(place, value, kind):
    """Outside of `evidence` stand numbers with their labels, and no key that is not known."""
    if kind == NUMBER:
        demand(value is None or type(value) is int or isinstance(value, Decimal), f"{place} is no number")
    elif isinstance(kind, set):
        demand(type(value) is str and value in kind, f"{place} is none of the labels")
    elif isinstance(kind, list):
        demand(type(value) is list, f"{place} is no list")
        for one in value:
            fits(place, one, kind[0])
    elif isinstance(kind, dict):
        known = {name.rstrip("?"): inner for name, inner in kind.items()}
        needed = {name for name in kind if name[-1] != "?"}
        demand(type(value) is dict and needed <= set(value) <= set(known), f"{place or 'it'} has other keys than the format")
        for name, inner in value.items():
            fits(name, inner, known[name])
    elif kind[0] == "null or":
        value is None or fits(place, value, kind[1])
    elif kind[0] == "pair":
        demand(type(value) is list and len(value) == 2, f"{place} is no pair")
        fits(place, value[0], kind[1])
        fits(place, value[1], kind[2])


def agrees(size, is_zero):
    """0 stands exactly where the evidence proves it."""
    demand(is_zero is None or (size is not None and exact(size) == 0) is is_zero, "the evidence differs")


def check_loads(document, judged, orders):
    for entry in each("orders", document["orders"]):
        for sense, is_zero in zip(("direct", "reverse"), judged[entry["quantity"], entry["order"]]):
            agrees(entry[sense]["amplitude"], is_zero)
    for entry in each("torque", document["torque"]):
        agrees(entry["amplitude"], *judged["torque", entry["order"]])
    force, moment = ([entry["order"] for entry in document["orders"] if entry["quantity"] == one] for one in ("force", "moment"))
    torque = [entry["order"] for entry in document["torque"]]
    rising = all(one == sorted(set(one)) for one in (force, torque))
    demand(force == moment and rising and sorted({*force, *torque}) == orders, "orders: these are not those of the evidence, each once")


def check_compared(engine, shapes, orders):
    demand([entry["order"] for entry in engine["orders"]] == orders, "orders: these are not those of the evidence")
    for entry in each("orders", engine["orders"]):
        for quantity in ("force", "moment"):
            shape = shapes[quantity, entry["order"]]
            agrees(entry[quantity]["largest"], None if shape == "not-decided" else shape in ("balanced", "does-not-exist"))


def check(document, notes):
    """Of loads, comparisons and sweeps: the documents of verdicts in them, and what the rest says beside those."""
    kind = document["format"].split()[1]
    fits("", document, {"loads": LOADS, "compare": COMPARE}.get(kind, CHECKED))
    notes.add("all that stands outside of `evidence`" if kind == "sweep" else "all numbers outside of `evidence` but those that are 0")
    proved, evidence = [], document["evidence"]
    for one in each("evidence", evidence):
        demand(one["format"] == "crankstar classify 2", "it is no document of verdicts")
        proved.append(check_classify(one, notes))
    demand(proved and (kind != "loads" or len(proved) == 1), "there is no evidence, or too much")
    if kind == "loads":
        demand(document["title"] == evidence[0]["title"], "title: it is not that of the evidence")
        check_loads(document, proved[0][0], evidence[0]["orders"])
    if kind == "compare":
        for ((_, shapes), one), engine in each("engines", document["engines"], list(zip(proved, evidence))):
            demand(engine["title"] == one["title"], "title: it is not that of the evidence")
            demand(document["orders"] == one["orders"], "orders: these are not those of the evidence")
            check_compared(engine, shapes, one["orders"])
