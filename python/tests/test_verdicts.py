"""Are the verdicts those of the program, exact, and provable?"""

import json
import math
from functools import cache

import numpy as np
import pytest

import crankstar
from crankstar import Engine

NAMES = crankstar.catalogue()


@cache
def verdicts_on(name: str) -> crankstar.Verdicts:
    """With the torque, which is not to be had of links on a master rod."""
    engine = Engine.named(name)
    return engine.classify(torque="[articulated]" not in engine.layout)


@pytest.mark.parametrize("name", NAMES)
def test_a_proved_zero_is_exactly_zero_and_nothing_else_is(name):
    for verdict in verdicts_on(name):
        if verdict.vanishes:
            assert verdict.value == 0.0 and verdict.exact == "0"
        elif verdict.vanishes is False and not verdict.parts:
            assert verdict.value is not None and verdict.value > 0.0
        for star in verdict.stars:
            assert star.vanishes == (star.value == 0.0) == (star.angle_deg is None)


@pytest.mark.parametrize("name", NAMES)
def test_every_star_is_the_sum_of_its_terms(name):
    for verdict in verdicts_on(name):
        for star in verdict.stars:
            terms = [(2 * math.pi * float(angle), float(weight)) for angle, weight in star.terms]
            x = math.fsum(weight * math.cos(angle) for angle, weight in terms)
            y = math.fsum(weight * math.sin(angle) for angle, weight in terms)
            assert math.hypot(x, y) == pytest.approx(star.value, abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_every_certificate_of_the_catalogue_holds(name):
    verdicts = verdicts_on(name)
    checked = crankstar.verify(verdicts.json)
    assert checked.certificates >= len(verdicts.document()["verdicts"]) > 0


def test_closed_forms_are_exact_texts():
    verdicts = Engine.named("V8-crossplane").classify()
    moment = verdicts.of("moment", 1)
    assert (moment.exact, moment.shape, moment.is_couple, moment.vanishes) == ("√10", "rotating", True, False)
    assert moment.value == pytest.approx(math.sqrt(10), rel=1e-15)
    assert moment.text == "couple √10 ≈ 3.162, rotating"
    force = verdicts.of("force", 4)
    assert (force.exact, force.shape, force.is_couple) == ("4√2", "planar", None)


def test_verdicts_are_a_sequence():
    verdicts = Engine.named("I4").classify([2, 1, 2])
    assert [(verdict.order, verdict.quantity) for verdict in verdicts] == [
        (1, "force"),
        (1, "moment"),
        (2, "force"),
        (2, "moment"),
    ]
    assert len(verdicts) == 4 and verdicts[-1].order == 2
    with pytest.raises(IndexError):
        verdicts[4]
    with pytest.raises(KeyError):
        verdicts.of("force", 4)


def test_masses_are_chosen_by_name():
    weighted = Engine(
        "x",
        throws=[0, 180, 180, 0],
        mechanism={"stroke": "80 mm", "rod_length": "140 mm", "reciprocating_mass": "0.5 kg"},
        counterweight=[{"throw": 1, "mass": "1 kg", "radius": "40 mm"}],
    )
    assert weighted.classify([1]).of("force", 1).vanishes is False
    assert weighted.classify([1], masses="reciprocating").of("force", 1).vanishes is True
    assert weighted.classify([1]).pistons is not None
    with pytest.raises(crankstar.CrankstarError, match="pistons"):
        weighted.classify(masses="pistons")  # type: ignore[arg-type]


def test_orders_that_are_none_are_refused():
    for orders in ([0], [1001], [-1], [1.5], ["x"]):
        with pytest.raises(crankstar.CrankstarError, match="1 to 1000"):
            Engine.named("I4").classify(orders)  # type: ignore[arg-type]


def test_orders_are_a_number_a_list_a_range_or_an_array():
    engine = Engine.named("I4")
    assert [verdict.order for verdict in engine.classify(2)] == [2, 2]
    wanted = engine.classify([1, 2, 3]).json
    assert engine.classify(range(1, 4)).json == engine.classify(np.array([3, 2, 1])).json == wanted


def test_different_rods_make_parts():
    mixed = Engine(
        "x",
        throws=[0, 90],
        mechanism={"stroke": "80 mm", "rod_ratio": ["0.25", "0.3"], "reciprocating_mass": "0.5 kg"},
    )
    second = mixed.classify([2]).of("force", 2)
    assert len(second.parts) == 2 and second.value is None and second.vanishes is False
    assert [part.of for part in second.parts] == ["cylinder 1", "cylinder 2"]


def test_every_order_can_be_proved():
    document = Engine.named("I6").classify(all_orders=True).document()
    assert document["theorems"]
    assert crankstar.verify(document).theorems == len(document["theorems"])


def test_a_document_that_was_changed_is_refused_with_its_place():
    document = Engine.named("I4").classify().document()
    document["verdicts"][0]["certificate"]["polygons"][0]["rotation"] = "1/7"
    with pytest.raises(crankstar.ProofError) as raised:
        crankstar.verify(document)
    assert isinstance(raised.value, ValueError)
    assert raised.value.place is not None and "verdicts[0]" in raised.value.place
    assert raised.value.place in str(raised.value)


@pytest.mark.parametrize("nonsense", ["", "{}", b"\xff", {"format": "something else"}])
def test_what_is_no_document_is_refused(nonsense):
    with pytest.raises(crankstar.ProofError) as raised:
        crankstar.verify(nonsense)
    assert raised.value.place is None


def test_a_document_is_a_text_bytes_or_a_dict():
    verdicts = Engine.named("I3").classify()
    counts = {crankstar.verify(form).certificates for form in (verdicts.json, verdicts.json.encode(), verdicts.document())}
    assert len(counts) == 1
    assert json.loads(verdicts.json) == verdicts.document()
