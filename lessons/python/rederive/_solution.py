"""Numerical solutions of the equations of motion that rows derive."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._expressions import exact, from_text, rate_name, sp


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


def solve(paper: Any, rows: list[str], start: Mapping[Any, Any], until: float, *, events: Mapping[str, Any] | None = None,
          stop: Iterable[str] = (), samples: int = 1001, accuracy: float = 1e-9) -> Solution:
    """Solves the equations of motion that rows derive, from the time 0 or start[t] on. See Paper.solve."""
    try:
        from scipy.integrate import solve_ivp
    except ImportError:
        raise ImportError("solve() needs SciPy, which is not installed. On Debian: apt-get install python3-scipy; "
                          "elsewhere: pip install scipy.") from None
    values = {str(symbol): exact(value) if not isinstance(value, float) else sp.Float(value) for symbol, value in start.items()}
    begin, t = float(values.pop("t", 0)), sp.Symbol("t", real=True)

    def settled(expression: Any, kept: Iterable[Any] = ()) -> Any:
        """The expression with the values of all symbols, but for those that are kept."""
        symbols = expression.free_symbols
        given = {s: values[s.name] for s in symbols if s.name in values and s.name not in kept}
        return expression.subs(given).subs({s: t for s in symbols if s.name == "t"})

    equations = [paper.equation(row) for row in rows]
    chains = [[name, rate_name(name), rate_name(rate_name(name))] for name in paper.declared.coordinates]
    names = {s.name for equation in equations for s in equation.free_symbols}
    chains = [chain[:order + 1] for chain in chains
              if (order := max((k for k in (1, 2) if chain[k] in names), default=0)) and chain[order] not in values]
    highest = [paper.declared[chain[-1]] for chain in chains]
    found = sp.solve(equations, highest, dict=True) if highest else []
    if len(highest) != len(rows) or len(found) != 1 or len(found[0]) != len(highest):
        raise ValueError(f"row {', '.join(rows)}: {len(rows)} equations must determine the highest rates, which are "
                         f"{', '.join(map(str, highest)) or 'none'}")
    rates = {name: found[0].get(paper.declared[rate], paper.declared[rate]) for chain in chains for name, rate in zip(chain, chain[1:])}

    def numeric(expressions: Iterable[Any]) -> Any:
        given = [settled(from_text(one, paper.declared) if isinstance(one, str) else exact(one), rates) for one in expressions]
        missing = {s.name for one in given for s in one.free_symbols} - {*rates, "t"} | rates.keys() - values.keys()
        if missing:
            raise ValueError(f"start has no value of {', '.join(sorted(missing))}")
        state = [sp.Symbol(f"state_{k}") for k in range(len(rates))]  # whatever the assumptions of the symbols are
        places = dict(zip(rates, state))
        return sp.lambdify([t, state], [one.subs({s: places.get(s.name, s) for s in one.free_symbols}) for one in given])

    def crossing(name: str, expression: Any) -> Any:
        value = numeric([expression])

        def event(time: float, state: Any) -> Any:
            return value(time, state)[0]

        event.terminal = name in stop
        return event

    events, stop = events or {}, [stop] if isinstance(stop, str) else list(stop)
    solved = solve_ivp(numeric(rates.values()), (begin, until), [float(settled(values[name])) for name in rates], method="DOP853",
                       rtol=accuracy, atol=accuracy * 1e-3, dense_output=True, events=[crossing(*one) for one in events.items()])
    if not solved.success:
        raise ValueError(f"the motion could not be followed beyond t = {solved.t[-1]:g}: {solved.message}")
    times = np.linspace(begin, solved.t[-1], samples)
    return Solution(times, dict(zip(rates, solved.sol(times))), dict(zip(events, solved.t_events or [])))
