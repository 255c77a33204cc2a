"""SymPy expressions as text in our own syntax, and back. Both directions are exact: what has no exact text is refused."""
from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

try:
    import sympy as sp
except ImportError as missing:
    raise ImportError("Derivations in Python need SymPy, which is not installed. On Debian: apt-get install python3-sympy; "
                      "elsewhere: pip install sympy.") from missing
from sympy.core.function import AppliedUndef

_NAMES = "sin cos tan cot sec csc asin acos atan sinh cosh tanh coth sech csch asinh acosh atanh exp log".split()
_FUNCTIONS = {name: getattr(sp, name) for name in _NAMES} | {"fabs": sp.Abs}
_TEXTS = {function: name for name, function in _FUNCTIONS.items()}
_READ = _FUNCTIONS | {"abs": sp.Abs, "Abs": sp.Abs, "sqrt": sp.sqrt, "pow": sp.Pow}
_RELATIONS = {"=": sp.Eq, "<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}
RELATION_TEXTS = {kind: sign for sign, kind in _RELATIONS.items()} | {sp.Ne: "!="}

# What to write instead of a function or a value that has no text.
_INSTEAD = {
    "Piecewise": "write one row for each branch, with the condition of the branch as its domain",
    "sign": "write x/Abs(x)", "Heaviside": "write one row for each side of the jump",
    "Max": "write (a + b + Abs(a - b))/2", "Min": "write (a + b - Abs(a - b))/2",
    "atan2": "write atan(y/x) where x > 0", "sinc": "write sin(x)/x", "acot": "write atan(1/x) where x > 0",
    "asec": "write acos(1/x)", "acsc": "write asin(1/x)", "acoth": "write atanh(1/x)", "asech": "write acosh(1/x)",
    "acsch": "write asinh(1/x)", "ImaginaryUnit": "write the real and the imaginary part as two rows",
    "re": "declare the symbols as real", "im": "declare the symbols as real", "conjugate": "declare the symbols as real",
    "arg": "declare the symbols as real", "Infinity": "write the limit", "NegativeInfinity": "write the limit",
    "ComplexInfinity": "the expression divides by 0", "NaN": "the expression has no value",
    "Integral": "call .doit(); what SymPy cannot integrate has no text", "Sum": "call .doit()", "Product": "call .doit()",
    "Limit": "call .doit()", "Order": "call .removeO()", "GoldenRatio": "write (1 + sqrt(5))/2",
    "Subs": "call .doit()", "Dummy": "use a declared symbol", "Wild": "use a declared symbol",
    "BooleanTrue": "SymPy has decided this relation by itself: use Eq(left, right, evaluate=False), or give both sides",
    "BooleanFalse": "SymPy has decided this relation by itself: use Eq(left, right, evaluate=False), or give both sides",
}


def rate_name(name: str) -> str:
    """Returns the name of the time derivative: thetadot for theta, thetaddot for thetadot."""
    return re.sub(r"(d*)dot$", r"d\1dot", name) if name.endswith("dot") else name + "dot"


def is_time(symbol: Any) -> bool:
    """Returns whether SymPy's dynamicsymbols and our papers write the time like this."""
    return isinstance(symbol, sp.Symbol) and symbol.name == "t"


def _refused(what: Any, instead: str) -> ValueError:
    return ValueError(f"{what} cannot be written in the syntax of papers: {instead}")


def _quoted(expression: Any) -> str:
    text = str(expression)
    return text if len(text) <= 60 else text[:57] + "..."


class _Writer:
    """Writes one expression, and notes which names stand for what in it."""

    def __init__(self, declared: Mapping[str, Any] | None) -> None:
        self.declared, self.used = declared, {}

    def name(self, name: str, what: Any) -> str:
        if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) or name.lower() in ("pi", "inf") or name in _READ:
            raise _refused(f"the symbol '{name}'", "a name is of letters, digits and '_', and is not that of a function or of pi")
        if self.declared is not None and name not in self.declared:
            rate = "" if isinstance(what, sp.Symbol) and not name.endswith("dot") else ", with the number of its rates"
            raise ValueError(f"the symbol '{name}' is not declared: declare it under [symbols] in paper.toml{rate}")
        self.used.setdefault(name, what)
        return name

    def rate(self, function: Any, order: int, what: Any) -> str:
        """The name of a function of time, or of its derivative: theta(t), or thetadot for Derivative(theta(t), t)."""
        if not isinstance(function, AppliedUndef) or len(function.args) != 1 or not is_time(function.args[0]):
            advice = "only derivatives of functions of the time t, such as theta(t), are rates; call .doit()" \
                if order else "only functions of the time t can be written; declare a symbol for this value"
            raise _refused(_quoted(what), advice)
        name = function.func.__name__
        for _ in range(order):
            name = rate_name(name)
        return self.name(name, what)

    def sum(self, e: Any) -> str:
        if not isinstance(e, sp.Add):
            return self.product(e)
        terms = [self.product(term) for term in e.as_ordered_terms()]
        return terms[0] + "".join(f" - {term[1:]}" if term[0] == "-" else f" + {term}" for term in terms[1:])

    def product(self, e: Any) -> str:
        """Texts of the factors above and below the line; the sign goes in front."""
        sign, above, below = "", [], []
        for factor in e.as_ordered_factors() if isinstance(e, sp.Mul) else [e]:
            if isinstance(factor, sp.Rational):
                sign = "-" if (sign == "-") != (factor < 0) else ""
                above += [str(abs(factor.p))] * (abs(factor.p) != 1)
                below += [str(factor.q)] * (factor.q != 1)
            elif isinstance(factor, sp.Pow) and factor.exp.is_Rational and factor.exp < 0:
                below.append(self.power(factor.base, -factor.exp))
            else:
                above.append(self.factor(factor))
        over = "*".join(above) or "1"
        under = below[0] if len(below) == 1 else f"({'*'.join(below)})"
        return sign + over + (f"/{under}" if below else "")

    def factor(self, e: Any) -> str:
        if isinstance(e, sp.Pow):
            is_quotient = e.exp.is_Rational and e.exp < 0
            return f"({self.product(e)})" if is_quotient else self.power(e.base, e.exp)
        if isinstance(e, (sp.Add, sp.Mul)) or (isinstance(e, sp.Rational) and (e.q != 1 or e < 0)):
            return f"({self.sum(e)})"
        return self.atom(e)

    def power(self, base: Any, exponent: Any) -> str:
        if exponent == 1:
            return self.factor(base)
        if exponent == sp.S.Half:
            return f"sqrt({self.sum(base)})"
        below = f"({self.product(base)})" if isinstance(base, sp.Pow) else self.factor(base)
        return f"{below}^{self.factor(exponent)}"

    def atom(self, e: Any) -> str:
        kind = type(e)
        if isinstance(e, sp.Integer):
            return str(e)
        if e is sp.pi:
            return "pi"
        if e is sp.E:
            return "exp(1)"
        if isinstance(e, sp.Float):
            raise _refused(f"the float {e}", f"it is not exact; write a fraction, such as Rational('{sp.nsimplify(e, rational=True)}')")
        if isinstance(e, sp.Symbol) and kind.__name__ not in _INSTEAD and e.is_commutative:
            return self.name(e.name, e)
        if kind in _TEXTS:
            return f"{_TEXTS[kind]}({self.sum(e.args[0])})"
        if isinstance(e, AppliedUndef):
            return self.rate(e, 0, e)
        if isinstance(e, sp.Derivative) and len(e.variable_count) == 1 and e.variable_count[0][1].is_Integer:
            return self.rate(e.expr, int(e.variable_count[0][1]), e)
        if isinstance(e, sp.MatrixBase):
            raise _refused("a matrix", "write one row for each entry")
        instead = _INSTEAD.get(kind.__name__, "write it in " + ", ".join(_NAMES) + ", sqrt and Abs")
        raise _refused(kind.__name__ if kind.__name__ == str(e) or e.args == () else f"{kind.__name__}, in {_quoted(e)},", instead)

    def statement(self, e: Any) -> str:
        if isinstance(e, sp.core.relational.Relational):
            return f"{self.sum(e.lhs)} {RELATION_TEXTS[type(e)]} {self.sum(e.rhs)}"
        return self.sum(e)


