"""SymPy expressions as text in our own syntax, and back. Both directions are exact: what has no exact text is refused."""
from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

try:
    import sympy as sp
except ImportError:
    raise ImportError("Derivations in Python need SymPy, which is not installed. On Debian: apt-get install python3-sympy; "
                      "elsewhere: pip install sympy.") from None
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

_NAMES = "sin cos tan cot sec csc asin acos atan sinh cosh tanh coth sech csch asinh acosh atanh exp log".split()
_FUNCTIONS = {name: getattr(sp, name) for name in _NAMES} | {"fabs": sp.Abs}
_TEXTS = {function: name for name, function in _FUNCTIONS.items()}
_READ = _FUNCTIONS | {"abs": sp.Abs, "Abs": sp.Abs, "sqrt": sp.sqrt, "pow": sp.Pow}
_RELATIONS = {"=": sp.Eq, "<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}
RELATION_TEXTS = {kind: sign for sign, kind in _RELATIONS.items()} | {sp.Ne: "!="}

_INSTEAD = {name: instead for names, instead in {  # what to write instead of what has no text
    "Piecewise": "write one row for each branch, with the condition of the branch as its domain",
    "Heaviside": "write one row for each side of the jump", "sign": "write x/Abs(x)",
    "Max": "write (a + b + Abs(a - b))/2", "Min": "write (a + b - Abs(a - b))/2",
    "atan2": "write atan(y/x) where x > 0", "acot": "write atan(1/x) where x > 0", "asec": "write acos(1/x)",
    "acsc": "write asin(1/x)", "acoth": "write atanh(1/x)", "asech": "write acosh(1/x)", "acsch": "write asinh(1/x)",
    "sinc": "write sin(x)/x", "GoldenRatio": "write (1 + sqrt(5))/2", "re im arg conjugate": "declare the symbols as real",
    "ImaginaryUnit": "write the real and the imaginary part as two rows", "Infinity NegativeInfinity": "write the limit",
    "ComplexInfinity": "the expression divides by 0", "NaN": "the expression has no value", "Order": "call .removeO()",
    "Integral Sum Product Limit Subs": "call .doit(); what is left has no text", "Dummy Wild": "use a declared symbol",
    "BooleanTrue BooleanFalse": "SymPy has decided this relation by itself: use Eq(left, right, evaluate=False)",
    "ImmutableDenseMatrix MutableDenseMatrix": "write one row for each entry"}.items() for name in names.split()}


def rate_name(name: str) -> str:
    """Returns the name of the time derivative: thetadot for theta, thetaddot for thetadot."""
    return re.sub(r"(d*)dot$", r"d\1dot", name) if name.endswith("dot") else name + "dot"


def is_time(symbol: Any) -> bool:
    """Returns whether this is the time, as our papers and SymPy's dynamicsymbols write it."""
    return isinstance(symbol, sp.Symbol) and symbol.name == "t"


def _refused(what: str, instead: str) -> ValueError:
    return ValueError(f"{what if len(what) <= 80 else what[:77] + '...'} cannot be written in the syntax of papers: {instead}")


class _Writer:
    """Writes one expression, and notes in `used` what each name in it stands for."""

    def __init__(self, declared: Mapping[str, Any] | None) -> None:
        self.declared, self.used = declared, {}

    def name(self, name: str, what: Any) -> str:
        if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) or name.lower() in ("pi", "inf") or name in _READ:
            raise _refused(f"the symbol '{name}'", "a name is of letters, digits and '_', and is not that of a function or of pi")
        if self.declared is not None and name not in self.declared:
            raise ValueError(f"the symbol '{name}' is not declared: declare it under [symbols] in paper.toml"
                             + ", with the number of its rates" * name.endswith("dot"))
        self.used.setdefault(name, what)
        return name

    def rate(self, function: Any, order: int, what: Any) -> str:
        """A function of time, or its derivative: theta for theta(t), thetadot for Derivative(theta(t), t)."""
        if not isinstance(function, AppliedUndef) or len(function.args) != 1 or not is_time(function.args[0]):
            raise _refused(str(what), "only derivatives of functions of the time t are rates; call .doit()" if order else
                           "only functions of the time t can be written; declare a symbol for this value")
        name = function.func.__name__
        for _ in range(order):
            name = rate_name(name)
        return self.name(name, what)

    def sum(self, e: Any) -> str:
        first, *terms = map(self.product, e.as_ordered_terms() if isinstance(e, sp.Add) else [e])
        return first + "".join(f" - {term[1:]}" if term[0] == "-" else f" + {term}" for term in terms)

    def product(self, e: Any) -> str:
        """The factors above and below the line, with the sign in front."""
        sign, above, below = 1, [], []
        for factor in e.as_ordered_factors() if isinstance(e, sp.Mul) else [e]:
            if isinstance(factor, sp.Rational):
                sign *= -1 if factor < 0 else 1
                above += [str(abs(factor.p))] * (abs(factor.p) != 1)
                below += [str(factor.q)] * (factor.q != 1)
            elif isinstance(factor, sp.Pow) and factor.exp.is_Rational and factor.exp < 0:
                below.append(self.power(factor.base, -factor.exp))
            else:
                above.append(self.factor(factor))
        under = "/" + (below[0] if len(below) == 1 else f"({'*'.join(below)})") if below else ""
        return "-" * (sign < 0) + ("*".join(above) or "1") + under

    def factor(self, e: Any) -> str:
        is_quotient = isinstance(e, sp.Pow) and e.exp.is_Rational and e.exp < 0
        if is_quotient or isinstance(e, (sp.Add, sp.Mul)) or (isinstance(e, sp.Rational) and (e.q != 1 or e < 0)):
            return f"({self.sum(e)})"
        return self.power(e.base, e.exp) if isinstance(e, sp.Pow) else self.atom(e)

    def power(self, base: Any, exponent: Any) -> str:
        if exponent == 1:
            return self.factor(base)
        if exponent == sp.S.Half:
            return f"sqrt({self.sum(base)})"
        below = f"({self.product(base)})" if isinstance(base, sp.Pow) else self.factor(base)
        return f"{below}^{self.factor(exponent)}"

    def atom(self, e: Any) -> str:
        kind = type(e)
        if e is sp.pi or isinstance(e, sp.Integer):
            return str(e)
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
        raise _refused(f"{kind.__name__}, in {e}," if getattr(e, "args", ()) else kind.__name__,
                       _INSTEAD.get(kind.__name__, f"write it in {', '.join(_NAMES)}, sqrt and Abs"))

    def statement(self, e: Any) -> str:
        return f"{self.sum(e.lhs)} {RELATION_TEXTS[type(e)]} {self.sum(e.rhs)}" if isinstance(e, Relational) else self.sum(e)


