# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""release.sh makes nothing of a tree that is not the one of its version. Arguments: release.sh, a folder for files."""

import pathlib
import shutil
import subprocess
import sys

SCRIPT, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])


def git(*words):
    subprocess.run(["git", "-C", str(FOLDER), "-c", "user.name=a", "-c", "user.email=b", *words], check=True, capture_output=True)


def write(name, text):
    (FOLDER / name).write_text(text, encoding="utf-8")


def refused(words):
    done = subprocess.run(["sh", str(FOLDER / "Utilities/release.sh")], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1 and words in done.stderr, (words, done.returncode, done.stdout, done.stderr)


def main():
    if not shutil.which("git"):
        print("no git")
        sys.exit(77)
    shutil.rmtree(FOLDER, ignore_errors=True)
    (FOLDER / "Utilities").mkdir(parents=True)
    shutil.copy(SCRIPT, FOLDER / "Utilities")
    write("Utilities/setup.sh", "#!/bin/sh\necho all agrees >&2\nexit 1\n")
    (FOLDER / "Utilities/setup.sh").chmod(0o755)
    write("CMakeLists.txt", "project(A\n  VERSION 1.2.0\n  LANGUAGES C)\n")
    git("init", "--quiet")
    for cited, heading, tag, words in (
            ("1.1.0", "1.2.0", "v1.2.0", "CITATION.cff has version 1.1.0, expected 1.2.0"),
            ("1.2.0", "Unreleased", "v1.2.0", "CHANGELOG.md begins with Unreleased, expected 1.2.0"),
            ("1.2.0", "1.2.0", "v1.1.0", "this commit has no tag v1.2.0"),
            ("1.2.0", "1.2.0", "v1.2.0", "all agrees")):
        write("CITATION.cff", "version: %s\n" % cited)
        write("CHANGELOG.md", "# Changelog\n\n## %s\n\n## 1.1.0\n" % heading)
        git("add", "-A")
        git("commit", "--quiet", "--allow-empty", "-m", "all")
        git("tag", "--force", tag)
        refused(words)
    write("more", "")
    refused("the tree has changes, expected a clean clone:\n?? more")


main()