def exact(value: Any) -> Any:
    """Returns a number or an expression as SymPy has it. Raises ValueError for floats, TypeError for other objects."""
    if isinstance(value, float) or type(value).__name__ in ("float16", "float32", "longdouble"):
        raise _refused(f"the float {value}", f"it is not exact; write a fraction, such as Rational('{Fraction(str(value))}')")
    if isinstance(value, str):
        raise TypeError(f"'{value}' is text; a SymPy expression is needed here")
    try:
        return sp.sympify(value, strict=True)
    except sp.SympifyError:
        raise TypeError(f"a {type(value).__name__} is not an expression; a SymPy expression is needed here") from None


def to_text_and_names(expression: Any, declared: Mapping[str, Any] | None = None) -> tuple[str, dict[str, Any]]:
    """Returns the text of an expression, and what each name in it stands for."""
    writer = _Writer(declared)
    try:
        return writer.statement(exact(expression)), writer.used
    except RecursionError:
        raise ValueError("the expression is nested too deeply to be written") from None


def to_text(expression: Any, declared: Mapping[str, Any] | None = None) -> str:
    """Returns a SymPy expression or relation as text in our own syntax, exactly.

    Functions of the time t are symbols, and their derivatives are rates: theta(t).diff(t) is thetadot.

    Parameters
    ----------
    expression : SymPy expression, relation or number
    declared : mapping, optional
        The names that may be used. Default: all.

    Raises
    ------
    ValueError
        If a part has no exact text, such as a float, I or Piecewise, or if a symbol is not declared. The message says
        what to write instead.

    >>> x, theta = sympy.Symbol("x"), sympy.physics.mechanics.dynamicsymbols("theta")
    >>> to_text(sympy.sqrt(x) * theta.diff() ** 2 / 2)
    'thetadot^2*sqrt(x)/2'
    """
    return to_text_and_names(expression, declared)[0]


