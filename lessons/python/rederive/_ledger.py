"""The rows of the paper, proofs, and the derived functions as code."""
from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any, Callable, Iterator

from . import _proofs

_judged = cache(_proofs.ledger)  # its rows do not change while Python runs


def _made(cls: Any, values: dict[str, Any]) -> Any:
    values = values | {"witness": _witness(values["witness"])}
    return cls(**{field.name: values[field.name] for field in fields(cls) if field.name in values})


@dataclass(frozen=True)
class Witness(Mapping[str, Fraction]):
    """A point at which two sides differ, to check by hand: a mapping of symbols to numbers.

    at: the numbers; of the constants in `exactly`, and of zeros of the equation `solves`, which lie in `between`, the
    first digits as a fraction. printed, derived: both sides there, as text of 30 digits.
    """

    at: dict[str, Fraction]
    printed: str
    derived: str
    in_words: list[str]
    exactly: dict[str, str]
    between: dict[str, tuple[Fraction, Fraction]]
    solves: str | None

    def __getitem__(self, symbol: str) -> Fraction:
        return self.at[symbol]

    def __iter__(self) -> Iterator[str]:
        return iter(self.at)

    def __len__(self) -> int:
        return len(self.at)


def _witness(found: dict[str, Any] | None) -> Witness | None:
    if found is None:
        return None
    at = {symbol: Fraction(number) for symbol, number in found["at"].items()}
    between = {symbol: (Fraction(low), Fraction(high)) for symbol, (low, high) in found.get("between", {}).items()}
    return Witness(at, found["printed"], found["derived"], found["in_words"], found.get("exactly", {}), between,
                   found.get("solves"))


@dataclass(frozen=True)
class Proof:
    """What `prove` found. verdict: proved, proved_under, approximation, refuted or undecided; by: identity, sign, points or
    expansion. certificate: of a proof by sign, sums that are 0 identically, "2*(x)*(y - 1) + 1*(z) = 0 where u >= 0"."""

    verdict: str
    factor: str | None
    side_conditions: list[str]
    witness: Witness | None
    reason: str | None
    by: str | None
    certificate: list[str]


@dataclass(frozen=True)
class Row:
    """A row of the ledger: an equation as printed, what is derived for it, and the verdict; what does not apply is None.

    Formulas are text that `prove` reads. verdict: proved, proved_under, approximation, refuted, definition or undecided.
    follows_from, rests_on_it: ids of rows. The last two are the formulas as LaTeX; a notebook shows them.
    """

    id: str
    section: str
    kind: str
    domain: str | None
    printed: str | None
    derived: str | None
    verdict: str
    expected: str
    factor: str | None
    side_conditions: list[str]
    assumption: str | None
    order: int | None
    error: str | None
    correction: str | None
    witness: Witness | None
    dimension: str
    follows_from: list[str]
    scan_repaired: bool
    scan: str | None
    reason: str | None
    rests_on_it: list[str]
    consequence: str | None
    printed_latex: str
    derived_latex: str

    def _repr_latex_(self) -> str:
        named = [(f"({self.id})\\ printed" if self.printed else f"({self.id})\\ stated", self.printed_latex),
                 ("derived", self.derived_latex), ("verdict", r"\text{%s}" % self.verdict.replace("_", " "))]
        lines = [r"\text{%s} & \displaystyle %s" % line for line in named if line[1]]
        return r"$$\begin{array}{ll}%s\end{array}$$" % r"\\[1ex]".join(lines)


def ledger() -> list[Row]:
    """Every numbered equation of the paper and the relations between them, derived and judged: the first time a second or two.

    >>> import pandas
    >>> table = pandas.DataFrame(ledger())
    >>> int((table.verdict == "undecided").sum())
    0
    """
    return [_made(Row, json.loads(row) | {"printed_latex": printed, "derived_latex": derived})
            for row, printed, derived in _judged(str(Path(__file__).with_name("equations.toml")))]


def prove(left: str, right: str, assume: str | Sequence[str] = (), *, small: str | Sequence[str] = (),
          order: int | None = None) -> Proof:
    """Decides whether two expressions, equations or inequalities say the same; `ledger prove --help` says what it reads.

    The str() of a SymPy expression is such a text: x**2 is x^2. With `small`, symbols, and `order` the series are compared:
    sin(x) is x to order 2 in x. Some two seconds and 480 MB at most, in a process of its own; what takes more is undecided;
    Ctrl-C ends it. Raises TypeError for what is not text, and ValueError, with a caret under the character, for text that
    cannot be read, and for assumptions that contradict each other.

    >>> prove("b < h", "alpha < pi/4", assume=["tan(alpha) = b/h"]).verdict
    'proved_under'
    >>> prove("sin(x)", "x", small="x", order=2).verdict
    'approximation'
    >>> prove("sin(x", "x")
    Traceback (most recent call last):
    ValueError: this parenthesis is never closed
      sin(x
         ^
    """
    return _made(Proof, json.loads(_proofs.prove(left, right, assume, small, order)))


class Emitted:
    """Derived functions as source code: `source`, and str(). In Python they can be called, one by one by name."""

    def __init__(self, target: str, names: tuple[str, ...], source: str) -> None:
        self.target, self.names, self.source = target, names, source
        self._namespace: dict[str, Any] = {"__name__": "rederive.emitted"}
        if target == "python":
            exec(compile(source, "<rederive.emit>", "exec"), self._namespace)

    def __str__(self) -> str:
        return self.source

    def __repr__(self) -> str:
        return f"<{', '.join(self.names) or 'all functions'} in {self.target}>"

    def __getitem__(self, name: str) -> Callable[..., Any]:
        """The function of this name; of restitution also restitution_with_derivatives, where there are some."""
        if self.target != "python":
            raise TypeError(f"source in {self.target} cannot be called here; emit('python', ...) can")
        return self._namespace[name]

    def __call__(self, *arguments: float, **named: float) -> Any:
        if len(self.names) != 1:
            raise TypeError("one function alone can be called so; of several take one by name: emitted['restitution']")
        return self[self.names[0]](*arguments, **named)


def emit(target: str, *functions: str) -> Emitted:
    """The derived functions as code of "cpp", "c", "python", "javascript" or "latex": those named, or all of them.

    Units are SI, and each function says in its source which equation it stands for, and its arguments with units. Raises
    ValueError for a target or a function that there is not; `emit --list` shows all functions.

    >>> emit("python", "restitution")(0.25)  # eq (46)
    0.908186921417...
    """
    return Emitted(target, tuple(dict.fromkeys(functions)), _proofs.emit(target, functions))
