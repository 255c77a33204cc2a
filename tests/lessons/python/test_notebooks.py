"""The notebooks of lessons/notebooks: without output where they are kept, and Jupyter runs them."""
import os
from pathlib import Path

import nbclient
import nbformat
import pytest

FOLDER = Path(__file__).parents[3] / "lessons/notebooks"

# What must come of each: the kind of an output, and a part of its text.
WANTED = {"the-ledger": [("text/plain", "refuted"), ("text/html", "argument"), ("text/latex", r"\text{refuted}"),
                         ("text/plain", "Fraction"), ("text/plain", "verdict='refuted'")],
          "a-threshold-map": [("text/plain", "(120, 120)"), ("image/png", "")],
          "a-class-in-pandas": [("text/html", "correct"), ("text/plain", "height-of-centre"), ("text/plain", "Fraction")]}


def test_there_are_no_other_notebooks():
    assert {file.stem for file in FOLDER.glob("*.ipynb")} == set(WANTED)


@pytest.mark.parametrize("name", WANTED)
def test_a_notebook_is_kept_without_output_and_runs(name, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", f"{os.environ['REDERIVE_PROGRAMS']}:{os.environ['PATH']}")
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1")
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", 4)
    nbformat.validate(notebook)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in cells)
    nbclient.NotebookClient(notebook, timeout=3000, resources={"metadata": {"path": tmp_path}}).execute()
    outputs = [output for cell in cells for output in cell.outputs]
    assert not [output for output in outputs if output.output_type in ("error", "stream")]
    for kind, text in WANTED[name]:
        assert any(text in output.data.get(kind, "-") for output in outputs)
