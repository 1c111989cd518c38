"""Do answers come as columns that pandas and polars take, and do their numbers hold against an independent method?"""

import json
import math
from pathlib import Path

import numpy as np
import pandas
import polars
import pytest

import crankstar
from crankstar import Engine
from engines import v6


def rods() -> list[tuple[float, float]]:
    """Throw and bank of each cylinder of the V6 in radians, as its layout says."""
    pins = [0, 120, 240]
    return [(math.radians(pin), math.radians(-30)) for pin in pins] + [
        (math.radians(pin - 60), math.radians(30)) for pin in pins
    ]


def shaking_force(theta: np.ndarray) -> np.ndarray:
    """The force of the V6 in newtons at these crank angles, by the motion of each piston in time: no phasors, no orders."""
    r, l, mass, rotating, omega = 0.045, 0.150, 0.6, 0.5, 6000 * 2 * math.pi / 60
    total = np.zeros_like(theta, dtype=complex)
    step = 1e-4
    for throw, bank in rods():
        psi = theta + throw - bank

        def travel(angle):
            return r * np.cos(angle) + np.sqrt(l**2 - (r * np.sin(angle)) ** 2)

        acceleration = (travel(psi + step) - 2 * travel(psi) + travel(psi - step)) / step**2 * omega**2
        total += -mass * acceleration * np.exp(1j * bank)
        total += rotating * r * omega**2 * np.exp(1j * (theta + throw))
    return total


def test_the_largest_force_is_that_of_the_moving_pistons():
    largest = v6().loads().document()["largest"]["force"]["value"]
    # The sixth order and what is above it: newtons, of ten thousand of one piston.
    assert largest == pytest.approx(np.abs(shaking_force(np.radians(np.arange(0, 360, 0.05)))).max(), rel=1e-3)


def test_the_course_is_that_of_the_moving_pistons():
    loads = v6().loads(list(range(1, 41)))
    theta = loads.tables["theta"]
    assert isinstance(theta["theta_deg"], np.ndarray) and len(theta["theta_deg"]) == 360
    moved = shaking_force(np.radians(theta["theta_deg"]))
    assert np.abs(moved).max() > 10
    assert np.allclose(theta["force_y_N"], moved.real, atol=0.02)
    assert np.allclose(theta["force_x_N"], -moved.imag, atol=0.02)


def test_loads_by_order_are_arrays_with_units_in_their_names():
    loads = v6().loads()
    orders = loads.columns
    assert isinstance(orders["order"], np.ndarray) and orders["order"].dtype == np.int64
    assert isinstance(orders["force_zero_to_peak_N"], np.ndarray) and orders["force_zero_to_peak_N"].dtype == np.float64
    zero = np.asarray(orders["force_vanishes"], dtype=bool)
    assert zero[:3].all() and not zero.all()
    assert (orders["force_zero_to_peak_N"][zero] == 0.0).all() and (orders["force_zero_to_peak_N"][~zero] > 0.0).all()
    assert loads.about["orders"]["force_zero_to_peak_N"][0] == "N"
    assert len(pandas.DataFrame(orders)) == polars.DataFrame(orders).height == len(zero)
    assert crankstar.verify(loads.json).certificates > 0


def test_verdicts_are_columns_too():
    verdicts = Engine.named("V8-crossplane").classify()
    frame = pandas.DataFrame(verdicts.columns)
    assert frame["order"].tolist() == [1, 2, 4, 6]
    assert frame["moment_exact"].tolist() == ["√10", "0", "0", "0"]
    assert frame["moment_vanishes"].tolist() == [False, True, True, True]
    assert polars.DataFrame(verdicts.tables["sums"]).height == 8


def test_bearings_are_columns():
    bearings = v6().bearings()
    for name, columns in bearings.tables.items():
        assert len(pandas.DataFrame(columns)) == polars.DataFrame(columns).height > 0, name
        assert set(columns) == set(bearings.about[name])


def test_a_sweep_is_taken_by_pandas_and_polars():
    sweep = Engine.named("V6-60-shared").sweep(bank_angle="0..180:10")
    frame, other = pandas.DataFrame(sweep.columns), polars.DataFrame(sweep.columns)
    assert len(frame) == other.height == 19
    assert list(frame.columns) == other.columns
    assert frame["bank_angle"].tolist() == list(range(0, 181, 10))
    assert set(sweep.about["points"]) == set(frame.columns)


