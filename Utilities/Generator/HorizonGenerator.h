// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes synthetic horizons of any size for tests, benchmarks and demonstrations.
//
// All horizons of one cube share folds and lie above each other with a varying distance; none touches another. Each has
// an outline of its own, lobed and ragged, with two bays; holes, the first of them large; islands, the first of them in
// the large hole; and missing single voxels. Thickness, amplitude and its polarity vary slowly over the horizon.
//
// The result depends on the options alone: every voxel is computed from its place with IEEE additions, multiplications,
// divisions and square roots, whose result the standard prescribes, and with random numbers of its own. (A compiler
// that fuses multiplications and additions has to be told not to.)

#ifndef SeismicHorizonsHorizonGenerator_h
#define SeismicHorizonsHorizonGenerator_h

#include "Common/Monitor.h"
#include "VerneySparseMatrix/SparseMatrixParser.h"

#include <cstdint>
#include <ostream>
#include <vector>

namespace SeismicHorizons
{
struct HorizonGeneratorOptions
{
  std::uint64_t Seed = 1;
  /// Cells of the lattice; nZ at least five times the number of horizons.
  SparseMatrixSize Size = { 240, 200, 120 };
  /// Their surface IDs are 1, 2, ... from the top down.
  int NumberOfHorizons = 3;
  /// Holes in each horizon.
  int NumberOfHoles = 8;
  /// Islands of each horizon: parts that touch no other part of it. The first lies in the large hole, the others
  /// outside or, where there is no room, in holes of their own.
  int NumberOfIslands = 3;
  /// Part of the voxels that are missing one by one, with all eight neighbours left in place: 0 to 0.1.
  double DropoutFraction = 0.02;
  /// The shape of the outline before lobes and bays bend it, which is how full the bounding box gets: from -1 (a star
  /// with four points) over 0 (a circle) to 1 (a square).
  double Squareness = 0.0;
};

class HorizonGenerator
{
public:
  /// Throws InputError when an option is out of range or the lattice has no room for all holes and islands.
  explicit HorizonGenerator(const HorizonGeneratorOptions& options);

  /// The size, in the proportions of options.Size and with its nZ, at which the file has about `numberOfVoxels` voxels,
  /// all horizons together.
  static SparseMatrixSize FindSize(const HorizonGeneratorOptions& options, std::int64_t numberOfVoxels);

  const HorizonGeneratorOptions& Options() const { return this->Given; }

  /// The horizon of a position, 0 to NumberOfHorizons - 1, in memory.
  HorizonVoxels MakeHorizon(int position) const;

  /// Writes the file row by row and returns the voxels of each horizon. Throws std::runtime_error when the stream
  /// does not take it.
  SparseMatrixCounts Write(std::ostream& stream, const Monitor& monitor = Monitor()) const;

private:
  /// A round hole, or an island with the moat around it, before noise bends it. In cells.
  struct Feature
  {
    double I = 0.0;
    double J = 0.0;
    double Radius = 0.0;
    double Moat = 0.0; // 0 for a hole
  };

  /// The place of a column in a frame that does not depend on the size: -1 to 1 from edge to edge.
  struct Place
  {
    double X = 0.0;
    double Y = 0.0;
  };

  /// What makes one horizon differ from the others.
  struct Horizon
  {
    std::uint64_t Seed = 0;
    std::vector<Feature> Features; // islands first, since one may lie in a hole
    std::vector<Place> Bays;
  };

  struct RowVoxel
  {
    int I = 0;
    SparseMatrixVoxel Voxel;
  };

  void PlaceBays(Horizon& horizon) const;
  void PlaceHoles(Horizon& horizon, int first, int last) const;
  void PlaceIslands(Horizon& horizon) const;
  bool PlaceFeature(Horizon& horizon, Feature feature, std::uint64_t seed) const;
  bool IsApart(const Horizon& horizon, const Feature& feature) const;
  bool HasRoom(const Horizon& horizon, const Feature& feature, bool isInBody) const;
  static double Reach(const Feature& feature);

  Place PlaceOf(double i, double j) const;
  bool IsInBody(const Horizon& horizon, double i, double j) const;
  bool IsOccupied(const Horizon& horizon, const std::vector<Feature>& features, int i, int j) const;
  bool IsDropout(const Horizon& horizon, int i, int j) const;
  double Fold(const Place& place) const;
  double Elevation(int position, const Place& place, int i, int j) const;
  SparseMatrixVoxel MakeVoxel(int position, int i, int j) const;
  void MakeRow(int position, int j, std::vector<RowVoxel>& row) const;

  HorizonGeneratorOptions Given;
  int RaggedOctaves = 1;
  double DropoutThreshold = 0.0;
  std::vector<Horizon> Horizons;
};
}

#endif
