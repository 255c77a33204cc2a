"""The module says what the commands say: the second road to each result."""
import dataclasses
import math
from fractions import Fraction

import numpy as np
import pytest

import rederive
from rederive import Block, Pulse


def without_witness(row):
    return {name: value for name, value in row.items() if name != "witness"}


def same_witness(ours, theirs):
    if theirs is None:
        return ours is None
    assert list(ours) == list(theirs["at"])
    assert all(ours[symbol] == Fraction(number) for symbol, number in theirs["at"].items())
    assert all(type(number) is Fraction for number in ours.values())
    assert ours.exactly == theirs.get("exactly", {})
    assert {symbol: [str(end) for end in ends] for symbol, ends in ours.between.items()} == theirs.get("between", {})
    return (ours.printed, ours.derived, ours.in_words) == (theirs["printed"], theirs["derived"], theirs["in_words"])


def test_the_ledger_has_the_rows_of_the_command(answer, rows):
    expected = answer("ledger", "--json")["equations"]
    assert len(rows) == len(expected) > 200
    for row, wanted in zip(rows, expected):
        values = {field.name: getattr(row, field.name) for field in dataclasses.fields(row)}
        assert without_witness(wanted) == {name: values[name] for name in wanted if name != "witness"}
        assert same_witness(row.witness, wanted["witness"])


def test_the_ledger_is_the_same_wherever_the_system_puts_the_library(script, rows):
    runs = [script("import rederive; print(rederive.ledger())").communicate()[0] for _ in range(2)]
    assert len(runs[0]) > 100_000
    assert runs[0] == runs[1] == f"{rows}\n"


STATEMENTS = [("sin(2*x)", "2*sin(x)*cos(x)", []),
              ("sin(2*x)", "2*sin(x)", []),
              ("b < h", "alpha < pi/4", ["tan(alpha) = b/h"]),
              ("log(x*y)", "log(x)+log(y)", ["0 < x < y"]),
              ("tan(x+y)", "(tan(x)+tan(y))/(1-tan(x)*tan(y))", []),
              ("x + exp(x) = y + exp(y)", "x = y", []),
              ("abs(x+y) <= abs(x)+abs(y)", "0 < 1", []),
              ("cos(y) - y", "(cos(y) - y)^2", ["cos(y) = 3/5"])]


@pytest.mark.parametrize("left, right, assume", STATEMENTS)
def test_a_proof_is_that_of_the_command(answer, left, right, assume):
    options = [part for text in assume for part in ("--assume", text)]
    expected = answer("ledger", "prove", "--json", *options, "--", left, right)
    proof = rederive.prove(left, right, assume=assume)
    assert without_witness(vars(proof)) == {name: expected[name] for name in vars(proof) if name != "witness"}
    assert same_witness(proof.witness, expected["witness"])


@pytest.mark.parametrize("arguments", [("sin(x", "x"), ("2 +* x", "x"), ("thetta", "x"), ("x", "y", "x + 1"), ("", "x"),
                                       ("x", "y", "x > 0 > x")])
def test_what_cannot_be_read_is_said_as_the_command_says_it(command, arguments):
    left, right, *assume = arguments
    options = [part for text in assume for part in ("--assume", text)]
    with pytest.raises(ValueError) as raised:
        rederive.prove(left, right, assume)
    assert str(raised.value) == command("ledger", "prove", *options, "--", left, right, fails=True)


@pytest.mark.parametrize("target", ["cpp", "c", "python", "javascript", "latex"])
@pytest.mark.parametrize("names", [[], ["restitution"], ["restitution", "the first of the list"]])
def test_what_is_emitted_is_what_the_command_emits(command, target, names):
    if names[1:]:
        names = names[:1] + [command("emit", "--list").split("\n")[0].partition("(")[0]]
    options = [part for name in names for part in ("--function", name)]
    assert str(rederive.emit(target, *names)) == command("emit", "--target", target, *options)


def test_what_cannot_be_emitted_is_said_as_the_command_says_it(command):
    with pytest.raises(ValueError) as raised:
        rederive.emit("python", "restitutoin")
    assert str(raised.value) == command("emit", "--target", "python", "--function", "restitutoin", fails=True)
    with pytest.raises(ValueError, match="no target 'fortran'; the target must be one of c, cpp"):
        rederive.emit("fortran")


CASES = [(Block(), "sine", {}), (Block(0.3, 2, 0.9), "cosine", {}), (Block(), "sine", {"model": "nonlinear"}),
         (Block(), "sine", {"theta0": 0.02, "thetadot0": -0.05})]


def options_of(block, kind, named):
    options = ["--alpha", repr(block.alpha), "--frequency-parameter", repr(block.p), "--restitution",
               repr(block.restitution), "--pulse", kind, "--json"]
    for name, value in named.items():
        options += [f"--{name}", str(value)]
    return options


def number(value):
    return math.nan if value is None else value


