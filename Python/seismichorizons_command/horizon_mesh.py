# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns files of seismic horizons into triangle meshes, with a table and a picture of every stage."""

import os
import signal
import sys

from . import VERSION_LINE

PROGRAM = os.path.splitext(os.path.basename(sys.argv[0]))[0]


def _end_at_once(signal_number, _frame):
    os._exit(128 + signal_number)


def make_parser():
    from . import parser

    return parser.make_parser(os.path.basename(sys.argv[0]), tell)


def tell(kind, text):
    """Writes an error or a warning."""
    sys.stderr.write("%s: %s: %s\n" % (PROGRAM, kind, text))
    sys.stderr.flush()


def fail(error):
    """Writes an error and returns the exit code."""
    tell("error", error)
    return 1


def _run(options):
    """Processes all files, then writes figures and report. Returns the exit code."""
    from . import batch, interrupt, progress, record, report
    from .core import HorizonError, heard_by
    from .settings import make_settings

    page = getattr(options, "report", None)
    if options.quiet:
        progress.silence()
    reason = None if options.no_pictures else batch.why_no_pictures()
    with_pictures = not options.no_pictures and reason is None
    run = record.Record(tell, bool(page or options.json), report.make_album(with_pictures) if page else None)
    if reason:
        run.warn(reason)
    try:
        if page:
            report.check(page)
        with heard_by(run.warn):
            batch.run(options.inputs, options.output_folder, make_settings(options), with_pictures, run,
                      not (options.json or options.quiet), options.threads)
        interrupt.check()
        if page:
            report.write(run.as_values(), page, run.album)
    except (HorizonError, OSError) as error:
        run.fail(error)
    if options.json:
        try:
            batch.print_lines([run.as_json()])
        except HorizonError as error:
            run.fail(error)
    return 0 if run.is_done() else 1


def main(arguments=None):
    # Until the work begins there is nothing to clean up, so Ctrl-C ends the program at once.
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _end_at_once)
    arguments = sys.argv[1:] if arguments is None else arguments
    if arguments == ["--version"]:  # needs no parser
        sys.stdout.write(VERSION_LINE)
        return 0
    parser = make_parser()
    options = parser.parse_args(arguments)
    parser.check(options)
    files = {os.path.normpath(path) for path in options.inputs}
    for word in arguments:
        is_text = word == word.encode(errors="replace").decode()
        if not is_text and os.path.normpath(word) not in files:  # errors of files are reported one by one
            parser.error("%s is not in UTF-8" % ascii(word))
    try:
        from . import interrupt
        from .core import set_threads
    except ImportError as error:
        return fail("the Python package seismichorizons cannot be loaded; is its folder in PYTHONPATH? (%s)" % error)
    interrupt.listen()
    set_threads(options.threads)
    return _run(options)


if __name__ == "__main__":
    sys.exit(main())