def statements_as_text(left: Any, right: Any, assume: Any, small: Any, declared: Mapping[str, Any] | None) -> tuple[Any, ...]:
    """Returns what `prove` is asked with texts in the place of SymPy expressions, and the symbols in these by name.

    If there is no SymPy expression, everything is returned as it is, with `declared` for the symbols. The signs that SymPy's
    symbols have, but paper.toml does not declare, become assumptions.
    """
    def listed(some: Any) -> list[Any]:
        return list(some.args if isinstance(some, sp.And) else some) if isinstance(some, (list, tuple, sp.And)) else [some]

    assumed, smalls = listed(assume), listed(small)
    if not any(isinstance(one, sp.Basic) for one in (left, right, *assumed, *smalls)):
        return left, right, assume, small, declared
    used: dict[str, Any] = {}

    def text(one: Any) -> Any:
        if isinstance(one, str):
            return one
        written, names = to_text_and_names(one)
        used.update(names)
        return written

    left, right, *assumed = map(text, (left, right, *assumed))
    for name, symbol in used.items():
        for sign, holds in (("> 0", symbol.is_positive), ("< 0", symbol.is_negative), (">= 0", symbol.is_nonnegative),
                            ("<= 0", symbol.is_nonpositive), ("!= 0", symbol.is_nonzero)):
            if holds:
                assumed += [f"{name} {sign}"] if name not in (declared or {}) else []
                break
    return left, right, assumed, [text(one) for one in smalls], {**(declared or {}), **used}


