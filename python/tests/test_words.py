"""Do mistakes speak Python, and not of options of a command line?"""

from collections.abc import Callable
from typing import Any

import pytest

import crankstar
from crankstar import CrankstarError, Engine

MISTAKES: list[tuple[Callable[[], Any], str]] = [
    (lambda: Engine.named("V6-60-even").sweep(), "bank_angle"),
    (lambda: Engine.named("V6-60-even").sweep(), r'ranges=\{"KEY": "FROM..TO:STEP"\}'),
    (lambda: Engine.named("I4").sweep(bank_angle="0..90:10"), "^bank_angle is for layouts"),
    (lambda: Engine.named("I4").sweep(bank_angle="0..90:10"), r'ranges=\{"KEY": "0..90:10"\}'),
    (lambda: Engine.named("V6-60-even").sweep(bank_angle="0..90"), "bank_angle"),
    (lambda: Engine.named("V6-60-even").sweep(bank_angle=(1, 2)), "bank_angle"),  # type: ignore[arg-type]
    (lambda: Engine.named("V6-60-even").sweep(bank_angle="0..180:0.001"), "100000 are kept"),
    (lambda: Engine.named("V6-60-even").sweep(rod_ratio="x..y:z"), "rod_ratio"),
    (lambda: crankstar.search(20, "four-stroke", torsion=True, grid=3), "omit torsion"),
    (lambda: crankstar.search(6, "two-stroke", resume="pyproject.toml"), "pyproject.toml"),
    (lambda: Engine.named("I3").remedy(balance_factor="x"), "balance_factor"),
    (lambda: Engine.named("I3").remedy(skew="x"), "skew"),
    (lambda: Engine.named("I3").firing(mode_shape=["x"]), "mode_shape"),
    (lambda: Engine.named("I3").classify(masses="some"), "masses"),  # type: ignore[arg-type]
    (lambda: Engine.named("I3").bearings(), "bearings"),
    (lambda: Engine.named("I3").torque(), "gas"),
]


@pytest.mark.parametrize(("ask", "words"), MISTAKES)
def test_a_mistake_names_keywords_and_no_options(ask: Callable[[], Any], words: str, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pyproject.toml").write_text("[project]\n")
    with pytest.raises(CrankstarError, match=words) as raised:
        ask()
    for of_the_command_line in ("--", "command line", "flag", "`crankstar "):
        assert of_the_command_line not in str(raised.value)
