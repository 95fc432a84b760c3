// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TraceTable.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Text/FileErrors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<int, 6> ShortFields = { TraceByte::Kind, TraceByte::PlaceScalar, TraceByte::PlaceUnit,
  TraceByte::Delay, TraceByte::Samples, TraceByte::TimeScalar };

bool IsShort(int byte)
{
  return std::find(ShortFields.begin(), ShortFields.end(), byte) != ShortFields.end();
}
}

//----------------------------------------------------------------------------------------------------------------------
TraceField::TraceField(std::int64_t traces)
  : Parts(CountChunks(traces, PartSize))
{
}

//----------------------------------------------------------------------------------------------------------------------
void TraceField::SetPart(std::size_t part, const RawVector<std::int32_t>& values)
{
  const std::int32_t first = values.front();
  const bool isConstant = std::all_of(values.begin(), values.end(), [first](std::int32_t v) { return v == first; });
  this->Parts[part].First = first;
  this->Parts[part].Values = isConstant ? RawVector<std::int32_t>() : values;
}

//----------------------------------------------------------------------------------------------------------------------
bool TraceField::IsConstant() const
{
  return std::all_of(this->Parts.begin(), this->Parts.end(),
    [this](const Part& part) { return part.Values.empty() && part.First == this->Parts.front().First; });
}

//----------------------------------------------------------------------------------------------------------------------
bool TraceTable::IsDead(std::int64_t trace) const
{
  constexpr std::int32_t dead = 2;
  constexpr std::int32_t dummy = 3;
  const std::int32_t kind = (*this)[TraceByte::Kind][trace];
  return kind == dead || kind == dummy;
}

//----------------------------------------------------------------------------------------------------------------------
std::string FieldText(int byte)
{
  return byte == NoField ? "no byte" : byte > SEGYTraceHeaderSize ? "by x and y" : "byte " + std::to_string(byte);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<FieldPair> ListPlaceFields(const TraceTable& table, const FieldPair& given)
{
  if (given.First != 0)
  {
    return given.First > 0 ? std::vector<FieldPair>{ given } : std::vector<FieldPair>();
  }
  std::vector<FieldPair> candidates;
  std::copy_if(PlacePairs.begin(), PlacePairs.end(), std::back_inserter(candidates),
    [&](const FieldPair& fields) { return !AreSame(table, fields); });
  return candidates;
}

//----------------------------------------------------------------------------------------------------------------------
bool AreSame(const TraceTable& table, const FieldPair& fields)
{
  return table[fields.First].IsConstant() && table[fields.Second].IsConstant();
}

//----------------------------------------------------------------------------------------------------------------------
SEGYFile::SEGYFile(const std::string& name, const SEGYHeader& header)
  : FirstTrace(header.FirstTrace)
  , TraceSize(std::int64_t(header.TraceSize()))
{
  this->Stream.rdbuf()->pubsetbuf(nullptr, 0); // With a buffer each header would be read with kilobytes of samples.
  this->Stream.open(std::filesystem::u8path(name), std::ios::binary);
  if (!this->Stream)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be opened, expected a readable one");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::Read(std::int64_t trace, std::size_t size, unsigned char* bytes)
{
  this->Stream.seekg(this->FirstTrace + trace * this->TraceSize);
  if (!this->Stream.read(reinterpret_cast<char*>(bytes), std::streamsize(size)))
  {
    throw InputError("trace " + std::to_string(trace + 1) + " cannot be read, expected an unchanged file");
  }
}

//----------------------------------------------------------------------------------------------------------------------
TraceTable ReadTraceTable(
  const std::string& name, const SEGYHeader& header, const std::vector<int>& fields, const Monitor& monitor)
{
  TraceTable table;
  table.Traces = header.Traces;
  table.Fields.emplace(TraceByte::Offset, TraceField(header.Traces));
  for (const int byte : ShortFields)
  {
    table.Fields.emplace(byte, TraceField(header.Traces));
  }
  for (const int byte : fields)
  {
    table.Fields.emplace(byte, TraceField(header.Traces));
  }
  ForEachChunk(header.Traces, TraceField::PartSize, monitor,
    [&](std::size_t part, std::int64_t first, std::int64_t last)
    {
      SEGYFile file(name, header);
      std::vector<unsigned char> headers(std::size_t(last - first) * SEGYTraceHeaderSize);
      for (std::int64_t trace = first; trace < last; ++trace)
      {
        file.Read(trace, SEGYTraceHeaderSize, &headers[std::size_t(trace - first) * SEGYTraceHeaderSize]);
      }
      RawVector<std::int32_t> values(std::size_t(last - first));
      for (auto& [byte, field] : table.Fields)
      {
        const unsigned char* place = headers.data() + byte - 1;
        const bool isShort = IsShort(byte);
        for (std::int32_t& value : values)
        {
          value =
            isShort ? DecodeNumber<std::int16_t>(place, header.Order) : DecodeNumber<std::int32_t>(place, header.Order);
          place += SEGYTraceHeaderSize;
        }
        field.SetPart(part, values);
      }
    });
  return table;
}
}
