"""Derives the rows of a paper and writes the derivations down: python3 -m rederive.derive DIR"""
from __future__ import annotations

import argparse
import contextlib
import json
import os
import sys
import types
from pathlib import Path

_ABOUT = """Runs DIR/derive.py and writes what it derives to DIR/derivations.json, which the programs read.

derive.py makes a Paper and a function for each row:

  from rederive import Paper, derived, step
  paper = Paper()
  m, L, J, x = paper.symbols("m L J x")

  @paper.row("1")
  def moment_of_inertia():
      inertia = sympy.integrate(x**2 * m/L, (x, 0, L))
      return derived(J, inertia, step("Integrate over the mass of all elements"))

derive.py is one file: it does not import other files of its folder. Whatever it prints goes to standard error.
A derivation that fails is named on standard error, and makes an error of its row alone."""
_EXIT = "Exit codes: 0 = written, also if some derivations failed; 2 = bad usage, or files that cannot be used or written."


def digest_of(data: bytes) -> str:
    """Returns the hash by which the programs see whether derivations.json is current: FNV-1a, 64 bits."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def write_whole(file: Path, text: str) -> None:
    """Writes a file whole or not at all."""
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        beside.write_text(text, encoding="utf-8")
        beside.replace(file)
    except OSError as error:
        raise ValueError(f"{file}: {error.strerror}") from None
    finally:
        beside.unlink(missing_ok=True)


def derive(folder: str | Path) -> dict[str, str]:
    """Derives all rows of the paper in a folder, and writes derivations.json there, whole or not at all.

    Returns the errors of single rows, by id. Raises ValueError, with the file and the line, for what cannot be used.
    """
    from ._paper import BadPaper, Paper, described, place_in  # not before: SymPy takes half a second

    folder = Path(folder).resolve()
    file = folder / "derive.py"
    for needed in (folder / "paper.toml", file):
        if not needed.is_file():
            raise BadPaper(f"{needed}: there is no such file")
    source = file.read_bytes()
    digest = digest_of((folder / "paper.toml").read_bytes() + source)
    module = types.ModuleType("derive")
    module.__file__ = str(file)
    sys.modules["derive"] = module
    try:
        exec(compile(source, str(file), "exec"), module.__dict__)  # an import would leave a __pycache__
    except BadPaper:
        raise
    except (Exception, SystemExit) as error:
        raise BadPaper(f"{folder / place_in(str(file), error)}: {described(error)}") from None
    papers = {id(value): value for value in vars(module).values() if isinstance(value, Paper)}
    if len(papers) != 1:
        raise BadPaper(f"{file}: it must make one paper, paper = Paper(), and makes {len(papers)}")
    rows = papers.popitem()[1].rows_as_data()
    document = {"format": 1, "digest": digest, "derivations": rows}
    write_whole(folder / "derivations.json", json.dumps(document, ensure_ascii=False, indent=1) + "\n")
    return {row: found["error"] for row, found in rows.items() if "error" in found}


def main() -> int:
    parser = argparse.ArgumentParser("python3 -m rederive.derive", description=_ABOUT, epilog=_EXIT,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", help="the folder of the paper")
    folder = parser.parse_args().folder
    if sys.flags.hash_randomization and os.environ.get("PYTHONHASHSEED") != "0":
        # SymPy's order of terms may follow Python's hashes: without this the bytes could differ from run to run.
        os.execve(sys.executable, sys.orig_argv, os.environ | {"PYTHONHASHSEED": "0"})
    try:
        with contextlib.redirect_stdout(sys.stderr):
            errors = derive(folder)
    except (ValueError, ImportError) as error:
        print(f"rederive.derive: {error}", file=sys.stderr)
        return 2
    for row, error in errors.items():
        print(f"rederive.derive: row {row}: {error}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
