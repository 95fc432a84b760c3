# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Types of arguments of the command, and options that collect lists."""

import argparse
import os
import re

HEIGHT_UNITS = ("ms", "s", "m", "ft")
MOST = 2**31  # exceeds the integers of the stages


def path(text):
    import pathlib  # takes longer to load than the rest of the command line

    return pathlib.Path(text)


def number_at_least(convert, least, more=False):
    """Returns an argparse converter for numbers that are at least `least` or, with `more`, larger than it."""

    def check(text):
        value = convert(text)
        if not (value > least if more else value >= least) or value >= (MOST if convert is int else float("inf")):
            raise ValueError(text)
        return value

    end = " and < 2^31" if convert is int else ""
    check.__name__ = "%s %s %g%s:" % ("integer" if convert is int else "number", ">" if more else ">=", least, end)
    return check


def line_number(text):
    value = int(text)
    if not -MOST <= value < MOST:
        raise ValueError(text)
    return value


line_number.__name__ = "integer of 32 bits:"


def vertical_step(text):
    value = float(text)
    if value == 0.0 or value != value or abs(value) == float("inf"):
        raise ValueError(text)
    return value


vertical_step.__name__ = "number other than 0:"


class Height(float):
    """A non-negative number from a text with a unit; without a unit it is in vertical indices."""

    def __new__(cls, text):
        number, unit = re.fullmatch(r"\s*(.*?)\s*(%s|)\s*" % "|".join(HEIGHT_UNITS), text).groups()
        try:
            height = super().__new__(cls, number)
        except ValueError:
            height = super().__new__(cls, "nan")
        if not 0.0 <= height < float("inf"):
            raise argparse.ArgumentTypeError("%s, expected a number of at least 0, with or without a unit (%s), such as 2ms" % (
                text, ", ".join(HEIGHT_UNITS)))
        height.unit = unit
        return height

    def __str__(self):
        return "%g%s" % (self, self.unit)


def memory(text):
    """Converts texts such as "2G", "1.5 GB" or "800M" to bytes."""
    found = re.fullmatch(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*([KMGT]?)I?B?\s*", text.upper())
    size = float(found.group(1)) * 1024 ** " KMGT".index(found.group(2) or " ") if found else 0.0
    if not 1.0 <= size < float("inf"):
        raise ValueError(text)
    return int(size)


memory.__name__ = "size like 2G or 800M:"


class Assignments(tuple):
    """Names that end in =, of which a list has some with values."""

    def __contains__(self, text):
        name, sign, value = text.partition("=")
        return bool(value) and super().__contains__(name + sign)


def assigned(words):
    """Returns the values of words such as "XByte=73", "KeepOthers=on" and "SampleRange=0:200", by their names."""
    return {name: _value(value) for name, _, value in (word.partition("=") for word in words)}


def _value(text):
    if text in ("on", "off"):
        return text == "on"
    for convert in (int, float, lambda pair: [int(number) for number in pair.split(":")]):
        try:
            return convert(text)
        except ValueError:
            continue
    return text


class AddToList(argparse.Action):
    """Adds the values of a comma list to the list of an option. With `values`, only these are accepted; paths of files that
    exist, and names of horizons, are not split, as they may contain commas (reading.names_in splits names)."""

    def __init__(self, values=None, are_names=False, **others):
        super().__init__(**others)
        self.values, self.are_names = values, are_names

    def ends_at(self, word):
        """Whether a word after this list is an input file and no value, for options whose values are not files."""
        return (self.values is not None or self.are_names) and os.path.exists(word) and word not in (self.values or ())

    def is_list(self, word):
        """Whether a word is a list with commas."""
        return "," in word and (self.values is not None or self.are_names or not os.path.exists(word))

    def __call__(self, parser, namespace, word, option_string=None):
        parts = [part.strip() for part in word.split(",") if part.strip()] if self.is_list(word) else [word]
        if not parts or not word:
            raise argparse.ArgumentError(self, "%r, expected values, with commas between them" % word)
        parts = [word] if self.are_names else parts
        for part in parts:
            if self.values is not None and part not in self.values:
                raise argparse.ArgumentError(self, "invalid choice: %r (choose from %s)" % (
                    part, ", ".join(map(repr, self.values))))
        known = getattr(namespace, self.dest, self.default)
        setattr(namespace, self.dest, parts if known is self.default else [*known, *parts])
