"""Is an engine of Python the engine of its layout file, whichever way it is written?"""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import crankstar
from crankstar import Engine, LayoutError

TEXT = 'title = "V6"\n[vee]\nbank_angle = 60\nthrows = [0, 240, 120]\n'


def documents_are_equal(one: Engine, other: Engine) -> bool:
    return one.classify(torque=True).json == other.classify(torque=True).json


def test_every_engine_of_the_catalogue_is_found_by_name():
    names = crankstar.catalogue()
    assert len(names) > 40
    for name in names:
        assert len(Engine.named(name.upper())) > 0


def test_text_file_and_keywords_are_one_engine(tmp_path):
    path = tmp_path / "v6.toml"
    path.write_text(TEXT, encoding="utf-8")
    text = Engine.parse(TEXT)
    assert documents_are_equal(text, Engine.read(path))
    assert documents_are_equal(text, Engine.read(str(path)))
    assert documents_are_equal(text, Engine("V6", vee={"bank_angle": 60, "throws": [0, 240, 120]}))
    assert (text.title, len(text), text.layout) == ("V6", 6, TEXT)


def test_lists_with_one_value_a_cylinder_are_cylinder_tables():
    listed = Engine("Twin", throws=[0, 0], banks=[-45, 45], positions=[0, 0], masses=[1, "5/4"], names=["L", "R"])
    tables = [
        {"name": "L", "throw": 0, "bank": -45, "position": 0, "reciprocating_mass": 1},
        {"name": "R", "throw": 0, "bank": 45, "position": 0, "reciprocating_mass": Fraction(5, 4)},
    ]
    assert documents_are_equal(listed, Engine("Twin", cylinder=tables))


def test_throws_alone_are_an_engine_in_line():
    four = Engine("Four", throws=[0, 180, 180, 0])
    assert documents_are_equal(four, Engine.parse('title = "Four"\n[inline]\nthrows = [0, 180, 180, 0]\n'))


@pytest.mark.parametrize(
    "third",
    [Fraction(1, 3), "1/3"],
)
def test_numbers_are_taken_exactly(third):
    turned = Engine("x", throws=[0, 120], banks=[third, third], positions=[1, 0])
    assert 'bank = "1/3"' in turned.layout
    # All of it turned by a third of a degree: the first star is there, exactly.
    terms = turned.classify([1]).of("force", 1).stars[0].terms
    assert terms[0] == (Fraction(0), Fraction(1))
    reverse = turned.classify([1]).of("force", 1).stars[1].terms
    assert reverse[0][0] % 1 == Fraction(2, 3) / 360


def test_numbers_of_numpy_and_decimals_are_what_they_show():
    arrays = Engine("x", throws=np.array([0.0, 180.0]), banks=np.zeros(2, dtype=np.int64), positions=np.array([0.5, 0]))
    plain = Engine("x", throws=[0, Decimal("180.0")], banks=[0, 0], positions=[0.5, np.float32(0)])
    assert documents_are_equal(arrays, plain)


def test_what_a_person_wrote_stays_a_text():
    title = 'a "quoted" \\ title\nwith\ttwo lines\x7f'
    assert Engine(title, throws=[0]).title == title


def test_a_mistake_has_its_place_and_the_words_of_the_command_line():
    with pytest.raises(LayoutError) as raised:
        Engine.parse(TEXT.replace("60", '"60x"'), name="v6.toml")
    error = raised.value
    assert isinstance(error, ValueError)
    assert (error.line, error.column, error.file) == (3, 14, "v6.toml")
    assert error.message == "cannot read the angle `60x`"
    assert str(error).splitlines()[:2] == [f"error: {error.message}", " --> v6.toml:3:14"]
    assert error.right in str(error)


def test_the_column_counts_characters():
    with pytest.raises(LayoutError) as raised:
        Engine.parse('title = "Äöü"\ninline = { throws = ["Ä", 0] }\n')
    assert (raised.value.line, raised.value.column) == (2, 22)


def test_a_mistake_about_the_whole_file_has_no_line():
    with pytest.raises(LayoutError) as raised:
        Engine.parse('title = "nothing"')
    assert (raised.value.line, raised.value.column) == (None, None)


def test_a_mistake_in_keywords_is_shown_in_the_layout_that_they_make():
    with pytest.raises(LayoutError) as raised:
        Engine("x", vee={"bank_angle": 60, "throw": [0]})
    assert "unknown key `throw`" in raised.value.message
    assert (raised.value.line, raised.value.column) == (5, 1)


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"throws": [0, 180], "banks": [0]}, "2 throws and 1 banks"),
        ({"throws": [0], "banks": [0]}, "positions"),
    ],
)
def test_lists_that_do_not_fit_are_refused(keys, words):
    with pytest.raises(crankstar.CrankstarError, match=words):
        Engine("x", **keys)


def test_what_is_no_value_of_a_layout_is_a_type_error():
    with pytest.raises(TypeError, match="object"):
        Engine("x", speed=object(), throws=[0])  # type: ignore[arg-type]


def test_a_file_that_is_not_there_is_an_os_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        Engine.read(tmp_path / "none.toml")


def test_a_file_that_is_no_text_is_refused(tmp_path):
    path = tmp_path / "bytes.toml"
    path.write_bytes(b"title = \"\xff\"")
    with pytest.raises(crankstar.CrankstarError, match="UTF-8"):
        Engine.read(path)


def test_a_layout_reads_what_lies_beside_it(tmp_path):
    rows = "\n".join(f"{angle},{1 + (angle == 0) * 50}" for angle in range(-360, 361, 5))
    (tmp_path / "indicator.csv").write_text("angle,pressure\n" + rows + "\n", encoding="utf-8")
    layout = """
title = "One"
cycle = "four-stroke"
speed = "3000 rpm"
[inline]
throws = [0]
[mechanism]
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "0.5 kg"
[gas]
bore = "80 mm"
table = "indicator.csv"
unit = "bar"
"""
    (tmp_path / "one.toml").write_text(layout, encoding="utf-8")
    assert "mean_N_m" in Engine.read(tmp_path / "one.toml").torque().document()["cycle"]
    with pytest.raises(LayoutError, match="indicator.csv"):
        Engine.parse(layout)


def test_open_angles_are_refused_with_what_would_be_right():
    with pytest.raises(crankstar.CrankstarError, match="phi"):
        Engine("x", vee={"bank_angle": "phi", "throws": [0]})
