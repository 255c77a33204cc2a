#!/usr/bin/env python3
"""Checks that each slip can be planted, and that braces, environments and $ of the manuscripts close."""
import json
import pathlib
import re
import sys
import tomllib

FOLDER = pathlib.Path(__file__).parent
KINDS = {"sign", "coefficient", "function", "square", "factor", "term", "symbol", "dot", "relation_sign"}


def faults_of_slips():
    """Yields what is wrong with slips.toml."""
    for slip in tomllib.loads((FOLDER / "slips.toml").read_text())["slip"]:
        place = f"{slip['file']}:{slip['line']}"
        text = (FOLDER / slip["file"]).read_text().split("\n")[slip["line"] - 1]
        if text.count(slip["find"]) != 1:
            yield f"{place}: {slip['find']!r} is there {text.count(slip['find'])} times, not once"
        if slip["kind"] not in KINDS or slip["find"] == slip["replace"]:
            yield f"{place}: the kind is unknown, or nothing changes"


def text_of(path):
    """Returns the text of a manuscript, the Markdown cells of a notebook, without comments."""
    text = path.read_text()
    if path.suffix == ".ipynb":
        cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
    return re.sub(r"(?<!\\)%.*", "", text)


def faults_of(path):
    """Yields what does not close in a manuscript."""
    text = text_of(path)
    plain = re.sub(r"\\[{}]", "", text)
    if plain.count("{") != plain.count("}"):
        yield f"{path.name}: {plain.count('{')} opening and {plain.count('}')} closing braces"
    if len(re.findall(r"\\left(?![a-z])", text)) != len(re.findall(r"\\right(?![a-z])", text)):
        yield f"{path.name}: \\left and \\right do not match"
    if text.count("$") % 2 or text.count("\\[") - len(re.findall(r"\\\\\[", text)) != text.count("\\]"):
        yield f"{path.name}: $ or \\[ does not close"
    stack = []
    for word, name in re.findall(r"\\(begin|end)\{([a-zA-Z]+\*?)\}", text):
        if word == "begin":
            stack.append(name)
        elif not stack or stack.pop() != name:
            yield f"{path.name}: \\end{{{name}}} ends another environment"
            return
    if stack:
        yield f"{path.name}: {stack[-1]} does not end"


def main():
    faults = list(faults_of_slips())
    for path in sorted(FOLDER.iterdir()):
        if path.suffix in {".tex", ".md", ".ipynb"} and path.name != "README.md":
            faults += faults_of(path)
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
