// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYCube.h"

#include "Common/FileErrors.h"
#include "Common/InputFile.h"
#include "Common/Lattice.h"
#include "Common/Parameters.h"
#include "Common/Survey/LineLattice.h"
#include "Common/Survey/Units.h"
#include "TraceColumns.h"
#include "TracePlaces.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr int LastFieldByte = SEGYTraceHeaderSize - 3; // where a field of 4 bytes can begin

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

/// Traces are read at their places, so that a compressed file is of no use.
std::ifstream OpenPlainFile(const std::string& name)
{
  std::ifstream stream(std::filesystem::u8path(name), std::ios::binary);
  if (!stream)
  {
    throw FileError(FileProblem::CannotOpen, "a file that can not be opened, expected a readable one");
  }
  constexpr int gzipBegin[2] = { 0x1f, 0x8b };
  if (stream.get() == gzipBegin[0] && stream.get() == gzipBegin[1])
  {
    throw InputError("a file that gzip compressed, expected SEG-Y as it is");
  }
  return stream;
}

/// All fields that have to be read.
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

/// Traces of another length would stand at other places than they are looked for at, where anything may be.
void RefuseOtherLengths(const TraceTable& table)
{
  const TraceField& samples = table[TraceByte::Samples];
  std::int64_t first = 0; // with a number; dead traces have none at times
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

double FindInterval(const SEGYHeader& header, double given)
{
  if (given == 0.0 && header.Interval == 0.0)
  {
    throw InputError("0 as sample interval, in the header (byte 3217) and in the first trace (byte 117), expected one; "
                     "set VerticalStep");
  }
  return given > 0.0 ? given : header.Interval;
}

void PlaceCube(SEGYCube& cube, const TraceTable& table, const SEGYOptions& options, const Monitor& monitor)
{
  const LineNumbers lines(table, cube.LineFields);
  const LineNumbering numbering = lines.Numbering(monitor.Step(0.0, 0.2));
  cube.Lattice.Lines = numbering;
  cube.Lattice.Columns = lines.CountColumns(numbering);
  cube.Sampling.Step = FindInterval(cube.Header, options.VerticalStep);
  FindSampling(cube, table, lines);
  FillColumns(cube, table, lines);

  const PlacedTraces placed = PlaceTraces(table, lines, numbering, options, monitor.Step(0.4, 1.0));
  cube.PlaceFields = placed.Fields;
  cube.LargestDistance = placed.LargestDistance;
  cube.Warning = placed.Warning;
  cube.Lattice.Origin = placed.ToWorld.Origin;
  cube.Lattice.ColumnStep = placed.ToWorld.Steps.col(0);
  cube.Lattice.RowStep = placed.ToWorld.Steps.col(1);
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSEGYOptions(const SEGYOptions& options)
{
  CheckPair("InlineByte", "CrosslineByte", options.LineFields);
  CheckPair("XByte", "YByte", options.PlaceFields);
  if ((options.PlaceFields.First == NoField) != (options.PlaceFields.Second == NoField))
  {
    throw InputError("one of XByte and YByte as -1, for no places, expected both");
  }
  CheckAtLeast("VerticalStep", options.VerticalStep, 0.0, "");
  if (options.FormatCode != 0)
  {
    CheckFormatCode(options.FormatCode, "");
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
  const FileStamp stamp = MakeFileStamp(name);
  std::ifstream stream = OpenPlainFile(name);
  cube.Header = ReadSEGYHeader(stream, std::int64_t(stamp.Size), options.FormatCode);
  const TraceTable table = ReadTraceTable(name, cube.Header, FieldsToRead(options), monitor.Step(0.0, 0.7));
  RefuseOtherLengths(table);
  const bool isGiven = options.LineFields.First != 0;
  cube.LineFields = isGiven ? options.LineFields : FindLineFields(table, monitor.Step(0.7, 0.8));
  PlaceCube(cube, table, options, monitor.Step(0.8, 1.0));
  SetVerticalUnit(cube.Survey, "ms");
  cube.Survey.HorizontalUnit = cube.PlaceFields.First == NoField ? "" : cube.Header.LengthUnit;
  return cube;
}
}