def from_text(text: str, symbols: Mapping[str, Any] | Iterable[Any] = ()) -> Any:
    """Returns the SymPy expression or relation of a text in our own syntax, with ASCII names, exactly.

    Decimal numbers become fractions. A chain such as a < b < c becomes And(a < b, b < c).

    Parameters
    ----------
    text : str
    symbols : mapping of names to expressions, or iterable of symbols
        What names stand for. Other names are real symbols.

    Raises
    ------
    ValueError
        If the text cannot be read.

    >>> from_text("2*sqrt(x)/3 < 0.1")
    2*sqrt(x)/3 < 1/10
    """
    known = symbols if isinstance(symbols, Mapping) else {symbol.name: symbol for symbol in symbols}
    parts = re.split(r"(<=|>=|[<>=])", text)
    sides = [_Reader(side, known).read() for side in parts[::2]]
    relations = [_RELATIONS[sign](left, right, evaluate=False) for sign, left, right in zip(parts[1::2], sides, sides[1:])]
    if not relations:
        return sides[0]
    return relations[0] if len(relations) == 1 else sp.And(*relations)


class _Reader:
    """Reads one side of a relation: Python reads the text as its own, after names were marked as such by a '_'."""

    def __init__(self, text: str, known: Mapping[str, Any]) -> None:
        self.text, self.known = text.strip(), known
        self.source = re.sub(r"\b(?<![\d.])[A-Za-z_]\w*", r"\g<0>_", self.text.replace("^", "**"))

    def read(self) -> Any:
        try:
            return self.value(ast.parse(self.source, mode="eval").body)
        except (SyntaxError, RecursionError, MemoryError):
            raise self.unreadable() from None

    def unreadable(self) -> ValueError:
        return ValueError(f"'{self.text}' cannot be read as an expression in our syntax with ASCII names")

    def value(self, node: ast.AST) -> Any:
        if isinstance(node, ast.Constant):
            digits = ast.get_source_segment(self.source, node)
            if re.fullmatch(r"[\d.]+([eE][-+]?\d+)?", digits):
                return sp.Rational(digits)
        if isinstance(node, ast.Name) and node.id.endswith("_") and node.id.isascii():
            name = node.id[:-1]
            return sp.pi if name == "pi" else self.known[name] if name in self.known else sp.Symbol(name, real=True)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            function = _READ.get(node.func.id[:-1])
            if function is None:
                raise ValueError(f"'{node.func.id[:-1]}' is not a function in our syntax")
            if len(node.args) != (2 if function is sp.Pow else 1):
                raise ValueError(f"'{node.func.id[:-1]}' has {'two arguments' if function is sp.Pow else 'one argument'}")
            return function(*map(self.value, node.args))
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            return sp.Pow(self.value(node.left), self.value(node.right))
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
            return sp.Add(*self.terms(node))
        if isinstance(node, (ast.BinOp, ast.UnaryOp)):
            return sp.Mul(*self.factors(node))
        raise self.unreadable()

    def terms(self, node: ast.AST) -> list[Any]:
        """The terms of a sum, all at once, because SymPy needs a time that is quadratic in them one by one."""
        terms = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
            terms.append(sp.Mul(*self.factors(node.right), 1 if isinstance(node.op, ast.Add) else -1))
            node = node.left
        return [self.value(node), *reversed(terms)]

    def factors(self, node: ast.AST) -> list[Any]:
        """The factors of a product, all at once: SymPy makes 2*x + 2 of 2*(x + 1), but not in 2*(x + 1)*y."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
            return [sp.Integer(-1 if isinstance(node.op, ast.USub) else 1), *self.factors(node.operand)]
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
            return self.factors(node.left) + self.factors(node.right)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            return self.factors(node.left) + [1 / factor for factor in self.factors(node.right)]
        if isinstance(node, ast.BinOp) and not isinstance(node.op, (ast.Add, ast.Sub, ast.Pow)) or isinstance(node, ast.UnaryOp):
            raise self.unreadable()
        return [self.value(node)]
