"""Housner's equations of the rocking block, from energies, moments and initial values."""
import sympy as sp
from rederive import Paper, cite, derived, step, taylor

paper = Paper("housner-1963")
m, g, W, R, I_o, alpha, theta, p, b, h, t = paper.symbols("m g W R I_o alpha theta p b h t")
theta_0, T, r, before, after = paper.symbols("theta_0 T r thetadot_1 thetadot_2")
n, phi_0, phi_n, T_n, a, t_1, omega, psi = paper.symbols("n phi_0 phi_n T_n a t_1 omega psi")


def root_of(linear, unknown):
    """Returns the value of `unknown` at which an expression that is linear in it vanishes."""
    linear = sp.expand(linear)
    return sp.factor(-linear.coeff(unknown, 0)/linear.coeff(unknown, 1))


def course_of(acceleration, start, rate, forced=sp.S.Zero):
    """Returns theta(t) with theta(0) = start and thetadot(0) = rate, and its coefficients of sinh, cosh and `forced`.

    `acceleration` is p^2*theta, a constant, and a multiple of `forced`, a sine of the time.
    """
    e = sp.Symbol("e")
    ansatz = e*forced - sp.expand(acceleration.subs(theta, 0).subs(forced, 0)/p**2)
    left_over = ansatz.diff(t, 2) - acceleration.subs(theta, ansatz)
    if forced != 0:
        e = root_of(sp.expand(left_over).coeff(forced), e)
        ansatz, left_over = ansatz.subs("e", e), left_over.subs("e", e)
    if sp.simplify(left_over) != 0:
        raise ValueError("the ansatz does not solve the equation of motion")
    cosh, sinh = start - ansatz.subs(t, 0), (rate - ansatz.diff(t).subs(t, 0))/p
    return ansatz + cosh*sp.cosh(p*t) + sinh*sp.sinh(p*t), [sinh, cosh, e]


def acceleration_on(ground):
    """Returns thetaddot, to the first order, of a block whose ground accelerates away from the corner on which it turns.

    Seen from the ground, the force of inertia m*ground acts at C as the weight does.
    """
    moment = m*g*(ground/g*R*sp.cos(alpha - theta) - R*sp.sin(alpha - theta))
    return first_order(moment/inertia().right, ground).subs(R, 3*g/(4*p**2))


def first_order(acceleration, ground=sp.S.Zero):
    """Returns it to the first order in theta, alpha and the acceleration of the ground in units of g."""
    scale = sp.Symbol("scale")
    return sp.expand(taylor(acceleration.subs(ground, scale*ground), [theta, alpha, scale], 1)).subs(scale, 1)


@paper.row("1")
def motion():
    kinetic, potential = I_o*theta.dot**2/2, W*R*(sp.cos(alpha - theta) - sp.cos(alpha))
    lagrange = paper.lagrange(kinetic - potential, theta)
    return derived(theta.ddot, root_of(lagrange, theta.ddot),
                   step("The centre C is at the distance $R$ from the corner, and has risen by $R*(cos(alpha - theta) - cos(alpha))$"),
                   step("Lagrange's equation with this potential", lagrange, 0))


@paper.row("2")
def slender_motion():
    linear = first_order(motion().right)
    return derived(theta.ddot, linear.subs(W, p**2*I_o/R), cite("1", "Begin with #"),
                   step("To the first order in $theta$ and $alpha$, which are small together", theta.ddot, linear),
                   step("Give the factor a name", p**2, W*R/I_o))


@paper.row("3")
def inertia():
    x, y = sp.symbols("x y")
    over_block = sp.integrate((x**2 + y**2)*m/(4*b*h), (x, 0, 2*b), (y, 0, 2*h))
    about_corner = sp.expand(over_block).subs(h, sp.sqrt(R**2 - b**2))
    return derived(I_o, sp.expand(about_corner),
                   step("Integrate the squared distance from the corner over the block", I_o, sp.expand(over_block)),
                   step("$R$ is half the diagonal", R**2, b**2 + h**2))


@paper.row("4")
def size():
    return derived(p, sp.sqrt(m*g*R/inertia().right), step("The weight is $W = m*g$", p**2, m*g*R/I_o),
                   cite("3", "The moment of inertia is #"))


