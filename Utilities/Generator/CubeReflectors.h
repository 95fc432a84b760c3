// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers of a synthetic cube: where each reflector is, and how strong. All share folds, which grow with depth, and
// have some of their own. A plane fault goes through the whole cube. On its upper side all layers are thrown down, so
// that it leaves a gap in each.

#ifndef SeismicHorizonsCubeReflectors_h
#define SeismicHorizonsCubeReflectors_h

#include "CubeGeneratorOptions.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class CubeReflectors
{
public:
  /// For options that CheckOptions accepts.
  explicit CubeReflectors(const CubeGeneratorOptions& options);

  int Size() const { return int(this->Layers.size()); }

  /// Where the traces of column (i, j) meet a reflector, in samples; nan where they do not: in the gap of the fault,
  /// where the channel took it away, and beyond the ends of the trace.
  double Place(int reflector, int i, int j) const;
  /// The reflection coefficient there; its sign is that of the reflection.
  double Strength(int reflector, int i, int j) const;

  /// The bottom of the channel, nan outside of it, and its reflection coefficient.
  double ChannelPlace(int i, int j) const;
  double ChannelStrength() const;
  /// The reflector that the channel cuts into; -1 without one.
  int ChannelReflector() const { return this->Given.HasChannel ? this->Size() / 2 : -1; }

  /// How far a place is from the fault, in columns: negative on the side that stayed.
  double FaultDistance(double i, double j, double sample) const;

  bool IsDead(int i, int j) const;
  bool IsMissing(int i, int j) const;

private:
  struct Layer
  {
    double Depth = 0.0;
    double Strength = 1.0;
    std::uint64_t Seed = 0;
  };

  /// Before the channel.
  double LayerPlace(const Layer& layer, int i, int j) const;
  /// Half the width of the channel less the distance to its middle, in columns.
  double InsideChannel(int i, int j) const;
  double Fold(double x, double y) const;

  CubeGeneratorOptions Given;
  std::vector<Layer> Layers;
};
}

#endif