def test_a_zero_of_a_sweep_is_exactly_zero_and_said_to_be_proved():
    frame = pandas.DataFrame(Engine.named("V8-crossplane").sweep(bank_angle=(80, 100, 10), orders=[1]).columns)
    assert frame["moment_1_reverse_vanishes"].tolist() == [False, True, False]
    assert (frame["moment_1_reverse"] == 0.0).tolist() == [False, True, False]


def test_exact_zeros_are_a_table():
    sweep = Engine.named("V8-crossplane").sweep(bank_angle="0..179:1", orders=[1])
    zeros = pandas.DataFrame(sweep.tables["zeros"])
    found = zeros[(zeros["quantity"] == "moment") & (zeros["of"] == "reverse")]
    assert found["bank_angle_exact"].tolist() == ["90"]


def test_a_sweep_is_one_sum_of_phasors_for_each_angle():
    angles = np.arange(0, 180, 2.5)
    sweep = Engine.named("V8-crossplane").sweep(bank_angle="0..177.5:2.5", orders=[1, 2]).columns
    throws = np.radians([0, 90, 270, 180])
    half = np.radians(angles)[:, None] / 2
    arms = np.array([1.5, 0.5, -0.5, -1.5])
    for order in (1, 2):
        for sense in (1, -1):
            banks = [np.exp(1j * (sense * order * throws + (1 - sense * order) * side * half)) for side in (-1, 1)]
            name = "direct" if sense == 1 else "reverse"
            sums = np.abs((sum(banks) * arms).sum(axis=1)) / 2
            assert np.allclose(sums, sweep[f"moment_{order}_{name}"], atol=1e-9), (order, name)


def test_two_parameters_make_a_map():
    swept = Engine.named("V6-60-even").sweep({"vee.pin_split": "-60..0:30"}, bank_angle="50..70:10", orders=[1])
    assert len(swept.columns["bank_angle"]) == 9 and next(iter(swept.tables)) == "points"


def test_firing_stars_are_swept_too():
    columns = Engine.named("V6-60-even").sweep(bank_angle="50..70:10", orders=[1], firing_orders=[0.5, "3/2"]).columns
    assert [name for name in columns if name.startswith("firing_star") and name.endswith("_r")]


@pytest.mark.parametrize(
    ("ranges", "words"),
    [("0..180", "step"), ((0, 180), "from, to, step"), ("180..0:10", "leads away"), (7, "from, to, step")],
)
def test_a_range_that_is_none_is_refused(ranges, words):
    with pytest.raises(crankstar.CrankstarError, match=words):
        Engine.named("V6-60-even").sweep(bank_angle=ranges)


def test_a_search_finds_engines():
    found = crankstar.search(6, "two-stroke")
    frame, other = pandas.DataFrame(found.columns), polars.DataFrame(found.columns)
    assert len(frame) == other.height == len(found.document()["stars"])
    best = Engine.parse(frame["layout"][0])
    assert best.classify([1]).of("moment", 1).vanishes is True
    assert len(best) == 6


def test_a_search_that_makes_no_sense_is_refused():
    with pytest.raises(crankstar.CrankstarError):
        crankstar.search(97, "two-stroke")
    with pytest.raises(crankstar.CrankstarError, match="orders"):
        crankstar.search(6, "two-stroke", orders=[])
    with pytest.raises(crankstar.CrankstarError, match="torsion=True"):
        crankstar.search(6, "two-stroke", mode_shape=[1, 2])
    with pytest.raises(crankstar.CrankstarError, match="two-stroke or four-stroke"):
        crankstar.search(6, "six-stroke")  # type: ignore[arg-type]


def test_a_remedy_holds_and_its_layout_is_balanced():
    remedy = Engine.named("I3").remedy([1, 2])
    assert remedy.holds
    weights = pandas.DataFrame(remedy.columns)
    assert weights["mass_radius_exact"][0] == "√3/4"
    assert weights["mass_radius_m_r"][0] == pytest.approx(math.sqrt(3) / 4)
    assert math.isnan(weights["mass_radius_kg_m"][0])
    corrected = Engine.parse(remedy.layout)
    assert all(verdict.vanishes for verdict in corrected.classify([1]))
    assert crankstar.verify(remedy.json).certificates > 0


