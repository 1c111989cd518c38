"""Do engines and answers travel to other processes, and are those that say the same equal?"""

import copy
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import crankstar
from crankstar import Engine, LayoutError

FOUR = {
    "speed": 6000,
    "cycle": "four-stroke",
    "bearings": [0.2, 0.1, 0.0, -0.1, -0.2],
    "mechanism": {"stroke": "86 mm", "rod_length": "143 mm", "reciprocating_mass": "0.5 kg"},
    "inline": {"throws": [0, 180, 180, 0], "spacing": "100 mm"},
}


def four() -> Engine:
    return Engine("Four", **FOUR)  # type: ignore[arg-type]


def marine() -> Engine:
    return Engine.read(Path(__file__).parents[2] / "reports/examples/marine-six/layout.toml")


MADE: list[Callable[[], Any]] = [
    four,
    lambda: Engine.named("V8-crossplane"),
    lambda: Engine.named("V8-crossplane").classify(torque=True),
    lambda: Engine.named("V8-crossplane").classify().of("moment", 1),
    lambda: Engine("T", throws=[0, 90], mechanism={"rod_ratio": 0.3}).classify([1, 2], torque=True)[0],
    lambda: four().loads(),
    lambda: four().bearings([1, 2, 4]),
    lambda: Engine.named("V8-crossplane").firing([0.5, 1, "3/2"]),
    lambda: Engine.named("I3").firing([1], mode_shape=[1, "1/2", 0.25]),
    lambda: Engine.named("V6-60-even").sweep(bank_angle="60..120:5"),
    lambda: Engine.named("V6-60-even").sweep({"vee.bank_angle": (60, 90, 10)}, orders=[1, 2], firing_orders=[0.5, 1]),
    lambda: crankstar.search(6, "two-stroke"),
    lambda: crankstar.search(6, "two-stroke", limits={2: "4000 kN m"}, sizes=marine()),
    lambda: marine().sweep(speed="100..120:10", values=["loads.largest.moment"]),
    lambda: crankstar.values([], ["rotor.left.force.vanishes"], files=["[[mass]]\nmass = 1\nradius = 1\nangle = 0\nposition = 0"]),
    lambda: crankstar.search(8, "four-stroke", bank_angle=90, minor_orders=[0.5], torsion=True),
    lambda: crankstar.rotor("[[mass]]\nmass = 1\nradius = 1\nangle = 0\nposition = 0"),
    lambda: crankstar.flywheel("points = [[0, 300], [180, 0], [360, 300]]"),
    lambda: Engine.named("I3").remedy(),
    lambda: Engine.named("I4").remedy([2], balance_factor=0.5, skew=10),
]


@pytest.mark.parametrize("make", MADE)
def test_what_travels_is_equal_to_what_was_made(make: Callable[[], Any]):
    one, other = make(), make()
    there = pickle.loads(pickle.dumps(one))
    for same in (other, there, copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(there))):
        assert same == one and not same != one and hash(same) == hash(one) and type(same) is type(one)
        assert len({same, one}) == 1
    assert one != "one" and one != 1
    assert repr(there) == repr(one) and str(there) == str(one)


def test_different_things_are_different():
    made = [make() for make in MADE]
    for at, one in enumerate(made):
        assert all(one != other for other in made[at + 1 :])
    force, moment = Engine.named("I4").classify([1])
    assert force != moment


def test_an_answer_of_a_pickle_has_columns_document_and_page():
    for answer in (four().loads(), Engine.named("V6-60-even").sweep(bank_angle="60..120:5"), crankstar.search(6, "two-stroke")):
        there = pickle.loads(pickle.dumps(answer))
        assert there.json == answer.json and there.about == answer.about and list(there.tables) == list(answer.tables)
        for name, columns in answer.tables.items():
            assert list(columns) == list(there.tables[name])
            for column, values in columns.items():
                np.testing.assert_array_equal(there.tables[name][column], values)
        assert there.report() == answer.report() and list(there.columns) == list(answer.columns)
        there.columns.clear()
        assert there.columns, "what a reader changes is a copy"


def test_an_engine_takes_the_files_beside_it_along(tmp_path):
    (tmp_path / "p.csv").write_text("angle,pressure\n" + "".join(f"{a},{20 - abs(a) / 40}\n" for a in range(-360, 361, 5)))
    (tmp_path / "one.toml").write_text(
        'cycle = "four-stroke"\nspeed = 3000\n[mechanism]\nstroke = "86 mm"\nrod_length = "143 mm"\n'
        'reciprocating_mass = "0.5 kg"\n[gas]\nbore = "86 mm"\ntable = "p.csv"\nunit = "bar"\n[inline]\nthrows = [0]\n'
    )
    engine = Engine.read(tmp_path / "one.toml")
    state = pickle.dumps(engine)
    torque = engine.torque().json
    (tmp_path / "p.csv").unlink()
    assert pickle.loads(state).torque().json == torque


def test_an_error_travels_with_its_place():
    with pytest.raises(LayoutError) as raised:
        Engine.parse('inline = { throws = ["x", 0] }\n')
    there = pickle.loads(pickle.dumps(raised.value))
    assert (str(there), there.line, there.column) == (str(raised.value), raised.value.line, raised.value.column)


def test_joblib_shares_engines_among_processes():
    joblib = pytest.importorskip("joblib")
    engines = [four(), Engine("Two", throws=[0, 180], mechanism={"rod_ratio": 0.3})]
    answers = joblib.Parallel(n_jobs=2)(joblib.delayed(Engine.loads)(engine) for engine in engines)
    assert answers == [engine.loads() for engine in engines]


def test_dask_knows_equal_engines_by_one_name():
    base = pytest.importorskip("dask.base")
    assert base.tokenize(four()) == base.tokenize(four()) != base.tokenize(Engine.named("I4"))
