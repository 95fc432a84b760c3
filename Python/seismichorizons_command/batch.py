# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Processes files of horizons one after the other: writes a mesh for each horizon, a picture and a table."""

import contextlib
import ctypes
import ctypes.util
import functools
import os
import pathlib
import shutil
import sys
import tempfile
import time
from dataclasses import replace

try:
    import fcntl
except ImportError:  # on Windows
    fcntl = None

from . import cutoffs, data, interrupt, jobs, naming, pipeline, reading, tables, volumes, writing
from .found import Found
from .found import written as written_line
from .large import LargeHorizon
from .memory import Budget
from .naming import make_labels, make_stems
from .core import HorizonError, heard_by, share_threads
from .supply import Supply

STACK = "stack"  # label of layers between files of one horizon each
WORKSPACE = ".horizon_mesh-"  # prefix of the temporary folders of a run
SECONDS_TO_LOCK = 2.0


class Results:
    """The output folder: results appear there, unless they would replace an input or the results of another file."""

    def __init__(self, workspace, taken):
        self.workspace, self.folder = workspace, workspace.parent
        self._taken = taken

    def require(self, names, label):
        """Reserves names of results for a file. Raises HorizonError."""
        self._taken.require(self.folder, names, label)

    def publish(self, folder):
        """Moves results into place and returns their names."""
        written = sorted(os.listdir(folder))
        for name in written:
            os.replace(os.path.join(folder, name), self.folder / name)
        return written


def run(inputs, output_folder, settings, with_pictures, record, prints=True, threads=0):
    """Processes all files and folders. An error in one file goes to the record (record.Record), and the other files are
    still processed; `threads` are shared by the processes of settings.jobs. Raises HorizonError or OSError if no file can be
    processed."""
    record.begin(settings)
    files = find_files(inputs, record)
    labels = make_labels(files)
    stack = [] if settings.joins_horizons() and len(files) > 1 else None
    stems = naming.distinct(naming.shorten(stem, naming.LONGEST_STEM) for stem in make_stems(labels))
    taken = naming.Taken([*files, *settings.other_files])
    settings = replace(settings, jobs=max(1, min(settings.jobs, len(files))) if jobs.CAN_FORK else 1)
    tasks = list(zip(files, labels, stems))
    print_if = print_lines if prints else lambda _: None
    with _workspace(output_folder) as workspace:
        results = Results(workspace, taken)
        if settings.jobs > 1:
            work = functools.partial(_process_apart, results=results, settings=settings, with_pictures=with_pictures,
                                     record=record, stack=stack, threads=threads)
            with contextlib.closing(jobs.run_in_order(work, tasks, settings.jobs)) as outcomes:
                for (path, label, _), outcome in zip(tasks, outcomes):
                    _accept(outcome, path, label, results, record, stack, print_if)
        else:
            for path, label, stem in tasks:
                _attempt(path, label, record, print_if, lambda: process(
                    path, label, stem, results, settings, with_pictures, record, stack))
        if stack:
            _attempt(STACK, STACK, record, print_if, lambda: process_stack(stack, results, settings, record))
    if len(record.files) > 1:
        print_if([record.summary(output_folder, record.files[:-1] if stack else record.files)])


def _attempt(path, label, record, print_if, make_lines):
    """Processes one file and prints its lines; an error goes to the record."""
    record.begin_file(path, label)
    try:
        with heard_by(functools.partial(record.warn_of_file, path, label)):
            lines = make_lines()
        print_if(lines)
    except (HorizonError, OSError) as error:
        record.fail_file(error)


def _process_apart(task, results, settings, with_pictures, record, stack, threads):
    """Processes one file in another process and returns the outcome (jobs.Outcome)."""
    share_threads(threads, settings.jobs)
    path, label, stem = task
    outcome = jobs.Outcome()
    own = record.part(lambda *message: outcome.messages.append(message))
    later = jobs.Later(results, outcome, own)
    stacked = None if stack is None else []
    _attempt(path, label, own, outcome.lines.extend, lambda: process(
        path, label, stem, later, settings, with_pictures, own, stacked))
    outcome.file, outcome.meshes = own.files[0], own.meshes
    if own.album:
        outcome.entries, outcome.layers = own.album.entries, own.album.layers
    if stacked:
        outcome.stacked = (*stacked[0][:2], jobs.store(stacked[0][2], results.workspace))
    return outcome


