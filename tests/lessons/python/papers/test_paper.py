"""Paper: symbols, mechanics, the ledger of a folder, and solutions."""
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import rederive
from rederive import Paper, derived, step, taylor


def test_symbols_have_the_signs_of_their_ranges(folder):
    paper = Paper(folder.path)
    m, beta, gamma, n, theta, t, x = paper.symbols("m beta gamma n theta t x")
    assert m.is_positive and beta.is_nonnegative and not beta.is_positive and gamma.is_negative and n.is_integer
    assert theta.is_real and theta.is_positive is None and x.is_positive and t.is_real
    assert paper.symbols("m") is m and paper.symbols(["m", "x"]) == (m, x)
    assert theta.dot == paper.symbols("thetadot") and theta.ddot == theta.dot.dot == paper.symbols("thetaddot")
    assert sp.sqrt(m ** 2) == m and not hasattr(m, "dot")


def test_a_symbol_that_is_not_declared_is_named(folder):
    with pytest.raises(ValueError, match="'q' is not declared under .symbols. in .*paper.toml"):
        Paper(folder.path).symbols("m q")


def test_a_paper_is_found_from_its_file_and_from_the_current_folder(folder, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert Paper("rods").folder == Paper(Path("rods")).folder == folder.path
    with pytest.raises(ValueError, match="there is no paper.toml in"):
        Paper("other")
    script = tmp_path / "script.py"
    script.write_text("import rederive; print(rederive.Paper('rods'))")
    assert subprocess.run([sys.executable, script], capture_output=True, text=True, cwd="/").stdout == f"Paper('{folder.path}')\n"


def test_time_derivatives_and_lagrange(folder):
    paper = Paper(folder.path)
    m, L, g, theta, t = paper.symbols("m L g theta t")
    assert paper.d_dt(sp.sin(theta) * t) == sp.cos(theta) * theta.dot * t + sp.sin(theta)
    assert paper.d_dt(m * theta.dot ** 2) == 2 * m * theta.dot * theta.ddot
    assert paper.d_dt(sp.Symbol("theta") ** 2) == 2 * sp.Symbol("theta") * theta.dot  # any symbol of that name
    K, V, c, Q = m * L ** 2 * theta.dot ** 2 / 2, -m * g * L * sp.cos(theta), sp.Symbol("c"), sp.Symbol("Q")
    assert paper.lagrange(K - V, theta) == m * L ** 2 * theta.ddot + m * g * L * sp.sin(theta)
    assert paper.lagrange(K, theta, force=Q, dissipation=c * theta.dot ** 2 / 2) == m * L ** 2 * theta.ddot + c * theta.dot - Q
    moving = dynamicsymbols("theta")
    time = dynamicsymbols._t
    lagrangian = m * L ** 2 * moving.diff(time) ** 2 / 2 + m * g * L * sp.cos(moving)
    assert paper.lagrange(lagrangian, moving) == m * L ** 2 * moving.diff(time, 2) + m * g * L * sp.sin(moving)


def test_a_taylor_polynomial_is_of_a_total_degree():
    x, y = sp.symbols("x y")
    assert taylor(sp.sin(x) * sp.cos(y) + x * y ** 3, [x, y], 3) == x - x ** 3 / 6 - x * y ** 2 / 2
    assert taylor(sp.cos(x), x, 0) == 1


def test_the_ledger_of_a_folder_is_judged_and_derived_when_something_changed(folder):
    paper = Paper(folder.path)
    assert [(row.id, row.verdict) for row in paper.ledger()] == [("1", "proved"), ("2", "proved"), ("3", "refuted")]
    written = (folder.path / "derivations.json").stat().st_mtime_ns
    paper.ledger()
    assert (folder.path / "derivations.json").stat().st_mtime_ns == written
    folder.write("derive.py", (folder.path / "derive.py").read_text().replace("m*g*L/2", "m*g*L/3"))
    assert paper.ledger().row("2").verdict == "refuted"


def test_rows_are_expressions_in_the_symbols_of_the_paper(folder):
    paper = Paper(folder.path)
    omega_0, g, L = paper.symbols("omega_0 g L")
    row = paper.ledger().row("3")
    assert row.derived_expression == sp.Eq(omega_0, sp.sqrt(3 * g / (2 * L)))
    assert row.printed_expression.rhs ** 2 == 2 * g / (3 * L)
    assert row.witness[g] == row.witness["g"] and (row.derived_expression.rhs - row.printed_expression.rhs).subs(row.witness) != 0


def test_rows_of_the_session_are_judged_without_a_file(folder):
    paper = Paper(folder.path)
    J, m, L = paper.symbols("J m L")

    @paper.row("1")
    def inertia():
        return derived(J, m * L ** 2 / 3)

    @paper.row("2")
    def fails():
        return 1 / 0

    first, second, third = paper.ledger()
    assert first.verdict == "proved" and third.derived is None
    assert second.verdict == "error" and "test_paper.py" in second.reason and "ZeroDivisionError" in second.reason
    assert not (folder.path / "derivations.json").exists()


def test_the_ledger_and_the_errata_are_shown_in_jupyter(folder):
    ledger, errata = Paper(folder.path).ledger(), Paper(folder.path).errata()
    html = ledger._repr_html_()
    assert html.count("<tr>") == 4 and r"$\omega_0 = \sqrt" in html and "refuted" in html
    assert pandas.DataFrame(ledger).verdict.tolist() == ["proved", "proved", "refuted"]
    assert "Equation (3)" in errata and "Equation (2)" not in errata
    assert r" $\omega_0 = " in errata._repr_markdown_() and "`" not in errata._repr_markdown_()


def test_an_error_in_a_file_of_the_folder_is_said(folder):
    folder.add("\n1/0\n")
    with pytest.raises(ValueError, match="derive.py:[0-9]*: ZeroDivisionError"):
        Paper(folder.path).ledger()
    folder.write("equations.toml", "[[equation]]\nid = 1\n")
    folder.add("")
    with pytest.raises(ValueError, match="equations.toml:2"):
        Paper(folder.path).ledger()


def test_the_prover_knows_the_symbols_of_the_paper(folder):
    paper = Paper(folder.path)
    m, L = paper.symbols("m L")
    assert paper.prove("fabs(L)", "L").verdict == paper.prove(sp.log(m * L), sp.log(m) + sp.log(L)).verdict == "proved"
    assert rederive.prove("fabs(L)", "L").verdict == "refuted"
    assert set(paper.prove(m, 2 * m).witness) == {m}


def test_functions_of_the_folder_are_emitted(folder):
    folder.write("functions.toml", """[[function]]
name = "inertia"
row = "1"
arguments = ["m", "L"]
""")
    assert Paper(folder.path).emit("inertia")(3, 2) == pytest.approx(4, rel=1e-15)
    assert "double inertia" in str(Paper(folder.path).emit("inertia", target="c"))
    with pytest.raises(ValueError, match="inertai"):
        Paper(folder.path).emit("inertai")


def test_a_motion_is_that_of_its_closed_form(folder):
    paper = Paper(folder.path)
    theta, g, L, m = paper.symbols("theta g L m")
    small = 1e-6
    motion = paper.solve("2", {theta: small, theta.dot: 0, g: 9.81, L: 1.5}, 3, events={"hangs": theta}, samples=31)
    omega = np.sqrt(3 * 9.81 / 3)
    np.testing.assert_allclose(motion[theta], small * np.cos(omega * motion.t), atol=small * 1e-6)
    np.testing.assert_allclose(motion["thetadot"], -small * omega * np.sin(omega * motion.t), atol=small * 1e-5)
    np.testing.assert_allclose(motion.events["hangs"], np.array([1, 3, 5]) * np.pi / 2 / omega, rtol=1e-6)
    stopped = paper.solve("2", {theta: 1, "thetadot": 0, g: 9.81, L: 1.5}, 3, events={"hangs": "theta"}, stop="hangs")
    assert stopped.t[-1] == stopped.events["hangs"][0] < 1 and abs(stopped[theta][-1]) < 1e-7
    axes = motion.plot()
    assert [line.get_label() for line in axes.lines] == [r"$\theta$"]


def test_equations_are_solved_together_and_driven(folder):
    paper = Paper(folder.path)
    theta, m, t, n, x = paper.symbols("theta m t n x")

    @paper.row("1")
    def driven():
        return derived(theta.ddot + theta, m)

    motion = paper.solve("1", {theta: 0, theta.dot: 0, m: sp.sin(2 * t)}, 5)
    np.testing.assert_allclose(motion[theta], (2 * np.sin(motion.t) - np.sin(2 * motion.t)) / 3, atol=1e-8)
    with pytest.raises(ValueError, match="start has no value of m, thetadot"):
        paper.solve("1", {theta: 0}, 5)

    @paper.row("2")
    def energy():
        return derived(theta.dot ** 2, m)

    with pytest.raises(ValueError, match="2 equations must determine the highest rates, which are thetaddot"):
        paper.solve(["1", "2"], {theta: 0}, 5)
    with pytest.raises(ValueError, match="row 9 is not derived"):
        paper.solve("9", {}, 1)


def test_the_double_pendulum_keeps_its_energy(tmp_path):
    shipped = Path(__file__).parents[4] / "lessons/papers/double-pendulum"
    folder = Path(shutil.copytree(shipped, tmp_path / "double-pendulum"))
    paper = Paper(folder)
    names = paper.symbols("theta_1 theta_2 theta_1dot theta_2dot m_1 m_2 L_1 L_2 g")
    start = dict(zip(names, [2, 1, 0, 0, 1, 2, 1, sp.Rational(1, 2), 9.81]))
    equations, solved = (paper.solve(rows, start, 5) for rows in (["5", "6"], ["7", "8"]))
    np.testing.assert_allclose(equations["theta_1"], solved["theta_1"], atol=1e-6)
    ledger = paper.ledger()
    energy = ledger.row("3").derived_expression.rhs + ledger.row("4").derived_expression.rhs
    values = sp.lambdify(names[:4], energy.subs(dict(zip(names[4:], list(start.values())[4:]))))(*(solved[q] for q in names[:4]))
    np.testing.assert_allclose(values, values[0], atol=1e-5)


def test_a_paper_of_15_rows_starts_nothing_that_it_does_not_need(folder):
    rows = "".join(f"\n@paper.row('a{k}')\ndef a{k}(): return derived(theta, {k}*theta, step('words'))\n" for k in range(12))
    folder.add(rows + "\nimport sys\nprint(sorted({'scipy', 'pandas', 'matplotlib'} & set(sys.modules)))\n")
    ran = folder.derive()
    assert ran.stderr == "[]\n" and len(json.loads((folder.path / "derivations.json").read_text())["derivations"]) == 15


def test_the_paper_in_the_readme_is_judged_and_solved(folder):
    blocks = (Path(__file__).parents[4] / "lessons/python/README.md").read_text().split("```python\n")[2:]
    source, solved = (block.partition("```")[0] for block in blocks)
    folder.write("derive.py", source)
    assert [(row.id, row.verdict) for row in Paper(folder.path).ledger()] == [("1", "proved"), ("2", "proved"), ("3", "refuted")]
    names = {"__file__": str(folder.path / "derive.py")}
    exec(source + solved.replace("motion[theta],", "shown = motion[theta],"), names)
    assert len(names["shown"][0]) == 1001 and len(names["shown"][1]) == 3