def exact(value: Any) -> Any:
    """Returns a number or an expression as SymPy has it. Raises ValueError for floats, TypeError for other objects."""
    if isinstance(value, float):
        raise _refused(f"the float {value}", f"it is not exact; write a fraction, such as Rational('{Fraction(str(value))}')")
    try:
        return sp.sympify(value, strict=True)
    except sp.SympifyError:
        raise TypeError(f"{value!r} is a {type(value).__name__}; a SymPy expression is needed here") from None


def to_text_and_names(expression: Any, declared: Mapping[str, Any] | None = None) -> tuple[str, dict[str, Any]]:
    """Returns the text of an expression, and what each name in it stands for."""
    writer = _Writer(declared)
    try:
        return writer.statement(exact(expression)), writer.used
    except RecursionError:
        raise ValueError("the expression is nested too deeply to be written") from None


def to_text(expression: Any, declared: Mapping[str, Any] | None = None) -> str:
    """Returns a SymPy expression or relation as text in our own syntax, exactly.

    Functions of the time t are symbols, and their derivatives are rates: theta(t).diff(t) is thetadot. `declared` has the
    names that may be used; by default all. Raises ValueError for what has no exact text (floats, I, Piecewise), saying what
    to write instead, and for a symbol that is not declared.

    >>> to_text(sympy.sqrt(sympy.Symbol("x")) * sympy.physics.mechanics.dynamicsymbols("theta").diff() ** 2 / 2)
    'thetadot^2*sqrt(x)/2'
    """
    return to_text_and_names(expression, declared)[0]


def statements_as_text(left: Any, right: Any, assume: Any, small: Any, declared: Mapping[str, Any] | None) -> tuple[Any, ...]:
    """Returns what `prove` is asked with texts in the place of SymPy expressions, and what the names in them stand for.

    The signs that SymPy's symbols have, and that paper.toml does not declare, become assumptions. Without SymPy expressions
    everything is returned as it is.
    """
    assumed, smalls = (list(some) if isinstance(some, (list, tuple)) else [some] for some in (assume, small))
    if not any(isinstance(one, sp.Basic) for one in (left, right, *assumed, *smalls)):
        return left, right, assume, small, declared
    used: dict[str, Any] = {}

    def text(one: Any) -> Any:
        written, names = (one, {}) if isinstance(one, str) else to_text_and_names(one)
        used.update(names)
        return written

    left, right, *assumed = map(text, (left, right, *assumed))
    for name in used.keys() - (declared or {}).keys():
        of = used[name]
        signs = {"> 0": of.is_positive, "< 0": of.is_negative, ">= 0": of.is_nonnegative, "<= 0": of.is_nonpositive, "!= 0": of.is_nonzero}
        assumed += [f"{name} {sign}" for sign, holds in signs.items() if holds][:1]
    return left, right, assumed, list(map(text, smalls)), {**(declared or {}), **used}


