# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The collection of help pages that the "?" button opens has a page for each proxy, with the text of each property.

Arguments: the folder of the XML files with help, and the compiled collection (.qch, a database of SQLite).
"""

import html
import pathlib
import re
import sqlite3
import sys
import xml.etree.ElementTree as ElementTree
import zlib


def read_pages(path):
    """The pages by name, as text."""
    rows = sqlite3.connect(path).execute("SELECT N.Name, D.Data FROM FileNameTable N JOIN FileDataTable D "
                                         "ON N.FileId = D.Id")
    # Qt writes the length, in four bytes, before what it compresses.
    return {name: zlib.decompress(data[4:]).decode() for name, data in rows if name.endswith(".html")}


def main():
    pages = read_pages(sys.argv[2])
    proxies = 0
    for path in pathlib.Path(sys.argv[1]).glob("*.xml"):
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            for proxy in group.findall("SourceProxy[@class]") + group.findall("WriterProxy[@class]"):  # others are bases
                page = pages["%s.%s.html" % (group.get("name"), proxy.get("name"))]
                assert proxy.get("label") in page, proxy.get("name")
                assert proxy.find("Documentation").get("long_help") in page, proxy.get("name")
                shown = " ".join(html.unescape(re.sub("<[^>]*>", " ", page)).split())
                for prop in (element for element in proxy if element.tag.endswith("Property")):
                    text = " ".join(prop.find("Documentation").text.split())
                    assert text in shown, (proxy.get("name"), prop.get("name"))
                proxies += 1
    assert proxies >= 5, proxies
    print("%d pages" % proxies)


main()
