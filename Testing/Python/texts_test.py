# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What becomes of the comments of setters, in the panel and on the page, on some classes made up for it.

Arguments: the program that makes texts, and a folder.
"""

import pathlib
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

PROGRAM, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:3])

BASE = """
/**
 * @class   vtkBase
 * @brief   a base
 *
 */
class VTK_EXPORT vtkBase : public vtkObject
{
public:
  ///@{
  /**
   * How far, in
   * the array RowCount. Unit: WidthUnit. Range: 0.5 to 1e3. Default: 4.5 in vtkOne, 2 in vtkTwo.
   *
   * For programmers.
   */
  vtkSetMacro(RowWidth, double);
  vtkGetMacro(RowWidth, double);
  ///@}

protected:
"""
ONE = """
/**
 * @class   vtkOne
 * @brief   does one thing
 *          of two
 *
 */
class VTK_EXPORT vtkOne : public vtkBase
{
public:
  /**
   * What is done with RowWidth, as in vtkTwo. ByRow: rows. Column2: columns. See "Some kinds" in One.md. Default: ByRow.
   */
  vtkHorizonChoice2Macro(Kind, Kinds,
    ByRow, Column2);

  /// Whether it is on. See "Some kinds" in Two.md. Default: off.
  vtkHorizonFlagMacro(On);

