// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RankedParts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
struct BandRange
{
  std::size_t First;
  std::size_t End;

  bool IsEmpty() const { return this->First == this->End; }
};

/// The last processes have none if there are more than pairs of bands.
BandRange BandsOf(int rank, const PartRanks& ranks, std::size_t bands)
{
  const std::size_t pairs = (bands + 1) / 2;
  const std::size_t busy = std::min(pairs, std::size_t(ranks.Size()));
  const auto firstOf = [&](int of) { return std::min(bands, 2 * (pairs * std::min(std::size_t(of), busy) / busy)); };
  return { firstOf(rank), firstOf(rank + 1) };
}

/// Some rows of a horizon, and the columns of all points of its boundary.
class SentRows : public PointRows
{
public:
  explicit SentRows(ByteBuffer& bytes)
    : Area(bytes.Read<PlaneBox>())
    , Starts(bytes.ReadAll<PointId>())
    , First(bytes.Read<PointId>())
    , Columns(bytes.ReadAll<PlanePoint>())
    , Height(bytes.ReadAll<double>())
    , OfBoundary(bytes.ReadAll<PointId>())
    , ColumnsOfBoundary(bytes.ReadAll<PlanePoint>())
  {
  }

  static void Write(
    const PointRows& rows, const Loops& boundary, std::int32_t firstRow, std::int32_t lastRow, ByteBuffer& bytes)
  {
    const PlaneBox box = rows.Box();
    std::vector<PointId> starts;
    for (std::int32_t row = box.Least.Y; row <= box.Greatest.Y + 1; ++row)
    {
      starts.push_back(rows.FirstOf(row));
    }
    std::vector<PointId> points;
    boundary.ForEachPoint([&points](PointId point) { points.push_back(point); });
    std::sort(points.begin(), points.end());
    std::vector<PlanePoint> columns;
    std::transform(points.begin(), points.end(), std::back_inserter(columns),
      [&rows](PointId point) { return rows.ColumnOf(point); });
    const PointWindow window = rows.Read(firstRow, lastRow);
    bytes.Write(box);
    bytes.WriteAll(starts);
    bytes.Write(window.First);
    bytes.WriteArray(window.Columns.begin(), window.Columns.size());
    bytes.WriteArray(window.Height, window.Columns.size());
    bytes.WriteAll(points);
    bytes.WriteAll(columns);
  }

  PlaneBox Box() const override { return this->Area; }

  PlanePoint ColumnOf(PointId point) const override
  {
    const PointId n = point - this->First;
    if (n >= 0 && std::size_t(n) < this->Columns.size())
    {
      return this->Columns[std::size_t(n)];
    }
    const auto found = std::lower_bound(this->OfBoundary.begin(), this->OfBoundary.end(), point);
    return this->ColumnsOfBoundary[std::size_t(found - this->OfBoundary.begin())];
  }

  PointId FirstOf(std::int32_t row) const override
  {
    return this
      ->Starts[std::size_t(std::clamp(row, this->Area.Least.Y, this->Area.Greatest.Y + 1) - this->Area.Least.Y)];
  }

  PointWindow Read(std::int32_t firstRow, std::int32_t lastRow) const override
  {
    const auto size = PointId(this->Columns.size());
    const PointId first = std::clamp(this->FirstOf(firstRow), this->First, this->First + size);
    const PointId end = std::clamp(this->FirstOf(lastRow + 1), first, this->First + size);
    const PointId before = first - this->First;
    return { first, PlanePoints(this->Columns.data() + before, std::size_t(end - first)),
      this->Height.data() + before };
  }

  std::size_t MostAtOnce() const override { return BandsAtOnce; }

private:
  const PlaneBox Area;
  const std::vector<PointId> Starts; // by row
  const PointId First;
  const std::vector<PlanePoint> Columns;
  const std::vector<double> Height;
  const std::vector<PointId> OfBoundary; // ascending
  const std::vector<PlanePoint> ColumnsOfBoundary;
};

