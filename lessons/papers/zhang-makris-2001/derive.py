"""The rocking block under sine and cosine pulses, from energies, moments and initial values."""
import functools

import sympy as sp
from rederive import Paper, cite, derived, step, taylor

paper = Paper("zhang-makris-2001")
m, g, R, I_o, alpha, theta, ground, p, before, after = paper.symbols("m g R I_o alpha theta uddot_g p thetadot_1 thetadot_2")
a_p, psi, omega_p, t, A_1, A_2, A_3, A_4 = paper.symbols("a_p psi omega_p t A_1 A_2 A_3 A_4")
theta_0, thetadot_0, speed = paper.symbols("theta_0 thetadot_0 udot_g")
sine, cosine = a_p*sp.sin(omega_p*t + psi), a_p*sp.cos(omega_p*t)


def root_of(linear, unknown):
    """Returns the value of `unknown` at which an expression that is linear in it vanishes, term by term."""
    linear = sp.expand(linear)
    slope = linear.coeff(unknown, 1)
    return sp.Add(*(sp.factor(-term/slope) for term in sp.Add.make_args(linear.coeff(unknown, 0))))


@functools.cache
def kinetic(side):
    """Returns the kinetic energy of a block that turns about its corner on this side, -1 or 1: about the centre, and of it."""
    lean = side*alpha - theta  # of the line from the corner to the centre
    x_rate, y_rate = speed + R*sp.cos(lean)*theta.dot, R*sp.sin(lean)*theta.dot
    return (I_o - m*R**2)*theta.dot**2/2 + m*(x_rate**2 + y_rate**2)/2


@functools.cache
def acceleration(side):
    """Returns thetaddot of a block that turns about its corner on this side."""
    potential = m*g*R*sp.cos(side*alpha - theta)
    lagrange = paper.lagrange(kinetic(side) - potential, theta) + ground*kinetic(side).diff(theta.dot).diff(speed)
    squares = sp.expand(lagrange).subs(sp.cos(side*alpha - theta)**2, 1 - sp.sin(side*alpha - theta)**2)
    return root_of(squares, theta.ddot)


@functools.cache
def about_corner():
    """Returns the moment of inertia of the block about a corner, with half the diagonal for its sides."""
    x, y, b = sp.symbols("x y b", positive=True)
    h = sp.sqrt(R**2 - b**2)
    return sp.expand(sp.integrate(sp.expand(sp.integrate((x**2 + y**2)*m/(4*b*h), (x, 0, 2*b))), (y, 0, 2*h)))


def sized(side):
    """Returns thetaddot with p in the place of the size of the block."""
    return sp.expand(acceleration(side).subs(I_o, about_corner()).subs(R, 3*g/(4*p**2)))


@functools.cache
def small(side, pulse):
    """Returns thetaddot to the first order in theta, alpha and the pulse in units of g."""
    scale = sp.Symbol("scale")
    linear = taylor(sized(side).subs(ground, scale*ground), [theta, alpha, scale], 1)
    return sp.expand(linear).subs({scale: 1, ground: pulse})


def course(side, pulse, sinh, cosh):
    """Returns the general theta(t) under a pulse, with these factors of sinh and cosh."""
    wave, e = pulse/a_p, sp.Symbol("e")
    ansatz = sinh*sp.sinh(p*t) + cosh*sp.cosh(p*t) + side*alpha + e*wave
    left_over = sp.expand(ansatz.diff(t, 2) - small(side, pulse).subs(theta, ansatz))
    forced = root_of(left_over.coeff(wave), e)
    if sp.simplify(left_over.subs(e, forced)) != 0:
        raise ValueError("the ansatz does not solve the equation of motion")
    return ansatz.subs(e, forced)


def growing(of, end, decay, wave):
    """Returns p*(theta - balance) + thetadot at the end of a pulse, times decay, for a motion with the time t in sinh and cosh.

    No part of the free motion that follows grows if this is zero. `decay` stands for exp(-p*end), and `wave` says which
    values the pulse and its slope have at the end.
    """
    terms = sp.expand(of)
    rest = terms.coeff(sp.sinh(p*t), 0).coeff(sp.cosh(p*t), 0)
    above_balance = rest - rest.subs(a_p, 0)
    return p*(terms.coeff(sp.sinh(p*t)) + terms.coeff(sp.cosh(p*t))) + decay*(p*above_balance + rest.diff(t)).subs(wave)


def derived_on(side):
    return derived(theta.ddot, acceleration(side),
                   step("The block turns about its centre, and the centre moves with the ground and about the corner. Its kinetic energy is",
                        sp.Symbol("K"), kinetic(side)),
                   step("The potential of the weight is", sp.Symbol("V"), m*g*R*sp.cos(side*alpha - theta)),
                   step("Put both into Lagrange's equation, and $uddot_g$ for the rate of $udot_g$"))


@paper.row("1")
def to_negative():
    return derived_on(-1)


@paper.row("2")
def to_positive():
    return derived_on(1)


@paper.row("3")
def frequency():
    return derived(p, sp.sqrt(m*g*R/about_corner()),
                   step("Integrate the squared distance from a corner over the block", I_o, about_corner()),
                   step("The moment of the weight over the moment of inertia is", p**2, m*g*R/I_o))


