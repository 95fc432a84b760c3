# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""No link of the site is dead, and it fetches nothing from elsewhere. Argument: the folder of the site."""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """What a page links to, loads, and has anchors for."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[name] for name in ("id", "name") if values.get(name))
        if tag == "a" and values.get("href") is not None:
            self.links.append(values["href"])
        elif tag == "link" and values.get("rel") in ("stylesheet", "icon") or tag in ("script", "img", "iframe"):
            address = values.get("href") or values.get("src")
            if address:
                self.loaded.append(address)


def check(site, path, pages):
    """What is wrong with the links of a page."""
    page = pages[path]
    for address in page.loaded:
        if urllib.parse.urlsplit(address).scheme in ("http", "https") or address.startswith("//"):
            yield "loads %s" % address
    for address in page.links + page.loaded:
        parts = urllib.parse.urlsplit(address)
        if parts.scheme or address.startswith(("//", "javascript:")):
            continue
        target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
        if parts.path.startswith("/"):
            target = site / parts.path.lstrip("/")
        if target.is_dir():
            target = target / "index.html"
        if not target.is_file():
            yield "dead link %s" % address
        elif target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
            yield "no such anchor: %s" % address


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    # Doxygen makes its pages of scripts; those of mkdocs are checked, with their links into the others.
    pages = {path: Page(path) for path in sorted(site.glob("*.html"))}
    assert len(pages) > 40, len(pages)
    wrong = ["%s: %s" % (path.name, fault) for path in pages for fault in check(site, path, pages)]
    assert not wrong, "\n".join(wrong)
    # The search finds a word of a page.
    index = (site / "search" / "search_index.json").read_text(encoding="utf-8")
    assert "SmallestThrow" in index
    print("%d pages, %d links" % (len(pages), sum(len(page.links) for page in pages.values())))


main()
