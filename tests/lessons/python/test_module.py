"""What Python programmers expect of a module: types, docstrings, threads, Ctrl-C, notebooks."""
import ast
import copy
import doctest
import io
import os
import pickle
import re
import signal
import sys
import threading
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import pandas
import pytest
from tqdm import tqdm

import rederive
from rederive import Block, Pulse
from rederive import _numbers, _proofs

FOLDER = Path(rederive.__file__).parent


@pytest.mark.parametrize("name", ["", *rederive.__all__])
def test_the_examples_in_the_docstrings_work(name):
    thing = getattr(rederive, name) if name else rederive
    text = thing.__doc__
    assert text
    run = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    test = doctest.DocTestParser().get_doctest(text, vars(rederive).copy(), name, None, None)
    run.run(test, out=lambda said: pytest.fail(said, pytrace=False))
    if name in ("", "prove", "ledger", "emit", "threshold", "windows", "response", "spectrum", "map", "Block", "Pulse"):
        assert test.examples


def defined(tree):
    """The names in a file of stubs, those of a class with dots."""
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name, node
        if isinstance(node, ast.ClassDef):
            yield from ((f"{node.name}.{name}", inner) for name, inner in defined(node))
        if isinstance(node, ast.AnnAssign):
            yield node.target.id, node


@pytest.mark.parametrize("module", [_numbers, _proofs])
def test_the_stubs_say_what_the_module_has(module):
    stubs = dict(defined(ast.parse((FOLDER / f"{module.__name__.rpartition('.')[2]}.pyi").read_text())))
    there = {name for name in vars(module) if not name.startswith("__")}
    for name in list(there):
        if isinstance(getattr(module, name), type):
            there |= {f"{name}.{member}" for member in vars(getattr(module, name))
                      if not member.startswith("_") or member == "__init__" and name != "Response"}
    assert set(stubs) == there
    for name, node in stubs.items():
        thing = module
        for part in name.split("."):
            thing = getattr(thing, part)
        if isinstance(node, ast.FunctionDef) and callable(thing):
            arguments = [a.arg for a in node.args.args + node.args.kwonlyargs]
            signature = thing.__doc__.splitlines()[0]
            assert re.findall(r"[(, ](\w+): ", signature) == arguments
            defaults = [ast.literal_eval(d) for d in node.args.defaults + node.args.kw_defaults if d is not None]
            assert [d for d in re.findall(r" = ('\w*'|[\w.]+)[,)]", signature) if d != "Ellipsis"] == [
                repr(d) for d in defaults if d is not ...]


def test_every_public_name_is_typed_and_listed():
    assert (FOLDER / "py.typed").exists()
    papers = {name for module in ("_expressions", "_paper", "_steps") for name in rederive._MODULES[module]}
    others = {name for names in rederive._MODULES.values() for name in names} - papers
    assert set(rederive.__all__) == others | {"Threshold"} and all(hasattr(rederive, name) for name in rederive.__all__)
    assert re.fullmatch(r"\d+\.\d+\.\d+", rederive.__version__)


@pytest.mark.parametrize("value, other", [(Block(0.3, 2), Block(0.3, 2, 0.9)), (Pulse(3), Pulse(3, "cosine"))])
def test_values_compare_hash_copy_and_pickle_and_do_not_change(value, other):
    again = pickle.loads(pickle.dumps(value))
    assert again == value == copy.deepcopy(value) and hash(again) == hash(value)
    assert value != other and value != 3
    assert eval(repr(value)) == value
    for name in ("alpha", "omega", "anything"):
        with pytest.raises(AttributeError):
            setattr(value, name, 1)


def test_a_block_from_its_size():
    block = Block.from_size(0.3, 1.0)
    assert block.alpha == np.arctan2(0.3, 1)
    assert block.p == pytest.approx(np.sqrt(0.75 * 9.81 / np.hypot(0.3, 1)), rel=1e-15)


@pytest.mark.parametrize("call, words", [
    (lambda: Pulse(float("nan")), "omega nan is not a finite number"),
    (lambda: Pulse(3, "square"), "pulse 'square' must be sine or cosine"),
    (lambda: rederive.threshold(Pulse(3), model="cubic"), "model 'cubic' must be linear or nonlinear"),
    (lambda: rederive.map([1, np.inf], [1]), "omegas inf is not a finite number"),
    (lambda: rederive.map([[1]], [1]), "omegas must be a list or an array of one dimension; this one has 2"),
    (lambda: rederive.map([1], [-1]), "amplitudes -1 must lie between 0 and 1000000"),
    (lambda: rederive.map([1], [1], threads=0), "threads 0 must lie between 1 and 1024"),
    (lambda: rederive.map(np.ones(10_000), np.ones(10_000)), "more than 50 million points"),
    (lambda: rederive.map([1], [0.5], theta0=0.01), "amplitude = 0.5: no instant at which rocking can start, below 1"),
    (lambda: rederive.response(Pulse(3), 2, samples=1), "samples 1 must lie between 2 and"),
    (lambda: rederive.spectrum([1e-9]), "omegas 1e-09 must lie between 0.01 and 1000")])
