"""A paper in a folder, with derivations in Python: `derive.py` makes a `Paper`, and a function for each row."""
from __future__ import annotations

import functools
import inspect
import json
import os
import re
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._expressions import exact, from_text, is_time, rate_name, sp
from ._steps import Derivation

if TYPE_CHECKING:
    from . import _ledger


class Coordinate(sp.Symbol):
    """A symbol that changes in time: `dot` and `ddot` are its rates."""

    __slots__ = ()

    @property
    def dot(self) -> Coordinate:
        return Coordinate(rate_name(self.name), real=True)

    @property
    def ddot(self) -> Coordinate:
        return self.dot.dot


class BadPaper(ValueError):
    """A file of a paper that cannot be used; the message begins with its path and line."""


def _folder_of(name: Any, caller: str | None) -> Path:
    """The folder of a paper: that of the derive.py which asks, or a path, as seen from that file or from the current folder."""
    here = Path(caller).resolve().parent if caller else None
    if here and Path(caller).name == "derive.py" and (here / "paper.toml").is_file() and "/" not in str(name or ""):
        return here
    places = [base / (name or ".") for base in (here, Path.cwd()) if base]
    for place in places:
        if (place / "paper.toml").is_file():
            return place.resolve()
    raise BadPaper(f"there is no paper.toml in {' or '.join(dict.fromkeys(map(str, places)))}")


def _read_toml(file: Path) -> dict[str, Any]:
    try:
        import tomllib
    except ImportError:
        raise ImportError("papers need Python 3.11 or newer, which can read TOML") from None
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise BadPaper(f"{file}: {error.strerror}") from None
    except ValueError as error:  # also of text that is not UTF-8
        line = re.search(r"at line (\d+)", str(error))
        raise BadPaper(f"{file}:{line[1] if line else 1}: {error}") from None


