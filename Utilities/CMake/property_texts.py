# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Property help in the panel and property tables on the pages, generated from the comments of the setters.

    property_texts.py panel FOLDER    writes the XML files of the plugin, with help, into a folder (run by the build)
    property_texts.py pages           writes the tables of properties into Documentation (target texts)

The first paragraph of a comment is the text; further paragraphs are for programmers. It ends with the facts that apply:

    Unit: columns. Range: 1 to 16. Default: 2.

The range of a choice lists the enumerators of its macro or below '/// Values of ...'; the page adds the labels of the
panel if they differ, because scripts of ParaView need them. 'Default: 3 in vtkA, 8 in vtkB.' gives a default for each
class. Names of properties, values and classes are written as in C++; the panel shows them with its labels, the page as
code and links. 'See "Faults" in HorizonFaults.md.' becomes a link on the page and is omitted from the panel. A property
without a method of its own (an input) has its text in the XML file, in the same form. The brief of a class is the short
help of its proxy.

The page of a proxy has a line '<!-- HorizonSurface -->' with its name, and below it the table of the proxy's own
properties. Properties of a base have a table of their own, and the pages of its proxies link to it if it is on another
one. A proxy without properties of its own has no table.

If the comment of a base class says 'Its properties are on HorizonSurface.md.', its properties are only in the first table
of that page that has them, and other pages link to it. A property whose default differs between classes is on the page of each class.