def _accept(outcome, path, label, results, record, stack, print_if):
    """Puts the results of another process in place and reports them, as if the file had been processed here."""
    if isinstance(outcome, HorizonError):
        record.begin_file(path, label)
        record.fail_file("%s: %s" % (label, outcome))
        return
    file, messages = outcome.before, outcome.messages[:outcome.told]
    try:
        if outcome.names:
            results.require(outcome.names, label)
        file, messages = outcome.unpublished, outcome.messages
        if outcome.folder:
            results.publish(outcome.folder)
    except (HorizonError, OSError) as error:
        record.take(file, messages)
        record.fail_file(error)
        return
    record.take(outcome.file, outcome.messages)
    record.take_results(outcome)
    if outcome.stacked:
        stack.append((*outcome.stacked[:2], jobs.restore(outcome.stacked[2])))
    try:
        if outcome.lines:
            print_if(outcome.lines)
    except HorizonError as error:
        record.fail_file(error)


def find_files(inputs, record):
    """Returns the input files and the files in input folders that a reader recognizes. A folder without any is reported to
    the record. Raises HorizonError or OSError."""
    files = []
    for path in inputs:
        if os.path.isdir(path):  # false for a name that is too long, which its reader reports
            found = sorted(file for file in path.iterdir() if file.is_file() and reading.find_format(file))
            if not found:
                record.begin_file(path, path)
                record.fail_file("%s: there is no file of horizons in this folder" % path)
            files.extend(found)
        else:
            files.append(path)
    return files


@contextlib.contextmanager
def _workspace(output_folder):
    """Makes a folder for incomplete results inside the output folder, so that finished files can be moved into place. A
    missing output folder is created, and removed if no result was written. Workspaces left by killed programs are removed.
    Raises HorizonError."""
    missing = [folder for folder in (output_folder, *output_folder.parents) if not os.path.exists(folder)]
    try:
        try:
            if missing:
                output_folder.mkdir(parents=True, exist_ok=True)
            _remove_abandoned(output_folder)
            workspace = tempfile.TemporaryDirectory(prefix=WORKSPACE, dir=output_folder)
        except OSError as error:
            raise HorizonError("results cannot be written into %s: %s" % (output_folder, error.strerror)) from None
        with workspace as path, _lock(path):
            yield pathlib.Path(path)
    finally:
        for folder in missing:
            with contextlib.suppress(OSError):  # the folder is not empty
                folder.rmdir()


@contextlib.contextmanager
def _lock(folder):
    """Locks a folder while the block runs; the system releases the lock when the program ends in any way. Yields whether no
    other program holds it; on Windows, which has no such locks, always False."""
    if fcntl is None:
        yield False
        return
    is_own = False
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        with contextlib.suppress(OSError):
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            is_own = True
        yield is_own
    finally:
        os.close(descriptor)


def _remove_abandoned(output_folder):
    """Removes the workspaces of killed programs. A workspace that has just been created may not be locked yet, and stays."""
    for folder in output_folder.glob(WORKSPACE + "*"):
        with contextlib.suppress(OSError):
            if time.time() - folder.stat().st_mtime < SECONDS_TO_LOCK:
                continue
            with _lock(folder) as is_own:
                if is_own:
                    shutil.rmtree(folder, ignore_errors=True)


def process(path, label, stem, results, settings, with_pictures, record, stack=None):
    """Processes one file. Its results (Results) appear all together at the end, or not at all. Returns the lines to print. With a stack, a file with a single horizon contributes its stem, name and points to the stack instead of
    having layers of its own. Raises HorizonError or OSError."""
    left_out = [] if settings.leave_out_invalid else None
    supply = Supply(path, settings.horizons, Budget(settings.memory, settings.jobs), settings.can_go_by_rows(), left_out, **settings.reader)
    for text in left_out or []:
        record.warn(text)
    _require_scale(label, supply, settings)
    names = naming.Names(stem, supply.names, settings, with_pictures)
    results.require(names.all(), label)
    found = Found()
    with tempfile.TemporaryDirectory(dir=results.workspace) as folder:
        made = _run_stages(label, supply, settings, record, names, pathlib.Path(folder), found)
        lines = _write(made, names, pathlib.Path(folder), settings.written_direction)
        if stack is not None and len(made) == 1:
            stack.append((stem, made[0].name, writing.prepared(made[0])))
        elif settings.joins_horizons():
            points = {result.name: writing.prepared(result) for result in made}
            lines += _write_together(label, points, settings, names, pathlib.Path(folder), record)
        interrupt.check()
        written = results.publish(folder)
    record.end_file(supply, written)
    lines = [*found.lines(supply.origin, settings), *tables.table(made), *lines, written_line(written, results.folder)]
    return ["%s: read in %.2f s" % (label, supply.seconds), *(("  " + line).rstrip() for line in lines)]


