"""The proved equations of the ledger in SymPy and Maxima, and the whole ledger beside them: rows of a table.

What is printed less what is derived is to be recognised as 0; start-up is not counted. The ledger's time is that
of deriving, proving and refuting every row, from its start to its end.
"""
import json
import re
import signal
import subprocess
import sys
import tempfile
import time

import sympy

MOST_SECONDS = 10  # for one statement: then it counts as not proved


def rows(document):
    for row in document["equations"]:
        sides = [row[kind].split(" = ") if row[kind] else [] for kind in ("printed", "derived")]
        plain = not re.search(r"d/dt|d_|partial|integral|iint|[\[\]∂∫'<>]", str(row["printed"]) + str(row["derived"]))
        if row["verdict"] == "proved" and row["factor"] == "1" and plain and all(len(pair) == 2 for pair in sides):
            yield row["id"], "({}) - ({}) - (({}) - ({}))".format(*sides[0], *sides[1])


def geometry(text):
    """b and h by R and alpha, as the derivations have them."""
    for name, value in (("b", "(R*sin(alpha))"), ("h", "(R*cos(alpha))")):
        text = re.sub(rf"\b{name}\b", value, text)
    return text


def by_sympy(statements):
    names = {name: sympy.Symbol(name, positive=True) for text in statements
             for name in re.findall(r"[A-Za-z_]\w*(?!\w*\()", text) if not hasattr(sympy, name) or len(name) == 1
             or name in ("alpha", "beta", "gamma", "psi", "theta", "lambda", "zeta")}
    parsed = [sympy.sympify(text.replace("^", "**").replace("lambda", "lambda_"),
                            locals={name.replace("lambda", "lambda_"): s for name, s in names.items()})
              for text in statements]
    begin, left = time.perf_counter(), 0
    for difference in parsed:
        signal.alarm(MOST_SECONDS)
        try:
            left += sympy.simplify(difference) != 0
        except TimeoutError:
            left += 1
        signal.alarm(0)
    return time.perf_counter() - begin, left


def give_up(*_):
    raise TimeoutError


def by_maxima(statements):
    lines = ["begin: elapsed_real_time()$", "left: 0$"]
    for text in statements:
        text = re.sub(r"\blambda\b", "lambda_", text)
        lines.append(f"if errcatch(is(ratsimp(exponentialize({text})) = 0)) # [true] and "
                     f"errcatch(is(trigsimp(trigexpand({text})) = 0)) # [true] then left: left + 1$")
    lines.append('print("RESULT", elapsed_real_time() - begin, left)$')
    with tempfile.NamedTemporaryFile("w", suffix=".mac") as file:
        file.write("\n".join(lines) + "\n")
        file.flush()
        out = subprocess.run(["maxima", "--very-quiet", "--batch=" + file.name], capture_output=True, text=True).stdout
    seconds, left = re.findall(r"^RESULT (\S+) (\d+)", out, re.M)[-1]
    return float(seconds), int(left)


def whole_ledger(program):
    begin = time.perf_counter()
    out = subprocess.run([program, "--json"], capture_output=True, text=True).stdout
    return time.perf_counter() - begin, json.loads(out)


signal.signal(signal.SIGALRM, give_up)
program = sys.argv[1]
times = []
for _ in range(3):
    seconds, document = whole_ledger(program)
    times.append(seconds)
statements = [geometry(text) for _, text in rows(document)]
print(f"| {len(document['equations'])} rows, derived and judged | this | {sorted(times)[1]:.2f} | |")
for name, prove in (("SymPy", by_sympy), ("Maxima", by_maxima)):
    seconds, left = prove(statements)
    print(f"| {len(statements)} of them, printed less derived | {name} | {seconds:.2f} | {left} |")
