"""What the README of the module shows is what comes of it."""
import doctest
from pathlib import Path

import pytest


def test_the_example_in_the_readme_works():
    text = (Path(__file__).parents[3] / "lessons/python/README.md").read_text().partition("```python\n")[2].partition("```")[0]
    test = doctest.DocTestParser().get_doctest(text, {}, "README", None, None)
    assert len(test.examples) == 4
    doctest.DocTestRunner().run(test, out=lambda said: pytest.fail(said, pytrace=False))
