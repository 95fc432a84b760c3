// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYCube.h"

#include "Common/Base/Parameters.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Survey/Units.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "TracePlaces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int LastFieldByte = SEGYTraceHeaderSize - 3; // last start of a field of 4 bytes

void CheckField(const char* name, int byte)
{
  if (byte < NoField || byte > LastFieldByte)
  {
    std::ostringstream text;
    text << name << ' ' << byte << ", expected 1 to " << LastFieldByte << ", 0 for the one that is found, or "
         << NoField << " for none";
    throw InputError(text.str());
  }
}

void CheckPair(const char* firstName, const char* secondName, const FieldPair& pair)
{
  CheckField(firstName, pair.First);
  CheckField(secondName, pair.Second);
  if ((pair.First == 0) != (pair.Second == 0))
  {
    std::ostringstream text;
    text << firstName << ' ' << pair.First << " with " << secondName << ' ' << pair.Second
         << ", expected both, or 0 for both";
    throw InputError(text.str());
  }
}

/// Random access to traces rules out compressed files.
std::ifstream OpenPlainFile(const std::string& name)
{
  std::ifstream stream(std::filesystem::u8path(name), std::ios::binary);
  if (!stream)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be opened, expected a readable one");
  }
  constexpr int gzipBegin[2] = { 0x1f, 0x8b };
  if (stream.get() == gzipBegin[0] && stream.get() == gzipBegin[1])
  {
    throw InputError("a file compressed by gzip, expected uncompressed SEG-Y");
  }
  return stream;
}

std::vector<int> FieldsToRead(const SEGYOptions& options)
{
  std::vector<int> bytes = ListFields();
  for (const int byte :
    { options.LineFields.First, options.LineFields.Second, options.PlaceFields.First, options.PlaceFields.Second })
  {
    if (byte > 0)
    {
      bytes.push_back(byte);
    }
  }
  return bytes;
}

/// Traces after one of another length would be read at wrong offsets.
void RefuseOtherLengths(const TraceTable& table)
{
  const TraceField& samples = table[TraceByte::Samples];
  std::int64_t first = 0; // Dead traces may state no samples.
  for (std::int64_t trace = 0; trace < table.Traces && !samples.IsConstant(); ++trace)
  {
    first = samples[first] == 0 ? trace : first;
    if (samples[trace] != samples[first] && samples[trace] != 0)
    {
      std::ostringstream text;
      text << "trace " << first + 1 << " of " << (samples[first] & 0xffff) << " and trace " << trace + 1 << " of "
           << (samples[trace] & 0xffff) << " samples (byte 115), expected the same for all";
      throw InputError(text.str());
    }
  }
}

std::optional<FieldPair> SuggestLines(const std::string& name, SEGYHeader header)
{
  constexpr std::int64_t most = 1 << 16; // traces
  header.Traces = std::min(header.Traces, most);
  std::vector<int> bytes;
  for (int byte = 1; byte <= LastFieldByte; byte += 4)
  {
    bytes.push_back(byte);
  }
  return FindAnyGrid(ReadTraceTable(name, header, bytes, Monitor()));
}

FieldPair FindLines(SEGYCube& cube, TraceTable& table, const SEGYOptions& options, const Monitor& monitor)
{
  const std::optional<FieldPair> found = FindLineFields(table, options.Duplicates != DuplicateRule::Refuse, monitor);
  if (!found && NumberByPlaces(table, options, monitor))
  {
    cube.Warnings.push_back("no line numbers that make a grid of " + std::to_string(table.Traces) +
      " traces: inlines and crosslines are rows and columns of the lattice of x and y, from 1. " +
      OtherLinesText(SuggestLines(cube.Name, cube.Header)));
    return { TraceByte::LatticeRow, TraceByte::LatticeColumn };
  }
  if (!found)
  {
    RefuseLines(table, SuggestLines(cube.Name, cube.Header));
  }
  if (IsPlacePair(*found))
  {
    std::ostringstream text;
    text << "line numbers at bytes " << found->First << " and " << found->Second << ", where the standard has x and y. "
         << OtherLinesText(SuggestLines(cube.Name, cube.Header));
    cube.Warnings.push_back(text.str());
  }
  return *found;
}

