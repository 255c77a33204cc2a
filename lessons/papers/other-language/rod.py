"""A rod of mass m and length L that swings on a hinge at its end."""
import sympy as sp

from rederive import Paper, cite, derived, step, taylor

paper = Paper()
m, L, J, x, g, theta, omega_0 = paper.symbols("m L J x g theta omega_0")


@paper.row("1")
def moment_of_inertia():
    inertia = sp.integrate(x**2*m/L, (x, 0, L))
    return derived(J, inertia, step("Integrate $x^2$ over the mass of all elements, $m/L$ per length"))


@paper.row("2")
def equation_of_motion():
    inertia = moment_of_inertia().right
    kinetic, potential = inertia/2*theta.dot**2, m*g*L/2*(1 - sp.cos(theta))
    motion = paper.lagrange(kinetic - potential, theta)
    return derived(theta.ddot, sp.solve(motion, theta.ddot)[0], cite("1", "With the moment of inertia of #"),
                   step("Lagrange's equation, with the weight in the middle of the rod", motion, 0))


@paper.row("3")
def frequency():
    linear = taylor(equation_of_motion().right, theta, 1)
    return derived(omega_0, sp.sqrt(-linear.coeff(theta)), step("For small angles", theta.ddot, linear))
