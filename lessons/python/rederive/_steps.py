"""How the argument of a row is written down: a result with its steps, and what they cite."""
from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from ._expressions import RELATION_TEXTS, exact, sp, to_text


@dataclass(frozen=True)
class Step:
    """One line of an argument: words, and the formula at which it arrives or the row that it cites."""

    says: str
    left: Any = None
    relation: str = "="
    right: Any = None
    cites: str | None = None


def _sides(left: Any, relation: str, right: Any) -> tuple[Any, str, Any]:
    """Both sides and the sign between them; `left` may be a SymPy relation instead."""
    if right is None and isinstance(left, sp.core.relational.Relational):
        left, relation, right = left.lhs, RELATION_TEXTS[type(left)], left.rhs
    if right is None or left is None:
        raise TypeError("a formula needs two sides: give left and right, or a relation such as Eq(left, right)")
    if relation not in ("=", "<", "<=", ">", ">="):
        raise ValueError(f"the relation '{relation}' must be =, <, <=, > or >=")
    return exact(left), relation, exact(right)


def step(words: str, left: Any = None, right: Any = None, *, relation: str = "=") -> Step:
    """Returns a step: words, and if it has one the formula left = right. `left` may be a relation. $…$ is mathematics."""
    return Step(words) if left is None and right is None else Step(words, *_sides(left, relation, right))


def cite(row: str, words: str) -> Step:
    """Returns the result of another row of the paper as a step. Its number replaces a # in the words, or follows them."""
    return Step(words, cites=str(row))


@dataclass(frozen=True)
class Derivation:
    """A result, left = right, with the steps that lead to it. See `derived`."""

    left: Any
    relation: str
    right: Any
    steps: tuple[Step, ...]
    given: tuple[tuple[Any, Any], ...] = ()
    assuming: str = ""
    order: int = 0
    small: str = ""

    def as_json(self, declared: Mapping[str, Any]) -> dict[str, Any]:
        """Returns what derivations.json has of it. Raises ValueError for what cannot be written."""
        text = partial(to_text, declared=declared)

        def formula(of: Any) -> dict[str, str]:
            return {} if of.left is None else {"left": text(of.left), "relation": of.relation, "right": text(of.right)}

        steps = [{"says": one.says} | formula(one) | ({} if one.cites is None else {"cites": one.cites}) for one in self.steps]
        return formula(self) | {
            "steps": steps, "given": [[text(name), text(value)] for name, value in self.given],
            "assumption": self.assuming, "order": self.order, "small": self.small, "stated": not steps}


def derived(left: Any, right: Any = None, *steps: Step, relation: str = "=", given: Any = (), assuming: Any = "",
            order: int = 0, small: Any = ()) -> Derivation:
    """Returns a derivation of left = right by steps.

    Parameters
    ----------
    left, right : SymPy expressions or numbers
        The result. Instead of both, one relation such as Eq(left, right).
    *steps : Step
        From `step` and `cite`, or those of another derivation: *other.steps. A derivation without steps is marked
        "stated" in the ledger.
    relation : {"=", "<", "<=", ">", ">="}
    given : dict or list of pairs
        What names stand for, such as {J: m*L**2/3}. It is put into both sides before they are compared.
    assuming : str or SymPy relation
        What the paper leaves unsaid. Words may follow a relation in a text, behind ":" or ";".
    order : int
        If above 0: the result is a Taylor approximation to this order in the symbols `small`.
    small : symbol, list of symbols, or text such as "alpha, theta"
    """
    if isinstance(right, Step):
        right, steps = None, (right, *steps)
    for one in steps:
        if not isinstance(one, Step):
            raise TypeError(f"a {type(one).__name__} is not a step: write step(words) or step(words, left, right)")
    pairs = tuple((exact(name), exact(value)) for name, value in (given.items() if isinstance(given, Mapping) else given))
    if not isinstance(small, str):
        small = ", ".join(map(to_text, small if isinstance(small, Iterable) else [small]))
    if not isinstance(order, int) or order < 0:
        raise ValueError(f"order must be a whole number that is not negative, not {order!r}")
    if (order > 0) != bool(small):
        raise ValueError("order and small belong together: the order of the series, and the symbols that are small")
    return Derivation(*_sides(left, relation, right), steps, pairs,
                      assuming if isinstance(assuming, str) else to_text(assuming), order, small)


def taylor(expression: Any, small: Any, order: int) -> Any:
    """Returns the Taylor polynomial about 0 in symbols of the same order of magnitude, to a total degree."""
    scale, names = sp.Dummy(), tuple(small) if isinstance(small, Iterable) else (small,)
    scaled = exact(expression).subs({name: scale * name for name in names}, simultaneous=True)
    slopes = itertools.accumulate(range(1, order + 1), lambda slope, _: slope.diff(scale), initial=scaled)
    return sp.expand(sum(slope.subs(scale, 0) / sp.factorial(k) for k, slope in enumerate(slopes)))
