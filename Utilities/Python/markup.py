# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts for a page: its parts are in files of the folder `page`, and whatever is put into them is escaped.

    fill("tile", name="<Top>", value=12)      # has &lt;Top&gt; in place of $name

Only what is Markup itself, as what fill() gives, is put in as it is.
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
    """A text that is a part of a page already."""


@functools.lru_cache(maxsize=None)
def read(name):
    """A file of the page."""
    return (FOLDER / name).read_text(encoding="utf-8")


@functools.lru_cache(maxsize=None)
def _parts():
    """The parts that are filled, by their names. The first line of each file is a comment on the file."""
    pieces = re.split(r"<!-- part (\w+) -->\n", read("parts.html"))
    parts = dict(zip(pieces[1::2], pieces[2::2]))
    parts["page"] = read("page.html").partition("\n")[2]
    return {name: string.Template(text) for name, text in parts.items()}


def fill(name, /, **values):
    """A part of the page with values in its places, all of them. None leaves a place empty."""
    return Markup(_parts()[name].substitute({key: escape(value) for key, value in values.items()}))


def escape(value):
    """Text that may stand between tags, and in attributes that have quotes."""
    if isinstance(value, Markup):
        return value
    # Control characters have no place in a page; bytes of file names that are no UTF-8 come as surrogates.
    text = "".join("\ufffd" if c < " " and c not in "\t\n" or "\ud800" <= c <= "\udfff" else c
                   for c in str("" if value is None else value))
    return Markup(html.escape(text, quote=True))


def join(parts, between=""):
    return Markup(escape(between).join(escape(p) for p in parts))


def script_safe(text):
    """Code, or data, that may stand in a script element: nothing in it ends that."""
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    return Markup(re.sub(r"<(?=!--|/?script)", r"\\x3c", text, flags=re.IGNORECASE))


def script_hash(code):
    """How a page names code that may run in it, in its Content-Security-Policy."""
    return "'sha256-%s'" % base64.b64encode(hashlib.sha256(code.encode("utf-8")).digest()).decode("ascii")


def as_json(value):
    """Data for a script element."""
    return Markup(json.dumps(value, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c"))


def data_uri(content, kind):
    return Markup("data:%s;base64,%s" % (kind, base64.b64encode(content).decode("ascii")))
