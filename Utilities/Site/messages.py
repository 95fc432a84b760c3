# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Collects the messages from the source, with `...` for each value, under the titles of the corresponding pages.

As a program, prints them. Some of them are explained in tables of the pages.
"""

import ast
import itertools
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import cpp_messages  # noqa: E402 -- beside this file

TREE = pathlib.Path(__file__).resolve().parents[2]
SHARED = "Several readers, writers or stages"
COMMAND, PACKAGE = "Report", "InPython"
# Stems and folders of files whose names differ from their pages.
PAGES = {stem: page for page, stems in {
    "HorizonExteriorBoundary": "Boundary BoundarySimplification",
    "HorizonTriangulation": "FaultClosing CrackData", "HorizonFaults": "CutData",
    "HorizonSources": "MapImage Gridding PickArrays HorizonFromPoints HorizonFromImage",
    "HorizonLayers": "HorizonStack LayerOutput HorizonCrossings", "HorizonSealedModel": "SealedModel",
    "HorizonText": "Survey", "Formats": "Writers HorizonDXF HorizonMesh",
    "SeismicReflectionExtraction": "Reflections ImageCube GuidePicks", "": "Parameters LatticeImage",
}.items() for stem in stems.split()}
# Python functions and exceptions that take messages.
TELLERS = ("HorizonError", "ValueError", "TypeError", "FileNotFoundError", "RuntimeError", "ArgumentTypeError", "error",
           "fail", "warn", "warnings.append")
PLACES = r"%\([^)]*\)[.\d]*[sdgf]|%[.\d]*[sdgf]"

def page_of(path):
    """Returns the page of a source file; empty for files that several pages share."""
    folder, stem = path.parent.name, path.stem.removeprefix("vtk")
    if stem in PAGES:
        return PAGES[stem]
    names = [stem, "Horizon" + stem, PAGES.get(folder)]
    if TREE / "Common" not in path.parents:
        names += ["Horizon" + folder, folder]
    return next((name for name in names if (TREE / "Documentation" / ("%s.md" % name)).is_file()), "")

def python_texts(node):
    """Returns the possible texts of an expression."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [re.sub(PLACES, "...", node.value).replace("%%", "%")]
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        return python_texts(node.left)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return [one + other for one in python_texts(node.left) for other in python_texts(node.right)]
    if isinstance(node, ast.IfExp):
        return python_texts(node.body) + python_texts(node.orelse)
    return ["..."]

def python_messages(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call) and node.args and ast.unparse(node.func).endswith(TELLERS):
            yield from python_texts(node.args[0])
        elif isinstance(node, ast.BinOp) or isinstance(node, ast.Assign):
            texts = python_texts(node.value if isinstance(node, ast.Assign) else node)
            yield from (text for text in texts if ", expected" in text)

def tidy(text):
    """Returns a message as users read it, without the leading position; None for other texts."""
    text = re.sub(r"\s+", " ", text.removesuffix(" (see --help)"))
    text = re.sub(r"\.{4,}", "...", re.sub(r"^(?=[ ,:.)])|(?<=[ ,:(])$", "...", text))
    text = re.sub(r"^\.\.\.(?=[\w\"])", "... ", re.sub(r"^((byte |line )?\.\.\.: )+", "", text))
    is_part = re.match(r"expected|(\.\.\.)?;", text) or re.search(r" (of|at) \.\.\.$", text) and "expected" not in text
    says = set(re.findall("[A-Za-z]{2,}", text))
    return None if is_part or len(says) < 2 or says <= {"expected", "to", "finite", "number", "at", "least"} else text

def cpp_paths():
    paths = itertools.chain(*((TREE / folder).rglob("*") for folder in ("Common", "Filters", "Sources", "Readers", "Writers")))
    # Users never see the messages of MeshChecker.
    return [path for path in sorted(paths) if path.suffix in (".h", ".cxx") and path.stem != "MeshChecker"]

def collect():
    """Returns the messages of each page: {page, or "" for shared messages: texts}."""
    model = (TREE / "Common" / "Horizon" / "DataModel.h").read_text("utf-8")
    constants = cpp_messages.named_texts(cpp_messages.tokens_of(model), {})
    found = {}
    for path in cpp_paths():
        for text in cpp_messages.messages_of(path.read_text("utf-8"), constants):
            found.setdefault(tidy(text), set()).add(page_of(path))
    for folder, page in (("seismichorizons_command", COMMAND), ("seismichorizons", PACKAGE)):
        for path in sorted((TREE / "Python" / folder).glob("*.py")):
            for text in python_messages(path.read_text("utf-8")):
                found.setdefault(tidy(text), set()).add(PAGES.get(path.stem, page))
    found.pop(None, None)
    pages = {}
    for text in sorted(found, key=lambda text: (text.strip("\"'. ").lower(), text)):
        pages.setdefault(found[text].pop() if len(found[text]) == 1 else "", []).append(text)
    return pages

def explained(page):
    """Returns the messages that a page explains in its tables: [(message, meaning)]."""
    tables = re.findall(r"^\| Message \|.*\n.*\n((?:\|.*\n)+)", page, re.M)
    rows = re.findall(r"^\| (.*?) \| (.*) \|$", "".join(tables), re.M)
    return [(message, meaning) for cell, meaning in rows for message in re.findall("`([^`]+)`", cell)]

def make_page():
    """Returns all messages as Markdown, with the explanations from the pages."""
    pages = {path.stem: path.read_text("utf-8") for path in sorted((TREE / "Documentation").glob("*.md"))}
    meanings = {message: meaning.replace("(#", "(%s.md#" % name) for name, text in pages.items() for message, meaning in explained(text)}
    lines = []
    for name, texts in sorted(collect().items()):
        lines += ["", "## " + ("[%s](%s.md)" % (pages[name].splitlines()[0].strip("# "), name) if name else SHARED), ""]
        lines += ["- `%s`%s" % (text, ": " + meanings[text] if text in meanings else "") for text in texts]
    return "\n".join(lines) + "\n"

if __name__ == "__main__":
    print(make_page())