def test_a_value_that_cannot_be_used_is_named(call, words):
    with pytest.raises(ValueError) as raised:
        call()
    assert words in str(raised.value)


@pytest.mark.parametrize("call", [lambda: rederive.threshold(3), lambda: rederive.map("a", [1]), lambda: Block("a")])
def test_a_value_of_another_type_is_refused(call):
    with pytest.raises((TypeError, ValueError)):
        call()


def test_empty_axes_make_empty_maps():
    assert rederive.map([], [1, 2]).shape == (0, 2)
    assert rederive.map([1, 2, 3], []).shape == (3, 0)
    assert rederive.spectrum([]).shape == (0,)


def test_a_witness_is_exact():
    proof = rederive.prove("sin(2*x)", "2*sin(x)")
    assert proof.verdict == "refuted" and dict(proof.witness) == {"x": Fraction(1)}
    assert proof.witness.printed.startswith("0.9092974268256816953960198659")


def test_the_ledger_becomes_a_table_in_one_line(rows):
    table = pandas.DataFrame(rows)
    assert {"id", "section", "printed", "derived", "verdict", "witness"} <= set(table.columns)
    assert table.verdict.value_counts()["refuted"] > 5
    assert pandas.DataFrame(rederive.windows(Pulse(3))).columns.tolist() == ["from", "to", "code"]


def test_a_row_shows_its_formulas_in_a_notebook(rows):
    row = next(row for row in rows if row.id == "71")
    text = row._repr_latex_()
    assert text.startswith("$$") and text.endswith("$$") and text.count("{") == text.count("}")
    assert row.printed_latex in text and row.derived_latex in text and r"\cosh" not in row.id
    assert r"\sin" in row.printed_latex and "*" not in row.printed_latex


def test_emitted_functions_are_called_by_name():
    emitted = rederive.emit("python", "restitution", "ground_that_starts")
    assert emitted["restitution"](alpha=0.25) == Block().restitution
    assert emitted["ground_that_starts"](0.25) == pytest.approx(np.tan(0.25), rel=1e-15)
    with pytest.raises(TypeError, match="only a single function"):
        emitted(0.25)
    with pytest.raises(TypeError, match="cannot be called"):
        rederive.emit("c", "restitution")(0.25)


def map_in_lanes(**named):
    return rederive.map(np.linspace(1, 5, 60), np.linspace(1, 8, 60), model="nonlinear", **named)


def judge_again():
    rederive._ledger._judged.cache_clear()
    rederive.ledger()


@pytest.mark.parametrize("work", [map_in_lanes, judge_again, lambda: rederive.threshold(Pulse(3), model="nonlinear"),
                                  lambda: rederive.prove("sin(3*x)", "3*sin(x) - 4*sin(x)^3")])
def test_other_threads_run_meanwhile(work):
    """No thread is made to give up Python's lock: the other one runs only if the module gives it up by itself, and then
    where it gets a processor in time, at one of several calls."""
    count, over = 0, False

    def counting():
        nonlocal count
        while not over:
            count += 1
            time.sleep(0)

    interval = sys.getswitchinterval()
    other = threading.Thread(target=counting)
    try:
        other.start()
        sys.setswitchinterval(1000)
        before = after = count
        for _ in range(100_000):
            work()
            after = count
            if after > before:
                break
    finally:
        over = True
        sys.setswitchinterval(interval)
        other.join()
    assert after > before


def test_the_result_does_not_depend_on_the_threads():
    assert (map_in_lanes(threads=1) == map_in_lanes(threads=3)).all()


