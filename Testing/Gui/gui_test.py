# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives the window of ParaView through a script of events, and compares what its view shows.

Every event of the script has to find its menu entry, button or field.
"""

import pathlib
import sys

import image_compare
import window


def fill_in(template, script, values):
    text = template.read_text(encoding="utf-8")
    for key, value in values.items():
        text = text.replace("@%s@" % key, value)
    script.write_text(text, encoding="utf-8")


def play(paraview, script, folder):
    """Plays the script and returns the picture of the view.

    ParaView writes the picture when it finds no baseline, so it is given none: its own comparison is too lenient.
    The exit code says no more than that, and the log tells whether all events found their object.
    """
    _, log = window.run(paraview, script, folder, "--test-baseline=%s" % (folder / "no-such-baseline.png"),
                        "--test-threshold=1")
    picture = image_compare.load(folder / "no-such-baseline.png")
    if "Success =  true" not in log or "critical:" in log or picture is None:
        print(log)
        sys.exit("the script was not played to its end")
    return picture


def main():
    parser = image_compare.make_parser()
    parser.add_argument("--paraview", required=True)
    parser.add_argument("--template", type=pathlib.Path, required=True)
    parser.add_argument("--baseline", required=True)
    options = parser.parse_args()
    folder = window.new_folder(options.output / (options.baseline + ("-changed" if options.changed else "")))
    script = folder / "events.xml"
    fill_in(options.template, script, {
        "SAMPLE": str(options.data / "blobs.vsm"), "CELL_SIZE": "4" if options.changed else "3"})
    image_compare.finish(play(options.paraview, script, folder), options.baseline, options)


if __name__ == "__main__":
    main()
