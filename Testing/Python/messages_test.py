# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The documentation lists the messages of the code. Argument: source tree.

Documentation/Report.md and InPython.md have each message of the Python package and of the command, and no other: what errors are
raised with, and what is told as a warning. In the code they are texts with places for values (`%s: there is no horizon %s`), on the
page they are examples. Those of C++ are put together from pieces; each piece with the word "expected" is on some page, where
`...` and words in angle brackets stand for anything. Messages with an explanation are in tables, others in blocks of text.
"""

import ast
import pathlib
import re
import sys

# What messages are given to.
TELLERS = ("HorizonError", "ValueError", "TypeError", "FileNotFoundError", "ArgumentTypeError", "error", "fail", "append_warning")
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


def lines_of_blocks(section):
    """Messages that no table explains."""
    return [line for block in re.findall(r"^```text\n(.*?)^```$", section, re.S | re.M) for line in block.splitlines()]


def listed_messages(page):
    """The examples of the page, which may be several in a row."""
    section = re.search(r"^## Errors\n(.*?)(?=^## |\Z)", page, re.S | re.M).group(1)
    rows = re.findall(r"^\| (`.*?) \| ", section, re.M)
    return [message for row in rows for message in re.findall(r"`([^`]+ [^`]+)`", row)] + lines_of_blocks(section)


# ---- C++ -----------------------------------------------------------------------------------------------------------
FOLDERS = ("Common", "Filters", "Readers", "Writers")
ANYTHING = ""  # among words


def words_of(text):
    """The words of a message, without punctuation; ANYTHING for what varies on a page."""
    text = re.sub(r"\.\.\.|<[^<>]*>", " \0 ", text)
    return [ANYTHING if word == "\0" else word for word in re.findall(r"\0|[^\s\0,.:;()]+", text)]


def agree(piece, listed):
    """How many words of a piece are listed, one after the other; None where one is not. The shorter list ends the
    comparison, and so does ANYTHING."""
    count = 0
    for word, other in zip(piece, listed):
        if other == ANYTHING:
            return count
        if word != other:
            return None
        count += 1
    return count if count == len(piece) else None


def is_listed(piece, rows):
    """Whether a piece of a message is in one of the rows, given as words. They may also end before its "expected"."""
    place = piece.index("expected")
    for row in rows:
        for n, word in enumerate(row):
            if word == "expected":
                before, after = agree(piece[:place][::-1], row[:n][::-1]), agree(piece[place + 1:], row[n + 1:])
                if before is not None and after is not None and before + after >= min(2, len(piece) - 1):
                    return True
            if word == ANYTHING and any(row[n - k:n] == piece[:k] for k in range(min(3, place), place + 1) if 0 < k <= n):
                return True
    return False


def pieces_of(text):
    """The literals of a C++ file that have the word "expected"."""
    text = re.sub(r'(?<!\\)"\s*\n\s*"', "", re.sub(r"^\s*//.*", "", text, flags=re.M))
    for literal in re.findall(r'"((?:[^"\\\n]|\\.)*)"', text):
        words = words_of(literal.replace('\\"', '"'))
        if "expected" in words and sum(len(word) > 1 for word in words) > 2:
            yield literal, words


def check_cpp(root):
    """What is on no page."""
    rows = []
    for page in sorted((root / "Documentation").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        rows += [words_of(message) for message in lines_of_blocks(text)]
        for table in re.findall(r"^\| message \|.*\n((?:\|.*\n)+)", text, re.M | re.I):
            cells = re.findall(r"^\| ((?:\\\||[^|])*) \|", table, re.M)
            rows += [words_of(message) for cell in cells for message in re.findall(r"`([^`]+)`", cell)]
    paths = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cxx") and path.stem != "MeshChecker"]  # which users never hear of
    pieces = [(path, *piece) for path in paths for piece in pieces_of(path.read_text(encoding="utf-8"))]
    assert len(rows) > 300 and len(pieces) > 200, (len(rows), len(pieces))
    return ["%s: on no page: %s" % (path.relative_to(root), literal) for path, literal, words in pieces
            if not is_listed(words, rows)]


def main():
    root = pathlib.Path(sys.argv[1])
    listed = [message for name in ("Report.md", "InPython.md")
              for message in listed_messages((root / "Documentation" / name).read_text(encoding="utf-8"))]
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
    wrong += check_cpp(root)
    print("\n".join(wrong) or "%d messages" % len(listed))
    sys.exit(1 if wrong else 0)


main()
