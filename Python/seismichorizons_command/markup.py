# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of a page, from templates in the folder `page`; all values that are filled in are escaped.

    fill("tile", name="<Top>", value=12)      # has &lt;Top&gt; in place of $name

Only Markup, such as the result of fill(), is inserted unchanged.
"""

import base64
import functools
import hashlib
import html
import json
import pathlib
import re
import string

FOLDER = pathlib.Path(__file__).resolve().with_name("page")


class Markup(str):
    """A text that is already markup."""


@functools.lru_cache(maxsize=None)
def read(name):
    """Reads a file of the page."""
    return (FOLDER / name).read_text(encoding="utf-8")


@functools.lru_cache(maxsize=None)
def _parts():
    """Returns the templates by name. The first line of each file is a comment."""
    pieces = re.split(r"<!-- part (\w+) -->\n", read("parts.html"))
    parts = dict(zip(pieces[1::2], pieces[2::2]))
    parts["page"] = read("page.html").partition("\n")[2]
    return {name: string.Template(text) for name, text in parts.items()}


def fill(name, /, **values):
    """Returns a template with all its placeholders replaced. None leaves a placeholder empty."""
    return Markup(_parts()[name].substitute({key: escape(value) for key, value in values.items()}))


def escape(value):
    """Escapes a text for use between tags and in quoted attributes."""
    if isinstance(value, Markup):
        return value
    # HTML has no control characters; bytes of file names that are not UTF-8 appear as surrogates.
    text = "".join("\ufffd" if c < " " and c not in "\t\n" or "\ud800" <= c <= "\udfff" else c
                   for c in str("" if value is None else value))
    return Markup(html.escape(text, quote=True))


def join(parts, between=""):
    return Markup(escape(between).join(escape(p) for p in parts))


def script_safe(text):
    """Escapes code or data so that it cannot end a script element."""
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    return Markup(re.sub(r"<(?=!--|/?script)", r"\\x3c", text, flags=re.IGNORECASE))


def script_hash(code):
    """Returns the hash of a script for the Content-Security-Policy of a page."""
    return "'sha256-%s'" % base64.b64encode(hashlib.sha256(code.encode("utf-8")).digest()).decode("ascii")


def as_json(value):
    """Returns data for a script element."""
    return Markup(json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c"))


def data_uri(content, kind):
    return Markup("data:%s;base64,%s" % (kind, base64.b64encode(content).decode("ascii")))