@pytest.mark.parametrize("block, kind, named", CASES)
def test_windows_and_threshold_are_those_of_the_command(answer, block, kind, named):
    expected = answer("rocking", "threshold", "--omega", "3", "--max-amplitude", "9", *options_of(block, kind, named))
    found = rederive.windows(Pulse(3, kind), block, largest=9, **named)
    assert found.dtype.names == ("from", "to", "code") and len(found)
    np.testing.assert_equal(found.tolist(), [(w["from"], number(w["to"]), w["code"]) for w in expected["windows"]])
    least = rederive.threshold(Pulse(3, kind), block, largest=9, **named)
    # found from below, and not between all windows: the last bit may differ
    assert least.amplitude == pytest.approx(expected["minimum"]["amplitude"], rel=1e-12)
    assert least.code == expected["minimum"]["code"]


def test_no_threshold_is_none_and_no_window_an_empty_array():
    assert rederive.threshold(Pulse(3), largest=1.1) is None
    assert rederive.windows(Pulse(3), largest=1.1).shape == (0,)


@pytest.mark.parametrize("block, kind, named", CASES)
@pytest.mark.parametrize("amplitude", [1.6, 4])
def test_a_response_is_that_of_the_command(answer, tmp_path, block, kind, named, amplitude):
    file = tmp_path / "history.csv"
    expected = answer("rocking", "response", "--omega", "2", "--amplitude", str(amplitude), "--csv", file,
                      *options_of(block, kind, named))
    found = rederive.response(Pulse(2, kind), amplitude, block, **named)
    for name in ("outcome", "code", "impacts", "time"):
        assert getattr(found, name) == expected[name]
    assert found.events.tolist() == [tuple(event[name] for name in found.events.dtype.names) for event in expected["events"]]
    history = np.genfromtxt(file, delimiter=",", names=True)
    for name in history.dtype.names:
        assert getattr(found, name).shape == (2001,)
        np.testing.assert_array_equal(getattr(found, name), history[name])


@pytest.mark.parametrize("block, kind, named", CASES)
def test_a_spectrum_is_that_of_the_command(answer, block, kind, named):
    expected = answer("rocking", "spectrum", "--from", "2", "--to", "4", "--points", "3", *options_of(block, kind, named))
    found = rederive.spectrum(np.linspace(2, 4, 3), block, kind=kind, **named)
    assert found.shape == (3,)
    np.testing.assert_equal(found.tolist(), [tuple(number(point[name]) for name in found.dtype.names)
                                             for point in expected["points"]])


@pytest.mark.parametrize("block, kind, named", CASES)
def test_a_map_is_that_of_the_command(answer, block, kind, named):
    expected = answer("rocking", "map", "--omega", "1:4:7", "--amplitude", "1.5:6:10", *options_of(block, kind, named))
    found = rederive.map(expected["omega_ratios"], expected["amplitudes"], block, kind=kind, **named)
    assert found.shape == (7, 10) and found.dtype == np.int32
    assert found.tolist() == expected["codes"]
    assert len(set(found.ravel().tolist())) > 1


@pytest.mark.parametrize("make, arguments", [
    (lambda: Block(2), ["--alpha", "2"]),
    (lambda: Block(p=-1), ["--frequency-parameter=-1"]),
    (lambda: Block(restitution=1.5), ["--restitution", "1.5"]),
    (lambda: Block(1.3), ["--alpha", "1.3"]),
    (lambda: Block.from_size(0, 1), ["--half-width", "0", "--half-height", "1"]),
    (lambda: rederive.threshold(Pulse(3), theta0=1e12), ["--theta0", "1e12"])])
def test_a_value_out_of_range_is_named_as_the_command_names_it(command, make, arguments):
    with pytest.raises(ValueError) as raised:
        make()
    options, why = command("rocking", "threshold", "--omega", "3", *arguments, fails=True).split(": ", 1)
    assert str(raised.value) == why
    assert arguments[0].split("=")[0] in options.split(", ")


@pytest.mark.parametrize("make, option, arguments", [
    (lambda: Pulse(0), "--omega", ["threshold", "--omega", "0"]),
    (lambda: rederive.threshold(Pulse(1), largest=0), "--max-amplitude",
     ["threshold", "--omega", "1", "--max-amplitude", "0"]),
    (lambda: rederive.response(Pulse(1), -1), "--amplitude", ["response", "--omega", "1", "--amplitude=-1"]),
    (lambda: rederive.response(Pulse(1), 2, until=1e6), "--until",
     ["response", "--omega", "1", "--amplitude", "2", "--until", "1000000"])])
def test_an_argument_out_of_bounds_is_named_as_the_command_names_the_option(command, make, option, arguments):
    with pytest.raises(ValueError) as raised:
        make()
    said = command("rocking", *arguments, fails=True)
    assert said.startswith(option) and str(raised.value).partition(" ")[2] == said.partition(" ")[2]