@paper.row("5")
def free_rocking():
    course, _ = course_of(slender_motion().right, theta_0, 0)
    return derived(theta, course, cite("2", "Solve # with a sum of sinh and cosh"),
                   step("The block is let go at $theta_0$, at rest"))


@paper.row("6")
def first_impact():
    return derived(0, free_rocking().right.subs(t, T/4), cite("5", "Free rocking is #"),
                   step("The impact comes after a quarter of the period, and there the angle is zero", t, T/4))


@paper.row("7")
def period():
    cosh = sp.Symbol("cosh")
    found = root_of(first_impact().right.subs(sp.cosh(p*T/4), cosh), cosh)
    return derived(T, 4*sp.acosh(found)/p, cite("6", "The condition # is linear in the cosh"),
                   step("It gives", sp.cosh(p*T/4), found))


@paper.row("8")
def energy_left():
    def kinetic(rate):
        return I_o*rate**2/2
    return derived(r, kinetic(after)/kinetic(before),
                   step("Before and after, the block turns about a corner, with the same moment of inertia"),
                   step("Divide the kinetic energies", r, (I_o*after**2/2)/(I_o*before**2/2)))


@paper.row("9")
def momentum():
    to_centre, from_old_corner = sp.Matrix([-b, h, 0]), sp.Matrix([b, h, 0])  # from the new corner, and from the old one
    velocity = sp.Matrix([0, 0, before]).cross(from_old_corner)
    moving = sp.expand(m*to_centre.cross(velocity)[2])
    total = sp.expand(((I_o - m*R**2)*before + moving).subs(h, sp.sqrt(R**2 - b**2)))
    kept = total.subs(b**2, b*R*sp.sin(alpha))
    return derived(after, sp.expand(kept/I_o),
                   step("The force of the impact has no moment about the new corner: the angular momentum about it is kept"),
                   step("Before, it is that of the turning about C, and that of the mass that moves with C",
                        I_o*after, (I_o - m*R**2)*before + moving),
                   step("With $R^2 = b^2 + h^2$ this is", I_o*after, total), step("One factor $b$ is $R*sin(alpha)$"))


@paper.row("10")
def energy_by_shape():
    ratio = sp.expand(momentum().right.subs(b, R*sp.sin(alpha))/before)
    return derived(r, ratio**2, cite("8", "Put into #"), cite("9", "the rate after the impact, by #"),
                   step("The ratio of the rates is", after/before, ratio))


@paper.row("11")
def energy_of_rectangle():
    return derived(r, energy_by_shape().right.subs(I_o, inertia().right),
                   cite("10", "In general #"), cite("3", "and for a block #"))


@paper.row("12")
def amplitude():
    phi, start = sp.symbols("phi start")
    kept = theta.dot**2/2 - sp.integrate(slender_motion().right, theta)  # its rate is zero
    struck = root_of(kept.subs(theta, 0) - kept.subs({theta.dot: 0, theta: alpha*phi}), theta.dot**2)
    energy = sp.expand(struck/(p*alpha)**2)
    u = sp.Function("u")
    after_n = sp.rsolve(u(n + 1) - r*u(n), u(n), {u(0): start}).subs(start, energy.subs(phi, phi_0))
    root = min(sp.solve(energy - start, phi), key=lambda one: one.subs(start, sp.Rational(1, 2)))
    return derived(phi_n, root.subs(start, after_n),
                   step("A slender block keeps $thetadot^2/2 - p^2*theta^2/2 + p^2*alpha*theta$ while it swings. From rest at $alpha*phi_0$ it strikes with",
                        theta.dot**2, struck.subs(phi, phi_0)),
                   step("Each impact leaves the part $r$ of it. So after $n$ impacts", energy.subs(phi, phi_n), after_n),
                   step("Of the two roots, one is beyond the balance. Take the other"))


@paper.row("13")
def period_after():
    speed = sp.sqrt(sp.expand(1 - (1 - amplitude().right)**2))
    course, _ = course_of(slender_motion().right, 0, p*alpha*speed)
    rate = sp.expand(course.diff(t))
    turning = -rate.coeff(sp.cosh(p*t))/rate.coeff(sp.sinh(p*t))
    return derived(T_n, 4*sp.atanh(turning)/p, cite("12", "To swing out to #"),
                   step("the block begins with the rate", theta.dot, p*alpha*speed),
                   step("It turns where its rate is zero, after a quarter of the period", sp.tanh(p*T_n/4), turning))


