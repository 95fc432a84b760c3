#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the measured figures of the pages again, and prints those that differ; exits with 1 if there are any.

    figures.py [--write] [--slow] PROGRAMS [REAL]

Needs the package seismichorizons in PYTHONPATH. PROGRAMS is the folder of the built programs (bin). REAL has real horizons
as files *.ijz and cubes; without them, figures of these are left out. --write puts the new figures into the pages. --slow
also compares a table that takes minutes, prints what the benchmarks say whose tables on StageTables.md are put in by hand,
and with --write makes whole pages anew: their times differ from run to run.

Figures are console blocks, rows of tables that a script prints, and numbers in sentences. An entry whose text is on no
page is an error. Seconds are not compared.
"""

import argparse
import functools
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings

import seismichorizons as sh
from hole_filling import read_real

PROJECT = pathlib.Path(__file__).resolve().parents[2]
STUDIES = PROJECT / "Utilities" / "Studies"
PAGES = PROJECT / "Documentation"
NUMBER = r"(\d[\d.,]*\d|\d)"

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--write", action="store_true")
parser.add_argument("--slow", action="store_true")
parser.add_argument("programs", type=lambda path: pathlib.Path(path).resolve())
parser.add_argument("real", nargs="?", type=lambda path: pathlib.Path(path).resolve())
GIVEN = parser.parse_args()
if GIVEN.real and not (GIVEN.real / "penobscot").is_dir():
    GIVEN.real = None
WORKSPACE = tempfile.TemporaryDirectory()  # removed at the end
FOLDER = pathlib.Path(WORKSPACE.name)


def output_of(*command):
    return subprocess.run([str(word) for word in command], cwd=FOLDER, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True).stdout


# ---- Console blocks --------------------------------------------------------------------------------------------------

def demo():
    """What demo.sh prints where there is no VTK."""
    words = re.search(r"set -- (--z-from .*) ", (PROJECT / "Utilities" / "demo.sh").read_text(encoding="utf-8")).group(1).split()
    return output_of(sys.executable, PROJECT / "Utilities" / "horizon_mesh.py", "--no-pictures", "--output-folder", "out", "--report", "report.html",
                     *words, PROJECT / "Data" / "sample.vsm")


def cube_description():
    from seismichorizons.vtk import vtkSEGYCubeReader

    reader = vtkSEGYCubeReader()
    reader.SetFileName(str(GIVEN.real / "segy" / "ex1_missing_traces_75x71x26.segy"))
    reader.UpdateInformation()
    return reader.GetDescription()


# Page, a text in the block, what prints it, and whether that needs real data.
CONSOLE = [(PROJECT / "README.md", "sample.vsm: read in", demo, False),
           (PAGES / "SEGYCube.md", "26 vertical indices from", cube_description, True)]


def is_same_line(then, now):
    """Whether lines are the same but for times, and for what dots of the page leave out."""
    start, dots, _ = then.partition("...")
    without_times = [re.sub(r"read in \S+ s| +\d+\.\d\d$", "", line.rstrip()) for line in (then, now)]
    return now.startswith(start) if dots else without_times[0] == without_times[1]


def console_blocks():
    for page, marker, make, is_real in CONSOLE:
        if is_real and not GIVEN.real:
            continue
        blocks = [text for kind, text in re.findall(r"^```(\w*)\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S) if not kind and marker in text]
        if len(blocks) != 1:
            yield page, marker, None
            continue
        made = make()
        lines = iter(made.splitlines())  # of which the page may leave some out
        is_same = all(any(is_same_line(then, now) for now in lines) for then in blocks[0].splitlines())
        yield page, blocks[0], blocks[0] if is_same else made


# ---- Tables ----------------------------------------------------------------------------------------------------------

# Heading in StageTables.md, script and arguments, a cell of the rows that are compared, the title of a column that is not.
TABLES = [("## Surface\n", ("real_surfaces.py", GIVEN.real), "", "Seconds"), ("### Even meshes\n", ("even_meshes.py", GIVEN.real), "ours", "seconds")]
SLOW_TABLES = [("## Hole filling\n", ("hole_filling.py", "--real", GIVEN.real), "", "")]


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def tables():
    page = PAGES / "StageTables.md"
    for heading, (script, *arguments), kept, times in [*TABLES, *(SLOW_TABLES if GIVEN.slow else ())] if GIVEN.real else ():
        section = page.read_text(encoding="utf-8").partition(heading)[2]
        then = re.search(r"(?:^\|.*\n)+", section, re.M)
        lines = output_of(sys.executable, STUDIES / script, *arguments).splitlines()
        made = [cells_of(line) for line in lines if line.startswith("|")]
        if not then or not made or made[0] != cells_of(then.group().splitlines()[0]):
            yield page, heading, None
            continue
        rows = [row for row in made[2:] if not kept or kept in row]
        now = then.group().splitlines()
        places = [n for n, line in enumerate(now) if n > 1 and (not kept or kept in cells_of(line))]
        if len(places) != len(rows):
            yield page, heading, None
            continue
        for place, row in zip(places, rows):
            old = cells_of(now[place])
            if [cell for title, cell in zip(made[0], old) if title != times] != [cell for title, cell in zip(made[0], row) if title != times]:
                now[place] = "| %s |" % " | ".join(row)
        yield page, then.group(), "\n".join(now) + "\n"


# ---- Sentences -------------------------------------------------------------------------------------------------------

@functools.cache
def real(name, factor=1.0, **keywords):
    return sh.horizon(factor * read_real(GIVEN.real / (name + ".ijz")), direction="down", **keywords)


def despiked(name, unit):
    """The parts removed by the noise, above 4 in steps of 1, and above 4 in steps of 2.5."""
    horizon, longer = (real(name, vertical_unit=unit, vertical_step=step) for step in (1.0, 2.5))
    return [100.0 * sh.despike(*given).left_out["spikes"] / len(horizon) for given in ((horizon,), (horizon, 4.0), (longer, 10.0))]


def faults(name, unit, factor=1.0, step_factor=None):
    """With the defaults, and those above 4 vertical steps, which are 1, 2.5 and 5 long."""
    found = sh.faults(real(name, factor, vertical_unit=unit))
    lines = [len(sh.faults(real(name, step_factor or factor, vertical_unit=unit, vertical_step=step), 4.0 * step)) for step in (1.0, 2.5, 5.0)]
    return [found.smallest_throw, len(found), 1000.0 * len(found.links) / len(real(name)), *lines]


def picks_of_dome():
    script = re.search(r"```sh\n(python3 - > dome.dat.*?END\n)", (PAGES / "TutorialPicks.md").read_text(encoding="utf-8"), re.S).group(1)
    output_of("sh", "-c", script)
    return [len(sh.read(FOLDER / "dome.dat").popitem()[1])]


def positive_surfaces():
    output_of(GIVEN.programs / "generate_cube", "--noise", "0.2", "cube.sgy")
    cube = sh.read_cube(FOLDER / "cube.sgy")
    both, positive = (len(sh.extract(cube, polarity=polarity, largest_number=1000)) for polarity in ("both", "positive"))
    return ["half" if both == 2 * positive else "%d of %d" % (positive, both)]


def cutoffs():
    rms = [float(found) for found in re.findall(r"wrong side.* rms ([\d.]+)", output_of(GIVEN.programs / "SeismicHorizonsCutoffsTests", "TestCutoffs"))]
    return [min(rms), max(rms)]


DESPIKED = r" \| %s \| %s \| %s \|" % (NUMBER, NUMBER, NUMBER)
FAULTED = r" \| %s (?:ms|m) \| %s \| %s \| %s / %s / %s \|" % ((NUMBER,) * 6)
# Page, text with groups, what gives a number or a text for each group, and whether that needs real data.
SENTENCES = [
    ("StageTables.md", r"Mount St Helens, terrain \(1 m\)" + DESPIKED, lambda: despiked("st_helens/horizon", "m"), True),
    ("StageTables.md", r"Penobscot, horizon B" + DESPIKED, lambda: despiked("penobscot/horizon_b", "ms"), True),
    ("StageTables.md", r"Penobscot, horizon B" + FAULTED, lambda: faults("penobscot/horizon_b", "ms"), True),
    ("StageTables.md", r"Penobscot, sea bed" + FAULTED, lambda: faults("penobscot/seabed", "ms", 4.0, 1.0), True),
    ("StageTables.md", r"GeoProbe, sea floor" + FAULTED, lambda: faults("geoprobe/seafloor", "m"), True),
    ("StageTables.md", r"Mount St Helens, terrain" + FAULTED, lambda: faults("st_helens/horizon", "m"), True),
    ("TutorialPicks.md", r"this writes `dome.dat`, %s picks" % NUMBER, picks_of_dome, False),
    ("TutorialCube.md", r"keep only peaks, (.*) of the\s+surfaces", positive_surfaces, False),
    ("HorizonCutoffs.md", r"rms error of cutoffs is %s to %s m" % (NUMBER, NUMBER), cutoffs, False),
]


def as_on_page(value, shown):
    """The value with the digits that the page shows."""
    if isinstance(value, str):
        return value
    digits = len(shown.partition(".")[2])
    return format(value, ",.%df" % digits if "," in shown else ".%df" % digits)


def sentences():
    for name, expression, make, is_real in SENTENCES:
        if is_real and not GIVEN.real:
            continue
        page = PAGES / name
        found = re.search(expression, page.read_text(encoding="utf-8"))
        if not found:
            yield page, expression, None
            continue
        text, start = found.group(), found.start()
        for group, value in reversed(list(enumerate(make(), 1))):
            text = text[:found.start(group) - start] + as_on_page(value, found.group(group)) + text[found.end(group) - start:]
        yield page, found.group(), text


# ---- What takes longer -----------------------------------------------------------------------------------------------

def print_benchmarks():
    """Benchmarks are built on request: ninja BoundaryBenchmark and so on."""
    horizons = [GIVEN.real / name for name in ("penobscot/seabed.ijz", "penobscot/horizon_b.ijz")] if GIVEN.real else ()
    for command in (("ReflectionBenchmark", 120, 100, 220), ("BoundaryBenchmark",), ("DecimationBenchmark", 886639),
                    *([("DecimationBenchmark", *("%s=%d" % pair for pair in zip(horizons, (1, 4))))] if horizons else ())):
        print(" ".join(map(str, command)), output_of(GIVEN.programs / command[0], *command[1:]), sep="\n")


def write_pages():
    for name, command in (("FaultTables.md", [GIVEN.programs / "FaultStudy"]), ("ReflectionTables.md", [GIVEN.programs / "ReflectionStudy"]),
                          ("Benchmarks.md", [STUDIES / "benchmark.sh", "--markdown"])):
        (PAGES / name).write_text(output_of(*command), encoding="utf-8")
    subprocess.run([STUDIES / "reproduce_thesis.sh"], check=True)


def main():
    warnings.simplefilter("ignore")
    wrong = 0
    for page, then, now in (*console_blocks(), *tables(), *sentences()):
        if now is None:
            print("%s: no such text or table: %s" % (page.name, then.strip()))
        elif now != then:
            print("%s: was\n%s\nis\n%s" % (page.name, then.rstrip(), now.rstrip()))
            if GIVEN.write:
                page.write_text(page.read_text(encoding="utf-8").replace(then, now, 1), encoding="utf-8")
        wrong += now != then
    if GIVEN.slow:
        print_benchmarks()
    if GIVEN.slow and GIVEN.write:
        write_pages()
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
