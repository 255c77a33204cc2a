"""A stone that is dropped."""
import sympy as sp

from rederive import Paper, derived, step

paper = Paper()
s, t, g = paper.symbols("s t g")


@paper.row("1")
def fall():
    velocity = sp.integrate(g, (t, 0, t))
    return derived(s, sp.integrate(velocity, (t, 0, t)), step("Integrate the acceleration $g$ over the time, and the velocity again"))
