// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lengths are in columns, which stand for bins of 25 m, and heights in ms of two-way time, downwards.

#include "AnticlineSurvey.h"

#include "SmoothNoise.h"
#include "VoxelText.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double Contact = 1318.0; // ms; gas above it is bright

/// What a random number is for. Each has a seed of its own.
enum class Part : std::uint64_t
{
  Fold = 1,
  Detail,
  Wedge,
  Trace,
  Throw,
  Heave,
  Meander,
  Margin,
  Fringe,
  Hole,
  Dropout,
  Jitter,
  Wander,
  Footprint,
  Strength,
  Wavelet
};

std::uint64_t SeedOf(Part part, int horizon = 0)
{
  return Mix(20 + static_cast<std::uint64_t>(horizon) + Mix(static_cast<std::uint64_t>(part)));
}

struct Place
{
  double X = 0.0;
  double Y = 0.0;
};

/// A direction by the tangent of half its angle: no sine or cosine is the same everywhere.
Place DirectionOf(double t)
{
  return { (1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t) };
}

/// The coordinates of a place in a frame that is turned around its origin.
Place ToFrame(const Place& place, const Place& origin, const Place& direction)
{
  const double x = place.X - origin.X;
  const double y = place.Y - origin.Y;
  return { x * direction.X + y * direction.Y, y * direction.X - x * direction.Y };
}

/// 1 at 0, and ever less on both sides.
double Bell(double x)
{
  return 1.0 / (1.0 + x * x);
}

