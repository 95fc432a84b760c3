# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Replaces property names in messages of classes, such as "expected StrayPicks LeaveOut", by options of the command or
keywords of functions."""

import re

# Quoted texts, which come from files, and paths are not changed.
OTHER_TEXT = r'"[^"]*"|\S*[/\\]\S*'


def rename(text, names, word):
    """Returns the text with word(names[name], value) in place of each property name. `value` is the word in capitals or the
    number that follows the name after a blank, or empty."""
    if not names:
        return text
    known = "|".join(sorted(map(re.escape, names), key=len, reverse=True))
    pattern = r"%s|(?<![\w.])(?P<name>%s)(?![\w(])(?P<value> (?:[A-Z][A-Za-z]+|-?\d[\d.]*)\b)?" % (OTHER_TEXT, known)
    return re.sub(pattern, lambda found: found[0] if found["name"] is None else
                  word(names[found["name"]], (found["value"] or "")[1:]), text)


def as_option(option, value):
    """Returns text such as `--stray-picks LeaveOut`."""
    return "%s %s" % (option, value) if value else option


def as_keyword(keyword, value):
    """Returns text such as `stray_picks="LeaveOut"` or `cell_size 0`, or `columns=` without a value."""
    if not value:
        return keyword + "="
    return "%s=\"%s\"" % (keyword, value) if value[0].isalpha() else "%s %s" % (keyword, value)