/// Everything that a process needs to mesh its bands.
class SentBands
{
public:
  explicit SentBands(ByteBuffer bytes)
    : Options(bytes.Read<SurfaceOptions>())
    , Parameters(bytes.Read<SurfaceParameters>())
    , RowsOfBand(bytes.Read<std::int32_t>())
    , Rows(bytes)
    , Cuts(this->Rows.Box())
  {
    while (bytes.Read<bool>())
    {
      const auto column = bytes.Read<PlanePoint>();
      bytes.Read<bool>() ? this->Cuts.CutEast(column) : this->Cuts.CutNorth(column);
    }
    this->Options.Cuts = this->Options.Cuts ? &this->Cuts : nullptr;
    this->Options.Ranks = nullptr;
    const std::vector<PointId> shared = bytes.ReadAll<PointId>();
    this->Shared.insert(shared.begin(), shared.end());
    for (auto loops = bytes.Read<std::size_t>(); loops > 0; --loops)
    {
      const std::vector<PointId> points = bytes.ReadAll<PointId>();
      std::for_each(points.begin(), points.end(), [this](PointId point) { this->Boundary.Append(point); });
      this->Boundary.Close();
    }
    this->Mesher.emplace(this->Rows, this->RowsOfBand, this->Options, this->Parameters, this->Boundary, this->Shared,
      [](const PointWindow&, PointId, PointId) {});
  }

  BandMesher& GetMesher() { return *this->Mesher; }

private:
  SurfaceOptions Options;
  const SurfaceParameters Parameters;
  const std::int32_t RowsOfBand;
  const SentRows Rows;
  LinkCuts Cuts;
  Loops Boundary;
  std::unordered_set<PointId> Shared;
  std::optional<BandMesher> Mesher;
};

void WriteCutLinks(const LinkCuts* cuts, ByteBuffer& bytes)
{
  if (cuts)
  {
    cuts->ForEach(
      [&bytes](const PlanePoint& column, bool isEast)
      {
        bytes.Write(true);
        bytes.Write(column);
        bytes.Write(isEast);
      });
  }
  bytes.Write(false);
}

void WriteLoops(const Loops& loops, ByteBuffer& bytes)
{
  bytes.Write(loops.Size());
  for (std::size_t loop = 0; loop < loops.Size(); ++loop)
  {
    bytes.WriteArray(loops.begin(loop), loops.Length(loop));
  }
}

/// Meshes the bands of this process, and the strips above all of them.
void MeshBandsOf(BandMesher& mesher, const PartRanks& ranks, const Monitor& monitor)
{
  const std::size_t bands = mesher.Cuts().NumberOfBands();
  const BandRange own = BandsOf(ranks.Own(), ranks, bands);
  const std::size_t beyond = std::min(own.End + 1, bands);
  ranks.Together(
    [&]()
    {
      if (own.First > 0 && !own.IsEmpty())
      {
        mesher.OpenCut(own.First - 1);
      }
      for (std::size_t first = own.First; first < own.End; first += BandsAtOnce)
      {
        const std::size_t end = std::min(first + BandsAtOnce, own.End);
        const auto part = [&](std::size_t band)
        { return 0.8 * double(band - own.First) / double(own.End - own.First); };
        mesher.MeshBands(first, end, monitor.Step(part(first), part(end)));
      }
      mesher.MeshStrips(own.First, own.End, monitor.Step(0.8, 0.9));
    });
  if (own.First > 0 && !own.IsEmpty())
  {
    ByteBuffer bytes;
    mesher.Band(own.First).Write(bytes);
    ranks.Send(bytes, ranks.Own() - 1);
  }
  if (!own.IsEmpty() && own.End < bands)
  {
    ByteBuffer bytes = ranks.Receive(ranks.Own() + 1);
    mesher.Band(own.End) = SurfacePart::Read(bytes);
  }
  ranks.Together(
    [&]()
    {
      if (!own.IsEmpty())
      {
        mesher.MeshStrips(own.First + 1, beyond, monitor.Step(0.9, 1.0));
      }
    });
}

