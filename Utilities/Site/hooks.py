# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds a site from the pages of the source tree; README.md and pictures are outside Documentation."""

import pathlib
import re
import sys

from mkdocs.structure.files import File

TREE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TREE / "Utilities" / "Site"))
import messages  # noqa: E402 -- beside this file
TOP_PAGES = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md")
QUICK_START = "QuickStart"  # README.md; index.md is the first page of the site
PICTURES = "Data/Baseline/*.png"
MESSAGES = "Messages.md"


def add(files, path, config):
    file = File(path, str(TREE), config["site_dir"], config["use_directory_urls"])
    if path == "README.md":
        file.name, file.dest_path, file.url = QUICK_START, QUICK_START + ".html", QUICK_START + ".html"
        file.abs_dest_path = str(pathlib.Path(config["site_dir"]) / file.dest_path)
    files.append(file)


def on_files(files, config):
    """Adds files outside Documentation that the pages use, and removes files that are not pages."""
    for file in list(files):
        if file.src_path.startswith("Example/"):
            files.remove(file)
    for name in TOP_PAGES:
        add(files, name, config)
    for path in sorted(TREE.glob(PICTURES)):
        add(files, path.relative_to(TREE).as_posix(), config)
    return files


def inside(target):
    """Returns the target of a link on the site; None if the site does not have it."""
    path = target.partition("#")[0]
    if (TREE / "Documentation" / path).is_file():
        return target
    if path in TOP_PAGES or (TREE / path).match(PICTURES):
        return target
    return None


def move_links(markdown, from_top):
    """Converts links between files of the tree to links on the site; links to other files become plain text."""

    def moved(match):
        words, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match.group(0)
        path = target.removeprefix("Documentation/") if from_top else target.removeprefix("../")
        found = inside(path)
        return "%s(%s)" % (words, found) if found else words.strip("![]")

    return re.sub(r"(!?\[(?:[^\]\[]|\[[^\]]*\]\([^)]*\))*\])\(([^)\s]+)\)", moved, markdown)


def on_page_markdown(markdown, page, config, files):
    """Converts links, and fills the page of messages from the source."""
    name = page.file.src_path
    if name == MESSAGES:
        markdown += messages.make_page()
    return move_links(markdown, name in TOP_PAGES)
