# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Extracts the messages of a C++ file: arguments of functions such as InputError, and other texts with "expected" or a
remedy.

Concatenated expressions are joined, with `...` for each value; a conditional expression yields several messages.
"""

import collections
import itertools
import re

VALUE = "..."
TELLERS = ("InputError", "FileError", "ErrorAt", "CutOffAt", "Error", "Fail", "SetProblem", "vtkWarningMacro",
           "vtkWarningWithObjectMacro", "arnings.push_back", "arnings.emplace_back", "oubts.push_back")
CHECKS = {"CheckAtLeast": "at least %s%s", "CheckWithin": "%s to %s%s"}  # arguments: name, number, bounds, unit
HINT = re.compile(r"\bexpected\b|[:;] (?:set|add)\b")
SILENT = ("std::fixed", "this->ErrorPrefix", "FilePrefix")  # terms without text, or with only the position
MOST_CHOICES = 12
TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\]|\\.)+'
                   |[A-Za-z_]\w*(?:(?:::|\.|->)~?[A-Za-z_]\w*)*|\d[\w.']*|<<|->|::|\S""", re.S | re.X)
CLOSING = {"(": ")", "[": "]", "{": "}"}

def tokens_of(text):
    text = re.sub(r"^\s*#.*", "", text, flags=re.M)
    return [token for token in TOKEN.findall(text) if not token.startswith(("//", "/*"))]

def end_of(tokens, start, stops=()):
    """Returns the position of the first stop, or of an unmatched bracket, from a token on."""
    depth = 0
    for n in range(start, len(tokens)):
        if depth == 0 and tokens[n] in stops:
            return n
        depth += (tokens[n] in CLOSING) - (tokens[n] in CLOSING.values())
        if depth < 0:
            return n
    return len(tokens)

def start_of(tokens, n):
    """Returns the start of the expression that contains a token."""
    depth = 0
    while n > 0:
        token = tokens[n - 1]
        depth += (token in CLOSING.values()) - (token in CLOSING)
        if depth < 0 and token == "(" and (tokens[n - 2] == "std::string" or not re.match(r"\w", tokens[n - 2])):
            depth = 0
        elif depth < 0 or depth == 0 and token in (",", ";", "{", "}", "return", "=", "throw"):
            return n
        n -= 1
    return n

def split(tokens, mark):
    parts, start = [], 0
    while start <= len(tokens):
        end = end_of(tokens, start, [mark])
        parts.append(tokens[start:end])
        start = end + 1
    return parts

def choice_of(tokens, question, named):
    """Returns the texts of a conditional expression: a value takes precedence over a word for none, and a text over an
    empty one."""
    colon, depth = question + 1, 0
    while tokens[colon] != ":" or depth:
        depth += {"?": 1, ":": -1, "(": 9, ")": -9}.get(tokens[colon], 0)
        colon += 1
    texts = list(filter(None, texts_of(tokens[question + 1:colon], named) + texts_of(tokens[colon + 1:], named)))
    has_value = any(VALUE in text for text in texts)
    return [VALUE] if VALUE in texts else [text for text in texts if not has_value or " " in text] or [""]

def texts_of(tokens, named):
    """Returns the possible texts of an expression."""
    question = end_of(tokens, 0, ["?"])
    if question < len(tokens):
        return choice_of(tokens, question, named)
    is_stream = end_of(tokens, 0, ["<<"]) < len(tokens)
    terms = split(tokens, "<<" if is_stream else "+")
    if len(terms) > 1:
        is_named = is_stream and not any(token[0] == '"' for token in terms[0])  # the first term is the stream itself
        choices = [texts_of(term, named) for term in terms[is_named:]]
        return list(map("".join, itertools.islice(itertools.product(*choices), MOST_CHOICES)))
    if not tokens or tokens[0] in SILENT:
        return [""]
    if all(token[0] in "\"'" for token in tokens):
        return ["".join(token[1:-1].replace('\\"', '"').replace("\\n", " ") for token in tokens)]
    if tokens[0] in ("(", "std::string") and tokens[-1] == ")":
        return texts_of(tokens[1 + (tokens[0] != "("):-1], named)
    if len(tokens) == 1 or tokens[1] == "(":
        return named.get(tokens[0] if tokens[0].endswith(".str") else re.split("::|->", tokens[0])[-1],
                         ['"..."' if tokens[0] == "Quote" else VALUE])
    return [VALUE]

