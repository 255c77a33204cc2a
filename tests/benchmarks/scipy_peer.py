"""SciPy's solve_ivp (DOP853, events) on the cells of FOLDER/cells.csv: a row of the table of maps."""
import csv
import math
import sys
import time

from scipy.integrate import solve_ivp

ALPHA, RESTITUTION = 0.25, 1 - 1.5 * math.sin(0.25) ** 2


def code(omega, amplitude, tolerance=1e-9):
    """Equations (21a,b) with p = 1 under a one-sine pulse from rest, decided by energy when it is over."""
    peak, level = ALPHA * amplitude, math.tan(ALPHA)
    if peak <= level:
        return 0
    psi = math.asin(level / peak)
    t, end, y, side, impacts = 0.0, (2 * math.pi - psi) / omega, [0.0, 0.0], -1, 0

    def rates(time, state):
        lean = side * ALPHA - state[0]
        ground = peak * math.sin(omega * time + psi)
        return [state[1], -math.sin(lean) - ground * math.cos(lean)]

    def upright(time, state):
        return side * state[0]

    def lies(time, state):
        return math.pi / 2 - side * state[0]

    upright.terminal = lies.terminal = True
    upright.direction = -1
    while True:
        found = solve_ivp(rates, (t, end), y, "DOP853", rtol=tolerance, atol=ALPHA * tolerance, events=[upright, lies])
        t, y = found.t[-1], [found.y[0][-1], found.y[1][-1]]
        if len(found.t_events[1]):
            return side * (impacts + 1)
        if not len(found.t_events[0]):
            break
        if abs(y[1]) < 1e-3 * ALPHA:
            return 0
        y, side, impacts = [0.0, RESTITUTION * y[1]], -side, impacts + 1
    lean, speed = ALPHA - side * y[0], side * y[1]
    barrier = 2 * (1 - math.cos(ALPHA))  # thetadot^2 from upright to the corner
    energy = speed**2 - 2 * (math.cos(ALPHA) - math.cos(lean))  # thetadot^2 at upright
    outward = speed > 0 and (lean < 0 or energy > barrier)
    if outward or (lean < 0 and energy < barrier):
        return side * (impacts + 1)
    return -side * (impacts + 2) if RESTITUTION**2 * energy > barrier else 0


cells = [(float(w), float(a), int(c)) for w, a, c in csv.reader(open(sys.argv[1] + "/cells.csv"))]
begin = time.perf_counter()
codes = [code(omega, amplitude) for omega, amplitude, _ in cells]
rate = len(cells) / (time.perf_counter() - begin)
differing = sum(found != cell[2] for found, cell in zip(codes, cells))
print(f"| nonlinear map, 1e-09 | SciPy DOP853, 1e-09 | {rate:.0f} | | {differing} |")