/// From 0 at and below `first` to 1 at and above `last`.
double Ramp(double x, double first, double last)
{
  return SmoothStep(std::clamp((x - first) / (last - first), 0.0, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
/// A normal fault, bent as a parabola, whose throw is largest in the middle and 0 at both ends. The hanging wall is to
/// the left of its direction.
struct Fault
{
  Place Middle;
  double Tangent; // of half the angle of its direction
  double Bend;
  double HalfLength;
  double Throw; // ms
  int Number;

  Place Along(const Place& place) const
  {
    const Place frame = ToFrame(place, this->Middle, DirectionOf(this->Tangent));
    const double wander = 1.5 * Noise(SeedOf(Part::Trace, this->Number), frame.X / 21.0, 0.5);
    return { frame.X, frame.Y - this->Bend * frame.X * frame.X - wander };
  }

  double ThrowAt(double along) const
  {
    const double part = std::min(1.0, along * along / (this->HalfLength * this->HalfLength));
    return this->Throw * (1.0 - part) * (1.0 + 0.12 * Noise(SeedOf(Part::Throw, this->Number), along / 14.0, 0.5));
  }

  /// How far it moves a place down. Most of the throw is subsidence of the hanging wall.
  double Shift(const Place& place) const
  {
    const Place frame = this->Along(place);
    const double throwHere = this->ThrowAt(frame.X);
    return frame.Y > 0.0 ? 0.68 * throwHere * Bell(frame.Y / 34.0) : -0.32 * throwHere * Bell(frame.Y / 26.0);
  }

  /// Whether no pick is there: in the heave, and where the reflection breaks up beside it.
  bool IsGap(const Place& place, int horizon) const
  {
    constexpr double HeavePerTime = 0.033; // columns per ms: about 60 degrees at 2.6 km/s
    const Place frame = this->Along(place);
    const double throwHere = this->ThrowAt(frame.X);
    const double ragged =
      0.7 * FractalNoise(SeedOf(Part::Heave, 2 * this->Number + horizon), place.X / 6.0, place.Y / 6.0, 3);
    return throwHere > 5.0 && std::abs(frame.Y) < 0.25 + 0.5 * HeavePerTime * throwHere + ragged;
  }
};

const std::vector<Fault>& Faults()
{
  static const std::vector<Fault> faults = { { { 78.0, 92.0 }, -0.84, 0.0013, 82.0, 74.0, 1 },
    { { 117.0, 84.0 }, 1.17, 0.0022, 50.0, 46.0, 2 } };
  return faults;
}

//----------------------------------------------------------------------------------------------------------------------
/// The middle of a meandering channel: a curve whose direction swings evenly, as that of rivers does.
class Channel
{
public:
  Channel()
  {
    Place place = { -12.0, 20.0 };
    for (double length = 0.0; length < 420.0; length += Step)
    {
      const double swing = Wave(length / 58.0 + 0.42 * Noise(SeedOf(Part::Meander), length / 52.0, 0.0));
      const double size = 0.46 + 0.22 * Noise(SeedOf(Part::Meander, 1), length / 40.0, 0.0);
      const Place direction = DirectionOf(0.05 + size * swing);
      this->Middle.push_back(place);
      place = { place.X + Step * direction.X, place.Y + Step * direction.Y };
    }
  }

  /// How far it is cut into a place; levees beside it are a little higher.
  double Depth(const Place& place) const
  {
    constexpr double HalfWidth = 2.9;
    const double part = this->Distance(place) / HalfWidth;
    const double inside = std::max(0.0, 1.0 - part * part);
    return 10.0 * inside * inside - 1.2 * Bell((part - 1.5) / 0.35);
  }

private:
  double Distance(const Place& place) const
  {
    double least = 1e9;
    for (const Place& middle : this->Middle)
    {
      const double x = place.X - middle.X;
      const double y = place.Y - middle.Y;
      least = std::min(least, x * x + y * y);
    }
    return std::sqrt(least);
  }

  static constexpr double Step = 0.5;
  std::vector<Place> Middle;
};

//----------------------------------------------------------------------------------------------------------------------
/// How far a place is folded down, from 0 on the crest to nearly 1.
double FoldingAt(const Place& place)
{
  const Place frame = ToFrame(place, { 94.0, 80.0 }, DirectionOf(0.16));
  const double across = frame.Y + 0.0011 * frame.X * frame.X;
  const double width = 42.0 + 9.0 * across / std::sqrt(900.0 + across * across); // one flank is steeper
  const double square = across * across / (width * width) + frame.X * frame.X / (108.0 * 108.0);
  return square / (1.0 + square);
}

/// Horizon 1 before it was faulted, without its channel.
double StructureAt(const Place& place)
{
  const Place frame = ToFrame(place, {}, DirectionOf(0.27)); // not along the lattice
  const Place other = ToFrame(place, { 168.0, 30.0 }, DirectionOf(0.1));
  const double culmination = Bell(std::sqrt(other.X * other.X / 900.0 + other.Y * other.Y / 324.0));
  return 1236.0 + 310.0 * FoldingAt(place) + 0.16 * place.X - 62.0 * culmination +
    14.0 * FractalNoise(SeedOf(Part::Fold), frame.X / 46.0, frame.Y / 34.0, 2) +
    2.4 * FractalNoise(SeedOf(Part::Detail), frame.X / 11.0, frame.Y / 9.0, 2);
}

/// Between the horizons, where nothing was eroded; negative where horizon 2 would lie above horizon 1.
double WedgeAt(const Place& place)
{
  const Place frame = ToFrame(place, {}, DirectionOf(-0.2));
  return 120.0 * FoldingAt(place) - 38.0 - 0.1 * (place.X - 100.0) +
    7.0 * FractalNoise(SeedOf(Part::Wedge), frame.X / 30.0, frame.Y / 24.0, 2);
}

//----------------------------------------------------------------------------------------------------------------------
/// A place without picks: gas above the crest, or a reflection too weak to follow.
struct Hole
{
  Place Middle;
  double Radius;
};

const std::vector<Hole>& HolesOf(int horizon)
{
  static const std::vector<Hole> first = { { { 97.0, 74.0 }, 5.5 }, { { 38.0, 96.0 }, 3.6 }, { { 152.0, 104.0 }, 4.2 },
    { { 30.0, 52.0 }, 2.6 }, { { 140.0, 58.0 }, 3.0 }, { { 66.0, 124.0 }, 2.4 }, { { 122.0, 130.0 }, 2.8 } };
  static const std::vector<Hole> second = { { { 60.0, 26.0 }, 4.4 }, { { 150.0, 112.0 }, 3.4 },
    { { 40.0, 118.0 }, 2.6 }, { { 170.0, 62.0 }, 3.2 } };
  return horizon == 1 ? first : second;
}

bool IsInHole(const Place& place, int horizon)
{
  const auto& holes = HolesOf(horizon);
  return std::any_of(holes.begin(), holes.end(),
    [&](const Hole& hole)
    {
      const double x = (place.X - hole.Middle.X) / 1.3;
      const double y = place.Y - hole.Middle.Y;
      const double bend = 1.0 + 0.45 * Noise(SeedOf(Part::Hole, horizon), place.X / 3.5, place.Y / 3.5);
      return std::sqrt(x * x + y * y) < hole.Radius * bend;
    });
}

/// How many columns a place is inside the part of the survey where the reflection can be followed; negative outside.
double QualityAt(const Place& place, int horizon)
{
  const double x = place.X;
  const double y = place.Y;
  const double first =
    std::min({ 187.0 - x - 20.0 * Bell((y - 112.0) / 22.0), 0.6 * x + 0.8 * (150.0 - y) - 20.0, y + 5.0 });
  const double second = std::min({ x - 46.0 + 25.0 * Bell((y - 34.0) / 24.0), 191.0 - x,
    0.55 * x + 0.83 * (150.0 - y) - 32.0, 0.3 * x + 0.95 * y - 22.0 });
  const double ragged = 8.0 * FractalNoise(SeedOf(Part::Margin, horizon), x / 17.0, y / 17.0, 4);
  return (horizon == 1 ? first : second) + ragged;
}

/// What is wrong with a pick: it jitters, wanders, and differs from line to line, more so where the reflection is weak.
double ErrorAt(const Place& place, int horizon, double quality)
{
  const auto i = static_cast<std::int64_t>(place.X);
  const auto j = static_cast<std::int64_t>(place.Y);
  const std::uint64_t seed = SeedOf(Part::Jitter, horizon);
  const double jitter = Random(seed, i, j) + Random(Mix(seed), i, j) - 1.0;
  const double wander = Noise(SeedOf(Part::Wander, horizon), place.X / 3.0, place.Y / 3.0);
  const double footprint = Random(SeedOf(Part::Footprint), 0, j) - 0.5;
  return (1.8 * jitter + 0.9 * wander + 0.5 * footprint) * (1.0 + 2.0 * Ramp(-quality, -9.0, 0.0));
}

//----------------------------------------------------------------------------------------------------------------------
class Survey
{
public:
  bool IsPicked(const Place& place, int horizon) const
  {
    const auto i = static_cast<std::int64_t>(place.X);
    const auto j = static_cast<std::int64_t>(place.Y);
    const double fringe = 2.4 * Random(SeedOf(Part::Fringe, horizon), i, j);
    const bool isFault =
      std::any_of(Faults().begin(), Faults().end(), [&](const Fault& fault) { return fault.IsGap(place, horizon); });
    const bool isEroded = horizon == 2 &&
      this->Thickness(place) + 3.0 * FractalNoise(SeedOf(Part::Fringe, 3), place.X / 9.0, place.Y / 9.0, 3) < Overrun;
    return QualityAt(place, horizon) > fringe && !isFault && !isEroded && !IsInHole(place, horizon) &&
      Random(SeedOf(Part::Dropout, horizon), i, j) > 0.004;
  }

  /// In whole tenths of ms.
  double TimeAt(const Place& place, int horizon) const
  {
    double time = StructureAt(place) + this->River.Depth(place);
    for (const Fault& fault : Faults())
    {
      time += fault.Shift(place);
    }
    const double error = ErrorAt(place, 1, QualityAt(place, 1));
    if (horizon == 1)
    {
      return Round(time + error, 10.0);
    }
    // Where horizon 1 has cut horizon 2 off, a tracker follows horizon 1 instead, with the same errors.
    const double thickness = std::max(0.0, this->Thickness(place));
    const double own = QualityAt(place, 1) > 0.0 ? Ramp(thickness, 0.0, 4.0) : 1.0;
    return Round(time + thickness + (1.0 - own) * error + own * ErrorAt(place, 2, QualityAt(place, 2)), 10.0);
  }

  double AmplitudeAt(const Place& place, int horizon) const
  {
    const auto i = static_cast<std::int64_t>(place.X);
    const auto j = static_cast<std::int64_t>(place.Y);
    const Place frame = ToFrame(place, {}, DirectionOf(0.27));
    const std::uint64_t seed = SeedOf(Part::Strength, horizon);
    const double change = FractalNoise(seed, frame.X / 40.0, frame.Y / 26.0, 3);
    const double bright = horizon == 1 ? 62.0 * Ramp(-this->TimeAt(place, 1), -Contact - 6.0, -Contact + 10.0) : 0.0;
    const double fading = 0.3 + 0.7 * Ramp(QualityAt(place, horizon), 0.0, 14.0);
    const double channel = horizon == 1 ? 1.2 * std::max(0.0, this->River.Depth(place)) : 0.0;
    const double strength = (125.0 + 42.0 * change + bright - channel) * fading + 9.0 * (Random(seed, i, j) - 0.5);
    return Round(horizon == 1 ? strength : -0.8 * strength, 1.0);
  }

private:
  static constexpr double Overrun = -13.0; // ms; where horizon 2 would be so far above horizon 1 a tracker stops

  double Thickness(const Place& place) const { return WedgeAt(place) - this->River.Depth(place); }

  Channel River;
};

SparseMatrixVoxel MakeVoxel(const Survey& survey, const Place& place, int horizon)
{
  SparseMatrixVoxel voxel;
  voxel.SurfaceId = horizon;
  voxel.RealZ = survey.TimeAt(place, horizon);
  voxel.VerticalIndex = static_cast<int>(std::floor(voxel.RealZ / TimePerSample + 0.5));
  voxel.Amplitude = survey.AmplitudeAt(place, horizon);
  voxel.Thickness =
    Round(4.0 + 1.3 * FractalNoise(SeedOf(Part::Wavelet, horizon), place.X / 25.0, place.Y / 25.0, 2), 10.0);
  return voxel;
}

/// The picks of a column, from the uppermost.
std::vector<SparseMatrixVoxel> MakeColumn(const Survey& survey, const Place& place)
{
  std::vector<SparseMatrixVoxel> column;
  for (const int horizon : { 1, 2 })
  {
    if (survey.IsPicked(place, horizon))
    {
      column.push_back(MakeVoxel(survey, place, horizon));
    }
  }
  if (column.size() == 2) // a cell has one pick: where the horizons meet the lower one is a sample below
  {
    column[1].VerticalIndex = std::max(column[1].VerticalIndex, column[0].VerticalIndex + 1);
  }
  return column;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::map<int, std::int64_t> WriteAnticlineSurvey(std::ostream& stream)
{
  const Survey survey;
  std::map<int, std::int64_t> counts;
  std::vector<std::string> columns(static_cast<std::size_t>(AnticlineSurveySize[0]));
  WriteHeader(AnticlineSurveySize, stream);
  for (int j = 0; j < AnticlineSurveySize[1]; ++j)
  {
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      for (const SparseMatrixVoxel& voxel : MakeColumn(survey, { double(i), double(j) }))
      {
        AppendVoxel(columns[i], voxel);
        ++counts[voxel.SurfaceId];
      }
    }
    WriteLines(columns, stream);
  }
  FinishFile(stream);
  return counts;
}
}
