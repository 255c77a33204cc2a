"""python3 -m rederive.derive: from derive.py to derivations.json."""
import json
import os
import subprocess
import sys

import pytest

from rederive import _proofs
from rederive.derive import derive

from papers_rods import DERIVE, PAPER


def derivations(folder):
    return json.loads((folder.path / "derivations.json").read_text())["derivations"]


def test_a_paper_becomes_derivations(folder):
    ran = folder.derive()
    assert (ran.stderr, ran.stdout, ran.returncode) == ("", "", 0)
    document = json.loads((folder.path / "derivations.json").read_text())
    assert document["format"] == 1 and _proofs.has_current_derivations(folder.path)
    assert document["derivations"]["2"] == {
        "left": "thetaddot*J + L*g*m*sin(theta)/2", "relation": "=", "right": "0",
        "steps": [{"says": "Lagrange's equation"}, {"says": "with #", "cites": "1"}], "given": [["J", "L^2*m/3"]],
        "assumption": "", "order": 0, "small": "", "stated": False}
    assert document["derivations"]["3"]["steps"] == [
        {"says": "For small angles", "left": "thetaddot", "relation": "=", "right": "-3*theta*g/(2*L)"}]


def test_the_bytes_are_the_same_and_nothing_else_is_left(folder, tmp_path):
    seen = set()
    for seed in ("1", "2", "random"):
        assert folder.derive(PYTHONHASHSEED=seed, PYTHONDONTWRITEBYTECODE="", cwd=tmp_path).returncode == 0
        seen.add((folder.path / "derivations.json").read_bytes())
    assert len(seen) == 1
    assert {file.name for file in folder.path.iterdir()} == {"derivations.json", "derive.py", "equations.toml", "paper.toml"}


def test_what_is_asked_for_reaches_the_file(folder):
    folder.add("""
@paper.row("4")
def four():
    return derived(theta, sp.sin(theta), order=2, small=theta, assuming="theta > 0: small angles")
@paper.row("5")
def five():
    return derived(sp.Lt(theta, 1), step("words"), assuming=theta < sp.Rational(1, 2))
import functools
@paper.row("6")
@functools.cache
def six():
    return derived(theta.dot, 0, *motion().steps, relation="<=")
""")
    assert folder.derive().stderr == ""
    found = derivations(folder)
    four, five, six = (found[row] for row in "456")
    assert (four["order"], four["small"], four["assumption"], four["stated"]) == (2, "theta", "theta > 0: small angles", True)
    assert (five["left"], five["relation"], five["right"], five["assumption"]) == ("theta", "<", "1", "theta < 1/2")
    assert (six["left"], six["relation"], six["steps"]) == ("thetadot", "<=", found["2"]["steps"])


FAILURES = [
    ("return derived(theta, 1/0)", "HERE: ZeroDivisionError: division by zero"),
    ("return motion(1)", "HERE: TypeError: motion() takes 0 positional arguments but 1 was given"),
    ("return derived(theta, 0.5)", "HERE: ValueError: the float 0.5 cannot be written in the syntax of papers: it is not exact; "
     "write a fraction, such as Rational('1/2')"),
    ("return derived(theta, sp.Float('0.25')*x)", "DEF: ValueError: the float 0.250000000000000 cannot be written"),
    ("return derived(theta, sp.Symbol('q'))", "DEF: ValueError: the symbol 'q' is not declared: declare it under [symbols] in "
     "paper.toml"),
    ("return derived(theta.ddot.dot, 0)", "DEF: ValueError: the symbol 'thetadddot' is not declared"),
    ("return derived(theta, sp.sign(x - 1))", "DEF: ValueError: sign, in sign(x - 1), cannot be written in the syntax of papers: "
     "write x/Abs(x)"),
    ("return 3", "DEF: TypeError: failing() returned int; it must return derived(left, right, steps)"),
    ("return derived(theta, 1, 'words')", "HERE: TypeError: a str is not a step"),
    ("return derived(theta)", "HERE: TypeError: a formula needs two sides"),
    ("return derived(theta, 1, order=2)", "HERE: ValueError: order and small belong together"),
    ("return derived(paper.lagrange(m, m), 0)", "HERE: ValueError: m does not change in time: declare it with rates = 2"),
    ("return derived(theta, 1, small='theta')", "HERE: ValueError: order and small belong together"),
    ("import sys; sys.exit(0)", "HERE: SystemExit: 0"), ("return failing.__wrapped__()", "RecursionError")]