@paper.row("14")
def beginning():
    push, weight = m*a*h, m*g*b
    return derived(push/(m*g*h), weight/(m*g*h), step("About the corner, the force of inertia $m*a$ has the arm $h$, and the weight has the arm $b$"),
                   step("The block begins to rock if the first moment is the greater one", push, weight, relation=">"), relation=">")


@paper.row("15")
def constant_pulse():
    return derived(theta.ddot, acceleration_on(a),
                   step("Seen from the ground, the force of inertia raises the block, and its weight turns it back",
                        I_o*theta.ddot, m*a*R*sp.cos(alpha - theta) - m*g*R*sp.sin(alpha - theta)),
                   cite("4", "To the first order in $theta$, $alpha$ and $a/g$, with #"))


@paper.row("16")
def pushed_course():
    course, _ = course_of(constant_pulse().right, 0, 0)
    return derived(theta, course, cite("15", "Solve # from rest, with a sum of sinh and cosh"))


@paper.row("17")
def shortest_pulse():
    cosh = sp.Symbol("cosh")
    course = pushed_course().right.subs(t, t_1)
    slope = course.diff(t_1)
    reached = course.subs(sp.cosh(p*t_1), cosh)
    squared_rate = (slope**2).subs(sp.sinh(p*t_1), sp.sqrt(cosh**2 - 1))
    found = root_of(squared_rate - p**2*(alpha - reached)**2, cosh)
    return derived(sp.cosh(p*t_1), found, cite("16", "The pulse lifts the block by #"),
                   step("and leaves it the rate", theta.dot, slope),
                   step("It just reaches the balance if its energy is that of a block at rest there", theta.dot**2, p**2*(alpha - theta)**2),
                   step("The squares of the cosh cancel, and the condition is linear in it"))


@paper.row("18")
def sine_pulse():
    return derived(theta.ddot, acceleration_on(a).subs(a, a*sp.sin(omega*t + psi)),
                   cite("15", "As #, with an acceleration that is a sine of the time"))


def sine_motion():
    """Returns the motion of row 19, and its coefficients of sinh, cosh and the sine."""
    course, constants = course_of(sine_pulse().right, 0, 0, sp.sin(omega*t + psi))
    return [sp.expand(course).collect([sp.sinh(p*t), sp.cosh(p*t), sp.sin(omega*t + psi)], sp.factor).subs(a, g*alpha/sp.sin(psi)),
            *(sp.factor(one.subs(a, g*alpha/sp.sin(psi))) for one in constants)]


@paper.row("19")
def sine_course():
    return derived(theta, sine_motion()[0], cite("18", "A sum of sinh, cosh and the sine solves #"),
                   step("It begins at zero, at rest, when the acceleration is just enough", a*sp.sin(psi), g*alpha))


@paper.row("20")
def least_amplitude():
    _, sinh, cosh, sine = sine_motion()
    phase, cot, decay = sp.pi, sp.Symbol("cot"), sp.Symbol("decay")
    end = (phase - psi)/omega
    # p*(theta - alpha) + thetadot at the end, times decay: sinh and cosh are together the growing exponential
    growing = p*(sinh + cosh) + decay*(p*sine*sp.sin(phase) + omega*sine*sp.cos(phase))
    condition = sp.factor(growing.subs(sp.cos(psi), cot*sp.sin(psi)))
    cotangent = sp.expand(root_of(condition, cot)).subs(decay, sp.exp(-p*end))
    amplitude = g*alpha*sp.sqrt(1 + cotangent**2)
    return derived(a, amplitude, cite("19", "The pulse ends with half a sine. Take # and its rate at $t = (pi - psi)/omega$"),
                   step("The free motion that follows just reaches the balance if it has no growing part", theta.dot, p*(alpha - theta)),
                   step("This is linear in the cotangent", sp.cot(psi), cotangent),
                   step("The amplitude is $g*alpha/sin(psi)$, and one over the square of the sine is one more than the square of the cotangent"),
                   given={psi: sp.asin(g*alpha/a)})
