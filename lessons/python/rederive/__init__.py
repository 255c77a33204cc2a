"""A paper you can run: *On the Overturning Instability of a Rectangular Rigid Block Under Ground Excitation*.

`ledger` and `prove` judge what the paper prints. `emit` gives the derived functions as code. `threshold`, `windows`,
`response`, `spectrum` and `map` compute the motion of a `Block` under a `Pulse`.

In both models, times are p*t, amplitudes a_p/(alpha*g) and frequencies omega_p/p. The code of an overturning is
side*(impacts + 1): -1 is to theta < 0 without impact, +2 is to theta > 0 after one impact, 0 is safe. Values that cannot
be used raise ValueError, with the words of the commands.

>>> import rederive
>>> rederive.prove("sin(3*x)", "3*sin(x) - 4*sin(x)^3").verdict
'proved'
>>> rederive.threshold(rederive.Pulse(3))
Threshold(amplitude=1.40009981815..., code=2)

`Paper`, `derived`, `step`, `cite` and `taylor` derive the rows of a paper of yours with SymPy, and `to_text` and
`from_text` convert SymPy expressions. SymPy is imported when one of these is first used.
"""
from collections import namedtuple
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._expressions import from_text, to_text
    from ._ledger import Emitted, Ledger, Proof, Row, Witness, emit, ledger, prove
    from ._numbers import Block, Pulse, Response, map, response, spectrum, threshold, windows
    from ._numbers import version as __version__
    from ._paper import BadPaper, Coordinate, Paper
    from ._steps import Derivation, Step, cite, derived, step, taylor

Threshold = namedtuple("Threshold", ["amplitude", "code"])
Threshold.__doc__ = "The least amplitude a_p/(alpha*g) that overturns a block, and its code side*(impacts + 1)."

__all__ = ["Block", "Emitted", "Ledger", "Proof", "Pulse", "Response", "Row", "Threshold", "Witness", "emit", "ledger", "map",
           "prove", "response", "spectrum", "threshold", "windows"]

# A module is imported when one of its names is first used. So derive.py runs in every Python that has SymPy, also in one
# for which the compiled modules are not built.
_MODULES = {"_expressions": ["from_text", "to_text"], "_paper": ["BadPaper", "Coordinate", "Paper"],
            "_steps": ["Derivation", "Step", "cite", "derived", "step", "taylor"],
            "_ledger": ["Emitted", "Ledger", "Proof", "Row", "Witness", "emit", "ledger", "prove"],
            "_numbers": ["Block", "Pulse", "Response", "map", "response", "spectrum", "threshold", "windows"]}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("rederive._numbers").version
    for module, names in _MODULES.items():
        if name == module or name in names:
            found = import_module(f"rederive.{module}")
            return found if name == module else globals().setdefault(name, getattr(found, name))
    raise AttributeError(f"module 'rederive' has no attribute '{name}'")
