"""Does the example notebook run from its first cell to its last?"""

from pathlib import Path

import nbformat
from nbclient import NotebookClient

EXAMPLE = Path(__file__).parent.parent / "example.ipynb"


def test_the_example_runs_and_shows_what_it_says():
    notebook = nbformat.read(EXAMPLE, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in cells), "outputs are not stored"
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    shown = [[output.get("data", {}) for output in cell.outputs] for cell in cells]
    first = shown[0][0]
    assert "<svg" in first["text/html"] and "\\sqrt{10}" in first["text/latex"]
    assert shown[1][0]["text/plain"] == "('√10', 3.1622776601683795, 'rotating', False)"
    assert "certificates hold" in shown[3][0]["text/plain"]
    assert "layout:4:14" in cells[-1].outputs[0]["text"]
