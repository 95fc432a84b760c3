# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/Site/messages.py finds the messages of the code, and the pages explain only such. Argument: source tree."""

import itertools
import pathlib
import re
import sys

# Messages of each kind, as they are put together in the source.
KNOWN = {
    "": ["no such file",
         "a special file, expected a regular one",  # one of two
         "a point of ... at ..., expected finite numbers",
         "no point array PatchId, expected the patch number of each point, as Horizon Exterior Boundary makes it",
         "folder \"...\" does not exist",  # no word "expected"
         "point ... at (..., ...) in lattice units, expected whole columns, as points have them before they are "
         "merged"],  # in a branch
    "FaultLines": ["\"...\", expected END of the GOCAD object",
                   "... ... with a point at (...) in ..., expected finite numbers"],  # in several statements
    "HorizonFaults": ["none of ... fault polylines passes between columns of a horizon, expected lines in the coordinates "
                      "of its points: ..."],  # a warning
    "GOCADTSurf": ["end of file, expected END of the GOCAD object of line ..."],  # by a function
    "HorizonDecimation": ["maximum number of triangles ..., expected at least the ... that the outlines require"],
    "HorizonDespiking": ["spur width ..., expected 0 to ... columns"],  # by a check
    "HorizonGrid": ["coordinates are rounded to single precision, by up to ...; IRAP text keeps them"],  # a warning
    "HorizonText": ["column 1 numbers the lines, expected coordinates or line numbers: name the columns in Columns, such "
                          "as Inline, Crossline, X, Y, Z"],  # with a constant
    "HorizonTriangulation": ["no surface to the left of the edge from point ... to point ..., expected closed boundary "
                             "loops with the surface to their right"],
    "SEGYCube": ["... duplicate traces: dead ones are not used"],  # one of four
    "VerneySparseMatrix": ["two horizons with the surface ID ..., expected one ID for each",
                           "header \"...\", expected three positive integers \"nX nY nZ\" below 2^31"],
    "Report": ["there is no horizon ...; the file has ...", "... requires --layers"],
    "InPython": ["values of shape ..., expected ... of the lattice"],
}
CODE = r"std::|->|<<|==|[{}\\]|\w\(\)|(?<!ZMAP)\+|%[sdg\d(.]|\.{4}|\b(?:to_string|text|nullptr|const)\b[.(]"
FEWEST = {"": 60, "HorizonGrid": 40, "HorizonText": 55, "SEGYCube": 45, "Report": 35, "InPython": 18,
          "SeismicReflectionExtraction": 35, "HorizonTriangulation": 15}


def is_unbalanced(text):
    return text.count("(") != text.count(")") or text.count('"') % 2 or text != text.strip() or "  " in text


def literals(messages):
    """The texts of the sources of C++ that have the word "expected" and another one after it."""
    for path in messages.cpp_paths():
        tokens = messages.cpp_messages.tokens_of(path.read_text(encoding="utf-8"))
        for is_text, group in itertools.groupby(tokens, lambda token: token[0] == '"'):
            text = "".join(token[1:-1] for token in group).replace('\\"', '"') if is_text else ""
            if re.search(r"\bexpected \w+ \w+", text):
                yield path.relative_to(messages.TREE), text


def check_pages(tree, messages, everything):
    """What is wrong with the tables of the pages."""
    explained = 0
    for page in sorted((tree / "Documentation").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        rows = messages.explained(text)
        explained += len(rows)
        yield from ("%s: nothing says: %s" % (page.name, message) for message, _ in rows if message not in everything)
        yield from ("%s: no meaning of: %s" % (page.name, message) for message, meaning in rows if not meaning.strip())
        if "```text" in text or text.lower().count("| message |") != text.count("| Message | Meaning |"):
            yield "%s: a list of messages that explains none" % page.name
    if explained < 50:
        yield "only %d messages are explained" % explained


def main():
    tree = pathlib.Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(tree / "Utilities" / "Site"))
    import messages

    found = messages.collect()
    everything = {text for texts in found.values() for text in texts}
    wrong = ["not found for %s: %s" % (page or "all", text) for page, texts in KNOWN.items() for text in texts
             if text not in found.get(page, [])]
    wrong += ["only %d messages of %s" % (len(found.get(page, [])), page or "all") for page, least in FEWEST.items()
              if len(found.get(page, [])) < least]
    # Messages of the package name keywords.
    wrong += ["code: %s" % text for text in everything.difference(found.get(messages.PACKAGE, [])) if re.search(CODE, text) or is_unbalanced(text)]
    wrong += ["%s: in no message: %s" % (path, text) for path, text in literals(messages)
              if not any(text.strip(" ,:") in message for message in everything)]
    wrong += check_pages(tree, messages, everything)
    page = messages.make_page()
    wrong += ["not once on the page: %s" % text for text in everything if page.count("\n- `%s`" % text) != 1]
    assert "expected loops around all points`: The loops belong to another horizon" in page
    print("\n".join(wrong) or "%d messages" % len(everything))
    sys.exit(1 if wrong else 0)


main()