def test_weights_of_a_remedy_have_a_mass_at_the_radius_that_is_asked_for():
    engine = Engine.read(Path(__file__).parents[2] / "examples/four.toml")
    weights = engine.remedy([2], radius="100 mm").columns
    assert list(weights["mass_kg"]) == pytest.approx([product / 0.1 for product in weights["mass_radius_kg_m"]])
    with pytest.raises(crankstar.CrankstarError, match="with its unit"):
        engine.remedy([2], radius="100")


def test_counterweights_of_a_balance_factor_are_part_of_a_remedy():
    remedy = Engine.named("I3").remedy([1], balance_factor=[0.5, "1/2", 0.5], planes=(1, -1))
    assert remedy.holds and len(remedy.columns["order"]) >= 3
    with pytest.raises(crankstar.CrankstarError, match="0 or more"):
        Engine.named("I3").remedy(balance_factor=-1)
    with pytest.raises(crankstar.CrankstarError, match="give two"):
        Engine.named("I3").remedy(planes=[1])


def test_firing_stars_are_proved():
    firing = Engine.named("V8-crossplane").firing([0.5, 1, "3/2"])
    assert crankstar.verify(firing.json).orders == ["1/2", "1", "3/2"]


def test_documents_of_answers_are_json():
    engine = v6()
    for answer in (engine.loads(), engine.bearings(), engine.remedy([1, 2]), engine.firing()):
        assert json.loads(answer.json) == answer.document()


def test_what_the_layout_lacks_is_said():
    with pytest.raises(crankstar.CrankstarError, match="bearings"):
        Engine.named("I4").bearings()
    with pytest.raises(crankstar.CrankstarError, match="gas"):
        Engine.named("I4").torque()


def test_a_shaft_that_twists_has_its_frequencies_in_columns() -> None:
    six = Engine.read(Path(__file__).parents[2] / "reports/examples/i6-torsion/layout.toml")
    modes = six.torsion(["1/2", 3]).tables["modes"]
    assert list(modes["mode"][:2]) == [1, 2] and modes["frequency_Hz"][0] < modes["frequency_Hz"][1]
    assert set(six.torsion([3]).tables["critical"]["order"]) == {"3"}


def test_a_damped_shaft_has_its_resonances_and_its_heat_in_columns() -> None:
    six = Engine.read(Path(__file__).parents[2] / "reports/examples/marine-six-torsion/layout.toml")
    tables = six.torsion([6]).tables
    assert abs(tables["resonances"]["speed_rpm"][0] - 70.2163732) < 1e-6
    assert set(tables["torques"]["order"]) == {"6"} and all(torque > 0 for torque in tables["torques"]["torque_zero_to_peak_N_m"])


def test_a_cylinder_that_does_not_fire_changes_the_twist_and_an_unknown_one_is_refused() -> None:
    six = Engine.read(Path(__file__).parents[2] / "reports/examples/i6-damper/layout.toml")
    firing, misfire = (six.torsion(misfire=name).tables["torques"] for name in (None, "2"))
    assert firing["torque_zero_to_peak_N_m"][0] != misfire["torque_zero_to_peak_N_m"][0]
    with pytest.raises(crankstar.CrankstarError, match="no cylinder `7`"):
        six.torsion(misfire="7")


def test_masses_on_a_shaft_and_a_turning_moment_diagram_are_asked_of_a_text() -> None:
    examples = Path(__file__).parents[2] / "examples"
    masses = crankstar.rotor((examples / "shaft.toml").read_text()).tables["masses"]
    assert abs(masses["mass_kg"][0] - 352.972118655) < 1e-8
    diagram = (examples / "turning-moment.toml").read_text()
    values = crankstar.flywheel(diagram).tables["values"]
    assert values["energy_exact"][0] == "π·(244205/192)" and abs(values["inertia_kg_m2"][0] - 202.429338) < 1e-6
    with pytest.raises(crankstar.LayoutError, match="speeed"):
        crankstar.flywheel("speeed = 3\n" + diagram)


