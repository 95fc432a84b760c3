# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the manual page of horizon-mesh from the description of its options and the examples on its page, so that all of
them agree.

Arguments: the page with examples, and the file to write.
"""

import gzip
import pathlib
import re
import sys

import seismichorizons_command
from seismichorizons_command.horizon_mesh import make_parser

SEE_ALSO = r"""\fBparaview\fR(1), \fBpvpython\fR(1), the pages in /usr/share/doc/seismichorizons"""


def escape(text):
    """Escapes a text for troff."""
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return re.sub(r"(?m)^([.'])", r"\\&\1", text)


def describe(formatter, action):
    """Describes one option: its syntax and its effect."""
    formatter._indent_increment = 0
    written = formatter._format_action_invocation(action)
    return ".TP\n.B %s\n%s\n" % (escape(written), escape(formatter._expand_help(action)))


def sections(parser):
    formatter = parser._get_formatter()
    for group in parser._action_groups:
        actions = [action for action in group._group_actions if action.help != "==SUPPRESS=="]
        if actions:
            yield ".SS %s\n" % escape(group.title) + "".join(describe(formatter, action) for action in actions)


def examples(name, examples_page):
    """Returns the commands on the page of the program and their purposes."""
    for line in examples_page.splitlines():
        command, _, meaning = line.partition("  # ")
        if command.startswith(name + " ") and not command.rstrip().endswith("--help"):
            meaning = meaning or "a mesh for each horizon, and a table"
            yield ".TP\n.B %s\n%s\n" % (escape(command.rstrip()), escape(meaning))


def manual_page(parser, name, version, examples_page):
    parser.prog = name
    usage = " ".join(parser.format_usage().split()).replace("usage: %s" % name, "", 1)
    return "".join((
        '.TH %s 1 "" "SeismicHorizons %s" "User Commands"\n' % (name.upper(), version),
        ".SH NAME\n%s \\- seismic horizons to triangle meshes\n" % escape(name),
        ".SH SYNOPSIS\n.B %s\n%s\n" % (escape(name), escape(usage.strip())),
        ".SH DESCRIPTION\n%s\n" % escape(parser.description),
        ".SH OPTIONS\n", *sections(parser),
        ".SH EXAMPLES\n", *examples(name, examples_page),
        ".SH RESULTS\n%s\n" % escape(parser.epilog),
        ".SH SEE ALSO\n%s\n" % SEE_ALSO))


def main(examples_page, page):
    text = manual_page(make_parser(), seismichorizons_command.NAME, seismichorizons_command.__version__,
                       pathlib.Path(examples_page).read_text(encoding="utf-8"))
    # Without a time stamp the same input gives the same file.
    pathlib.Path(page).write_bytes(gzip.compress(text.encode("utf-8"), 9, mtime=0))


if __name__ == "__main__":
    main(*sys.argv[1:])