def from_text(text: str, symbols: Mapping[str, Any] | Iterable[Any] = ()) -> Any:
    """Returns the SymPy expression or relation of a text in our own syntax, with ASCII names, exactly.

    `symbols` says what names stand for: symbols, or a mapping of names to expressions. Other names are real symbols. Decimal
    numbers become fractions; a chain such as a < b < c becomes And(a < b, b < c). Raises ValueError for other texts.

    >>> from_text("2*sqrt(x)/3 < 0.1")
    2*sqrt(x)/3 < 1/10
    """
    known = symbols if isinstance(symbols, Mapping) else {symbol.name: symbol for symbol in symbols}
    parts = re.split(r"(<=|>=|[<>=])", text)
    sides = [_Reader(side, known).read() for side in parts[::2]]
    links = [_RELATIONS[sign](*ends, evaluate=False) for sign, *ends in zip(parts[1::2], sides, sides[1:])]
    return sides[0] if not links else links[0] if len(links) == 1 else sp.And(*links)


class _Reader:
    """Reads one side of a relation: Python parses it, after names were marked by a '_', so that none is a word of Python."""

    def __init__(self, text: str, known: Mapping[str, Any]) -> None:
        self.text, self.known = " ".join(text.split()), known
        self.source = re.sub(r"\b(?<![\d.])[A-Za-z_]\w*", r"\g<0>_", self.text.replace("^", "**"))

    def read(self) -> Any:
        try:
            return self.value(ast.parse(self.source, mode="eval").body)
        except (SyntaxError, RecursionError, MemoryError):
            raise ValueError(f"'{self.text}' cannot be read as an expression in our syntax with ASCII names") from None

    def value(self, node: ast.AST) -> Any:
        digits = isinstance(node, ast.Constant) and ast.get_source_segment(self.source, node)
        if digits and re.fullmatch(r"[\d.]+([eE][-+]?\d+)?", digits):
            return sp.Rational(digits)
        if isinstance(node, ast.Name) and node.id.endswith("_") and node.id.isascii():
            name = node.id[:-1]
            return sp.pi if name == "pi" else self.known[name] if name in self.known else sp.Symbol(name, real=True)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            name, count = node.func.id[:-1], 2 if node.func.id == "pow_" else 1
            if name not in _READ or len(node.args) != count:
                raise ValueError(f"'{name}' {'has two arguments' if count == 2 else 'has one argument'}" if name in _READ else
                                 f"'{name}' is not a function in our syntax")
            return _READ[name](*map(self.value, node.args))
        kind = type(getattr(node, "op", None))
        if kind is ast.Pow:
            return sp.Pow(self.value(node.left), self.value(node.right))
        if kind in (ast.Add, ast.Sub):
            return sp.Add(*self.terms(node))
        if kind in (ast.Mult, ast.Div, ast.USub, ast.UAdd):
            return sp.Mul(*self.factors(node))
        raise SyntaxError

    def terms(self, node: ast.AST) -> list[Any]:
        """The terms of a sum, all at once: one by one, SymPy takes a time that is quadratic in their number."""
        terms = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
            terms.append(sp.Mul(*self.factors(node.right), 1 if isinstance(node.op, ast.Add) else -1))
            node = node.left
        return [self.value(node), *reversed(terms)]

    def factors(self, node: ast.AST) -> list[Any]:
        """The factors of a product, all at once: SymPy makes 2*x + 2 of 2*(x + 1), but not in 2*(x + 1)*y."""
        kind = type(getattr(node, "op", None))
        if kind in (ast.USub, ast.UAdd):
            return [sp.Integer(-1 if kind is ast.USub else 1), *self.factors(node.operand)]
        if kind in (ast.Mult, ast.Div):
            below = self.factors(node.right)
            return self.factors(node.left) + (below if kind is ast.Mult else [1 / factor for factor in below])
        return [self.value(node)]
