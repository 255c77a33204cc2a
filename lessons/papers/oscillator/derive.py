"""A mass on a spring with a damper: free, damped and forced."""
import functools

import sympy as sp

from rederive import Paper, cite, derived, step

paper = Paper()
m, k, c, x, t, x_0, v_0, omega_0 = paper.symbols("m k c x t x_0 v_0 omega_0")
zeta, omega_d, delta, F_0, Omega, r, V = paper.symbols("zeta omega_d delta F_0 Omega r V")
A, B, decay = sp.symbols("A B decay")  # constants of a trial solution
of_ratio = {k: m*omega_0**2, c: 2*zeta*m*omega_0}


def motion(force=0, damping=c):
    """The acceleration by Lagrange's equation, with Rayleigh's function for the damper."""
    equation = paper.lagrange(m*x.dot**2/2 - k*x**2/2, x, force=force, dissipation=damping*x.dot**2/2)
    return sp.expand(sp.solve(equation, x.ddot)[0].subs(of_ratio))


def left_over(trial, acceleration):
    """What is left if a trial solution is put into an equation of motion: 0 if it is a solution."""
    return sp.expand(trial.diff(t, 2) - acceleration.subs({x.dot: trial.diff(t), x: trial}))


def from_start(trial):
    """The trial solution with the constants A and B that give x_0 and v_0 at the time 0."""
    return trial.subs(sp.solve([trial.subs(t, 0) - x_0, trial.diff(t).subs(t, 0) - v_0], [A, B]))


@paper.row("1")
def undamped():
    return derived(x.ddot, motion(damping=0),
                   step("Write Lagrange's equation of $x$, with the energies $m*xdot^2/2$ and $k*x^2/2$"),
                   step("Put in $k = m*omega_0^2$"))


@paper.row("2")
def free():
    trial = A*sp.cos(omega_0*t) + B*sp.sin(omega_0*t)
    assert left_over(trial, undamped().right) == 0
    return derived(x, from_start(trial), cite("1", "A sum of a cosine and a sine of $omega_0*t$ solves #"),
                   step("Choose the two amplitudes so that $x = x_0$ and $xdot = v_0$ at $t = 0$"))


@paper.row("3")
def damped():
    return derived(x.ddot, motion(),
                   step("Add to Lagrange's equation Rayleigh's function of the damper, $c*xdot^2/2$"),
                   step("Put in $k = m*omega_0^2$ and $c = 2*zeta*m*omega_0$"))


@functools.cache
def damped_trial():
    """The trial solution, with the decay and the frequency that the equation of motion asks for."""
    trial = sp.exp(-decay*t)*(A*sp.cos(omega_d*t) + B*sp.sin(omega_d*t))
    rest = sp.expand(left_over(trial, damped().right)*sp.exp(decay*t))
    of_cosine, of_sine = (rest.coeff(f(omega_d*t)) for f in (sp.cos, sp.sin))
    rate = sp.solve(sp.expand(of_cosine.coeff(B)), decay)[0]
    square = sp.solve(of_cosine.coeff(A).subs(decay, rate), omega_d**2)[0]
    assert sp.expand(of_sine.subs(decay, rate).subs(omega_d**2, square)) == 0
    return trial.subs(decay, rate), sp.factor_terms(square)


@paper.row("4")
def damped_frequency():
    square = damped_trial()[1]
    return derived(omega_d, sp.sqrt(square),
                   cite("3", "Put an exponential function times a sum of a cosine and a sine of $omega_d*t$ into #"),
                   step("The cosine with the amplitude of the sine vanishes if the first factor is $exp(-zeta*omega_0*t)$"),
                   step("All other terms vanish if", omega_d**2, square))


@paper.row("5")
def damped_motion():
    return derived(x, from_start(damped_trial()[0]), cite("4", "Take the decaying cosine and sine of the frequency of #"),
                   step("Choose the two amplitudes so that $x = x_0$ and $xdot = v_0$ at $t = 0$"),
                   given={omega_d: damped_frequency().right})


@paper.row("6")
def decrement():
    later = damped_motion().right.subs(t, t + 2*sp.pi/omega_d)
    ratio = sp.simplify(damped_motion().right/later)
    logarithm = sp.log(ratio).expand(force=True)
    return derived(delta, logarithm.subs(omega_d, damped_frequency().right),
                   cite("5", "Divide # by what it is after the time $2*pi/omega_d$"),
                   step("The cosine and the sine are the same as before; the logarithm of the rest is", delta, logarithm),
                   cite("4", "Put in #"))


@paper.row("7")
def magnification():
    trial = A*sp.cos(Omega*t) + B*sp.sin(Omega*t)
    rest = left_over(trial, motion(force=F_0*sp.cos(Omega*t)))
    found = sp.solve([rest.coeff(f(Omega*t)) for f in (sp.cos, sp.sin)], [A, B])
    square = sp.factor((found[A]**2 + found[B]**2).subs(Omega, r*omega_0)*(m*omega_0**2/F_0)**2)
    return derived(V, 1/sp.sqrt(1/square), cite("3", "Add the force $F_0*cos(Omega*t)/m$ to the right side of #"),
                   step("Put a cosine and a sine of $Omega*t$ in for $x$, and solve for the two amplitudes"),
                   step("The sum of their squares, in proportion to $(F_0/k)^2$, with $Omega = r*omega_0$", V**2, square))


@paper.row("8")
def resonance():
    below = magnification().right**-2
    slope = sp.factor(below.diff(r))
    return derived(r, sp.sqrt(sp.solve(slope/r, r**2)[0]),
                   cite("7", "The amplitude is largest where the sum under the root of # is least"),
                   step("There its derivative by $r$ is 0", slope, 0))