def test_values_of_engines_shafts_and_diagrams_are_one_table() -> None:
    examples = Path(__file__).parents[2] / "examples"
    files = [(examples / name).read_text() for name in ("shaft.toml", "turning-moment.toml")]
    names = ["rotor.masses.1.X.mass", "flywheel.values.inertia", "classify.orders.2.force_vanishes"]
    columns = crankstar.values([Engine.named("I6")], names, files=files).columns
    assert columns["engine"][1] == "Four masses and two planes"
    assert abs(columns["rotor_masses_1_X_mass_kg"][1] - 352.972118655) < 1e-8
    assert abs(columns["flywheel_values_inertia_kg_m2"][2] - 202.429338) < 1e-6
    assert columns["classify_orders_2_force_vanishes"][0] and "masses on a shaft" in columns["rotor_masses_1_X_mass_missing"][0]
    assert len(crankstar.values([], names[:1], files=files[:1]).columns["engine"]) == 1
    with pytest.raises(ValueError, match="neither masses"):
        crankstar.values([], names, files=["title = 'nothing'"])


def test_a_sweep_has_values_of_any_question_beside_its_points() -> None:
    six = Engine.read(Path(__file__).parents[2] / "reports/examples/marine-six/layout.toml")
    name = "loads.largest.moment"
    columns = six.sweep(speed="100..120:10", values=[name]).columns
    assert len(columns["loads_largest_moment_N_m"]) == 3
    assert abs(columns["loads_largest_moment_N_m"][2] / columns["loads_largest_moment_N_m"][0] - 1.44) < 1e-9
    with pytest.raises(ValueError, match="there are orders"):
        six.sweep(speed="100..120:10", values=["loads.weather.rain"])


def test_a_search_keeps_limits_in_newton_metres() -> None:
    six = Engine.read(Path(__file__).parents[2] / "reports/examples/marine-six/layout.toml")
    everything = crankstar.search(7, "two-stroke", sizes=six).columns
    moments = everything["moment_2_N_m"]
    most = sorted(moments)[0]
    kept = crankstar.search(7, "two-stroke", limits={2: f"{most * 1.001} N m"}, sizes=six).columns
    assert 0 < len(kept["moment_2_N_m"]) < len(moments)
    assert all(moment <= most * 1.001 for moment in kept["moment_2_N_m"])
    assert len(crankstar.search(6, "two-stroke", limits={1: 0}).columns["star"]) > 0
    with pytest.raises(ValueError, match="sizes"):
        crankstar.search(6, "two-stroke", limits={2: "30 kN m"})
    with pytest.raises(ValueError, match="limits: cannot read `2=much`"):
        crankstar.search(6, "two-stroke", limits={2: "much"})


def test_an_engine_on_its_mounts_has_modes_and_orders_in_columns() -> None:
    four = Engine.read(Path(__file__).parents[2] / "reports/examples/i4-mounts/layout.toml")
    tables = four.mounts([1, 2], speed=800).tables
    assert abs(tables["modes"]["frequency_Hz"][0] - 5.856231193) < 1e-9
    assert list(tables["orders"]["is_still"]) == [True, False]
    assert abs(tables["orders"]["centre_x_mm"][1] - 0.041134184) < 1e-9


def test_values_at_an_angle_are_those_of_a_slider_crank() -> None:
    single = Engine(
        "Single",
        throws=[0],
        speed=3000,
        mechanism={"stroke": "86 mm", "rod_length": "143 mm", "reciprocating_mass": "0.5 kg"},
    )
    answer = single.angle([0, 90])
    assert list(answer.tables["pistons"]["theta_deg"]) == [0, 90]
    assert abs(answer.tables["pistons"]["displacement_m"][1] - (0.043 + 0.143 - (0.143**2 - 0.043**2) ** 0.5)) < 1e-15
    assert len(single.angle(every=90).tables["torque"]["theta_deg"]) == 4
    with pytest.raises(crankstar.CrankstarError, match="no step"):
        single.angle(every=0)


def test_the_table_of_a_project_guide_has_a_row_an_engine() -> None:
    keys = {"crank_radius": "1 m", "rod_length": "2.05 m", "reciprocating_mass": "3000 kg"}
    engines = [
        Engine(order, cycle="two-stroke", speed=127, firing_order=order, inline={"spacing": "0.85 m"}, mechanism=keys)
        for order in ("1-4-3-2-5", "1-5-3-4-2-6")
    ]
    moments = crankstar.moments(engines).tables["moments"]
    assert list(moments["moment_1_v_vanishes"]) == [False, True]
    assert abs(moments["moment_2_v_kN_m"][0] - 1169.272630) < 1e-5
