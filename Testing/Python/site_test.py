# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""No link of the site is dead, it fetches nothing from elsewhere, and its page of messages has all that pages explain.

Argument: the folder of the site.
"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """What a page links to, loads, and has anchors for; and the messages that it lists, and that its tables explain."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], {""}
        self.listed, self.explained = set(), set()
        self._head, self._cells, self._messages, self._is_first = "", [], None, False
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
        elif tag in ("tr", "td", "th"):
            self._cells = [] if tag == "tr" else [*self._cells, ""]
        elif tag == "code" and (self._is_first or len(self._cells) == 1 and self._head == "message"):
            self._messages, self._message = self.listed if self._is_first else self.explained, ""
        self._is_first = tag == "li"

    def handle_data(self, data):
        if self._cells:
            self._cells[-1] += data
        if self._messages is not None:
            self._message += data

    def handle_endtag(self, tag):
        if tag == "thead":
            self._head = self._cells[0].strip().lower()
        elif tag == "table":
            self._head, self._cells = "", []
        elif tag == "code" and self._messages is not None:
            self._messages.add(self._message)
            self._messages = None


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
    listed = pages[site / "Messages.html"].listed
    explained = set().union(*(page.explained for page in pages.values()))
    assert len(listed) > 500 and len(explained) > 50, (len(listed), len(explained))
    assert explained <= listed, explained - listed
    # The search finds a word of a page.
    index = (site / "search" / "search_index.json").read_text(encoding="utf-8")
    assert "SmallestThrow" in index
    print("%d pages, %d links" % (len(pages), sum(len(page.links) for page in pages.values())))


main()
