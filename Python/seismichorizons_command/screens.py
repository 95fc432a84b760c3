# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The help: one screen, or all options."""

import argparse
import os
import re

WIDTH = 79
TEXT_COLUMN = 30  # of the effect of an option on the first screen
SUMMARY = ("Meshes the horizons in files of picks, grids, surfaces or sparse voxels, and the strongest ones in "
           "seismic cubes (SEG-Y), with few triangles within a largest error.")
USUAL = ("output_folder", "formats", "horizons", "largest_error", "triangles", "despike", "cut_faults", "fill_holes", "layers",
         "measure_error", "report", "jobs", "quiet")
EXAMPLES = (
    ("-o results surveys/*.vsm", "error from the noise"),
    ("--largest-error 2ms picks.dat", "error of 2 ms"),
    ("--formats ts,stl picks.dat", "GOCAD and STL"),
    ("--picks tops.dat survey.sgy", "horizons of a cube"),
    ("--despike 6 --cut-faults 8ms picks.dat", "open along faults"),
    ("--layers top.xyz base.xyz", "closed volumes"),
    ("--report run.html picks.dat", "HTML with pictures"))


class Formatter(argparse.ArgumentDefaultsHelpFormatter):
    """Shows defaults that the text of an option does not state."""

    def __init__(self, prog, **others):
        try:
            columns = int(os.environ.get("COLUMNS") or 0) or os.get_terminal_size().columns
        except (OSError, ValueError):
            columns = WIDTH + 1
        super().__init__(prog, **{"width": columns - 2, **others})

    def _get_help_string(self, action):
        has_default = action.nargs == 0 or "(default:" in action.help
        return action.help if has_default else super()._get_help_string(action)


def effect(parser, action):
    """Returns the first clause of the help of an option."""
    text = action.help % {**vars(action), "prog": parser.prog}
    return re.split(r"[;:] | \(default", text)[0]


def short_help(parser, name):
    """Returns one screen: the usage, what the command does, the options that most runs need, and examples."""
    import textwrap  # loaded only if needed

    lines = ["usage: " + parser.usage % {"prog": parser.prog}, "",
             *textwrap.wrap(SUMMARY, WIDTH), "", "options of most runs:"]
    for dest in USUAL:
        action = next(action for action in parser._actions if action.dest == dest)
        written = ", ".join(action.option_strings) + (" " + action.metavar if action.metavar else "")
        indent = "  " if len(action.option_strings) > 1 else "      "
        lines += textwrap.wrap(effect(parser, action), WIDTH, initial_indent=(indent + written).ljust(TEXT_COLUMN),
                               subsequent_indent=TEXT_COLUMN * " ")
    commands = ["%s %s" % (name, words) for words, _ in EXAMPLES]
    longest = max(map(len, commands))
    lines += ["", "examples:", *("  %s  # %s" % (command.ljust(longest), text) for command, (_, text) in zip(commands, EXAMPLES)), ""]
    titles = [group.title for group in parser._action_groups[2:]]
    lines += textwrap.wrap("--help-all prints all options: %s." % ", ".join(titles), WIDTH)
    return "\n".join(lines) + "\n"
