# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds a site from the pages of the source tree; README.md and pictures are outside Documentation, notebooks are pages."""

import json
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
CLASSES = "api/"  # by Doxygen, which mkdocs does not know
NOTEBOOKS = "Notebooks/*.ipynb"  # a page each, beside the file itself


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
    for name in (*TOP_PAGES, *config["extra_css"]):
        add(files, name, config)
    for path in sorted(TREE.glob(PICTURES)):
        add(files, path.relative_to(TREE).as_posix(), config)
    for file in list(files):
        if pathlib.PurePath(file.src_path).match(NOTEBOOKS):
            add(files, page_of(file.src_path), config)
    return files


def page_of(notebook):
    return notebook.removesuffix(".ipynb") + ".md"


def convert(notebook):
    """Converts a notebook with its stored outputs to Markdown."""
    parts = []
    for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
        text = "".join(cell["source"])
        parts.append(text if cell["cell_type"] == "markdown" else "```python\n%s\n```" % text)
        for output in cell.get("outputs", ()):
            data = output.get("data", {})
            if "image/png" in data:
                parts.append("![Figure](data:image/png;base64,%s)" % "".join("".join(data["image/png"]).split()))
            else:
                parts.append("```text\n%s\n```" % "".join(output.get("text") or data.get("text/plain", "")).rstrip())
    title, _, rest = "\n\n".join(parts).partition("\n")
    return "%s\n\n[%s](%s)\n%s\n" % (title, notebook.name, notebook.name, rest)


def on_page_read_source(page, config):
    """Gives the text of a notebook, for which there is no file in Markdown."""
    path = TREE / "Documentation" / (page.file.src_path.removesuffix(".md") + ".ipynb")
    return convert(path) if path.match(NOTEBOOKS) and path.is_file() else None


def inside(target):
    """Returns the target of a link on the site; None if the site does not have it."""
    path = target.partition("#")[0]
    if pathlib.PurePath(path).match(NOTEBOOKS) and (TREE / "Documentation" / path).is_file():
        return page_of(path)
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
        if target.startswith(CLASSES):
            return '<a href="%s">%s</a>' % (target, words.strip("[]"))
        path = target.removeprefix("Documentation/") if from_top else target.removeprefix("../")
        found = inside(path)
        return "%s(%s)" % (words, found) if found else words.strip("![]")

    return re.sub(r"(!?\[(?:[^\]\[]|\[[^\]]*\]\([^)]*\))*\])\(([^)\s]+)\)", moved, markdown)


def on_page_markdown(markdown, page, config, files):
    """Converts links, and fills the page of messages from the source."""
    name = page.file.src_path
    if pathlib.PurePath(name).parent.name == "Notebooks":
        return markdown
    if name == MESSAGES:
        markdown += messages.make_page()
    return move_links(markdown, name in TOP_PAGES)
