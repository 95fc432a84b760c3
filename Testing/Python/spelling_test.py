# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Words are spelled right in pages, panels and headers, and pages are without some phrases that are no plain English.

Spelling needs codespell (its Debian package, or that of pip); the phrases do not. Argument: source tree.
spelling_words.txt has the words that codespell takes for others, in lower case.
"""

import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
PAGES = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "Documentation/*.md")
OTHERS = ("ParaViewPlugin/*.xml", *("%s/**/*.h" % folder for folder in ("Common", "Filters", "ParaViewPlugin", "Readers", "Sources", "Writers")))
WORDS = pathlib.Path(__file__).with_name("spelling_words.txt")
# Not in tables, whose rows are made of headers and of messages, and not in code.
PHRASES = ("hang together", "hangs together", "can not", "cannot be had", "for itself", "is told", "are told", "goes on",
           "at last", "to and fro", "nobody waits")


def phrases_in(path, root):
    """Where a page has one of the phrases, also over the end of a line."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"^```.*?^```|^\|[^\n]*|`[^`\n]*`", lambda found: re.sub(r"[^\n]", "-", found.group(0)), text, flags=re.M | re.S)
    for phrase in PHRASES:
        for found in re.finditer(r"\b%s\b" % phrase.replace(" ", r"\s+"), text, re.I):
            line = text.count("\n", 0, found.start()) + 1
            yield "%s:%d: \"%s\" is no plain English" % (path.relative_to(root), line, phrase)


def misspelled(program, root):
    paths = [path for pattern in (*PAGES, *OTHERS) for path in sorted(root.glob(pattern))]
    assert len(paths) > 300, len(paths)
    # An empty configuration, so that none of a user counts.
    done = subprocess.run([program, "--config", "/dev/null", "--ignore-words", str(WORDS), *map(str, paths)],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    assert done.stdout or done.returncode == 0, done
    return done.stdout.splitlines()


def main():
    root = pathlib.Path(sys.argv[1])
    program = shutil.which("codespell")
    pages = [root / "README.md", *sorted((root / "Documentation").glob("*.md"))]
    wrong = [place for page in pages for place in phrases_in(page, root)]
    wrong += misspelled(program, root) if program else []
    print("\n".join(wrong) or ("nothing to correct" if program else "SKIPPED: no codespell"))
    sys.exit(1 if wrong else 0 if program else SKIPPED)


main()