double FindInterval(const SEGYHeader& header, double given)
{
  if (given == 0.0 && header.Interval == 0.0)
  {
    throw InputError("sample interval 0 in the header (byte 3217) and in the first trace (byte 117), expected more: "
                     "set VerticalStep");
  }
  return given > 0.0 ? given : header.Interval;
}

void WarnOfDuplicates(SEGYCube& cube, DuplicateRule rule)
{
  if (cube.DuplicateTraces > 0)
  {
    const char* const what = rule == DuplicateRule::Mean ? "their mean is used"
      : rule == DuplicateRule::Last                      ? "the last of each is used"
      : rule == DuplicateRule::First                     ? "the first of each is used"
                                                         : "dead ones are not used";
    cube.Warnings.push_back(std::to_string(cube.DuplicateTraces) + " duplicate traces: " + what);
  }
}

/// If a file was cut between two traces, only its last line is incomplete.
void WarnOfCut(SEGYCube& cube, const LineNumbers& lines)
{
  const std::int64_t last = cube.Header.Traces - 1;
  const std::size_t along = cube.IsCrosslineSorted ? 1 : 0;
  const auto length = std::int64_t(cube.Lattice.Columns[along]);
  const std::int64_t found = length - cube.MissingTraces;
  if (cube.MissingTraces == 0 || cube.Lattice.Columns[1 - along] < 2 || !lines.IsUsed(last))
  {
    return;
  }
  std::array<int, 2> place = lines.Column(last);
  const bool isForward = place[along] == found - 1;
  bool isCut = isForward || place[along] == length - found;
  for (std::int64_t n = 0; n < length; ++n)
  {
    place[along] = int(isForward ? n : length - 1 - n);
    isCut = isCut && (cube.Traces[cube.Column(place[0], place[1])] != NoTrace) == (n < found);
  }
  if (isCut)
  {
    const std::string line = along == 1 ? "crossline " + std::to_string(lines.Crossline(last))
                                        : "inline " + std::to_string(lines.Inline(last));
    cube.Warnings.push_back(std::to_string(cube.Header.Traces) + " traces, expected " +
      std::to_string(cube.Header.Traces + cube.MissingTraces) + ": " + line + " at the end of the file has " +
      std::to_string(found) + " of " + std::to_string(length) + "; was the file cut?");
  }
}

void PlaceCube(SEGYCube& cube, const TraceTable& table, const SEGYOptions& options, const Monitor& monitor)
{
  const LineNumbers lines(table, cube.LineFields, monitor.Step(0.0, 0.2));
  cube.Lattice.Lines = lines.Numbering;
  cube.Lattice.Columns = lines.CountColumns();
  cube.Sampling.Step = FindInterval(cube.Header, options.VerticalStep);
  FillColumns(cube, lines, options.Duplicates);
  WarnOfDuplicates(cube, options.Duplicates);
  WarnOfCut(cube, lines);
  FindSampling(cube, table, options.Delays);

  const bool isLine = std::min(cube.Lattice.Columns[0], cube.Lattice.Columns[1]) == 1;
  const PlacedTraces placed = PlaceTraces(lines, options, isLine, monitor.Step(0.4, 1.0));
  cube.PlaceFields = placed.Fields;
  cube.LargestDistance = placed.LargestDistance;
  cube.StrayPlaces = placed.Strays;
  cube.Warnings.insert(cube.Warnings.end(), placed.Warnings.begin(), placed.Warnings.end());
  cube.Lattice.Origin = placed.ToWorld.Origin;
  cube.Lattice.ColumnStep = placed.ToWorld.Steps.col(0);
  cube.Lattice.RowStep = placed.ToWorld.Steps.col(1);
  if (isLine && options.PlaceFields.First != NoField)
  {
    PlaceAlongLine(cube, lines, options.PlaceFields);
  }
}