class _Declared(dict):
    """The symbols of a paper by name, from the table [symbols] of paper.toml; `coordinates` are those that have rates."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.file, self.coordinates = file, []
        table = _read_toml(file).get("symbols", {})
        for name, entry in table.items() if isinstance(table, dict) else [("symbols", None)]:
            rates = entry.get("rates", 0) if isinstance(entry, dict) else None
            if rates not in (0, 1, 2) or isinstance(rates, bool):
                raise self.error(name, f'{name} must be a table such as {{ unit = "m", rates = 2 }}; rates are 0, 1 or 2')
            kind = Coordinate if rates else sp.Symbol
            whole = {"integer": True} if entry.get("integer") else {}
            self[name] = kind(name, real=True, **self.sign(name, entry.get("range", "(-inf, inf)")), **whole)
            self.coordinates += [name] * (rates > 0)
            for _ in range(rates):
                name = rate_name(name)
                self[name] = Coordinate(name, real=True)

    def error(self, name: str, message: str) -> BadPaper:
        lines = self.file.read_text(encoding="utf-8").split("\n")
        at = next((k for k, line in enumerate(lines, 1) if re.match(rf"\s*(\[?symbols\.)?\[?[\"']?{re.escape(name)}\b", line)), 1)
        return BadPaper(f"{self.file}:{at}: {message}")

    def sign(self, name: str, its_range: Any) -> dict[str, bool]:
        """What SymPy may assume of the sign: what the ends of the range show, numbers or symbols that are declared above."""
        form = re.fullmatch(r"\s*([(\[])\s*([^,]+?)\s*,\s*([^,]+?)\s*([)\]])\s*", its_range) if isinstance(its_range, str) else None
        if form is None:
            raise self.error(name, f'the range of {name} must be written "(lower, upper)", not {its_range!r}')
        try:
            least, most = (sp.nan if end in ("inf", "-inf") else from_text(end, self) for end in form.group(2, 3))
        except ValueError as error:
            raise self.error(name, f"the range of {name}: {error}") from None
        if least.is_positive or (least.is_nonnegative and form[1] == "("):
            return {"positive": True}
        if most.is_negative or (most.is_nonpositive and form[4] == ")"):
            return {"negative": True}
        return {"nonnegative": True} if least.is_nonnegative else {"nonpositive": True} if most.is_nonpositive else {}


class Paper:
    """A paper in a folder, which is seen from the file that calls this, or from the current folder.

    In the derive.py of a folder it is always that folder. `declared` has the SymPy symbols by name, with the signs that
    their ranges show, and `derivations` the functions that derive rows by their ids. Raises ValueError, with the file and
    the line, if paper.toml is missing or cannot be read.
    """

    def __init__(self, folder: str | Path | None = None) -> None:
        self.folder = _folder_of(folder, sys._getframe(1).f_globals.get("__file__"))
        self.declared = _Declared(self.folder / "paper.toml")
        self.derivations: dict[str, Callable[[], Derivation]] = {}

    def __repr__(self) -> str:
        return f"Paper({str(self.folder)!r})"

    def symbols(self, names: str | Iterable[str]) -> Any:
        """Returns the declared symbols with these names, one or a tuple; t is the time, also where it is not declared.

        Symbols with rates have the attributes `dot` and `ddot`. Raises ValueError for a name that is not declared.
        """
        wanted = re.split(r"[,\s]+", names.strip()) if isinstance(names, str) else list(names)
        found = []
        for name in wanted:
            if name not in self.declared and name != "t":
                raise ValueError(f"the symbol '{name}' is not declared under [symbols] in {self.folder / 'paper.toml'}")
            found.append(self.declared[name] if name in self.declared else sp.Symbol("t", real=True))
        return found[0] if len(found) == 1 else tuple(found)

    def row(self, row: str) -> Callable[[Callable[[], Derivation]], Callable[[], Derivation]]:
        """Marks the function that derives a row, by its id. It is run once; other functions may call it for its result."""
        if not isinstance(row, (str, int)):
            raise TypeError('the id of the row is missing: write @paper.row("1")')
        if str(row) in self.derivations:
            raise ValueError(f"two functions derive row {row}")

        def mark(function: Callable[[], Derivation]) -> Callable[[], Derivation]:
            self.derivations[str(row)] = functools.cache(function)
            return self.derivations[str(row)]

        return mark

    def d_dt(self, expression: Any) -> Any:
        """Returns the time derivative: by the rates of the symbols, by functions of t, and by t itself."""
        expression = exact(expression)
        slopes = [expression.diff(q) * (1 if is_time(q) else rate) for q in expression.free_symbols
                  if (rate := self._rate(q)) is not None or is_time(q)]
        return sp.Add(*slopes)

    def _rate(self, q: Any) -> Any:
        """The rate of a coordinate, also of another symbol with its name, or of a function of t; None for constants."""
        if isinstance(q, sp.Function) and len(q.args) == 1 and is_time(q.args[0]):
            return q.diff(q.args[0])
        known = self.declared[q.name] if isinstance(q, sp.Symbol) and q.name in self.declared else q
        return known.dot if isinstance(known, Coordinate) else None

    def lagrange(self, L: Any, q: Any, force: Any = 0, dissipation: Any = 0) -> Any:
        """Returns d/dt(dL/dq') - dL/dq + dD/dq' - Q, which is 0 in every motion.

        L is the kinetic minus the potential energy, and the coordinate q is a symbol with rates or a function of t. `force`
        is the generalised force Q that is not in the potential, and `dissipation` Rayleigh's function D, half the power
        that is lost.
        """
        rate = self._rate(q)
        if rate is None:
            raise ValueError(f"{q} does not change in time: declare it with rates = 2 in paper.toml")
        L, force, dissipation = exact(L), exact(force), exact(dissipation)
        return self.d_dt(L.diff(rate)) - L.diff(q) + dissipation.diff(rate) - force

    def rows_as_data(self) -> dict[str, dict[str, Any]]:
        """Runs the functions that derive rows. Returns what derivations.json has of each; an error is that of its row alone."""
        return {row: self._row_as_data(function) for row, function in self.derivations.items()}

    def _row_as_data(self, function: Any) -> dict[str, Any]:
        try:
            found = function()
            if not isinstance(found, Derivation):
                raise TypeError(f"{function.__name__}() returned {type(found).__name__}; it must return derived(left, right, steps)")
            return found.as_json(self.declared)
        except (Exception, SystemExit) as error:
            code = getattr(inspect.unwrap(function), "__code__", Paper.row.__code__)  # a callable object has none
            return {"error": f"{place_in(code.co_filename, error, code.co_firstlineno)}: {described(error)}"}

    def equation(self, row: str) -> Any:
        """Returns the left side minus the right side of what is derived for a row, with what is given put in."""
        if row in self.derivations:
            found = self.derivations[row]()
            relation, left, right, given = found.relation, found.left, found.right, found.given
        else:
            data = json.loads((self._current() / "derivations.json").read_text(encoding="utf-8"))["derivations"].get(row, {})
            if "error" in data or not data:
                raise ValueError(f"row {row} is not derived{': ' + data['error'] if data else ''}")
            read = functools.partial(from_text, symbols=self.declared)
            relation, left, right = data["relation"], read(data["left"]), read(data["right"])
            given = [(read(name), read(value)) for name, value in data["given"]]
        if relation != "=":
            raise ValueError(f"row {row} is not an equation")
        return (left - right).subs(dict(given))

    def _current(self) -> Path:
        """The folder, after derive.py was run if it or paper.toml has changed since."""
        from . import _proofs
        if (self.folder / "derive.py").is_file() and not _proofs.has_current_derivations(self.folder):
            ran = subprocess.run([sys.executable, "-m", "rederive.derive", self.folder], capture_output=True, text=True,
                                 env=os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))})
            if ran.returncode != 0:
                raise BadPaper(ran.stderr.strip())
        return self.folder

    def _ask(self, question: Callable[..., Any], *arguments: Any) -> Any:
        """Asks the prover about the paper, with the rows of this session if it has derived some."""
        from . import _proofs
        if not self.derivations:
            return question(_proofs.Source(self._current()), *arguments)
        with tempfile.NamedTemporaryFile("w", encoding="utf-8", suffix=".json") as file:
            json.dump({"format": 1, "derivations": self.rows_as_data()}, file)
            file.flush()
            return question(_proofs.Source(self.folder, derivations=file.name), *arguments)

    def ledger(self) -> _ledger.Ledger:
        """Returns all rows, judged. Derivations are those of this session, or those of the folder if there are none."""
        from . import _ledger, _proofs
        return _ledger.rows_told(self._ask(_proofs.ledger), self.declared)

    def errata(self) -> Errata:
        """Returns the errors alone, as a page; str() gives Markdown."""
        from . import _proofs
        return Errata(self._ask(_proofs.errata, "markdown"))

    def prove(self, left: Any, right: Any, assume: Any = (), *, small: Any = (), order: int | None = None) -> _ledger.Proof:
        """Decides as `rederive.prove` does, with the symbols of the paper and their ranges."""
        from . import _ledger, _proofs
        return _ledger.proof_in(_proofs.Source(self.folder), left, right, assume, small, order, self.declared)

    def emit(self, *functions: str, target: str = "python") -> _ledger.Emitted:
        """Returns functions that functions.toml lists as code, as `rederive.emit` does; those in Python can be called."""
        from . import _ledger
        return self._ask(_ledger.emitted_from, target, functions)

    def solve(self, rows: str | Iterable[str], start: Mapping[Any, Any], until: float, **options: Any) -> Any:
        """Solves the equations of motion that rows derive, numerically: by SciPy's DOP853.

        Parameters
        ----------
        rows : str or list of str
            Rows with as many equations as coordinates. They determine the highest rates.
        start : dict
            Initial values of the coordinates and their rates, and the values of all other symbols, which may depend on t.
            start[t] is the time at which the motion begins. Default: 0.
        until : float
            End of the time.
        events : dict of names to expressions, optional
            An event is where its expression is 0. The names in `stop` end the motion.
        samples : int
            Number of times in the solution. Default: 1001.
        accuracy : float
            Relative tolerance. Default: 1e-9.
        """
        from ._solution import solve
        return solve(self, [rows] if isinstance(rows, str) else list(rows), start, until, **options)


class Errata(str):
    """An errata sheet in Markdown, which Jupyter shows."""

    def _repr_markdown_(self) -> str:
        return self.replace("$`", "$").replace("`$", "$")  # mathematics as Jupyter marks it


def place_in(file: str, error: BaseException, otherwise: int | None = None) -> str:
    """Returns FILE:LINE, the innermost line of a file at which an error was raised; without folders."""
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    if isinstance(error, SyntaxError) and error.filename == file:
        lines.append(error.lineno)
    line = lines[-1] if lines else otherwise
    return Path(file).name + (f":{line}" if line else "")


def described(error: BaseException) -> str:
    """Returns the kind of an error and its message, on one line."""
    words = " ".join((error.msg if isinstance(error, SyntaxError) else str(error)).split())
    return type(error).__name__ + (f": {words}" if words else "")
