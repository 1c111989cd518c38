"""The second checker, verify.py: is a document about the engine that it should be about? Compared with that of another document.

    crankstar classify LAYOUT --masses all --json > engine.json      and then      python3 formal/verify.py --engine engine.json FILE…

A layout file is not read here: forms, units and shorthands are the program's. What it reads from one is in any document of the
same engine; compare its cylinders with your drawing once, and let every other document be compared with it. A document of the same kind
is compared entry by entry; one on all masses does for verdicts on the pistons and for a remedy besides. Loads and comparisons are best
compared with a document of `loads`, whose masses in kilograms, speed and units are then compared too.
"""
from verify import beside, demand, demand_document, each, opened, read

ENGINE = ("cycle", "reference_plane", "cylinders", "turning_masses")
KINDS = {"classify 2": ("classify", None), "family 2": ("family", "families"), "remedy 2": ("remedy", "remedies"), "firing 1": ("firing", "firing")}


def engine_of(tree):
    """What a document says of its engine."""
    name = tree["format"][10:]
    demand_document(name in KINDS, "an engine is taken from the document of one engine")
    kind, file = KINDS[name]
    if file:
        beside(file)
    if tree.get("all_orders"):
        beside("every_order")
    return kind, read(tree, kind)


def without(entries, *keys):
    return [{key: value for key, value in entry.items() if key not in keys} for entry in entries]


def compare(tree, paths, notes):
    """A document with evidence has one engine for each document of it, and says of each how fast it turns and what is as heavy as 1."""
    has_evidence = tree["format"][10:] not in KINDS
    trees = tree["evidence"] if has_evidence else [tree]
    demand_document(len(trees) == len(paths), f"{len(paths)} engines are named by --engine, and {len(trees)} are compared")
    for index, (own, path) in enumerate(zip(trees, paths)):
        reference = opened(path)
        if reference["format"][10:] == "loads 4":
            if has_evidence:
                same_numbers(tree["engines"][index] if "engines" in tree else tree, reference)
            reference = reference["evidence"][0]
        elif has_evidence:
            notes.add("masses in kilograms, the speed and units: --engine compares them with those of a document of `loads`")
        kind, found = engine_of(own)
        told, of = engine_of(reference)
        if has_evidence and told == "classify":
            demand(found.masses == "all" or not of.turning_masses, "the engine is another one: it has masses that turn, and numbers are those of all masses")
        due = due_of(kind, found, told, of)
        for key in ENGINE:
            if key in due:
                same(key, found[key], due[key])


def due_of(kind, found, reference, of):
    """What a document of this kind has to say of the engine of the other."""
    if kind == "classify" and reference == "classify":
        roll = "roll" in found.quantities
        demand_document(of.masses in (found.masses, "all"), f"the engine is taken from a document on {of.masses} masses, which does not tell {found.masses} ones")
        demand_document(of.masses == found.masses or found.masses == "reciprocating", f"the engine is taken from a document on all masses, which does not tell which are {found.masses}")
        demand_document(not roll or "roll" in of.quantities, "the engine is taken from a document without roll moment, which does not tell where axes stand")
        turning = of.turning_masses if found.masses != "reciprocating" else []
        left_out = () if roll else ("crankshaft", "axis")
        return {"reference_plane": of.reference_plane, "cylinders": without(of.cylinders, *left_out), "turning_masses": without(turning, *left_out)}
    if kind == "remedy" and reference == "classify":
        demand_document(of.masses == "all", "the engine of a remedy is taken from a document on all masses")
        cylinders = without(of.cylinders, "name", "crankshaft", "reciprocating_mass", "crank_radius")
        weighed = [{**entry, "weight": c.reciprocating_mass * c.crank_radius} for entry, c in zip(cylinders, of.cylinders)]
        return {"reference_plane": of.reference_plane, "cylinders": weighed, "turning_masses": without(of.turning_masses, "name", "axis")}
    demand_document(kind == reference, f"the engine is taken from a document of another kind, {reference}, which does not tell that of {kind}")
    return of


def same_numbers(own, due):
    """Without a scale a comparison says nothing of it, and loads say that there is none."""
    for key in ("scale", "units"):
        if key in own and (own[key] is not None or "newtons" not in own):
            found, right = ({inner: getattr(one, "text", one) for inner, one in (of[key] or {}).items()} for of in (own, due))
            demand(found == right, f"the engine is another one: {key} is {found}, and {right} is due")


def same(key, found, due):
    """Entry by entry, the same."""
    if not isinstance(due, list):
        return demand(found == due, f"the engine is another one: {key} is {found}, and {due} is due")
    for one, entry in each(key, found, due):
        other = [inner for inner in {**entry, **one} if entry.get(inner) != one.get(inner)]
        demand(not other, f"the engine is another one: {', '.join(other)}")
