"""What does a notebook show, and are pages whole?"""

import pytest

import crankstar
from crankstar import Engine
from engines import v6


def test_an_engine_shows_its_star_and_its_verdicts():
    page = Engine.named("V8-crossplane")._repr_html_()
    assert page.count("<svg") == 2 and "<table>" in page
    assert '<strong class="zero">0</strong>' in page and "3.162, rotating" in page
    assert "<html" not in page and "<script" not in page


def test_a_title_is_no_markup():
    page = Engine("<b>x</b>", throws=[0])._repr_html_()
    assert "<b>" not in page


def test_an_engine_is_a_formula_too():
    formula = Engine.named("V8-crossplane")._repr_latex_()
    assert formula.startswith("$$\\begin{array}{rll}") and formula.endswith("\\end{array}$$")
    assert "1 & \\mathbf{0} & \\text{couple $\\sqrt{10}$ $\\approx$ 3.162, rotating}" in formula


@pytest.mark.parametrize(
    ("format", "begins"),
    [("markdown", "# "), ("html", "<!DOCTYPE html>"), ("latex", "\\documentclass"), ("typst", "#"), ("text", "V8")],
)
def test_reports_are_written_in_every_format(format, begins):
    engine = Engine.named("V8-crossplane")
    assert engine.report(format).startswith(begins)
    files = engine.report_files(format)
    assert files[0][1] == engine.report(format)


def test_pictures_stand_beside_markdown():
    files = dict(Engine.named("I4").report_files("markdown"))
    assert "report.md" in files
    pictures = [name for name in files if name.endswith(".svg")]
    assert pictures and all(files[name].startswith("<svg") for name in pictures)


def test_a_report_speaks_german():
    assert "Ordnung" in Engine.named("I4").report("markdown", language="de")
    with pytest.raises(crankstar.CrankstarError, match="en or de"):
        Engine.named("I4").report("markdown", language="fr")


def test_a_format_that_is_none_is_refused():
    with pytest.raises(crankstar.CrankstarError, match="markdown, latex"):
        Engine.named("I4").report("docx")  # type: ignore[arg-type]


def test_drawings_are_asked_for_by_name():
    assert Engine.named("I4").figure("star:2").startswith("<svg")
    assert Engine.named("I4").figure("star:3").startswith("<svg")
    with pytest.raises(crankstar.CrankstarError, match="end-view"):
        Engine.named("I4").figure("nothing")


def test_answers_show_themselves():
    answer = v6().loads()
    assert "<table>" in answer._repr_html_()
    assert str(answer) and "Largest force" in str(answer)
    assert answer.report("latex").startswith("\\documentclass")
