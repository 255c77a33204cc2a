"""Two bobs on two rods without mass, the second hinged to the first, in a vertical plane."""
import functools

import sympy as sp

from rederive import Paper, cite, derived, step, taylor

paper = Paper()
m_1, m_2, L_1, L_2, L, g, theta_1, theta_2 = paper.symbols("m_1 m_2 L_1 L_2 L g theta_1 theta_2")
x_2, y_2, K, V, E, omega, omega_1, omega_2, rho = paper.symbols("x_2 y_2 K V E omega omega_1 omega_2 rho")


def rod(length, angle):
    """The vector from the upper end of a rod to the lower one: it hangs down, and is turned by the angle."""
    turn = sp.Matrix([[sp.cos(angle), -sp.sin(angle)], [sp.sin(angle), sp.cos(angle)]])
    return turn * sp.Matrix([0, -length])


upper = rod(L_1, theta_1)
lower = upper + rod(L_2, theta_2)


def squared_speed(position):
    """The square of the velocity; the coefficient of each product of rates has its simplest form."""
    velocity = position.applyfunc(paper.d_dt)
    square = sp.Poly(velocity.dot(velocity), theta_1.dot, theta_2.dot)
    return sum(sp.trigsimp(factor) * theta_1.dot**i * theta_2.dot**j for (i, j), factor in square.terms())


kinetic = m_1/2*squared_speed(upper) + m_2/2*squared_speed(lower)
potential = m_1*g*upper[1] + m_2*g*lower[1]


@paper.row("1")
def distance():
    return derived(x_2, lower[0], step("Turn each rod from the vertical by its angle, and add the parts to the right"))


@paper.row("2")
def height():
    return derived(y_2, lower[1], step("Add the parts of the turned rods upwards"))


@paper.row("3")
def kinetic_energy():
    return derived(K, kinetic, cite("1", "Differentiate the position of #"), cite("2", "Differentiate the height of #"),
                   step("Add half of each mass times the square of its velocity"))


@paper.row("4")
def potential_energy():
    return derived(V, potential, cite("2", "Multiply each weight by its height, which for the lower bob is that of #"))


energies = (cite("3", "Take $K$ from #"), cite("4", "Take $V$ from #"))


def motion(angle, divisor):
    """The left side of Lagrange's equation of an angle, divided by a factor that all its terms have."""
    return sp.expand(paper.lagrange(kinetic - potential, angle) / divisor)


@paper.row("5")
def motion_of_upper_rod():
    return derived(motion(theta_1, L_1), 0, *energies,
                   step("Write Lagrange's equation of $theta_1$, and divide it by $L_1$, which is in all terms"))


@paper.row("6")
def motion_of_lower_rod():
    return derived(motion(theta_2, m_2*L_2), 0, *energies,
                   step("Write Lagrange's equation of $theta_2$, and divide it by $m_2*L_2$, which is in all terms"))


@functools.cache
def accelerations():
    """Both accelerations by Cramer's rule: the equations of motion are linear in them."""
    equations = [motion_of_upper_rod().left, motion_of_lower_rod().left]
    matrix, right = sp.linear_eq_to_matrix(equations, (theta_1.ddot, theta_2.ddot))
    cosine, sine = sp.cos(theta_1 - theta_2), sp.sin(theta_1 - theta_2)
    below = sp.factor(matrix.det().subs(cosine**2, 1 - sine**2))
    above = [sp.Matrix.hstack(right, matrix[:, 1]), sp.Matrix.hstack(matrix[:, 0], right)]
    return [sp.factor_terms(one.det()) / below for one in above]


linear_in_both = (cite("5", "# is linear in the accelerations"), cite("6", "So is #"),
                  step("Solve the two by Cramer's rule; their determinant is positive"))


@paper.row("7")
def acceleration_of_upper_rod():
    return derived(theta_1.ddot, accelerations()[0], *linear_in_both)


@paper.row("8")
def acceleration_of_lower_rod():
    return derived(theta_2.ddot, accelerations()[1], *linear_in_both)


@paper.row("9")
def energy_is_kept():
    power = paper.d_dt(kinetic + potential)
    of_motion = L_1*theta_1.dot*motion_of_upper_rod().left + m_2*L_2*theta_2.dot*motion_of_lower_rod().left
    return derived(E.dot, sp.expand(power - of_motion), step("Differentiate $K + V$ in time", E.dot, power),
                   cite("5", "Subtract $L_1*theta_1dot$ times the left side of #, which is 0"),
                   cite("6", "Subtract $m_2*L_2*theta_2dot$ times the left side of #; nothing is left"))


angles = (theta_1, theta_2)
small = [*angles, theta_1.dot, theta_2.dot, theta_1.ddot, theta_2.ddot]


@paper.row("10")
def small_motion_of_upper_rod():
    return derived(taylor(motion_of_upper_rod().left, small, 1), 0, cite("5", "Keep the terms of # that are linear"),
                   order=1, small=small)


def swings():
    """The matrix whose product with both amplitudes is 0 if both angles are amplitudes times cos(omega*t)."""
    linear = [taylor(row().left, small, 1) for row in (motion_of_upper_rod, motion_of_lower_rod)]
    swinging = {angle.ddot: -omega**2*angle for angle in angles}
    return sp.linear_eq_to_matrix([sp.expand(one.subs(swinging)) for one in linear], angles)[0]


@paper.row("11")
def frequencies():
    return derived(sp.expand(swings().det()), 0, cite("10", "Let both angles go with $cos(omega*t)$ in #"),
                   cite("6", "Do so in the linear terms of #"),
                   step("The two amplitudes are not both 0 if the determinant of these equations is 0"))


def equal_squares():
    """The squares of both frequencies, the lower one first, where masses and lengths are equal."""
    square = sp.Symbol("omega_squared", positive=True)
    equation = swings().det().subs({m_2: m_1, L_1: L, L_2: L}).subs(omega, sp.sqrt(square))
    a, b, c = sp.Poly(equation, square).all_coeffs()
    root = sp.sqrt(sp.factor(b**2 - 4*a*c))
    return [sp.factor((-b - root) / (2*a)), sp.factor((-b + root) / (2*a))]


def equal(which, frequency, words):
    square = equal_squares()[which]
    return derived(frequency, sp.sqrt(square, evaluate=False),
                   cite("11", "With $m_2 = m_1$ and both lengths $L$, # is a quadratic equation for $omega^2$"),
                   step(words, frequency**2, square))


@paper.row("12")
def lower_frequency():
    return equal(0, omega_1, "Its smaller root")


@paper.row("13")
def higher_frequency():
    return equal(1, omega_2, "Its larger root")


@paper.row("14")
def mode():
    of_theta_1, of_theta_2 = swings()[1, :]
    return derived(rho, -of_theta_1/of_theta_2, cite("6", "Let both angles go with $cos(omega*t)$ in the linear terms of #"),
                   step("Let the second amplitude be $rho$ times the first", of_theta_1 + of_theta_2*rho, 0))
