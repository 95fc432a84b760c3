# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arranges the words of a command line as argparse needs them: lists of any form, and options and files in any order."""

import os
import re

from .arguments import AddToList, Height

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", re.IGNORECASE)
UNIT = re.compile(r"[A-Za-z]{1,6}")


def arrange(parser, words):
    """Returns the words with options first, then `--` and the files. Lists become repeated options: a list ends after a
    word with commas, before `--`, before the next option, and before a file that exists. If no file is left, the last word
    of a list at the end of the line is the file."""
    words, options, files = list(words), [], []
    last = None  # a list at the end of the line
    while words:
        word = words.pop(0)
        if word == "--":
            files += words
            break
        if not _is_option(word):
            files.append(word)
            continue
        action, wanted = _find(parser, word)
        if isinstance(action, AddToList) and wanted:
            values = _take_list(parser, action, words)
            last = (len(options) + len(values) - 1) if len(values) > 1 and not words else None
            options += [_joined(action, value) for value in values] or [word]
        else:
            options += _with_values(action, word, _take(parser, action, wanted, words))
    if not files and last is not None:
        files.append(options.pop(last).partition("=")[2])
    return [*options, *(["--", *files] if files else [])]


def _is_option(word):
    return word.startswith("-") and word != "-" and not NUMBER.fullmatch(word)


def _ends_values(parser, word):
    """Whether a word in the place of a value is an option. Other values may begin with a minus, as -,X,Y,Z and -1e5 do."""
    return _is_option(word) and (word.startswith("--") or _find_short(parser._option_string_actions, word)[0] is not None)


def _joined(action, value):
    return "%s=%s" % (action.option_strings[-1], value)


def _with_values(action, word, values):
    """The words of an option and its values, which argparse must not take for options."""
    if len(values) == 1 and action.nargs is None and values[0].startswith("-"):
        return [_joined(action, values[0])] if word.startswith("--") else [word + values[0]]
    return [word, *(" " + value if value.startswith("-") else value for value in values)]


def _find(parser, word):
    """Returns the option of a word, None if there is none, and the number of further words that are its values."""
    known = parser._option_string_actions
    if not word.startswith("--"):
        return _find_short(known, word)
    name, has_value, _ = word.partition("=")
    found = {known[option] for option in known if option.startswith(name)} if name not in known else {known[name]}
    action = found.pop() if len(found) == 1 else None
    return action, 0 if action is None or has_value else 1 if action.nargs is None else action.nargs


def _find_short(known, word):
    """Does the same for a word such as -j4 or -qj, in which the last letter may have a value in the next word."""
    for place, letter in enumerate(word[1:], 2):
        action = known.get("-" + letter)
        if action is None or action.nargs != 0:
            return action, 1 if action is not None and place == len(word) else 0
    return action, 0


def _take(parser, action, number, words):
    """Removes the values of an option from the beginning of the words and returns them. A number and a unit are one value."""
    taken = []
    while words and len(taken) < number and not _ends_values(parser, words[0]):
        taken.append(words.pop(0))
    if (taken and action.type is Height and NUMBER.fullmatch(taken[-1]) and words and UNIT.fullmatch(words[0])
            and not os.path.exists(words[0])):
        taken[-1] += " " + words.pop(0)
    return taken


def _take_list(parser, action, words):
    """Removes the values of a list from the beginning of the words and returns them."""
    end = next((place for place, word in enumerate(words) if _ends_values(parser, word)), len(words))
    if end == len(words) or words[end] != "--":
        if end and action.is_list(words[0]):
            end = 1
        end = next((place for place in range(1, end) if action.ends_at(words[place])), end)
    taken, words[:end] = words[:end], []
    return taken
