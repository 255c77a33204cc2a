"""A paper on a rod, as a user writes it."""
PAPER = """title = "On Rods"
[symbols]
m = { unit = "kg", range = "(0, inf)" }
L = { unit = "m", range = "(0, inf)" }
J = { unit = "kg*m^2", range = "(0, inf)" }
g = { unit = "m/s^2", range = "(0, inf)" }
x = { unit = "m", range = "(0, L)" }
theta = { range = "(-pi, pi)", rates = 2 }
omega_0 = { unit = "1/s", range = "(0, inf)" }
beta = { range = "[0, pi/2)" }
gamma = { range = "(-inf, 0)" }
n = { integer = true }
"""

DERIVE = """import sympy as sp
from rederive import Paper, cite, derived, step, taylor
paper = Paper("rods")
m, g, L, J, theta, x, omega_0 = paper.symbols("m g L J theta x omega_0")

@paper.row("1")
def moment_of_inertia():
    return derived(J, sp.integrate(x**2*m/L, (x, 0, L)), step("Integrate $x^2$ over the mass of all elements"))

@paper.row("2")
def motion():
    K, V = J*theta.dot**2/2, m*g*L/2*(1 - sp.cos(theta))
    return derived(paper.lagrange(K - V, theta), 0, step("Lagrange's equation"), cite("1", "with #"),
                   given={J: moment_of_inertia().right})

@paper.row("3")
def frequency():
    linear = taylor(-3*g/(2*L)*sp.sin(theta), theta, 1)
    return derived(omega_0, sp.sqrt(-linear.coeff(theta)), step("For small angles", sp.Eq(theta.ddot, linear)))
"""

EQUATIONS = "".join(f"""
[[equation]]
id = "{id}"
section = "A rod on a hinge"
kind = "equation"
printed = "{printed}"
follows_from = []
expected = "{expected}"
""" for id, printed, expected in [("1", "J = m*L^2/3", "proved"), ("2", "thetaddot = -3*g/(2*L)*sin(theta)", "proved"),
                                  ("3", "omega_0 = sqrt(2*g/(3*L))", "refuted")])