def test_threads_may_prove_at_once():
    found = []
    threads = [threading.Thread(target=lambda: found.append(rederive.prove("sin(2*x)", "2*sin(x)*cos(x)").verdict))
               for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == ["proved"] * 4


@pytest.mark.parametrize("work, total", [(map_in_lanes, 60), (lambda **n: rederive.spectrum([2, 3, 4], **n), 3)])
def test_progress_rises_to_the_total(work, total):
    told = []
    work(progress=lambda *now: told.append(now))
    assert told[-1] == (total, total)
    assert told == sorted(set(told)) and all(0 < done <= total == of for done, of in told)


def test_progress_works_with_tqdm():
    with tqdm(total=60, file=io.StringIO()) as bar:
        map_in_lanes(progress=lambda done, total: bar.update(done - bar.n))
        assert bar.n == bar.total


def test_an_exception_in_the_callback_ends_the_work():
    def fail(done, total):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        map_in_lanes(progress=fail)


def processor_seconds(process):
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


LONG = """
import sys
import numpy as np
import rederive
def tell(done, total):
    print(done, flush=True)
try:
    rederive.{function}
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.parametrize("function", [
    "map(np.linspace(1, 9, 5000), np.linspace(1, 9, 5000), model='nonlinear', threads=2, progress=tell)",
    "spectrum(np.linspace(1, 9, 100000), threads=2, progress=tell)"])
def test_ctrl_c_ends_a_long_computation(script, function):
    """Alone either takes many minutes."""
    running = script(LONG.format(function=function))
    assert int(running.stdout.readline()) > 0  # it has begun
    running.send_signal(signal.SIGINT)
    out, err = running.communicate()
    assert (running.returncode, out.splitlines()[-1], err) == (0, "interrupted", "")


@pytest.mark.parametrize("function", [
    "windows(rederive.Pulse(0.01), rederive.Block(restitution=1), largest=1e6)",
    "threshold(rederive.Pulse(0.01), rederive.Block(restitution=1), model='nonlinear', largest=1e6)"])
def test_ctrl_c_ends_a_search_that_tells_no_progress(script, function):
    """Alone either takes many minutes."""
    running = script(LONG.replace("try:", "try:\n    tell(1, 1)").format(function=function))
    assert running.stdout.readline() == "1\n"
    begun = processor_seconds(running.pid)
    while processor_seconds(running.pid) < begun + 0.2:  # then it is at work
        time.sleep(0.01)
    running.send_signal(signal.SIGINT)
    out, err = running.communicate()
    assert (running.returncode, out, err) == (0, "interrupted\n", "")


def test_small_symbols_are_those_of_the_command(answer):
    found = rederive.prove("sin(x)", "x", small="x", order=3)
    assert found.verdict == answer("ledger", "prove", "sin(x)", "x", "--small", "x", "--order", "3", "--json")["verdict"]
    assert found.verdict == "refuted"
    with pytest.raises(ValueError, match="order"):
        rederive.prove("sin(x)", "x", small="x", order=-1)


def test_the_module_needs_no_locale_and_no_home(script):
    running = script("import rederive; print(rederive.prove('α', 'alpha').verdict)",
                     env={"PYTHONPATH": os.environ["PYTHONPATH"], "LC_ALL": "C"})
    assert running.communicate() == ("proved\n", "")


@pytest.mark.parametrize("left, right", [
    ("sin(x)**2 + cos(x)**2", "1"), ("-x**2", "-(x^2)"), ("x**-2", "1/x**2"), ("Abs(x)**2", "x**2"),
    ("2*sqrt(3)*x**(3/2)", "sqrt(12)*x*sqrt(x)"), ("x**2**3", "x**8")])
def test_text_as_sympy_prints_it_is_read(left, right):
    assert rederive.prove(left, right).verdict == "proved"


@pytest.mark.parametrize("call, argument", [
    (lambda: rederive.prove(1, "x"), r"prove\(\): left must be text, not int"),
    (lambda: rederive.prove("x", None), r"prove\(\): right must be text, not NoneType"),
    (lambda: rederive.prove(b"x", "x"), r"prove\(\): left must be text, not bytes"),
    (lambda: rederive.prove("x", "x", assume=b"x > 0"), r"prove\(\): assume must be text, not bytes"),
    (lambda: rederive.prove("x", "x", assume=["x > 0", 1]), r"prove\(\): assume must be text, not int"),
    (lambda: rederive.prove("x", "x", small=3, order=1), r"prove\(\): small must be text, not int"),
    (lambda: rederive.prove("x", "x", small="x", order=1.5), r"prove\(\): order must be a whole number, not float"),
    (lambda: rederive.emit(3), r"emit\(\): target must be text, not int"),
    (lambda: rederive.emit("python", 3), r"emit\(\): functions must be text, not int")])
def test_an_argument_of_a_wrong_type_is_named_with_the_function_that_was_called(call, argument):
    with pytest.raises(TypeError, match=argument):
        call()
