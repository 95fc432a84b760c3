// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers of a synthetic cube: where each reflector is, and how strong. All share folds, which grow with depth, and
// have some of their own. A plane fault goes through the whole cube. On its upper side all layers are thrown down, so
// that it leaves a gap in each. Short faults do the same to what others left, by less towards their ends.

#ifndef SeismicHorizonsCubeReflectors_h
#define SeismicHorizonsCubeReflectors_h

#include "CubeGeneratorOptions.h"
#include "TraceStatics.h"

#include <array>
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

  /// The bottom of a channel, nan outside of it, and its reflection coefficient.
  double ChannelPlace(int channel, int i, int j) const;
  double ChannelStrength(int channel) const;
  /// The reflector that a channel cuts into; of channel 0, the middle one, and of the others those around it.
  int ChannelReflector(int channel) const;

  /// How far a place is from the fault, in columns: negative on the side that stayed.
  double FaultDistance(double i, double j, double sample) const;

  bool IsDead(int i, int j) const;
  bool IsMissing(int i, int j) const;

private:
  enum class LayerKind
  {
    Plain, // of a cube without unconformity
    Old,
    Young,
    Foreset,
    Unconformity
  };

  struct Layer
  {
    LayerKind Kind = LayerKind::Plain;
    double Depth = 0.0;
    double Strength = 1.0;
    std::uint64_t Seed = 0;
    double Edge = 0.0; // of a foreset: where it leaves the surface above
    bool IsReef = false;
  };

  /// A plane fault that dips along `Across`, with the throw at its middle, and none from `HalfLength` along it on.
  struct ShortFault
  {
    std::array<double, 2> Middle = { 0.0, 0.0 }; // at the middle sample
    std::array<double, 2> Across = { 1.0, 0.0 }; // of length 1
    double Dip = 0.0;
    double Throw = 0.0;
    double HalfLength = 1.0;

    double ThrowAt(double i, double j) const;
  };

  void AddLayer(double depth, LayerKind kind);
  /// Between two depths.
  void AddForesets(double top, double bottom);
  void AddShortFaults();
  /// Before faults and channels; nan where the layer is eroded, or was never laid down.
  double LaidPlace(const Layer& layer, int i, int j) const;
  double UnconformityPlace(int i, int j) const;
  double ForesetPlace(const Layer& foreset, int i, int j) const;
  double BesideGrowthFault(double place, int i, int j) const;
  double FaultedPlace(const Layer& layer, int i, int j) const;
  /// Before channels.
  double LayerPlace(const Layer& layer, int i, int j) const;
  double BesideSalt(double place, int i, int j) const;
  double ReefHeight(int i, int j) const;
  /// From 0 to 1, at its middle and below.
  double InGas(double place, int i, int j) const;
  /// From the center of a round body, in its radii.
  double FromBody(double centerX, double centerY, double radius, int i, int j) const;
  /// Half the width of a channel less the distance to its middle, in columns.
  double InsideChannel(int channel, int i, int j) const;
  double Fold(double x, double y) const;
  /// Of the wavelet, in samples.
  double Period() const { return 1000.0 / (this->Given.Frequency * this->Given.SampleInterval); }

  CubeGeneratorOptions Given;
  TraceStatics Shifts;
  std::vector<Layer> Layers;
  std::vector<ShortFault> Faults;
  std::size_t Toplap = 0; // the layer that foresets come down from
  double ForesetHeight = 0.0;
};
}

#endif