/// Returns the unit of x and y, with a warning if it is an angle. The field that says so is often wrong, so that all
/// places must be in its range.
std::string FindHorizontalUnit(SEGYCube& cube, const TraceTable& table)
{
  constexpr std::array<const char*, 3> names = { "arcsec", "degrees", "DDDMMSS" }; // codes 2 to 4
  constexpr std::array<double, 3> perDegree = { 3600.0, 1.0, 10000.0 };
  const auto first = std::find_if(cube.Traces.begin(), cube.Traces.end(), [](std::int32_t t) { return t >= 0; });
  const int code = first == cube.Traces.end() ? 0 : table[TraceByte::PlaceUnit][*first];
  const std::size_t unit = std::size_t(code - 2);
  const Eigen::Vector2d origin = cube.Lattice.Origin;
  const Eigen::Vector2d last =
    origin + cube.Lattice.Steps() * Eigen::Vector2d(cube.Lattice.Columns[0] - 1, cube.Lattice.Columns[1] - 1);
  const Eigen::Vector2d largest = origin.cwiseAbs().cwiseMax(last.cwiseAbs());
  const bool hasPlaces = cube.PlaceFields.First != NoField;
  if (!hasPlaces || unit >= names.size() || largest.x() > 360.0 * perDegree[unit] ||
    largest.y() > 90.0 * perDegree[unit])
  {
    return hasPlaces ? cube.Header.LengthUnit : "";
  }
  cube.Warnings.push_back("x and y in " + std::string(names[unit]) + " (byte 89 is " + std::to_string(code) +
    "), expected a length: they are used unchanged; if they are lengths, set HorizontalUnit");
  return names[unit];
}

// ---- Description ----------------------------------------------------------------------------------------------------
std::string DescribeFile(const SEGYHeader& header)
{
  std::ostringstream text;
  text << "SEG-Y" << (header.Revision > 0 ? " revision " + std::to_string(header.Revision) : "") << ", "
       << FormatName(header.Format) << ", " << (header.Order == ByteOrder::BigEndian ? "big" : "little")
       << "-endian, text in " << (header.IsEbcdic ? "EBCDIC" : "ASCII");
  text << (header.LabelSize > 0 ? ", after a tape label" : "");
  if (header.ExtendedTexts > 0)
  {
    text << ", " << header.ExtendedTexts << " extended text headers";
  }
  text << '\n'
       << header.Traces << " traces of " << header.Samples << " samples"
       << (header.HasOwnSamples ? "" : " (by the first trace)");
  return text.str();
}

std::string DescribeLines(const SEGYCube& cube)
{
  const SurveyLattice& lattice = cube.Lattice;
  std::ostringstream text;
  const auto describe = [&text](const char* what, double first, double step, int count, int byte)
  {
    text << count << ' ' << what << (count == 1 ? " " : "s ") << first;
    if (count > 1)
    {
      text << " to " << first + step * (count - 1) << " in steps of " << step;
    }
    text << " (" << FieldText(byte) << ")\n";
  };
  text.precision(10);
  describe("inline", lattice.Lines->FirstInline, lattice.Lines->InlineStep, lattice.Columns[1], cube.LineFields.First);
  describe("crossline", lattice.Lines->FirstCrossline, lattice.Lines->CrosslineStep, lattice.Columns[0],
    cube.LineFields.Second);
  text << "sorted by " << (cube.IsCrosslineSorted ? "crosslines" : "inlines") << "; " << cube.MissingTraces
       << " traces missing, " << cube.DeadTraces << " dead";
  if (cube.DuplicateTraces > 0)
  {
    text << ", " << cube.DuplicateTraces << " duplicate";
  }
  if (cube.Fillers > 0)
  {
    text << ", " << cube.Fillers << " dead ones without line numbers";
  }
  return text.str();
}

