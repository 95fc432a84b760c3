# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The parser of the command."""

import argparse
import difflib

from . import NAME, VERSION_LINE, completion, options, screens, words
from .arguments import path

WRONG_COMMAND_LINE = 2  # exit code


class Parser(argparse.ArgumentParser):
    """Reports a wrong command line in the same form as other errors, by calling `tell` with "error" and the text."""

    def __init__(self, tell=None, **others):
        super().__init__(**others)
        self._tell = tell

    def error(self, message):
        self._tell("error", "%s%s (see --help)" % (message, self._meant(message)))
        self.exit(WRONG_COMMAND_LINE)

    def _meant(self, message):
        """Returns the options that are most like the unknown ones, as text."""
        unknown = [word.partition("=")[0] for word in message.split() if word.startswith("--")] if message.startswith("unrecognized") else ()
        found = [close for word in unknown for close in difflib.get_close_matches(word, self._option_string_actions, n=1)]
        return "; did you mean %s?" % " ".join(found) if found else ""

    def parse_known_args(self, args=None, namespace=None):
        return super().parse_known_args(words.arrange(self, args), namespace)

    def check(self, given):
        """Reports options that need another option, which was not given."""
        for action in self.stages._group_actions:
            if hasattr(given, action.dest) and not given.stages:
                self.error("%s is an option of --stages" % action.option_strings[0])
        for action in self.quality:
            if hasattr(given, action.dest) and given.stages:
                self.error("%s is not an option of --stages" % action.option_strings[0])
        of_layers = [action.option_strings[0] for action in self.layers if hasattr(given, action.dest)] + [
            form for form in given.formats if form in options.LAYER_FORMATS]
        if of_layers and not hasattr(given, "layers"):
            self.error("%s requires --layers" % of_layers[0])


class _Print(argparse.Action):
    """Prints a text, which is made from the parser and the value of the option, and ends the program."""

    def __init__(self, make=None, **others):
        super().__init__(default=argparse.SUPPRESS, **others)
        self._make = make

    def __call__(self, parser, _namespace, values, option_string=None):
        print(self._make(parser, values), end="")
        parser.exit()


def make_parser(prog=NAME, tell=None):
    """Returns the parser; its `stages` and `layers` are the options that need --stages and --layers, its
    `quality` those that --stages does not have."""
    parser = Parser(
        tell, prog=prog, add_help=False, formatter_class=screens.Formatter, usage="%(prog)s [options] INPUT...",
        description=screens.SUMMARY + " Reads picks of OpendTect, Petrel, OpenWorks, IESX and others, and grids as "
        "IRAP, ZMAP+, CPS-3, EarthVision, Surfer, GXF, GeoTIFF and others; formats are recognised by their content. "
        "Writes a mesh for each horizon and a picture for each file, and prints how each file was read, and a table. "
        "Existing files are replaced.",
        epilog="Results are named after their file and horizon: x_horizon_1.vtp or x_Top.vtp, x.png and x_error.csv "
        "for x.vsm or x.dat; x_dat.png if there is also x.map; a_x.png for a/x.vsm and b_x.png for b/x.vsm. The "
        "results of a file appear all together or not at all. Distances are in lattice units: 1 is one column "
        "horizontally and one vertical index vertically. Heights (E, and T of --despike and --cut-faults) are in "
        "vertical indices unless they have a unit: 2ms, 0.002s, 5m, 16ft. Lists are separated by commas, or are "
        "several words up to the next option, -- or file: --formats ts,stl a.dat and --formats ts stl a.dat. "
        "Repeated options add to the list. The exit code is 0 on success, 1 if a file or the report fails (other "
        "files are still processed), 2 if the command line is wrong, 130 after Ctrl-C, and 143 after the signal TERM.")
    parser.add_argument("inputs", nargs="+", metavar="INPUT", type=path, help="files of horizons or seismic cubes, or "
                        "folders of them")
    _add_printing_options(parser)
    options.add_result_options(parser.add_argument_group("results"))
    options.add_reader_options(parser.add_argument_group("reading"))
    options.add_cube_options(parser.add_argument_group("seismic cubes"))
    options.add_preparation_options(parser.add_argument_group("preparation", "these options read horizons whole"))
    parser.quality = options.add_mesh_options(parser.add_argument_group("meshes"))
    parser.layers = options.add_layer_options(parser.add_argument_group("volumes"))
    parser.stages = parser.add_argument_group("stages of the thesis", "with --stages")
    options.add_stage_options(parser.stages)
    options.add_error_options(parser.add_argument_group("error"))
    options.add_report_options(parser.add_argument_group("report"))
    options.add_running_options(parser.add_argument_group("running"))
    return parser


def _add_printing_options(parser):
    for names, make, text in (
            (("-h", "--help"), lambda parser, _: screens.short_help(parser, NAME), "print the most used options and examples"),
            (("--help-all",), lambda parser, _: parser.format_help(), "print all options"),
            (("--version",), lambda _parser, _: VERSION_LINE, "print the version")):
        parser.add_argument(*names, action=_Print, nargs=0, make=make, help=text)
    parser.add_argument("--completion", action=_Print, make=lambda parser, shell: completion.SHELLS[shell](parser, NAME),
                        choices=tuple(completion.SHELLS), metavar="SHELL", help="print the completion script for "
                        "bash or zsh; installed commands have both")
