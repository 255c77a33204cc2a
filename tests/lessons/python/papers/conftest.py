"""What the tests of papers in Python share: a paper in a folder, as a user writes it."""
import os
import subprocess
import sys

import pytest

from papers_rods import DERIVE, EQUATIONS, PAPER


class Folder:
    """A paper in a folder; its files are text to change."""

    def __init__(self, path):
        self.path = path
        path.mkdir()
        self.write("paper.toml", PAPER)
        self.write("derive.py", DERIVE)
        self.write("equations.toml", EQUATIONS)

    def write(self, name, text):
        (self.path / name).write_text(text)

    def add(self, text):
        self.write("derive.py", DERIVE + text)

    def derive(self, cwd=None, **environment):
        return subprocess.run([sys.executable, "-m", "rederive.derive", self.path], capture_output=True, text=True, cwd=cwd,
                              env=os.environ | environment)


@pytest.fixture
def folder(tmp_path):
    return Folder(tmp_path / "rods")