def process_stack(stack, results, settings, record):
    """Makes the layers and cutoffs of files of one horizon each, in the same way as process."""
    if len(stack) == 1 and settings.layers is not None:
        raise HorizonError("%s: one horizon, expected at least 2, in the file or in files of one horizon each" % stack[0][0])
    titles = [name for _, name, _ in stack]
    if len(set(titles)) < len(titles):
        titles = [stem for stem, _, _ in stack]
    names = naming.Names(STACK, titles, settings, False)
    results.require(names.of_stack(), STACK)
    with tempfile.TemporaryDirectory(dir=results.workspace) as folder:
        points = dict(zip(titles, (points for _, _, points in stack)))
        lines = _write_together(STACK, points, settings, names, pathlib.Path(folder), record)
        interrupt.check()
        written = results.publish(folder)
    record.end_stack(written)
    return ["%s of %d files" % (STACK, len(stack)),
            *("  " + line for line in [*lines, written_line(written, results.folder)])]


def _require_scale(label, supply, settings):
    """Raises HorizonError if heights have a unit that does not fit z, or if the size of a vertical index is unknown."""
    for name, unit in supply.units():
        try:
            settings.in_unit(unit)
        except HorizonError as error:
            raise HorizonError("%s: %s: %s" % (label, name, error)) from None
    said, unit = settings.said_unit(), settings.reader.get("VerticalUnit")
    if not reading.counts_indices(supply.origin["format"], settings.reader):
        return
    if said:
        raise HorizonError("%s: an error or threshold in %s, and z in vertical indices, expected --vertical-step with the "
                           "length of one, or --z-from RealZ" % (label, said))
    if unit:
        raise HorizonError("%s: --vertical-unit %s, and z in vertical indices, expected --vertical-step with the length of "
                           "one, or --z-from RealZ" % (label, unit))


def _run_stages(label, supply, settings, record, names, folder, found):
    """Returns the results of all horizons except those left out, and writes each at once. If not all horizons fit in
    memory, only their meshes are kept. `found` collects what was recognised in the file."""
    results = []
    settings = pipeline.with_faults(settings)
    for name, points in supply:
        if isinstance(points, LargeHorizon):
            result = pipeline.run_by_rows(label, points, settings)
        else:
            result = pipeline.run(label, name, points, settings, supply.surfaces.get(name))
        if settings.said_unit() or settings.plain_error() is None and not reading.counts_indices(
                supply.origin["format"], settings.reader):
            result.report_in(settings.said_unit())
        found.add(result.data.get("points", result.data["mesh"]), result.data["mesh"])
        del points
        for warning in result.warnings:
            record.warn("%s: %s" % (label, warning))
        files = _files_of(result, names.meshes[name], record, label)
        if files and (data.count_points(result.data["mesh"]) or not settings.leave_out_invalid):
            _write_mesh(result, files, names.lines.get(name, {}), folder, record, settings)
            record.add_horizon(result, supply, files)
            results.append(result)
        result.data.pop("measured", None)
        if not supply.is_whole and settings.joins_horizons():
            raise HorizonError("%s: layers, cutoffs or sealed models of horizons larger than memory, expected more memory (--memory) or fewer "
                               "horizons (--horizons)" % label)
        if not supply.is_whole:
            result.release()
    for warning in settings.given_faults.warnings() if settings.given_faults else ():
        record.warn("%s: %s" % (label, warning))
    if not results:
        raise HorizonError("%s: all horizons were left out" % label)
    return results


