"""What the tests of the Python module share: the commands, to hold it against."""
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import rederive

PROGRAMS = Path(os.environ["REDERIVE_PROGRAMS"])


@pytest.fixture
def command():
    """Runs one of our programs: its standard output, or its complaint after "program: "."""

    def run(program, *arguments, fails=False):
        done = subprocess.run([PROGRAMS / program, *arguments], capture_output=True, text=True)
        if fails:
            assert done.returncode == 2
            return done.stderr.partition(": ")[2].rstrip("\n")
        assert done.returncode in (0, 1, 3), done.stderr
        return done.stdout

    return run


@pytest.fixture
def answer(command):
    """The JSON of a command."""
    return lambda *arguments: json.loads(command(*arguments))


@pytest.fixture
def script():
    """Starts another Python with this text; none outlives its test."""
    started = []

    def start(text, **options):
        started.append(subprocess.Popen([sys.executable, "-c", text], text=True, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, **options))
        return started[-1]

    yield start
    for process in started:
        process.kill()
        process.communicate()


@pytest.fixture(scope="session")
def rows():
    """The ledger, judged once for all tests."""
    return rederive.ledger()
