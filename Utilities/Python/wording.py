# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages of classes name properties, as the panels of the window do: "expected StrayPicks LeaveOut". The command has
options for them, functions have keywords."""

import re

# What is not replaced: quoted texts, which come from files, and paths.
OTHER_TEXT = r'"[^"]*"|\S*[/\\]\S*'


def rename(text, names, word):
    """The text with word(names[name], value) for each name of a property. `value` is that behind the name, a word in
    capitals or a number with a blank in front, or empty."""
    if not names:
        return text
    known = "|".join(sorted(map(re.escape, names), key=len, reverse=True))
    pattern = r"%s|(?<![\w.])(?P<name>%s)(?![\w(])(?P<value> (?:[A-Z][A-Za-z]+|-?\d[\d.]*)\b)?" % (OTHER_TEXT, known)
    return re.sub(pattern, lambda found: found[0] if found["name"] is None else
                  word(names[found["name"]], (found["value"] or "")[1:]), text)


def as_option(option, value):
    """`--stray-picks LeaveOut`."""
    return "%s %s" % (option, value) if value else option


def as_keyword(keyword, value):
    """`stray_picks="LeaveOut"`, `cell_size 0`, and `columns=` where no value follows."""
    if not value:
        return keyword + "="
    return "%s=\"%s\"" % (keyword, value) if value[0].isalpha() else "%s %s" % (keyword, value)
