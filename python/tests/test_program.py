"""Are the answers those of the command line, letter by letter? Asked where CRANKSTAR_PROGRAM names the program."""

import csv
import io
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import crankstar
from crankstar import Engine
from engines import v6

PROGRAM = os.environ.get("CRANKSTAR_PROGRAM", "")
pytestmark = pytest.mark.skipif(not PROGRAM, reason="CRANKSTAR_PROGRAM names no program")


def said(*arguments: str) -> str:
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True, encoding="utf-8").stdout


def table(text: str) -> dict[str, list[str]]:
    header, *rows = csv.reader(io.StringIO(text))
    return {name: [row[place] for row in rows] for place, name in enumerate(header)}


def assert_equal(columns: dict, written: dict[str, list[str]]) -> None:
    assert list(columns) == list(written)
    for name, texts in written.items():
        values = columns[name]
        if isinstance(values, np.ndarray) and values.dtype == np.bool_:
            assert [str(bool(value)).lower() for value in values] == texts, name
        elif isinstance(values, np.ndarray):
            numbers = np.array([float(text) if text else float("nan") for text in texts])
            assert np.array_equal(values, numbers, equal_nan=True), name
        else:
            shown = ["" if value is None else str(value).lower() if isinstance(value, bool) else str(value) for value in values]
            assert shown == texts, name


@pytest.mark.parametrize("name", ["V8-crossplane", "I5-12453", "radial-9", "V6-60-shared"])
def test_documents_are_equal(name):
    engine = Engine.named(name)
    assert engine.classify().json == said("classify", name, "--json")
    assert engine.remedy([1, 2]).json == said("remedy", name, "--orders", "1,2", "--json")


def test_pages_are_equal(tmp_path):
    said("report", "I4", "--math", "dollars", "--output", str(tmp_path))
    for name, text in Engine.named("I4").report_files("markdown"):
        assert (tmp_path / name).read_text(encoding="utf-8") == text, name


def test_columns_of_sweeps_and_searches_are_those_of_the_files():
    swept = Engine.named("V6-60-shared").sweep(bank_angle="0..180:10")
    assert_equal(swept.columns, table(said("sweep", "V6-60-shared", "--bank-angle", "0..180:10", "--format", "csv")))
    found = crankstar.search(6, "two-stroke")
    written = said("search", "--cylinders", "6", "--cycle", "two-stroke", "--format", "csv")
    assert_equal(found.columns, table(written))


def test_columns_of_loads_are_those_of_the_files(tmp_path: Path):
    path = tmp_path / "v6.toml"
    path.write_text(v6().layout, encoding="utf-8")
    assert_equal(Engine.read(path).loads().columns, table(said("loads", str(path), "--format", "csv")))
    assert_equal(Engine.read(path).bearings().columns, table(said("bearings", str(path), "--format", "csv")))
    assert_equal(Engine.read(path).classify().columns, table(said("classify", str(path), "--format", "csv")))


def test_mistakes_are_told_in_the_same_words(tmp_path: Path):
    path = tmp_path / "wrong.toml"
    path.write_text('title = "x"\n[vee]\nbank_angle = 60\nthrow = [0]\n', encoding="utf-8")
    with pytest.raises(crankstar.LayoutError) as raised:
        Engine.read(path)
    told = subprocess.run([PROGRAM, "classify", str(path)], capture_output=True, text=True, encoding="utf-8")
    assert told.returncode == 1 and told.stderr.strip() == str(raised.value)