def name_local(tokens, n, named):
    """Stores the text of a definition under its name."""
    if tokens[n] == "=" and tokens[n - 2] in ("*", "std::string", "const"):
        named[tokens[n - 1]] = texts_of(tokens[n + 1:end_of(tokens, n + 1, ";")], named)

def named_texts(tokens, named):
    """Returns the texts of constants, and of functions whose only statement returns a text."""
    for n in range(2, len(tokens) - 1):
        if "constexpr" in tokens[max(0, n - 6):n]:
            name_local(tokens, n, named)
        head = tokens[max(0, n - 30):n] if tokens[n] == "{" and tokens[n + 1] == "return" else []
        places = [k for k in range(1, len(head) - 1) if head[k - 1] == "std::string" and head[k + 1] == "("]
        place = max(places, default=0)
        if place and not {";", "{", "}"} & set(head[place:]):
            named[head[place]] = texts_of(tokens[n + 2:end_of(tokens, n + 2, ";")], named)
    return named

def stream_texts(tokens, declared, teller, named):
    """Returns the texts written to a stream between its declaration and its use, joined if they continue the previous text."""
    before, texts = [], []
    for n in range(declared, teller):
        if tokens[n] == tokens[declared] and tokens[n - 1] in (";", "{", "}", ")") and tokens[n + 1] == "<<":
            more = texts_of(tokens[n:end_of(tokens, n, ";")], named)
            if tokens[n - 2:n] == ["else", "{"]:
                texts += [text + end for text in before for end in more]
            elif texts and (texts[0].endswith(" ") or re.match(r"[,;:)]|\.(?!\.\.)", more[0])):
                before, texts = texts, [text + end for text in texts for end in more]
            else:
                before, texts = [], more
    return texts

def checked(tokens, n, named):
    """Returns the message of a parameter check."""
    start = tokens.index("(", n) + 1
    name, _, *bounds, unit = split(tokens[start:end_of(tokens, start)], ",")
    numbers = ["".join(bound).removesuffix(".0") for bound in bounds]
    values = [number if re.match(r"-?[\d.e]+$", number) else VALUE for number in numbers]
    return "%s ..., expected %s" % (texts_of(name, named)[0], CHECKS[tokens[n]] % (*values, texts_of(unit, named)[0]))

def messages_of(text, constants):
    """Yields all message texts of a file, unprocessed."""
    tokens = tokens_of(text)
    named = collections.ChainMap({}, named_texts(tokens, dict(constants)))
    streams, untold = {}, {}
    for n in range(2, len(tokens) - 1):
        token = tokens[n]
        if token == "}" and len(named.maps) > 2:
            named = named.parents
        name_local(tokens, n, named)
        if token == "{":
            named = named.new_child()
        elif token == "std::ostringstream":
            streams[tokens[n + 1]] = n + 1
        elif token in CHECKS and tokens[n - 1] in (";", "{", "}"):
            yield checked(tokens, n, named)
        elif token.endswith(TELLERS) and tokens[n + 1] == "(":
            for argument in split(tokens[n + 2:end_of(tokens, n + 2)], ","):
                stream = argument[0].removesuffix(".str") if argument else None
                if stream in streams and argument[0] != stream:
                    named[argument[0]] = stream_texts(tokens, streams[stream], n, named)
                    untold.pop(streams[stream], None)
                yield from texts_of(argument, named)
        elif token[0] == '"' and HINT.search(token):
            start = start_of(tokens, n)
            texts = texts_of(tokens[start:end_of(tokens, start, [",", ";"])], named)
            if tokens[start] in streams:
                untold.setdefault(streams[tokens[start]], []).extend(texts)
            elif not (tokens[start - 1] == "=" and texts[0].startswith(",")):  # a continuation of other messages
                yield from texts
    yield from itertools.chain(*untold.values())
