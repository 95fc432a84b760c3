// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Text files of picks, and what is read from them as tables that tests can compare with literals.

#ifndef SeismicHorizonsTextTables_h
#define SeismicHorizonsTextTables_h

#include "Common/Survey/PickTable.h"
#include "Readers/HorizonText/HorizonTextParser.h"

#include <array>
#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace TextTables
{
using namespace SeismicHorizons;

inline PickTable Read(
  const std::string& text, const TextOptions& options = TextOptions(), const TextPieces& pieces = TextPieces())
{
  std::istringstream stream(text);
  const TextLayout layout = ReadTextLayout(stream, options);
  return ReadPicks(stream, layout, Monitor(), pieces);
}

inline TextLayout Layout(const std::string& text, const TextOptions& options = TextOptions())
{
  std::istringstream stream(text);
  return ReadTextLayout(stream, options);
}

/// What a file is taken for.
inline std::string Describe(const std::string& text, const TextOptions& options = TextOptions())
{
  return Layout(text, options).Describe();
}

/// The columns of a table that there are, and their names.
struct Columns
{
  std::vector<const std::vector<double>*> Values;
  std::string Names;

  explicit Columns(const PickTable& picks)
  {
    this->Add("il", picks.Inline);
    this->Add("xl", picks.Crossline);
    this->Add("x", picks.X);
    this->Add("y", picks.Y);
    this->Add("z", picks.Z);
    for (const PickAttribute& attribute : picks.Attributes)
    {
      this->Add(attribute.Name.c_str(), attribute.Values);
    }
  }

  void Add(const char* name, const std::vector<double>& values)
  {
    if (!values.empty())
    {
      this->Values.push_back(&values);
      this->Names += (this->Names.empty() ? "" : " ") + std::string(name);
    }
  }
};

/// As few digits as give the number back.
inline std::string ToText(double value)
{
  std::array<char, 32> digits;
  return std::string(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

/// The table as text: the names of the columns, then a line for each pick, all of them separated by blanks, with the
/// name of its horizon in front where there is one.
inline std::string ToText(const PickTable& picks)
{
  const Columns columns(picks);
  std::ostringstream text;
  text << columns.Names << '\n';
  for (std::size_t pick = 0; pick < picks.Size(); ++pick)
  {
    const std::string& name = picks.Names[picks.Horizon.empty() ? 0 : std::size_t(picks.Horizon[pick])];
    const char* before = "";
    if (!name.empty())
    {
      text << name << ':';
      before = " ";
    }
    for (const std::vector<double>* values : columns.Values)
    {
      text << before << ToText((*values)[pick]);
      before = " ";
    }
    text << '\n';
  }
  return text.str();
}

/// The picks of a file as text.
inline std::string Table(const std::string& text, const TextOptions& options = TextOptions())
{
  return ToText(Read(text, options));
}

/// A small file of each kind. The kinds with a header, and those with fixed layouts.
struct Sample
{
  const char* Name;
  std::string Text;
};

inline const std::string OldIesx =
  "PROFILE Top Chalk        TYPE 1  4                                              3d_ci7m.ifdf     m ms\n"
  "SNAPPING PARAMETERS 5     0 1\n"
  "  6.20986880E+05  6.08088236E+06  0 14   648.62    914.00    914.00  914 5.3956040E+03 I    376 XX      \n"
  "  6.21035464E+05  6.08093374E+06  0 14   648.18    916.00    916.00  916 3.4028235E+38 I    378 XX      \n"
  "EOD\n";

inline const std::string NewIesx =
  "PROFILE Top              TYPE 1  4                                              3d_ci7m.ifdf     ft ft\n"
  "SNAPPING PARAMETERS 5     0 1\n"
  "  6.20986880E+05  6.08088236E+06  0 14   648.62    914.00    914.00  914 5.3956040E+03 I    376 XX      \n"
  "\t648.61750602722168\t5395.6040039\n"
  "EOD  6.21035464E+05  6.08093374E+06  0 14   648.18    916.00    916.00  916 5.7035142E+03 I    378 XX    \n"
  "\t648.17714691162109\t5703.51416\n"
  "EOD";

inline std::vector<Sample> Samples()
{
  return { { "columns", "1 2 10.5\n1 3 11.5\n2 2 12.5\n" },
    { "OpendTect, a line",
      "# \"X\"\t\"Y\"\t\"Z\"\t\"Amp\"\n# - - - - -\n500000.5\t6000000.25\t100.5\t1\n500025.5\t6000000.25\t1e30\t2\n" },
    { "OpendTect, lines",
      "# 1: Inline\n# 2: Crossline\n# 3: Z\n# - - -\n\"Top A\"\t1\t2\t10.5\n\"Top "
      "A\"\t1\t3\t11.5\n\"Base\"\t1\t2\t12.5\n" },
    { "old IESX", OldIesx }, { "new IESX", NewIesx },
    { "Charisma",
      "INLINE :    476 XLINE :    320    626540.48  6073670.99   1236.45\n"
      "INLINE :476 XLINE :321 626552.98 6073671.25 1237.5\n" },
    { "OpenWorks",
      "@File_Version: 4\n#Horizon_name____-> Top\n#End_of_Horizon_ASCII_Header_\n"
      " 1331.0  2009   655615.25   6627263.5   1587.5\n 1332  2008.0   655605.5   6627255.25   1588\nEOB" },
    { "EarthVision",
      "# Type: scattered data\n# Field: 1 x\n# Field: 2 y\n# Field: 3 z meters\n# Null_value: 1e20\n"
      "# End:\n100.5 200.5 -50.25\n125.5 200.5 -51.5\n" },
    { "Petrel",
      "# Petrel Points with attributes\nVERSION 1\nBEGIN HEADER\nX\nY\nZ\nFLOAT,Dip\nEND HEADER\n"
      "100.5 200.5 -50.25 -999\n125.5 200.5 -51.5 7\n" },
    { "RMS", "Float Dip\nString Zone\n100.5 200.5 50.25 UNDEF a\n125.5 200.5 51.5 7 b\n" },
    { "CSV",
      "\"X\",\"Y\",\"Depth (m)\",\"Dip\"\r\n\"100.5\",\"200.5\",\"50.25\",\r\n\"125.5\",\"200.5\",\"51.5\",\"7\"\r\n" },
    { "indices", "# a lattice\n4 3 3\n0 0 1.5\n3 1 2.5\n2 2 3.5\n" } };
}
}

#endif