  /// How many there were.
  vtkGetMacro(Count, vtkIdType);

protected:
"""
XML = """<ServerManagerConfiguration><ProxyGroup name="filters">
<SourceProxy name="One" class="vtkOne" label="Number One"><Documentation long_help="Long."/>
<Input types="vtkTable" single="1">The points.</Input>
<PropertyGroup label="All">
<Property name="RowWidth" max="20" special="none"/>
<Property name="Kind" visible_if="On=on" entries="ByRow: By Rows"/>
<Property name="On" panel_visibility="advanced"/>
</PropertyGroup>
<Property name="Count" label="Rows"/>
</SourceProxy>
<SourceProxy name="Two" class="vtkTwo" label="Number Two"><Documentation long_help="Long."/>
<Property name="RowWidth" label="Width"/>
</SourceProxy>
<SourceProxy name="Three" class="vtkThree" label="Number Three" base_proxygroup="horizon_bases" base_proxyname="Base">
<Documentation long_help="Long."/>
<Property name="Kind"/>
<IntVectorProperty name="On" command="SetOn"><BooleanDomain name="bool"/></IntVectorProperty>
</SourceProxy></ProxyGroup></ServerManagerConfiguration>
"""
BASES = """<ServerManagerConfiguration><ProxyGroup name="horizon_bases"><SourceProxy name="Base">
<Property name="RowWidth"/>
</SourceProxy></ProxyGroup></ServerManagerConfiguration>
"""
ELEMENTS = """<SourceProxy>
<InputProperty name="Input" command="SetInputConnection">
<ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
<DataTypeDomain name="input_type"><DataType value="vtkTable"/></DataTypeDomain></InputProperty>
<DoubleVectorProperty name="RowWidth" command="SetRowWidth" number_of_elements="1" default_values="4.5">
<DoubleRangeDomain name="range" min="0.5" max="20"/>
<Hints><PropertyWidgetDecorator type="HorizonSpecialValue" text="none" value="4.5" unit="WidthUnit"/></Hints></DoubleVectorProperty>
<IntVectorProperty name="Kind" command="SetKind" number_of_elements="1" default_values="0">
<EnumerationDomain name="enum"><Entry text="By Rows" value="0"/><Entry text="Column 2" value="1"/></EnumerationDomain>
<Hints><PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="On" value="1"/></Hints></IntVectorProperty>
<IntVectorProperty name="On" command="SetOn" number_of_elements="1" default_values="0" panel_visibility="advanced">
<BooleanDomain name="bool"/></IntVectorProperty>
<IntVectorProperty name="Count" command="GetCount" number_of_elements="1" information_only="1" default_values="0"
panel_visibility="never" label="Rows"/>
<PropertyGroup label="All"><Property name="RowWidth"/><Property name="Kind"/><Property name="On"/></PropertyGroup></SourceProxy>"""
PAGE = "# A page\n\n<!-- %s -->\n\n| Property | Default | Range | Unit | Meaning |\n| --- | --- | --- | --- | --- |\n| old |\n\nMore.\n"
ROWS = """| RowWidth | 4.5 | 0.5 to 1e3 | `WidthUnit` | How far, in the array `RowCount`. |
| Kind | ByRow | ByRow (0, "By Rows"), Column2 (1, "Column 2") | - | What is done with `RowWidth`, as in [Number Two](Two.md). ByRow: rows. \
Column2: columns. See [Some kinds](#some-kinds). |
| On | off | off, on | - | Whether it is on. See [Some kinds](Two.md#some-kinds). |
"""


def outline(element):
    """What an element is, without its help."""
    return element.tag, element.attrib, [outline(child) for child in element if child.tag != "Documentation"]


class TextsTest(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        files = {"Filters/vtkBase.h": BASE, "Filters/vtkOne.h": ONE, "ParaViewPlugin/Both.xml": XML,
                 "Filters/vtkTwo.h": BASE.replace("vtkBase", "vtkTwo").replace("vtkObject", "vtkBase"),
                 "Filters/vtkThree.h": ONE.replace("vtkOne", "vtkThree"), "ParaViewPlugin/Bases.xml": BASES,
                 "Documentation/One.md": PAGE % "One", "Documentation/Two.md": PAGE % "Two", "Documentation/Bases.md": PAGE % "Base",
                 "Documentation/Three.md": (PAGE % "Three").replace("More", "More in [Bases](Bases.md)")}
        for name, text in files.items():
            self.write(name, text)
        self.program = FOLDER / "Utilities" / "CMake" / PROGRAM.name
        self.program.parent.mkdir(parents=True)
        for name in (PROGRAM.name, "property_panels.py"):
            shutil.copy(PROGRAM.parent / name, self.program.parent)

    def write(self, name, text):
        path = FOLDER / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def run_program(self, *arguments):
        return subprocess.run([sys.executable, self.program, *arguments], capture_output=True, text=True, check=False)

    def panel(self):
        self.run_program("panel", FOLDER / "made").check_returncode()
        proxies = ElementTree.parse(FOLDER / "made" / "Both.xml").iter("SourceProxy")
        return {proxy.get("name"): {element.get("name"): element.find("Documentation").text for element in proxy
                                    if element.tag.endswith("Property")} for proxy in proxies}

    def test_the_panel_has_its_own_names(self):
        self.assertEqual(self.panel()["One"], {
            "Input": "The points.",
            "RowWidth": "How far, in the array RowCount. Unit: WidthUnit. Range: 0.5 to 1e3. Default: 4.5.",
            "Kind": "What is done with Row Width, as in Number Two. By Rows: rows. Column 2: columns. Default: By Rows.",
            "On": "Whether it is on. Default: off.",
            "Count": "How many there were."})
        self.assertIn("Default: 2.", self.panel()["Two"]["RowWidth"])

    def test_a_name_becomes_an_element(self):
        self.panel()
        one = next(ElementTree.parse(FOLDER / "made" / "Both.xml").iter("SourceProxy"))
        self.assertEqual(outline(one)[2], outline(ElementTree.fromstring(ELEMENTS))[2])

    def test_what_the_class_does_not_have_is_an_error(self):
        for name, other, message in (
                ('"RowWidth" max', '"RowWidths" max', "One: RowWidths is no property of its class"),
                ("On=on", "On=yes", "One: On=yes, expected a choice or a switch of the class"),
                ("ByRow: By", "ByRows: By", "One: Kind has no choices ByRows")):
            self.write("ParaViewPlugin/Both.xml", XML.replace(name, other))
            self.assertIn(message, self.run_program("panel", FOLDER / "made").stderr)

    def test_a_property_without_a_name_comes_last(self):
        self.write("ParaViewPlugin/Both.xml", XML.replace('<Property name="On" panel_visibility="advanced"/>', ""))
        self.panel()
        one = next(ElementTree.parse(FOLDER / "made" / "Both.xml").iter("SourceProxy"))
        self.assertEqual([child.get("name") for child in one if child.tag.endswith("Property")],
                         ["Input", "RowWidth", "Kind", "Count", "On"])

    def test_the_brief_is_the_short_help(self):
        self.panel()
        text = (FOLDER / "made" / "Both.xml").read_text(encoding="utf-8")
        self.assertIn('short_help="Does one thing of two."', text)

    def test_what_stays_is_not_written_again(self):
        self.panel()
        path = FOLDER / "made" / "Both.xml"
        before = path.stat().st_mtime_ns
        self.panel()
        self.assertEqual(path.stat().st_mtime_ns, before)

    def test_the_page_has_code_and_links(self):
        self.run_program("pages").check_returncode()
        text = (FOLDER / "Documentation" / "One.md").read_text(encoding="utf-8")
        self.assertEqual(text, (PAGE % "One").replace("| old |\n", ROWS))

    def test_properties_of_a_base_are_on_its_page_alone(self):
        self.run_program("pages").check_returncode()
        base = (FOLDER / "Documentation" / "Bases.md").read_text(encoding="utf-8")
        self.assertIn("\n| RowWidth | 4.5 in vtkOne, 2 in vtkTwo | 0.5 to 1e3 |", base)
        text = (FOLDER / "Documentation" / "Three.md").read_text(encoding="utf-8")
        self.assertIn("\n| On | off |", text)
        self.assertNotIn("| RowWidth |", text)
        self.assertEqual(set(self.panel()["Three"]), {"Kind", "On"})

    def test_a_page_without_a_link_to_the_base_is_an_error(self):
        self.write("Documentation/Three.md", PAGE % "Three")
        self.assertIn("Three.md: no link to Bases.md, expected one", self.run_program("pages").stderr)

    def test_properties_of_a_base_class_are_on_the_page_that_it_names(self):
        base = BASE.replace(" *\n */", " *\n * Of rows. Its properties are on\n * Two.md.\n */")
        self.write("Filters/vtkBase.h", base.replace("4.5 in vtkOne, 2 in vtkTwo", "4.5"))
        self.write("Filters/vtkTwo.h", ONE.replace("vtkOne", "vtkTwo"))
        self.write("ParaViewPlugin/Both.xml", XML.replace('"Width"/>', '"Width"/><Property name="Kind"/><Property name="On"/>'))
        self.write("Documentation/Bases.md", "# A page\n\n<!-- Base -->\n\nAll are in [Two](Two.md#properties).\n")
        self.assertIn("One.md: no link to Two.md, expected one", self.run_program("pages").stderr)
        self.write("Documentation/One.md", (PAGE % "One").replace("More", "More in [Two](Two.md#properties)"))
        self.run_program("pages").check_returncode()
        rows = {page: (FOLDER / "Documentation" / page).read_text(encoding="utf-8").count("| RowWidth |")
                for page in ("One.md", "Two.md")}
        self.assertEqual(rows, {"One.md": 0, "Two.md": 1})
        self.assertIn("RowWidth", self.panel()["One"])
        (FOLDER / "Documentation" / "One.md").unlink()
        self.write("Documentation/Two.md", PAGE % "Two" + PAGE % "One")
        self.run_program("pages").check_returncode()
        text = (FOLDER / "Documentation" / "Two.md").read_text(encoding="utf-8")
        self.assertEqual((text.count("| RowWidth |"), text.count("| Kind |")), (1, 2))

    def test_another_default_in_each_class_keeps_a_property_on_both_pages(self):
        self.write("Filters/vtkBase.h", BASE.replace(" *\n */", " *\n * Its properties are on Two.md.\n */"))
        self.run_program("pages").check_returncode()
        self.assertIn("| RowWidth | 4.5 |", (FOLDER / "Documentation" / "One.md").read_text(encoding="utf-8"))

    def test_a_proxy_without_a_place_is_an_error(self):
        (FOLDER / "Documentation" / "One.md").unlink()
        self.assertIn("no page has a line <!-- One -->, expected one", self.run_program("pages").stderr)
        self.write("Documentation/One.md", PAGE % "Other")
        self.assertIn("One.md: <!-- Other -->, expected the name of a proxy", self.run_program("pages").stderr)

    def test_a_page_has_several_tables(self):
        (FOLDER / "Documentation" / "One.md").unlink()
        self.write("Documentation/Two.md", PAGE % "Two" + PAGE % "One")
        self.run_program("pages").check_returncode()
        text = (FOLDER / "Documentation" / "Two.md").read_text(encoding="utf-8")
        self.assertGreater(text.index("| On | off |"), text.index("<!-- One -->"))

    def test_a_setter_without_a_comment_is_an_error(self):
        self.write("Filters/vtkOne.h", ONE.replace("  /// Whether it is on.", "  // Whether it is on."))
        self.assertIn("One: On has no default, expected a comment of its setter that ends with one", self.run_program("panel", FOLDER).stderr)

    def test_two_texts_are_an_error(self):
        self.write("ParaViewPlugin/Both.xml", XML.replace('special="none"/>', "><Documentation>Another.</Documentation></Property>"))
        self.assertIn("One: RowWidth has a text in its XML file and one in C++", self.run_program("pages").stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
