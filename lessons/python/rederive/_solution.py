"""Numerical solutions of the equations of motion that rows derive."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._expressions import exact, from_text, is_time, rate_name, sp
from ._paper import Coordinate


class Solution:
    """A motion: `solution[theta]` is the history of a symbol at the times `t`; `events` has the times of each event."""

    def __init__(self, t: Any, histories: dict[str, Any], events: dict[str, Any]) -> None:
        self.t, self.histories, self.events = t, histories, events

    def __getitem__(self, symbol: Any) -> Any:
        return self.histories[str(symbol)]

    def __repr__(self) -> str:
        return f"<{', '.join(self.histories)} at {len(self.t)} times from {self.t[0]:g} to {self.t[-1]:g}>"

    def plot(self, *symbols: Any, axes: Any = None) -> Any:
        """Draws symbols, or all coordinates, against the time. Returns the axes of Matplotlib."""
        if axes is None:
            import matplotlib.pyplot
            axes = matplotlib.pyplot.figure().subplots()
        for symbol in symbols or [name for name in self.histories if not name.endswith("dot")]:
            axes.plot(self.t, self[symbol], label=f"${sp.latex(sp.Symbol(str(symbol)))}$")
        axes.set_xlabel("$t$")
        axes.legend()
        return axes


def _highest_rates(equations: list[Any], known: Mapping[str, Any]) -> list[Any]:
    """The highest rate of each coordinate in the equations whose course is not given."""
    names = {symbol.name for equation in equations for symbol in equation.free_symbols}
    return [symbol for symbol in sorted({s for equation in equations for s in equation.free_symbols}, key=str)
            if isinstance(symbol, Coordinate) and symbol.name.endswith("dot") and symbol.name not in known
            and rate_name(symbol.name) not in names]


def solve(paper: Any, rows: list[str], start: Mapping[Any, Any], until: float, *, events: Mapping[str, Any] | None = None,
          stop: Iterable[str] = (), samples: int = 1001, accuracy: float = 1e-9) -> Solution:
    """Solves the equations of motion that rows derive, from the time 0, or start[t], on.

    Parameters
    ----------
    rows : list of str
        Rows with as many equations as coordinates. The equations are linear in the highest rates.
    start : dict
        Initial values of the coordinates and their rates, and the values of all other symbols; these may depend on t.
    until : float
        End of the time.
    events : dict of names to expressions
        An event is where its expression is 0.
    stop : names
        Events that end the motion.
    samples : int
        Number of times in the solution.
    accuracy : float
        Relative tolerance of the integration, by SciPy's DOP853.

    Raises
    ------
    ValueError
        If the equations do not determine the highest rates, or if a value is missing.
    """
    try:
        from scipy.integrate import solve_ivp
    except ImportError:
        raise ImportError("solve() needs SciPy, which is not installed. On Debian: apt-get install python3-scipy; "
                          "elsewhere: pip install scipy.") from None
    known = {str(symbol): value if isinstance(value, float) else exact(value) for symbol, value in start.items()}
    begin = float(known.pop("t", 0))
    equations = []
    for row in rows:
        of = paper.derivation(row)
        if of.relation != "=":
            raise ValueError(f"row {row} is not an equation")
        equations.append((of.left - of.right).subs(dict(of.given)))
    wanted = _highest_rates(equations, known)
    found = sp.solve(equations, wanted, dict=True) if wanted else []
    if len(wanted) != len(rows) or len(found) != 1 or len(found[0]) != len(wanted):
        raise ValueError(f"row {', '.join(rows)}: {len(rows)} equations must determine the highest rates, which are "
                         f"{', '.join(map(str, wanted)) or 'none'}")
    rates: dict[str, Any] = {}  # of each part of the state
    for highest in wanted:
        base = next(q for q in paper.declared if highest.name in (rate_name(q), rate_name(rate_name(q))) and not q.endswith("dot"))
        chain = [base] if rate_name(base) == highest.name else [base, rate_name(base)]
        rates |= {name: found[0][highest] if rate_name(name) == highest.name else paper.declared[rate_name(name)] for name in chain}

    t = sp.Symbol("t", real=True)

    def callable_of(what: Any) -> Any:
        values = {name: value for name, value in known.items() if name not in rates}
        expressions = [(from_text(one, paper.declared) if isinstance(one, str) else exact(one)) for one in what]
        settled = [one.subs({s: values[s.name] for s in one.free_symbols if s.name in values}) for one in expressions]
        settled = [one.subs({s: t for s in one.free_symbols if is_time(s)}) for one in settled]
        missing = {s.name for one in settled for s in one.free_symbols} - set(rates) - {"t"}
        if missing := missing | (set(rates) - set(known)):
            raise ValueError(f"start has no value of {', '.join(sorted(missing))}")
        state = [sp.Symbol(f"state_{k}") for k in range(len(rates))]
        places = dict(zip(rates, state))
        return sp.lambdify([t, state], [one.subs({s: places[s.name] for s in one.free_symbols if s.name in places})
                                        for one in settled])

    def crossing(expression: Any, ends: bool) -> Any:
        value = callable_of([expression])

        def event(time: float, state: Any) -> Any:
            return value(time, state)[0]

        event.terminal = ends
        return event

    events, stop = dict(events or {}), [stop] if isinstance(stop, str) else list(stop)
    solved = solve_ivp(callable_of(rates.values()), (begin, until), [float(known[name]) for name in rates], method="DOP853",
                       rtol=accuracy, atol=accuracy * 1e-3, dense_output=True,
                       events=[crossing(expression, name in stop) for name, expression in events.items()])
    if not solved.success:
        raise ValueError(f"the motion could not be followed beyond t = {solved.t[-1]}: {solved.message}")
    times = np.linspace(begin, solved.t[-1], samples)
    return Solution(times, dict(zip(rates, solved.sol(times))), dict(zip(events, solved.t_events or [])))
