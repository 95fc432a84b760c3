# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of horizon-mesh: version, help, lists, heights and completion. Nothing is meshed.

Arguments: the program horizon_mesh.py, the version of the project, the page of the command, and a folder for files.
"""

import contextlib
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from seismichorizons_command import completion, parser, screens
from seismichorizons_command.arguments import AddToList

PROGRAM, PAGE, FOLDER = (pathlib.Path(sys.argv[number]).resolve() for number in (1, 3, 4))
VERSION = sys.argv[2]
MOST_LINES, MOST_COLUMNS = 40, 80  # of a screen


def run(*words):
    return subprocess.run([sys.executable, str(PROGRAM), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=60, check=False)


def shown_options():
    return [action for action in completion.shown(parser.make_parser())]


class CommandTest(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(FOLDER)
        for name in ("a.dat", "b.dat", "cube.sgy", "top.dat", "base.dat", "one,two.dat"):
            pathlib.Path(name).touch()

    def parse(self, line):
        """The options and files of a command line whose words are separated by |, or the message of its error."""
        told = []
        made = parser.make_parser("horizon-mesh", lambda _, text: told.append(text))
        try:
            return made.parse_args(line.split("|"))
        except SystemExit as end:
            self.assertEqual(end.code, 2)
            return told[0]

    def test_version(self):
        done = run("--version")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "horizon-mesh %s\n" % VERSION, ""))
        self.assertEqual(run("--version", "a.dat").stdout, done.stdout)
        import seismichorizons as sh

        self.assertEqual(sh.__version__, VERSION)

    def test_start(self):
        """Neither VTK nor NumPy is loaded before there is work, nor for a wrong command line."""
        for words, code in ((["--version"], 0), (["--help"], 0), (["--help-all"], 0), (["--completion", "bash"], 0), (["--wrong"], 2)):
            done = subprocess.run([sys.executable, "-X", "importtime", str(PROGRAM), *words], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, code)
            loaded = re.findall(r"^import time: .*\| *(\S+)$", done.stderr, re.M)
            self.assertIn("seismichorizons_command", loaded)
            self.assertFalse([name for name in loaded if re.match(r"(vtk|vtkmodules|numpy|seismichorizons)(\.|$)", name)])

    def test_help(self):
        """One screen, with the names of the groups of which --help-all has the options."""
        first, whole = run("--help").stdout, run("--help-all").stdout
        lines = first.splitlines()
        self.assertLessEqual(len(lines), MOST_LINES)
        self.assertLessEqual(max(map(len, lines)), MOST_COLUMNS)
        self.assertTrue(first.startswith("usage: horizon_mesh.py [options] INPUT..."))
        self.assertEqual(run("-h").stdout, first)
        for group in parser.make_parser()._action_groups[2:]:
            self.assertIn(group.title, " ".join(first.split()))
            self.assertIn("\n%s:\n" % group.title, whole)
        for action in shown_options():
            for option in action.option_strings:
                self.assertRegex(whole, r"(?m)^  .*(?<![\w-])%s(?![\w-])" % option)

    def test_examples(self):
        """They are right, and on the page of the command."""
        page = PAGE.read_text(encoding="utf-8")
        for words, _ in screens.EXAMPLES:
            self.assertNotIsInstance(self.parse(words.replace(" ", "|")), str)
            self.assertIn("horizon-mesh %s " % words, page)

    def test_lists(self):
        """Words up to --, an option or a file; or one word with commas."""
        a, b = ["a.dat"], ["a.dat", "b.dat"]
        for line, dest, values, inputs in (
                ("--formats|ts,stl|a.dat", "formats", ["ts", "stl"], a), ("--formats|ts|stl|--|a.dat", "formats", ["ts", "stl"], a),
                ("--formats|ts|stl|a.dat|b.dat", "formats", ["ts", "stl"], b), ("--formats=ts,stl|a.dat", "formats", ["ts", "stl"], a),
                ("a.dat|--formats|ts|stl", "formats", ["ts", "stl"], a), ("a.dat|--formats|ts|b.dat", "formats", ["ts"], b),
                ("--formats|ts|--formats|stl,ply|a.dat", "formats", ["ts", "stl", "ply"], a), ("a.dat", "formats", ["vtp"], a),
                ("--form|ts,stl|none.dat", "formats", ["ts", "stl"], ["none.dat"]), ("--formats|ts|none.dat", "formats", ["ts"], ["none.dat"]),
                ("--formats|ts,stl|--stages|a.dat", "formats", ["ts", "stl"], a), ("--formats|ts, stl,|a.dat", "formats", ["ts", "stl"], a),
                ("--horizons|Top, upper|a.dat", "horizons", ["Top, upper"], a), ("--horizons|1,2|a.dat", "horizons", ["1,2"], a),
                ("--horizons|Top, upper|Base|--|a.dat", "horizons", ["Top, upper", "Base"], a),
                ("--horizons|1|2|a.dat", "horizons", ["1", "2"], a), ("--horizons|1|--horizons|-2|a.dat", "horizons", ["1", "-2"], a),
                ("--horizons|1|b.dat|--|a.dat", "horizons", ["1", "b.dat"], a),
                ("--crossings|Mean,Stop|--layers|a.dat", "crossings", ["Mean", "Stop"], a),
                ("--limits|top.dat,base.dat|cube.sgy", "limits", ["top.dat", "base.dat"], ["cube.sgy"]),
                ("--limits|top.dat|base.dat|--|cube.sgy", "limits", ["top.dat", "base.dat"], ["cube.sgy"]),
                ("--limits|top.dat|base.dat|cube.sgy", "limits", ["top.dat", "base.dat"], ["cube.sgy"]),
                ("cube.sgy|--limits|top.dat|base.dat", "limits", ["top.dat", "base.dat"], ["cube.sgy"]),
                ("--limits|one,two.dat|cube.sgy", "limits", ["one,two.dat"], ["cube.sgy"])):
            with self.subTest(line):
                given = self.parse(line)
                self.assertNotIsInstance(given, str, given)
                self.assertEqual((getattr(given, dest), [str(path) for path in given.inputs]), (values, inputs))

    def test_lists_of_all_values(self):
        """Each form of a list gives the same values, in whatever order the words are."""
        for action in shown_options():
            if isinstance(action, AddToList) and action.values:
                option, values = action.option_strings[0], [value + "1" * value.endswith("=") for value in action.values]
                for words in ([option, ",".join(values), "a.dat"], ["a.dat", option, *values], [option, *values, "a.dat"],
                              ["a.dat", *("%s=%s" % (option, value) for value in values)], [option, *values, "--", "a.dat"]):
                    given = self.parse("|".join(words))
                    self.assertEqual((getattr(given, action.dest), list(map(str, given.inputs))), (values, ["a.dat"]))

    def test_wrong_lists(self):
        for line, text in (("--formats|ts,doc|a.dat", "argument --formats: invalid choice: 'doc' (choose from 'vtp', "),
                           ("--formats|ts|a.dat|--|b.dat", "invalid choice: 'a.dat'"), ("--formats|a.dat", "invalid choice: 'a.dat'"),
                           ("--formats|,|a.dat", "argument --formats: ',', expected values, with commas between them"),
                           ("--horizons||a.dat", "argument --horizons: '', expected values, with commas between them"),
                           ("--formats|--stages|a.dat", "argument --formats: expected one argument"),
                           ("--horizons|a.dat", "the following arguments are required: INPUT")):
            self.assertIn(text, self.parse(line))

    def test_short_options(self):
        for line in ("-o|out|-q|-j|4|a.dat", "-oout|-qj4|a.dat", "a.dat|-qj|4|--output-folder|out", "-qo|out|a.dat|-j4"):
            given = self.parse(line)
            self.assertEqual((str(given.output_folder), given.quiet, given.jobs, len(given.inputs)), ("out", True, 4, 1), line)
        self.assertIn("not allowed with", self.parse("-q|--json|a.dat"))

    def test_heights(self):
        """A number and its unit are one word or two; what is no unit is refused, unless it is a file."""
        for option in ("--largest-error", "--despike", "--cut-faults"):
            dest = option[2:].replace("-", "_")
            for words in ("2ms", "2 ms", "2|ms", " 2  ms ", "2.0|ms"):
                given = self.parse("%s|%s|a.dat" % (option, words))
                self.assertEqual((getattr(given, dest), getattr(given, dest).unit), (2.0, "ms"), words)
                self.assertEqual(list(map(str, given.inputs)), ["a.dat"])
            for words in ("2km", "2|km", "2 msec", "ms", "-2ms", "nanms"):
                self.assertRegex(self.parse("%s|%s|a.dat" % (option, words)), "argument %s: " % option)
            pathlib.Path("ms").touch()
            self.assertEqual(list(map(str, self.parse("%s|2|ms" % option).inputs)), ["ms"])
            pathlib.Path("ms").unlink()

    def complete(self, *words):
        """The proposals of bash for the last word, as it completes after the program."""
        script = ("source ./completion.bash\nCOMP_WORDS=(horizon-mesh \"$@\")\nCOMP_CWORD=$#\n"
                  "_horizon_mesh\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n")
        done = subprocess.run(["bash", "-c", script, "bash", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=True, timeout=60)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash(self):
        """All options and their values, in lists too; folders or files where they belong."""
        pathlib.Path("completion.bash").write_text(run("--completion", "bash").stdout, encoding="utf-8")
        os.mkdir("folder")
        options = [option for action in shown_options() for option in action.option_strings]
        self.assertEqual(self.complete("-"), options)
        self.assertEqual(self.complete("--largest-"), ["--largest-error"])
        for action in shown_options():
            values = list(completion.values_of(action))
            for option in action.option_strings:
                if values:
                    self.assertEqual(self.complete(option, ""), values)
                    self.assertEqual(self.complete(option, "=", values[0]), [v for v in values if v.startswith(values[0])])
        self.assertEqual(self.complete("--formats", "ts,st"), ["ts,stl"])
        self.assertEqual(self.complete("-o", ""), ["folder"])
        self.assertEqual(self.complete("--stages", "a."), ["a.dat"])
        self.assertEqual(self.complete("--picks", "to"), ["top.dat"])
        self.assertEqual(self.complete("--radius", ""), [])

    def test_zsh(self):
        """Every option has a description, and zsh reads the file."""
        text = run("--completion", "zsh").stdout
        self.assertTrue(text.startswith("#compdef horizon-mesh\n"))
        for action in shown_options():
            for option in action.option_strings:
                self.assertRegex(text, r"(?m)^  '[^']*[*)]%s[=+]?\[[^]']+\][^']*'" % option)
            for value in completion.values_of(action):
                self.assertRegex(text, r"%s.*[ (]%s[ )']" % (action.option_strings[0], value))
        if not shutil.which("zsh"):
            self.skipTest("zsh is not installed")
        script = "_arguments() { print -l -- \"$@\" }\n" + text
        done = subprocess.run(["zsh", "-f", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60, check=True)
        number = sum(len(action.option_strings) for action in shown_options())
        self.assertEqual((done.stderr, len(done.stdout.splitlines())), ("", number + 3))

    def test_wrong_shell(self):
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            self.assertIn("invalid choice: 'fish'", self.parse("--completion|fish"))
        self.assertEqual(printed.getvalue(), "")


if __name__ == "__main__":
    unittest.main(argv=["command_test"], verbosity=2)
