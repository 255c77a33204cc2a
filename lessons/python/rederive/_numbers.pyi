from typing import Callable
import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import Threshold

version: str
class Block:
    def __init__(self, alpha: float = 0.25, p: float = 2.14, restitution: float | None = None) -> None: ...
    @staticmethod
    def from_size(half_width: float, half_height: float, restitution: float | None = None, gravity: float = 9.81) -> Block: ...
    @property
    def alpha(self) -> float: ...
    @property
    def p(self) -> float: ...
    @property
    def restitution(self) -> float: ...

class Pulse:
    def __init__(self, omega: float, kind: str = "sine") -> None: ...
    @property
    def omega(self) -> float: ...
    @property
    def kind(self) -> str: ...

class Response:
    outcome: str
    code: int
    impacts: int
    time: float | None
    events: NDArray[np.void]
    tau: NDArray[np.float64]
    theta_over_alpha: NDArray[np.float64]
    thetadot_over_alpha_p: NDArray[np.float64]
    ground_over_g: NDArray[np.float64]

def threshold(pulse: Pulse, block: Block = ..., *, model: str = "linear", theta0: float = 0.0, thetadot0: float = 0.0,
              largest: float = 12.0) -> Threshold | None: ...
def windows(pulse: Pulse, block: Block = ..., *, model: str = "linear", theta0: float = 0.0, thetadot0: float = 0.0,
            largest: float = 12.0) -> NDArray[np.void]: ...
def response(pulse: Pulse, amplitude: float, block: Block = ..., *, model: str = "linear", theta0: float = 0.0,
             thetadot0: float = 0.0, until: float | None = None, samples: int = 2001) -> Response: ...
def spectrum(omegas: ArrayLike, block: Block = ..., *, kind: str = "sine", model: str = "linear", theta0: float = 0.0,
             thetadot0: float = 0.0, largest: float = 12.0, threads: int | None = None,
             progress: Callable[[int, int], object] | None = None) -> NDArray[np.void]: ...
def map(omegas: ArrayLike, amplitudes: ArrayLike, block: Block = ..., *, kind: str = "sine", model: str = "linear",
        theta0: float = 0.0, thetadot0: float = 0.0, threads: int | None = None,
        progress: Callable[[int, int], object] | None = None) -> NDArray[np.int32]: ...