@paper.row("4")
def both_sides():
    side = sp.Symbol("side")
    return derived(theta.ddot, sized(side).subs(side, theta/sp.Abs(theta)),
                   cite("1", "To the one side #"), cite("2", "and to the other #"),
                   cite("3", "The two differ in the sign of $alpha$, which is that of $theta$. Put in #"))


@paper.row("5")
def impact():
    b, h = R*sp.sin(alpha), R*sp.cos(alpha)
    velocity = sp.Matrix([0, 0, before]).cross(sp.Matrix([b, h, 0]))
    moving = m*sp.Matrix([-b, h, 0]).cross(velocity)[2]
    total = (about_corner() - m*R**2)*before + moving
    rate = sp.expand(total/about_corner()/before).subs(sp.cos(alpha)**2, 1 - sp.sin(alpha)**2)
    return derived((after/before)**2, sp.factor(sp.expand(rate))**2,
                   step("About the new corner, the angular momentum is kept. Before the impact it is", I_o*after, total),
                   step("After the impact the block turns about that corner itself, with", I_o, about_corner()),
                   step("Divide", after/before, sp.expand(rate)))


@paper.row("6")
def phase():
    # the block is at rest at theta = 0: to the negative side it begins where its acceleration passes through zero
    start = small(-1, sine).subs({t: 0, theta: 0}, simultaneous=True)
    level = root_of(start, sp.sin(psi))
    return derived(psi, sp.asin(level), step("Upright, a slender block has to the negative side the acceleration", theta.ddot, start),
                   step("It begins to rock where this passes through zero", sp.sin(psi), level))


@paper.row("7")
def sine_to_negative():
    return derived(theta, course(-1, sine, A_1, A_2), step("To the first order, below zero,", theta.ddot, small(-1, sine)),
                   step("A sum of sinh, cosh and the sine solves it"))


@paper.row("8")
def sine_to_positive():
    return derived(theta, course(1, sine, A_3, A_4), step("To the first order, above zero,", theta.ddot, small(1, sine)),
                   step("A sum of sinh, cosh and the sine solves it"))


@paper.row("9")
def rate_at_first():
    start = sine_to_negative().right.diff(t).subs(t, 0)
    return derived(A_1, root_of(start - thetadot_0, A_1), cite("7", "Differentiate # and put the time zero"),
                   step("The rate is then", thetadot_0, start))


@paper.row("10")
def angle_at_first():
    start = sine_to_negative().right.subs(t, 0)
    return derived(A_2, root_of(start - theta_0, A_2), cite("7", "Put the time zero into #"), step("The angle is then", theta_0, start))


@paper.row("11")
def angle_at_first_to_positive():
    start = sine_to_positive().right.subs(t, 0)
    return derived(A_4, root_of(start - theta_0, A_4), cite("8", "Put the time zero into #"), step("The angle is then", theta_0, start))


@paper.row("12")
def without_impact():
    from_rest = {theta_0: 0, thetadot_0: 0}
    of = sine_to_negative().right.subs({A_1: rate_at_first().right.subs(from_rest), A_2: angle_at_first().right.subs(from_rest)})
    end, cos, decay = (2*sp.pi - psi)/omega_p, sp.Symbol("cos"), sp.Symbol("decay")
    ends = growing(of, end, decay, {sp.sin(omega_p*t + psi): 0, sp.cos(omega_p*t + psi): 1}).subs(a_p, alpha*g/sp.sin(psi))
    found = root_of(sp.factor(ends.subs(sp.cos(psi), cos)), cos)
    return derived(sp.cos(psi), found.subs(decay, sp.exp(-p*end)), cite("7", "The block begins at rest. Then #"),
                   cite("9", "has the factors #"), cite("10", "and #"),
                   step("The pulse ends at $t = (2*pi - psi)/omega_p$. From there the block just reaches the balance if no part of its motion grows",
                        theta.dot + p*(theta + alpha), 0),
                   cite("6", "The amplitude follows from #"))


@paper.row("13")
def cosine_to_negative():
    return derived(theta, course(-1, cosine, A_1, A_2), step("To the first order, below zero,", theta.ddot, small(-1, cosine)),
                   step("A sum of sinh, cosh and the cosine solves it"))


@paper.row("r1")
def cosine_without_impact():
    of = cosine_to_negative().right
    cosh, sinh = root_of(of.subs(t, 0), A_2), root_of(of.diff(t).subs(t, 0), A_1)
    end, decay = 2*sp.pi/omega_p, sp.Symbol("decay")
    ends = growing(of.subs({A_1: sinh, A_2: cosh}), end, decay, {sp.sin(omega_p*t): 0, sp.cos(omega_p*t): 1})
    return derived(a_p, root_of(ends, a_p).subs(decay, sp.exp(-p*end)),
                   cite("13", "Take # from rest"), step("The factor of the sinh vanishes, and that of the cosh is", A_2, cosh),
                   step("At $t = 2*pi/omega_p$ the pulse ends. From there no part of the motion may grow", theta.dot + p*(theta + alpha), 0),
                   step("This is linear in the amplitude"))
