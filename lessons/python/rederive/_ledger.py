"""The rows of the paper, proofs, and the derived functions as code."""
from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from functools import cache
from html import escape
from pathlib import Path
from typing import Any, Callable, ClassVar, Iterator

from . import _proofs

_built_in = _proofs.Source(equations=str(Path(__file__).with_name("equations.toml")))


@cache  # the rows do not change while Python runs
def _judged() -> list[tuple[str, str, str]]:
    return _proofs.ledger(_built_in)


def _made(cls: Any, values: dict[str, Any], symbols: Mapping[str, Any] | None = None) -> Any:
    values = values | {"witness": _witness(values["witness"], symbols)}
    return cls(**{field.name: values[field.name] for field in fields(cls) if field.name in values})


@dataclass(frozen=True)
class Witness(Mapping[Any, Any]):
    """A point at which two sides differ, to check by hand. It is a mapping of symbols to numbers.

    If SymPy expressions were given, the symbols are theirs and the numbers are those of SymPy: expression.subs(witness).

    Attributes
    ----------
    at : dict
        The value of each symbol. For the constants in `exactly` and the zeros in `between`, it is the fraction of
        the first digits; SymPy has the constants themselves.
    printed, derived : str
        The values of both sides there, with 30 digits.
    in_words : list of str
        The values in words.
    exactly : dict
        Symbols that are constants such as "pi/6".
    between : dict
        Bounds of symbols that are zeros of the equation `solves`.
    solves : str or None
        The equation of these zeros.
    """

    at: dict[Any, Any]
    printed: str
    derived: str
    in_words: list[str]
    exactly: dict[str, str]
    between: dict[str, tuple[Fraction, Fraction]]
    solves: str | None

    def __getitem__(self, symbol: Any) -> Any:
        for known, number in self.at.items():  # x is found by "x", and by every symbol x
            if str(known) == str(symbol):
                return number
        raise KeyError(symbol)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.at)

    def __len__(self) -> int:
        return len(self.at)


def _witness(found: dict[str, Any] | None, symbols: Mapping[str, Any] | None) -> Witness | None:
    if found is None:
        return None
    at = {symbol: Fraction(number) for symbol, number in found["at"].items()}
    if symbols is not None:
        from ._expressions import exact, from_text
        at = {symbols.get(name, name): from_text(found["exactly"][name]) if name in found.get("exactly", {}) else exact(number)
              for name, number in at.items()}
    between = {symbol: (Fraction(low), Fraction(high)) for symbol, (low, high) in found.get("between", {}).items()}
    return Witness(at, found["printed"], found["derived"], found["in_words"], found.get("exactly", {}), between,
                   found.get("solves"))


@dataclass(frozen=True)
class Proof:
    """The result of `prove`.

    Attributes
    ----------
    verdict : {"proved", "proved_under", "approximation", "refuted", "undecided"}
    factor : str or None
        left = factor*right, for two relations.
    side_conditions : list of str
        Conditions under which both sides have values.
    witness : Witness or None
        A point at which the sides differ, if refuted.
    reason : str or None
    by : {"identity", "sign", "points", "expansion"} or None
    certificate : list of str
        For a proof by sign, sums that are identically 0, such as "2*(x)*(y - 1) + 1*(z) = 0 where u >= 0".
    """

    verdict: str
    factor: str | None
    side_conditions: list[str]
    witness: Witness | None
    reason: str | None
    by: str | None
    certificate: list[str]


@dataclass(frozen=True)
class Row:
    """A row of the ledger: an equation as printed, what is derived for it, and the verdict.

    Formulas are text that `prove` reads, and a field that does not apply is None. The verdict is proved, proved_under,
    approximation, refuted, definition or undecided. `follows_from` and `rests_on_it` are ids of rows. `printed_latex` and
    `derived_latex` are the formulas as LaTeX, which a notebook shows. `read_as` is how a row in LaTeX was read, `parts` has
    the entries of a vector or matrix, and `stated` says that the derivation has no step of its own.
    """

    id: str
    section: str
    kind: str
    domain: str | None
    printed: str | None
    read_as: str | None
    derived: str | None
    parts: list[dict[str, Any]]
    verdict: str
    stated: bool
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
    _symbols: ClassVar[Mapping[str, Any]] = {}

    @property
    def printed_expression(self) -> Any:
        """What is printed, as a SymPy expression or relation; None if nothing is."""
        return self._expression(self.printed)

    @property
    def derived_expression(self) -> Any:
        """What is derived, as a SymPy expression or relation, with the symbols of the paper; None if nothing is."""
        return self._expression(self.derived)

    def _expression(self, text: str | None) -> Any:
        from ._expressions import from_text
        return None if text is None else from_text(text, self._symbols)

    def _repr_latex_(self) -> str:
        named = [(f"({self.id})\\ printed" if self.printed else f"({self.id})\\ stated", self.printed_latex),
                 ("derived", self.derived_latex), ("verdict", r"\text{%s}" % self.verdict.replace("_", " "))]
        lines = [r"\text{%s} & \displaystyle %s" % line for line in named if line[1]]
        return r"$$\begin{array}{ll}%s\end{array}$$" % r"\\[1ex]".join(lines)