def _files_of(result, files, record, label):
    """Returns those of the files of a horizon that can be written: only points, with a warning, if there are no triangles."""
    if not data.count_points(result.data["mesh"]) or data.count_polygons(result.data["mesh"]):
        return files
    kept = [file for file in files if file.endswith(tuple("." + form for form in writing.POINT_FORMATS))]
    if kept != files:
        record.warn("%s: %s is left out%s: no triangles between %d points, expected some that are not on one line%s" % (
            label, result.name, " of the meshes" if kept else "", result.number_of_points,
            "" if kept else "; --formats dat writes the points of a line"))
    return kept


def _write_mesh(result, files, fault_files, folder, record, settings):
    for name in files:
        for warning in writing.write(result, folder / name, settings.grids_of_meshes, settings.written_direction):
            record.warn("%s: %s" % (name, warning))
    for name, given in fault_files.items():
        writing.write_fault_lines(result.data[given], folder / name, settings.written_direction)


def _write(results, names, folder, direction):
    """Writes results and returns the lines to print."""
    lines = []
    for name in names.faults:
        writing.write_data(results[0].data["fault surfaces"], folder / name, "Faults", direction)
    for name in names.figures:
        writing.write_tables([result.figures for result in results], folder / name)
    for name in names.pictures:
        # The drawing libraries are loaded only if needed.
        from . import overview

        if len(results) > overview.MOST_ROWS:
            lines.append("the picture shows the first %d of %d horizons" % (overview.MOST_ROWS, len(results)))
        overview.write(results, folder / name)
    return lines


def _write_together(label, points, settings, names, folder, record):
    """Writes what all horizons have together, given their points by name, and returns the lines to print. Raises HorizonError."""
    lines = []
    for wanted, write in ((settings.cutoffs, cutoffs.write), (settings.sealed, cutoffs.write_sealed)):
        if wanted is not None:
            more, warnings = write(points, settings, label, names, folder)
            lines += more
            for warning in warnings:
                record.warn("%s: %s" % (label, warning))
    if settings.layers is not None:
        lines += _write_layers(label, points, settings, names, folder, record)
    return lines


def _write_layers(label, points, settings, names, folder, record):
    """Writes the volumes between horizons, given their points by name, and returns the lines to print. Raises HorizonError."""
    made, warnings = volumes.of_points(points, settings, label)
    writing.write_tables([made.table], folder / names.layers[0])
    for name in names.layers[1:]:
        warnings += writing.write_cells(made.cells, folder / name)
    for number, (name, body) in enumerate(made.bodies.items()):
        for form in names.body_formats:
            for warning in writing.write_data(body, folder / names.body(number, form), name, settings.written_direction):
                record.warn("%s: %s" % (names.body(number, form), warning))
    for warning in warnings:
        record.warn("%s: %s" % (label, warning))
    record.add_layers(made)
    return ["%s: volume %.6g%s, thickness %.6g to %.6g, mean %.6g" % (
        name, own.volume, " " + own.volume_unit if own.volume_unit else "", own.thickness_least, own.thickness_largest,
        own.thickness_mean) for name, own in made.figures.items()]


def print_lines(lines):
    """Prints lines. Raises HorizonError if that fails; later output is then discarded."""
    try:
        print("\n".join(lines), flush=True)
    except OSError as error:
        # Unwritten output must not be flushed again when the program ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise HorizonError("the table cannot be printed: %s" % error.strerror) from None


NO_VTK = "no pictures, as VTK is missing (pip install seismichorizons[pictures])"
NO_DISPLAY = "no pictures, as there is no X server (xvfb-run starts one)"


def why_no_pictures():
    """Returns why pictures cannot be drawn; None if they can. Without an X server VTK ends the program, except in builds
    that need none."""
    try:
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: registers window classes
    except ImportError:
        return NO_VTK
    library = ctypes.util.find_library("X11") or "libX11.so.6"
    try:
        x11 = ctypes.CDLL(library)
        x11.XOpenDisplay.restype = ctypes.c_void_p
        display = x11.XOpenDisplay(None)
        if display:
            x11.XCloseDisplay(ctypes.c_void_p(display))
            return None
    except OSError:
        pass
    return None if _draws_without_display() else NO_DISPLAY


def _draws_without_display():
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    before = vtkObject.GetGlobalWarningDisplay()
    vtkObject.SetGlobalWarningDisplay(False)  # later versions of VTK try X first and warn
    try:
        return not vtkRenderWindow().IsA("vtkXOpenGLRenderWindow")
    finally:
        vtkObject.SetGlobalWarningDisplay(before)
