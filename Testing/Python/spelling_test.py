# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Words are spelled right in pages, panels and headers. Needs codespell (its Debian package, or that of pip).

Argument: source tree. spelling_words.txt has the words that codespell takes for others, in lower case.
"""

import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
PAGES = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "Documentation/*.md")
OTHERS = ("ParaViewPlugin/*.xml", *("%s/**/*.h" % folder for folder in ("Common", "Filters", "ParaViewPlugin", "Readers", "Writers")))
WORDS = pathlib.Path(__file__).with_name("spelling_words.txt")


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
    if not program:
        print("SKIPPED: no codespell")
        sys.exit(SKIPPED)
    wrong = misspelled(program, root)
    print("\n".join(wrong) or "no misspelled word")
    sys.exit(1 if wrong else 0)


main()
