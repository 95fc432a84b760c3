# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Report.md lists each message of the Python package and of the command, and no other. Argument: source tree.

Messages are what errors are raised with, and what is told as a warning; in the code they are texts with places for values
(`%s: there is no horizon %s`), on the page they are examples.
"""

import ast
import pathlib
import re
import sys

# What messages are given to.
TELLERS = ("HorizonError", "ValueError", "ArgumentTypeError", "error", "fail", "append_warning")
FEWEST_WORDS = 4
PLACES = r"%\([^)]*\)[.\d]*[sdgf]|%[.\d]*[sdgf]"


def name_of(function):
    """The last name of what is called; `x.warnings.append` has one of its own."""
    if isinstance(function, ast.Attribute):
        owner = function.value
        if function.attr == "append" and isinstance(owner, ast.Attribute) and owner.attr == "warnings":
            return "append_warning"
        return function.attr
    return function.id if isinstance(function, ast.Name) else None


def text_of(node):
    """The text of a message, with or without values for it; None where it comes from elsewhere."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        node = node.left
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def has_words(text):
    """Not only `%s: %s`, which puts a name before a message."""
    return re.search(r"[a-z]{3}", re.sub(PLACES, "", text)) is not None


def messages_of(tree):
    """The messages of a module: (line, text)."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and node.args and name_of(node.func) in TELLERS:
            text = text_of(node.args[0])
            if text and has_words(text):
                yield node.lineno, text


def texts_of(tree):
    """All texts of a module that may be sentences of messages."""
    texts = [node.value.strip() for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    return [text for text in texts if len(re.findall("[a-z]+", re.sub(PLACES, "", text))) >= FEWEST_WORDS]


def pattern_of(text):
    pieces = re.split(PLACES, text)
    return ".+".join(re.escape(piece.replace("%%", "%")) for piece in pieces)


def listed_messages(page):
    """The examples of the page, which may be several in a row."""
    section = re.search(r"^## Errors\n(.*?)(?=^## |\Z)", page, re.S | re.M).group(1)
    rows = re.findall(r"^\| (`.*?) \| ", section, re.M)
    return [message for row in rows for message in re.findall(r"`([^`]+ [^`]+)`", row)]


def main():
    root = pathlib.Path(sys.argv[1])
    listed = listed_messages((root / "Documentation" / "Report.md").read_text(encoding="utf-8"))
    paths = [root / "Utilities" / "horizon_mesh.py", *sorted((root / "Utilities" / "Python").glob("*.py"))]
    trees = {path: ast.parse(path.read_text(encoding="utf-8")) for path in paths}
    told = [(path, line, text) for path, tree in trees.items() for line, text in messages_of(tree)]
    assert len(told) > 20 and len(listed) > 20, (told, listed)
    wrong = ["%s:%d: not on the page: %s" % (path.relative_to(root), line, text) for path, line, text in told
             if not any(re.search(pattern_of(text), message) for message in listed)]
    # Some are put together, or stand in the page of a report itself.
    texts = [text for _, _, text in told] + [text for tree in trees.values() for text in texts_of(tree)]
    texts.append((root / "Utilities" / "Python" / "page" / "parts.html").read_text(encoding="utf-8"))
    wrong += ["Documentation/Report.md: nothing says: %s" % message for message in listed
              if not any(re.search(pattern_of(text), message) or message in text for text in texts)]
    print("\n".join(wrong) or "%d messages" % len(listed))
    sys.exit(1 if wrong else 0)


main()