std::string DescribePlaces(const SEGYCube& cube)
{
  const SurveyLattice& lattice = cube.Lattice;
  std::ostringstream text;
  if (cube.PlaceFields.First == NoField)
  {
    text << "x and y are line numbers";
  }
  else
  {
    text << "x and y at bytes " << cube.PlaceFields.First << " and " << cube.PlaceFields.Second << ": from "
         << ToText(lattice.Origin) << " in steps of " << ToText(lattice.ColumnStep) << " along crosslines' numbers and "
         << ToText(lattice.RowStep) << " along inlines'";
    text.precision(3);
    text << "; traces at most " << cube.LargestDistance << " of a step off";
    text << (cube.StrayPlaces > 0 ? ", but for " + std::to_string(cube.StrayPlaces) : "");
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSEGYOptions(const SEGYOptions& options)
{
  CheckPair("InlineByte", "CrosslineByte", options.LineFields);
  CheckPair("XByte", "YByte", options.PlaceFields);
  if ((options.PlaceFields.First == NoField) != (options.PlaceFields.Second == NoField))
  {
    throw InputError("only one of XByte and YByte is -1 (no coordinates), expected both or neither");
  }
  CheckAtLeast("VerticalStep", options.VerticalStep, 0.0, "");
  if (options.FormatCode != 0)
  {
    CheckFormatCode(options.FormatCode, "");
  }
  if (options.Samples < 0)
  {
    throw InputError("NumberOfSamples " + std::to_string(options.Samples) + ", expected at least 1, or 0 to find it");
  }
  if (!(options.Tolerance > 0.0 && options.Tolerance < 0.5))
  {
    std::ostringstream text;
    text << "LatticeTolerance " << options.Tolerance << ", expected more than 0 and less than 0.5 columns";
    throw InputError(text.str());
  }
}

//----------------------------------------------------------------------------------------------------------------------
SEGYCube ReadSEGYCube(const std::string& name, const SEGYOptions& options, const Monitor& monitor)
{
  CheckSEGYOptions(options);
  SEGYCube cube;
  cube.Name = name;
  cube.Stamp = MakeFileStamp(name);
  std::ifstream stream = OpenPlainFile(name);
  cube.Header = ReadSEGYHeader(stream, std::int64_t(cube.Stamp.Size), options);
  cube.Warnings = cube.Header.Warnings;
  TraceTable table = ReadTraceTable(name, cube.Header, FieldsToRead(options), monitor.Step(0.0, 0.7));
  RefuseOtherLengths(table);
  const bool isGiven = options.LineFields.First != 0;
  cube.LineFields = isGiven ? options.LineFields : FindLines(cube, table, options, monitor.Step(0.7, 0.8));
  PlaceCube(cube, table, options, monitor.Step(0.8, 1.0));
  SetVerticalUnit(cube.Survey, "ms");
  cube.Survey.HorizontalUnit = FindHorizontalUnit(cube, table);
  return cube;
}

//----------------------------------------------------------------------------------------------------------------------
std::string Describe(const SEGYCube& cube, const SurveyDescription& survey)
{
  std::ostringstream text;
  text << DescribeFile(cube.Header) << '\n' << DescribeLines(cube) << '\n' << DescribePlaces(cube) << '\n';
  text << cube.Sampling.Indices << " vertical indices from " << cube.Sampling.First << " in steps of "
       << cube.Sampling.Step << (survey.VerticalUnit.empty() ? "" : " ") << survey.VerticalUnit
       << (survey.VerticalDomain == "time" ? ", taken as time; set VerticalUnit for depth" : "")
       << (cube.Delays.empty() ? "" : "; traces begin at different ones");
  return text.str();
}

//----------------------------------------------------------------------------------------------------------------------
std::string WarningText(const SEGYCube& cube)
{
  std::string text;
  for (const std::string& warning : cube.Warnings)
  {
    text += (text.empty() ? "" : "; ") + warning;
  }
  return text;
}
}
