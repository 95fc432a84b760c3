# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Completion for bash and zsh, written from the parser."""

from . import screens
from .arguments import AddToList

FILE_METAVARS = ("FILE", "FILES", "FILE.html")


def shown(parser):
    """Returns the options that the help shows."""
    return [action for action in parser._actions if action.option_strings]


def values_of(action):
    """Returns the values that an option accepts; none if they are files or free."""
    return tuple(action.values or () if isinstance(action, AddToList) else action.choices or ())


def _is_folder(action):
    return action.metavar == "FOLDER"


def _is_file(action):
    return action.metavar in FILE_METAVARS


BASH = """\
# Completion of {name} for bash, written by {name} --completion bash.
{function}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD-1]}} values= kind=file before=
  if [[ $current == = ]]; then # --option=
    current=
  elif [[ $option == = ]]; then
    option=${{COMP_WORDS[COMP_CWORD-2]}}
  elif [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "{options}" -- "$current"))
    return
  fi
  case $option in
{cases}
  esac
  case $kind in
    list)
      [[ $current == *,* ]] && before=${{current%,*}},
      COMPREPLY=($(compgen -P "$before" -W "$values" -- "${{current##*,}}")) ;;
    value) COMPREPLY=($(compgen -W "$values" -- "$current")) ;;
    folder) compopt -o filenames 2> /dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    file) compopt -o filenames 2> /dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
  esac
}}
complete -F {function} {name}
"""


def bash(parser, name):
    """Returns the completion for bash."""
    grouped = {}  # options by kind and values
    for action in shown(parser):
        if action.nargs != 0 and not _is_file(action):
            kind = "folder" if _is_folder(action) else "list" if isinstance(action, AddToList) else "value"
            grouped.setdefault((kind, " ".join(values_of(action))), []).extend(action.option_strings)
    cases = ["    %s) kind=%s values=\"%s\" ;;" % ("|".join(options), *which) for which, options in grouped.items()]
    options = " ".join(option for action in shown(parser) for option in action.option_strings)
    return BASH.format(name=name, function="_" + name.replace("-", "_"), options=options, cases="\n".join(cases))


def zsh(parser, name):
    """Returns the completion for zsh."""
    repeated = [action for action in shown(parser) if isinstance(action, AddToList)]
    lines = [_zsh_option(parser, action, option, action in repeated)
             for action in shown(parser) for option in action.option_strings]
    return "#compdef %s\n# Completion of %s for zsh, written by %s --completion zsh.\n_arguments -s -S \\\n%s\n" % (
        name, name, name, " \\\n".join("  " + line for line in [*lines, "'*:input:_files'"]))


def _zsh_option(parser, action, option, is_repeated):
    """Returns one option as _arguments takes it."""
    others = " ".join(other for other in action.option_strings)
    before = "*" if is_repeated else "(%s)" % others
    metavars = action.metavar if isinstance(action.metavar, tuple) else (action.metavar or action.dest.upper(),) * (
        1 if action.nargs is None else action.nargs)
    values = "".join(":%s:%s" % (metavar.replace(":", ""), _zsh_values(action)) for metavar in metavars)
    sign = "" if action.nargs == 0 else "=" if option.startswith("--") and action.nargs is None else "" if len(metavars) > 1 else "+"
    text = screens.effect(parser, action).replace("[", "(").replace("]", ")").replace("'", "")
    return "'%s%s%s[%s]%s'" % (before, option, sign, text, values)


def _zsh_values(action):
    values = values_of(action)
    if values:
        words = " ".join(values)
        return "_values -s , value %s" % words if isinstance(action, AddToList) else "(%s)" % words
    return "_files -/" if _is_folder(action) else "_files" if _is_file(action) else " "


SHELLS = {"bash": bash, "zsh": zsh}
