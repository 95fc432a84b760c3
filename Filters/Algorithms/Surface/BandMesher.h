// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes bands of rows and the strips along the cuts between them (SurfaceParts.h).

#ifndef SeismicHorizonsBandMesher_h
#define SeismicHorizonsBandMesher_h

#include "BandCuts.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/Decimation/HeightRaster.h"
#include "PointRows.h"
#include "Surface.h"
#include "SurfacePart.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class BandMesher
{
public:
  using Places = std::vector<PlanePoint>;
  /// Takes the points of a band when they are read, from the first one to before the last one; from several threads.
  using TakePoints = std::function<void(const PointWindow& window, PointId first, PointId last)>;

  /// Points that several loops share always stay. All must outlive this.
  BandMesher(const PointRows& rows, std::int32_t rowsOfBand, const SurfaceOptions& options,
    const SurfaceParameters& parameters, const Loops& boundary, const std::unordered_set<PointId>& shared,
    TakePoints take);

  const BandCuts& Cuts() const { return this->AllCuts; }
  const PartMesher& Mesher() const { return this->Parts; }

  /// Meshes bands from the first one to before the last one. The cut below them must be open.
  void MeshBands(std::size_t first, std::size_t end, const Monitor& monitor);
  /// Opens a cut below bands if others mesh the bands below it.
  void OpenCut(std::size_t cut) { this->AllCuts.Open(cut, this->Options.MaximumError); }

  /// Meshes strips of each second cut, between bands up to the end. Strips of even cuts, which come first, are independent
  /// of each other, and so are those of odd cuts.
  void MeshStrips(std::size_t first, std::size_t end, const Monitor& monitor);

  /// Makes anew what is not good beside triangles of other strips. These are complete then, whatever bands are at hand.
  void Improve(std::size_t end, const Monitor& monitor);

  /// A band with the strip below it.
  SurfacePart& Band(std::size_t n) { return this->Bands[n]; }
  /// Bands before this one are complete after Improve(end), which next needs the band below its first cut.
  std::size_t CompleteBefore(std::size_t end) const
  {
    return end == this->Bands.size() ? end : std::max<std::size_t>(this->Improved, 1) - 1;
  }
  /// All strips are meshed, some of them by others.
  void CloseCuts()
  {
    std::for_each(this->Strips.begin(), this->Strips.end(), [](Strip& strip) { strip.IsOpen = false; });
  }
  /// What is not good in the strip of a cut.
  Places& LeftIn(std::size_t cut) { return this->Strips[cut].Left; }

private:
  using EdgeKeys = std::vector<std::uint64_t>;
  using Meshes = std::vector<SurfacePart*>;

  /// Around triangles that are made anew.
  struct StripSides
  {
    EdgeKeys Inner; // of other triangles
    EdgeKeys Outer; // of outlines
  };

  struct Strip
  {
    bool IsOpen = true;
    Places Left;
  };

  PlanePoint At(PointId point) const { return this->Rows.ColumnOf(point); }

  SurfacePart MeshBand(std::size_t band, const Monitor& monitor);
  static void LockCut(const BandCut& cut, PartBoundary& boundary);
  void ForEach(std::size_t size, const Monitor& monitor, const std::function<void(std::size_t, const Monitor&)>& work);
  /// Finds triangles beside a cut, if other strips made some of them when links to its points did not count. Bands that
  /// are higher than their triangles have none.
  SurfacePart FindNext(std::size_t cut, const Meshes& meshes) const;
  Meshes MeshesOf(std::size_t first, std::size_t end);
  /// Adds triangles that were made anew to the band above the cut, and makes those around places anew. Returns what is
  /// still not good.
  Places Improve(std::size_t cut, const Meshes& meshes, SurfacePart made, Places places, const Monitor& monitor);
  bool IsBeside(std::size_t cut, const PartCorners& corners) const;
  /// Bands drop points of cuts, and edges in the rows beside may be far from links to these.
  bool IsNext(std::size_t cut, const PartCorners& corners) const;
  /// Triangles along cuts that are still open wait for these.
  bool MayGo(std::size_t cut, const PartCorners& corners) const;
  /// Whether the box of a triangle is so near to one of the places, which ascend by rows.
  bool IsNear(const Places& places, const PartCorners& corners, std::int32_t distance) const;
  /// Finds edges inside a part that are too far from links.
  void AddFar(const SurfacePart& made, const Meshes& others, Places& places) const;
  HeightRaster MakeRaster(const PointWindow& window, const SurfacePart& made, const Meshes& others) const;
  std::pair<std::int32_t, std::int32_t> RowsOf(const std::vector<PartCorners>& triangles) const;
  /// Finds slivers beside edges that stay.
  void AddSlivers(const SurfacePart& made, Places& places) const;
  /// Takes the triangles that are chosen, and meshes their area anew. Edges along an open cut go.
  SurfacePart Remesh(const Meshes& meshes, const BandCut* cut, const std::function<bool(const PartCorners&)>& isChosen,
    const Monitor& monitor) const;
  StripSides FindSides(const BandCut* cut, const std::vector<PartCorners>& triangles, const Meshes& meshes) const;
  /// Outlines are simplified anew, unless the boundary there meets edges that stay.
  PartBoundary BoundaryOf(const StripSides& sides, const SurfacePart& taken, const Meshes& meshes) const;
  /// Ends of the chain do not count.
  bool Meets(const std::vector<PointId>& chain, const std::set<PointId>& stay,
    const std::map<std::int32_t, EdgeKeys>& edgesByRow) const;

  const PointRows& Rows;
  const SurfaceOptions& Options;
  BandCuts AllCuts;
  const std::int32_t RowsBeside;
  const PartMesher Parts;
  const TakePoints Take;
  std::vector<SurfacePart> Bands;
  std::vector<Strip> Strips; // by cut
  std::size_t Improved = 0; // strips
};
}

#endif