class Ledger(list[Row]):
    """The rows of a paper. Jupyter shows them as a table; pandas.DataFrame(ledger) has all their fields."""

    def row(self, id: str) -> Row:
        """Returns the row with an id."""
        return next(row for row in self if row.id == id)

    def _repr_html_(self) -> str:
        def cells(kind: str, *texts: str) -> str:
            return "<tr>" + "".join(f'<{kind} style="text-align: left">{text}</{kind}>' for text in texts) + "</tr>"

        rows = [cells("td", escape(row.id), escape(row.section),
                      *(f"${escape(latex)}$" if latex else escape(text or "") for latex, text in
                        ((row.printed_latex, row.printed), (row.derived_latex, row.derived))),
                      escape(row.verdict.replace("_", " "))) for row in self]
        return f"<table>{cells('th', 'row', 'section', 'printed', 'derived', 'verdict')}{''.join(rows)}</table>"


def rows_told(told: list[tuple[str, str, str]], symbols: Mapping[str, Any] | None = None) -> Ledger:
    rows = Ledger(_made(Row, json.loads(row) | {"printed_latex": printed, "derived_latex": derived}, symbols)
                  for row, printed, derived in told)
    for row in rows if symbols is not None else ():
        object.__setattr__(row, "_symbols", symbols)
    return rows


def ledger() -> Ledger:
    """Returns every numbered equation of the paper and the relations between them, derived and judged.

    The first call takes a second or two.

    >>> import pandas
    >>> table = pandas.DataFrame(ledger())
    >>> int((table.verdict == "undecided").sum())
    0
    """
    return rows_told(_judged())


def prove(left: Any, right: Any, assume: Any = (), *, small: Any = (), order: int | None = None) -> Proof:
    """Decides whether two expressions, equations or inequalities are the same.

    The decision takes at most about two seconds and 480 MB, in a process of its own; beyond that it is undecided.
    Ctrl-C ends it.

    Parameters
    ----------
    left, right : str, or SymPy expression or relation
        The statements, as `ledger prove --help` describes them, or as SymPy has them.
    assume : str or SymPy relation, or sequence of these
        Conditions that hold, such as "x > 0". The signs that SymPy's symbols have (positive=True) hold as well.
    small : str or symbol, or sequence of these
        Small symbols. With `order`, the series in these symbols are compared: sin(x) is x to order 2 in x.
    order : int or None
        Order of the series, 0 to 12.

    Returns
    -------
    Proof

    Raises
    ------
    TypeError
        If an argument is neither text nor an expression.
    ValueError
        If a text or an expression cannot be read (a caret marks the character), or if the assumptions contradict each other.

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
    return proof_in(_built_in, left, right, assume, small, order)


def proof_in(source: Any, left: Any, right: Any, assume: Any, small: Any, order: int | None,
             symbols: Mapping[str, Any] | None = None) -> Proof:
    asked: tuple[Any, ...] = (left, right, assume, small)
    if "sympy" in sys.modules:
        from ._expressions import statements_as_text
        *asked, symbols = statements_as_text(*asked, symbols)
    return _made(Proof, json.loads(_proofs.prove(source, *asked, order)), symbols)


class Emitted:
    """Derived functions as source code: `source`, also by str(). Functions in Python can be called by name."""

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
        """Returns the function of this name, such as restitution or restitution_with_derivatives."""
        if self.target != "python":
            raise TypeError(f"source in {self.target} cannot be called; use emit('python', ...)")
        return self._namespace[name]

    def __call__(self, *arguments: float, **named: float) -> Any:
        if len(self.names) != 1:
            raise TypeError("only a single function can be called without its name; choose one, as in emitted['restitution']")
        return self[self.names[0]](*arguments, **named)


def emit(target: str, *functions: str) -> Emitted:
    """Returns derived functions as source code.

    Units are SI. The source of each function names its equation, and its arguments with their units.

    Parameters
    ----------
    target : {"cpp", "c", "python", "javascript", "latex"}
        The language.
    *functions : str
        Names of functions. Default: all functions; `emit --list` shows them.

    Raises
    ------
    ValueError
        If there is no such target or function.

    >>> emit("python", "restitution")(0.25)  # eq (46)
    0.908186921417...
    """
    return emitted_from(_built_in, target, functions)


def emitted_from(source: Any, target: str, functions: tuple[str, ...]) -> Emitted:
    return Emitted(target, tuple(dict.fromkeys(functions)), _proofs.emit(source, target, functions))