def test_a_derivation_that_fails_is_an_error_of_its_row_alone(folder):
    """Each in its turn: DEF stands for the line of the decorator, HERE for that of the body."""
    folder.add("".join(f'\n@paper.row("f{k}")\ndef failing():\n    {body}\n' for k, (body, _) in enumerate(FAILURES)))
    ran, found = folder.derive(), derivations(folder)
    decorator = len(DERIVE.splitlines()) + 2
    for k, (_, error) in enumerate(FAILURES):
        places = {"DEF": f"derive.py:{decorator + 4 * k}", "HERE": f"derive.py:{decorator + 4 * k + 2}"}
        place, colon, rest = error.partition(": ")
        assert places.get(place, place) + colon + rest in found[f"f{k}"]["error"]
    assert ran.returncode == 0
    assert ran.stderr == "".join(f"rederive.derive: row f{k}: {found[f'f{k}']['error']}\n" for k in range(len(FAILURES)))
    assert all("error" not in found[row] for row in "123")


@pytest.mark.parametrize("added, error", [
    ("1/0", "ZeroDivisionError: division by zero"), ("x = (", "SyntaxError: '(' was never closed"),
    ("import nothing_of_this_name", "ModuleNotFoundError"), ("exit(0)", "SystemExit: 0"), ("raise ValueError", "ValueError"),
    ("paper.symbols('q')", "ValueError: the symbol 'q' is not declared under [symbols]"),
    ("paper.row('1')", "ValueError: two functions derive row 1"), ("paper.row(motion)", "TypeError: the id of the row is missing")])
def test_a_file_that_cannot_be_run_is_refused_with_its_line(folder, added, error):
    folder.add("\n" + added)
    with pytest.raises(ValueError) as raised:
        derive(folder.path)
    assert str(raised.value).startswith(f"{folder.path}/derive.py:{len(DERIVE.splitlines()) + 2}: {error}")
    assert not (folder.path / "derivations.json").exists()


def test_a_file_without_a_paper_is_refused(folder):
    folder.add("\npaper = None\n")
    ran = folder.derive()
    assert ran.returncode == 2
    assert ran.stderr == f"rederive.derive: {folder.path}/derive.py: it must make one paper, paper = Paper(), and makes 0\n"


@pytest.mark.parametrize("line, error", [
    ("a = ", "Invalid value"), ("a = 3", "a must be a table"), ("a = { rates = 3 }", "a must be a table such"),
    ("a = { range = '0, 1' }", "the range of a must be written \"(lower, upper)\""),
    ("a = { range = '(2x, 3)' }", "the range of a: '2x' cannot be read")])
def test_symbols_that_cannot_be_read_are_refused_with_their_line(folder, line, error):
    folder.write("paper.toml", PAPER + line + "\n")
    with pytest.raises(ValueError) as raised:
        derive(folder.path)
    assert str(raised.value).startswith(f"{folder.path}/paper.toml:{len(PAPER.splitlines()) + 1}: {error}")


@pytest.mark.parametrize("name", ["paper.toml", "derive.py"])
def test_a_missing_file_is_named(folder, name):
    (folder.path / name).unlink()
    with pytest.raises(ValueError, match=f"{folder.path}/{name}: there is no such file"):
        derive(folder.path)


def test_what_the_file_prints_does_not_reach_standard_output(folder):
    folder.add("\nprint('hello')\n")
    ran = folder.derive()
    assert (ran.stdout, ran.stderr) == ("", "hello\n")


def test_help_and_usage():
    def run(*arguments):
        ran = subprocess.run([sys.executable, "-m", "rederive.derive", *arguments], capture_output=True, text=True)
        return ran.returncode, ran.stdout + ran.stderr

    code, said = run("--help")
    assert code == 0 and "@paper.row" in said
    code, said = run()
    assert code == 2 and "DIR" in said


def test_a_folder_that_cannot_be_written_is_named(folder):
    (folder.path / "derivations.json").mkdir()
    with pytest.raises(ValueError, match="derivations.json"):
        derive(folder.path)


def test_without_sympy_the_program_says_what_to_install(folder, tmp_path):
    (tmp_path / "hidden").mkdir()
    (tmp_path / "hidden/sympy.py").write_text("raise ImportError('hidden')")
    ran = folder.derive(PYTHONPATH=f"{tmp_path}/hidden{os.pathsep}{os.environ['PYTHONPATH']}")
    assert ran.returncode == 2 and "apt-get install python3-sympy" in ran.stderr