The plugin has two proxies of each reader: the one in the XML file and a copy under another name. ParaView asks readers
for a file in alphabetical order of these names and takes the first that accepts it. The copy comes before all readers of
ParaView that do not check the content of files, such as the CSV reader. Python uses labels and therefore creates the
copy; state files of earlier versions contain the original.
"""

import argparse
import collections
import copy
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

from property_panels import Expander, read_methods, read_values, with_blanks

TREE = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("Property", "Default", "Range", "Unit", "Meaning")
NAME = r"(?<!array )(?<!field data )\b[A-Z]\w*\b"
COMPOUND = r"[A-Z]\w*[a-z0-9][A-Z]\w*$|[A-Z]{2}[a-z]{2}\w*$"
FIRST = "ByContent"  # prefix of the copy of a reader proxy
SEE = r'See "([^"]+)" in (\w+\.md)\.'
PLACE = r"^<!-- (\w+) -->\n\n"
TABLE = r"(?:\| %s \|\n(?:\|.*\n)*)?" % r" \| ".join(COLUMNS)

Text = collections.namedtuple("Text", "meaning unit range default")
Header = collections.namedtuple("Header", "base brief page texts values methods")
Facts = collections.namedtuple("Facts", "texts values methods")


def split_facts(paragraph):
    """Splits a text from the facts at its end; None for missing facts."""
    text = " ".join(paragraph.split())
    facts = {}
    for name in ("default", "range", "unit"):
        found = re.fullmatch(r"(.*?) ?\b%s: (.*)\." % name.capitalize(), text)
        if found:
            text, facts[name] = found.groups()
    return Text(text, facts.get("unit"), facts.get("range"), facts.get("default"))


def text_of(class_name, paragraph):
    """A text with the default of a class."""
    text = split_facts(paragraph)
    own_default = re.search(r"(\S+) in %s\b" % class_name, text.default or "")
    return text._replace(default=own_default.group(1)) if own_default else text


def read_header(path):
    """Returns the base of a class, its brief, the page of its properties, the texts of its methods, and the values of
    choices."""
    text = path.read_text(encoding="utf-8")
    brief = re.search(r"@brief +((?:.+\n)+?) \*\n", text)
    page = re.search(r"Its properties are on (\w+\.md)\.", text.replace("\n * ", " "))
    base = re.search(r"^class \w+ (?:vtk\w+) : public (\w+)", text, re.M)
    texts = {}
    comment = r"^  (?:/\*\*\n((?:   \*(?!/).*\n)+)   \*/|/// (.*))\n((?:  (?!/).*\n)+)"
    for block, line, lines in re.findall(comment, text, re.M):
        paragraph = re.sub(r"^   \* ?", "", block, flags=re.M).split("\n\n")[0] or line
        for access, name, method in re.findall(r"^  (?:vtk(Set|Get|Horizon)\w*Macro\((\w+)|[^(\n]*?(\w+)\()", lines, re.M):
            texts[method or access.replace("Horizon", "Set") + name] = paragraph
        if "vtkHorizonFileNamesMacro" in lines:
            texts["AddFileName"] = paragraph
    return Header(base and base.group(1), brief and " ".join(brief.group(1).replace("\n *", " ").split()),
                  page and page.group(1), texts, read_values(text), read_methods(text))


class Proxy:
    """A proxy of the plugin with its properties, base properties first. `places` are the pages of proxies."""

    def __init__(self, element, proxies, places):
        self.base = proxies.get(element.get("base_proxyname"))
        self.name = element.get("name")
        self.class_name = element.get("class") or "vtk" + self.name  # a base has the name of its class
        self.is_base = not element.get("class")
        self.label = element.get("label", self.name)
        self.element = element
        self.own = [e for e in element if e.tag.endswith("Property")]
        self.properties = (self.base.properties if self.base else []) + self.own
        self.page = places.get(self.name)


def first_asked(element):
    """Returns the copy of a reader proxy that ParaView asks before others and for any file name; the original is no longer
    asked."""
    hints = element.find("Hints")
    first = ElementTree.Element("SourceProxy", name=FIRST + element.get("name"), label=element.get("label"),
                                base_proxygroup="sources", base_proxyname=element.get("name"))
    first.set("class", element.get("class"))
    first.extend([copy.deepcopy(element.find("Documentation")), copy.deepcopy(hints)])
    hints.remove(hints.find("ReaderFactory"))
    first.find("Hints/ReaderFactory").set("filename_patterns", "*")
    return first


def label_of(prop):
    """Returns the label of a property in the panel; ParaView inserts blanks into the name."""
    return prop.get("label") or with_blanks(prop.get("name"))


class Texts:
    """The texts of all properties of the plugin."""

    def __init__(self, tree=TREE):
        self.documentation = tree / "Documentation"
        folders = ("Filters", "Sources", "Readers", "Writers")
        self.headers = {path.stem: read_header(path) for folder in folders for path in (tree / folder).rglob("vtk*.h")}
        self.files = {}
        self.proxies = {}
        self.places = {name: path.name for path in self.documentation.glob("*.md")
                       for name in re.findall(PLACE, path.read_text(encoding="utf-8"), re.M)}
        waiting = [(path, ElementTree.parse(path)) for path in sorted((tree / "ParaViewPlugin").glob("*.xml"))]
        waiting.sort(key=lambda entry: entry[1].find("ProxyGroup[@name='horizon_bases']") is None)  # bases first
        for path, document in waiting:
            self.files[path.name] = document
            for kind in ("SourceProxy", "WriterProxy"):
                for element in document.iter(kind):
                    expander = Expander(element, self.facts(element.get("class") or "vtk" + element.get("name")))
                    expander.expand()
                    if element.get("class"):
                        base = self.proxies.get(element.get("base_proxyname"))
                        expander.add_unnamed({prop.get("command") for prop in base.properties} if base else set())
                    self.proxies[element.get("name")] = Proxy(element, self.proxies, self.places)
        self.of_class = {proxy.class_name: proxy for proxy in self.proxies.values() if not proxy.is_base}

    def lineage(self, class_name):
        while class_name in self.headers:
            yield self.headers[class_name]
            class_name = self.headers[class_name].base

    def facts(self, class_name):
        """What the headers of a class and its bases state; an own statement goes before that of a base."""
        facts = Facts({}, {}, {})
        for header in reversed([*self.lineage(class_name)]):
            texts = {name: text_of(class_name, paragraph) for name, paragraph in header.texts.items()}
            for known, own in zip(facts, (texts, header.values, header.methods)):
                known.update(own)
        return facts

    def header_of(self, proxy, prop):
        """Returns the header with the text of a property; None if it has none."""
        return next((header for header in self.lineage(proxy.class_name) if prop.get("command") in header.texts), None)

    def base_page(self, proxy, prop):
        """Returns the page that the base class of a property names; None for most properties."""
        header = self.header_of(proxy, prop)
        if not header or not header.page:
            return None
        return None if " in vtk" in (split_facts(header.texts[prop.get("command")]).default or "") else header.page

    def find(self, proxy, prop):
        """Returns the text of a property; None if neither a header nor the XML file has one."""
        own = prop.find("Documentation")
        header = self.header_of(proxy, prop)
        if header:
            if own is not None:
                sys.exit("%s: %s has a text in its XML file and one in C++" % (proxy.name, prop.get("name")))
            return text_of(proxy.class_name, header.texts[prop.get("command")])
        return split_facts(own.text) if own is not None and own.text else None

    def values(self, proxy, prop):
        """Returns the C++ names of a choice with their numbers as texts."""
        if prop.find("EnumerationDomain") is None:
            return []
        name = re.sub("^Set", "", prop.get("command", ""))
        return next((header.values[name] for header in self.lineage(proxy.class_name) if name in header.values), [])

    def labels(self, proxy):
        """Returns the panel labels of the C++ names of a proxy."""
        labels = {prop.get("name"): label_of(prop) for prop in proxy.properties}
        for prop in proxy.properties:
            entries = {entry.get("value"): entry.get("text") for entry in prop.iter("Entry")}
            labels.update((name, entries[value]) for name, value in self.values(proxy, prop) if value in entries)
        return labels

    def help(self, proxy, prop):
        """Returns a text as the panel shows it."""
        text = self.find(proxy, prop)
        if not text:
            sys.exit("%s: %s has no text, expected a comment of %s in %s.h" % (
                proxy.name, prop.get("name"), prop.get("command"), proxy.class_name))
        labels = self.labels(proxy)

        def shown(match):
            word = match.group(0)
            return word if re.fullmatch("[A-Z][a-z]+", word) else labels.get(word, word)

        words = [re.sub(" ?" + SEE, "", text.meaning)]
        words += ["%s: %s." % (name, fact) for name, fact in
                  (("Unit", text.unit), ("Range", text.range), ("Default", text.default)) if fact]
        words = re.sub(NAME, shown, " ".join(words))
        return re.sub(r"\bvtk\w+", lambda m: self.of_class[m[0]].label if m[0] in self.of_class else m[0], words)

    def row(self, proxy, prop):
        """Returns the cells of a table row on the page; None for properties that are only displayed or connected."""
        text = self.find(proxy, prop)
        if not text or not text.default or prop.get("information_only") == "1":
            return None
        reach = text.range
        plain = {name for other in proxy.properties for name, _ in self.values(proxy, other)}
        values = self.values(proxy, prop)
        if values:
            entries = {entry.get("value"): entry.get("text") for entry in prop.iter("Entry")}
            reach = ", ".join("%s (%s%s)" % (name, value, ', "%s"' % entries[value] if entries.get(value, name) != name else "")
                              for name, value in values)
        elif prop.find("BooleanDomain") is not None:
            reach = "off, on"

        def see(match):
            words, page = match.groups()
            anchor = "#" + words.lower().replace(" ", "-")
            return "See [%s](%s)." % (words, anchor if page == proxy.page else page + anchor)

        def code(match):
            return "`%s`" % match[0] if re.match(COMPOUND, match[0]) and match[0] not in plain else match[0]

        def link(match):
            other = self.of_class.get(match[0])
            return "[%s](%s)" % (other.label, other.page) if other else "`%s`" % match[0]

        def cell(words):
            words = re.sub(r"\bvtk\w+", link, re.sub(SEE, see, words))
            words = re.sub(r"\b(array|attribute|field data) ([A-Z]\w*)", r"\1 `\2`", words)
            parts = re.split(r"(\[[^]]*\]\([^)]*\)|`[^`]*`)", words)
            return "".join(part if part[:1] in ("[", "`") else re.sub(r"\b[A-Z]\w*\b", code, part) for part in parts)

        return [prop.get("name"), text.default, reach or "-", cell(text.unit or "-"), cell(text.meaning)]

    def table(self, proxy, listed):
        """Returns the table of a proxy; empty without rows. `listed` has the properties of bases that the page has so far."""
        own = [prop for prop in proxy.own if self.base_page(proxy, prop) is None
               or (self.base_page(proxy, prop) == proxy.page and prop.get("command") not in listed)]
        listed.update(prop.get("command") for prop in own if self.base_page(proxy, prop))
        rows = [row for row in (self.row(proxy, prop) for prop in own) if row]
        lines = [COLUMNS, ["---"] * len(COLUMNS)] + rows if rows else []
        return "".join("| %s |\n" % " | ".join(line) for line in lines)

    def pages(self):
        """Yields each page with tables of properties and its updated content."""
        for name in self.places.keys() - self.proxies.keys():
            sys.exit("%s: <!-- %s -->, expected the name of a proxy" % (self.places[name], name))
        proxies = {}
        for proxy in self.proxies.values():
            proxies.setdefault(proxy.page, []).append(proxy)
        for page, on_it in proxies.items():
            if not page:
                sys.exit("no page has a line <!-- %s -->, expected one" % on_it[0].name)
            path = self.documentation / page
            text = path.read_text(encoding="utf-8")
            others = {self.base_page(proxy, prop) for proxy in on_it for prop in proxy.own} - {None}
            for base in ({proxy.base.page for proxy in on_it if proxy.base} | others) - {page}:
                if "(%s" % base not in text:
                    sys.exit("%s: no link to %s, expected one, as there are more of its properties" % (page, base))
            listed = set()

            def place(found, listed=listed):
                return "<!-- %s -->\n\n%s" % (found[1], self.table(self.proxies[found[1]], listed))

            yield path, text, re.sub(PLACE + TABLE, place, text, flags=re.M)

    def write_panel(self, folder):
        """Writes the XML files of the plugin with the text of each property; unchanged files are not touched."""
        for proxy in self.proxies.values():
            for prop in proxy.element:
                if prop.tag.endswith("Property") and prop.get("command"):
                    text = self.help(proxy, prop)
                    if prop.find("Documentation") is None:
                        ElementTree.SubElement(prop, "Documentation").text = text
            if not proxy.is_base:
                brief = self.headers[proxy.class_name].brief
                proxy.element.find("Documentation").set("short_help", brief[0].upper() + brief[1:] + ".")
        folder.mkdir(parents=True, exist_ok=True)
        for group in (group for document in self.files.values() for group in document.iter("ProxyGroup")):
            for element in group.findall("SourceProxy[Hints]"):
                if element.find("Hints/ReaderFactory") is not None:
                    group.append(first_asked(element))
        for name, document in self.files.items():
            path = folder / name
            text = ElementTree.tostring(document.getroot(), encoding="unicode") + "\n"
            is_menu = document.getroot().tag != "ServerManagerConfiguration"
            if not is_menu and not (path.is_file() and path.read_text(encoding="utf-8") == text):
                path.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("panel", "pages"))
    parser.add_argument("folder", nargs="?", type=pathlib.Path)
    arguments = parser.parse_args()
    texts = Texts()
    if arguments.what == "panel":
        texts.write_panel(arguments.folder)
        return
    for path, text, fresh in texts.pages():
        if text != fresh:
            path.write_text(fresh, encoding="utf-8")
            print(path)


if __name__ == "__main__":
    main()