/// Calls visit(band) for the bands of a process that other processes do not need, and the first one above.
template <typename Visitor>
void ForEachMeshed(const BandRange& own, std::size_t bands, Visitor&& visit)
{
  for (std::size_t band = own.First + 1; !own.IsEmpty() && band < std::min(own.End + 1, bands); ++band)
  {
    visit(band);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void MeshOnRanks(BandMesher& mesher, const PointRows& rows, std::int32_t rowsOfBand, const SurfaceOptions& options,
  const SurfaceParameters& parameters, const Loops& boundary, const std::unordered_set<PointId>& shared,
  const PartRanks& ranks, const Monitor& monitor)
{
  const BandCuts& cuts = mesher.Cuts();
  const std::size_t bands = cuts.NumberOfBands();
  const std::int32_t around = mesher.Mesher().RowsAround() + 1;
  std::vector<ByteBuffer> sent;
  for (int rank = 1; rank < ranks.Size(); ++rank)
  {
    const BandRange range = BandsOf(rank, ranks, bands);
    const std::int32_t firstRow = range.IsEmpty() ? 1 : cuts.FirstRow(range.First) - around;
    const std::int32_t lastRow = range.IsEmpty() ? 0 : cuts.LastRow(std::min(range.End, bands - 1)) + around;
    ByteBuffer& bytes = sent.emplace_back();
    bytes.Write(options);
    bytes.Write(parameters);
    bytes.Write(rowsOfBand);
    SentRows::Write(rows, boundary, firstRow, lastRow, bytes);
    WriteCutLinks(options.Cuts, bytes);
    bytes.WriteAll(shared);
    WriteLoops(boundary, bytes);
  }
  for (int rank = 1; rank < ranks.Size(); ++rank)
  {
    ranks.Send(std::exchange(sent[std::size_t(rank) - 1], ByteBuffer()), rank);
  }
  ranks.Together([]() {}); // Others read.
  MeshBandsOf(mesher, ranks, monitor);
  for (int rank = 1; rank < ranks.Size(); ++rank)
  {
    ByteBuffer bytes = ranks.Receive(rank);
    ForEachMeshed(BandsOf(rank, ranks, bands), bands,
      [&](std::size_t band)
      {
        mesher.Band(band) = SurfacePart::Read(bytes);
        mesher.LeftIn(band - 1) = bytes.ReadAll<PlanePoint>();
      });
  }
  mesher.CloseCuts();
  mesher.Improve(bands, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void HelpToMesh(const PartRanks& ranks, const Monitor& monitor)
{
  ByteBuffer bytes = ranks.Receive(0);
  if (bytes.Bytes().empty())
  {
    return;
  }
  std::optional<SentBands> sent;
  ranks.Together([&]() { sent.emplace(std::move(bytes)); });
  BandMesher& mesher = sent->GetMesher();
  MeshBandsOf(mesher, ranks, monitor);
  const std::size_t bands = mesher.Cuts().NumberOfBands();
  ByteBuffer meshed;
  ForEachMeshed(BandsOf(ranks.Own(), ranks, bands), bands,
    [&](std::size_t band)
    {
      mesher.Band(band).Write(meshed);
      meshed.WriteAll(mesher.LeftIn(band - 1));
    });
  ranks.Send(meshed, 0);
}

//----------------------------------------------------------------------------------------------------------------------
void ReleaseHelpers(const PartRanks& ranks)
{
  const int released = ranks.HasSent() ? 0 : ranks.Size();
  for (int rank = 1; rank < released; ++rank)
  {
    ranks.Send(ByteBuffer(), rank);
  }
}
}
