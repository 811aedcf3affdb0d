# SPDX-License-Identifier: MIT
"""The notebooks of docs/notebooks do what they say, in the folder of the source."""
import json

import pytest

from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


def test_there_are_notebooks():
    assert len(NOTEBOOKS) == 4


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path, monkeypatch):
    monkeypatch.chdir(ROOT)
    names = {"__name__": "__main__"}
    cells = json.loads(path.read_text())["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    assert "assert" in "".join(code)
    for cell in code:
        exec(compile(cell, str(path), "exec"), names)
