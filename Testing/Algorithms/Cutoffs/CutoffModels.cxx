// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutoffModels.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double Bin = 25.0;
constexpr int Bins = 81;
constexpr double Pi = 3.14159265358979323846;
const std::vector<double> Depths = { -1000.0, -1200.0, -1450.0 };

double Fold(double z, double x, double y)
{
  return z + 25.0 * std::sin(x / 420.0) * std::cos(y / 560.0) + 0.02 * (y - 1000.0);
}

/// Where the listric fault is, by height: 65 degrees at the top, 27 at the bottom.
double ListricAt(double z)
{
  const double t = (-700.0 - z) / 1200.0;
  const double clipped = std::clamp(t, -1.0, 3.0);
  return 500.0 + 550.0 * t + 600.0 * clipped * clipped * clipped;
}

void AddStick(FaultPicks& fault, const std::vector<Eigen::Vector3d>& places)
{
  for (std::size_t n = 1; n < places.size(); ++n)
  {
    fault.Segments.push_back({ places[n - 1], places[n] });
  }
}

void MakeListric(CutoffModel& model)
{
  model.Distance = [](const Eigen::Vector3d& place) { return place.x() - ListricAt(place.z()); };
  for (int stick = 0; stick < 11; ++stick)
  {
    std::vector<Eigen::Vector3d> places;
    for (int n = 0; n <= 20; ++n)
    {
      const double z = -500.0 - 80.0 * n;
      places.emplace_back(ListricAt(z), -300.0 + 260.0 * stick, z);
    }
    AddStick(model.Fault, places);
  }
  model.Fault.Spacing = 260.0;
}

void MakePlane(CutoffModel& model, double dip, double strike, double noise, std::mt19937& random)
{
  const double angle = dip * Pi / 180.0, turn = strike * Pi / 180.0;
  const Eigen::Vector3d normal(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
  const Eigen::Vector3d origin(900.0, 1000.0, -1200.0);
  model.Distance = [=](const Eigen::Vector3d& place) { return (place - origin).dot(normal) / std::sin(angle); };
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(normal).normalized(), down = normal.cross(along);
  std::normal_distribution<double> off(0.0, 1.0);
  for (int stick = 0; stick < 9; ++stick)
  {
    std::vector<Eigen::Vector3d> places;
    for (int n = 0; n < 8; ++n)
    {
      places.push_back(
        origin + (-1300.0 + 325.0 * stick) * along + (-900.0 + 1800.0 / 7.0 * n) * down + noise * off(random) * normal);
    }
    AddStick(model.Fault, places);
  }
  model.Fault.Spacing = 325.0;
}

/// At most one pick per column, unless picks are right on both walls.
HorizonPicks Pick(const CutoffModel& model, std::size_t horizon, const PickErrors& errors, std::mt19937& random)
{
  HorizonPicks picks;
  picks.Steps *= Bin;
  picks.Noise = errors.Noise;
  std::normal_distribution<double> noise(0.0, 1.0);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int j = 0; j < Bins; ++j)
  {
    for (int i = 0; i < Bins; ++i)
    {
      std::vector<Eigen::Vector3d> right, wrong;
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        const double x = Bin * i, y = Bin * j;
        const Eigen::Vector3d place(x, y, model.Height(horizon, wall, x, y));
        const double inside = wall == HangingWall ? model.Distance(place) : -model.Distance(place);
        if (inside > 0.0)
        {
          right.push_back(place);
        }
        else if (inside > -errors.WrongSide * Bin && part(random) < errors.WrongPart)
        {
          wrong.push_back(place);
        }
      }
      if (!wrong.empty() && (right.empty() || part(random) < errors.WrongPart))
      {
        right = { wrong.front() };
      }
      for (Eigen::Vector3d& place : right)
      {
        place.z() += errors.Noise * noise(random);
        picks.Places.push_back(place);
      }
    }
  }
  return picks;
}
}

//----------------------------------------------------------------------------------------------------------------------
CutoffModel MakeCutoffModel(FaultForm form, const PickErrors& errors, std::mt19937& random)
{
  CutoffModel model;
  model.Fault.Name = "F1";
  model.Height = [form](std::size_t n, FaultWall wall, double x, double y)
  {
    const double level = form == FaultForm::Flat ? Depths[n] : Fold(Depths[n], x, y);
    const double moved = form == FaultForm::Reverse ? -90.0
      : form == FaultForm::Listric                  ? 130.0 * std::exp(-std::abs(x - 900.0) / 700.0)
                                                    : 90.0;
    return level - (wall == HangingWall ? moved : 0.0);
  };
  const double sticks = errors.Noise > 0.0 ? 4.0 : 0.0;
  switch (form)
  {
    case FaultForm::Listric:
      MakeListric(model);
      break;
    case FaultForm::Oblique:
      MakePlane(model, 60.0, 25.0, sticks, random);
      break;
    case FaultForm::Steep:
      MakePlane(model, 80.0, 0.0, sticks, random);
      break;
    case FaultForm::Upright:
      MakePlane(model, 90.0, 0.0, sticks, random);
      break;
    default:
      MakePlane(model, 60.0, 0.0, sticks, random);
  }
  for (std::size_t horizon = 0; horizon < Depths.size(); ++horizon)
  {
    model.Horizons.push_back(Pick(model, horizon, errors, random));
  }
  return model;
}

//----------------------------------------------------------------------------------------------------------------------
CutoffErrors MeasurePlain(
  const CutoffModel& model, std::size_t horizon, const FaultPlate& fault, const HorizonCutoffs& cutoffs)
{
  HorizonCutoffs plain = cutoffs;
  for (CutoffPiece& piece : plain.Pieces)
  {
    for (CutoffPair& pair : piece.Pairs)
    {
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        CutoffPlace& own = pair.Wall[wall];
        std::vector<Eigen::Vector3d> rows;
        std::vector<double> heights;
        for (const Eigen::Vector3d& world : model.Horizons[horizon].Places)
        {
          const FaultPlace place = fault.ToPlace(world);
          const double side = wall == HangingWall ? fault.Distance(place) : -fault.Distance(place);
          if (side > 0.0 && std::hypot(place.S - pair.S, place.N - own.Offset) < 3.0 * Bin)
          {
            rows.emplace_back(1.0, place.S - pair.S, place.N - own.Offset);
            heights.push_back(place.Z);
          }
        }
        Eigen::MatrixXd matrix(std::ptrdiff_t(rows.size()), 3);
        for (std::size_t n = 0; n < rows.size(); ++n)
        {
          matrix.row(std::ptrdiff_t(n)) = rows[n];
        }
        const Eigen::Vector3d plane =
          matrix.colPivHouseholderQr().solve(Eigen::Map<Eigen::VectorXd>(heights.data(), matrix.rows()));
        const double start = own.Offset;
        for (int step = 0; step < 20; ++step)
        {
          own.Height = plane(0) + plane(2) * (own.Offset - start);
          own.Offset = fault.Offset(pair.S, own.Height);
        }
      }
    }
  }
  return MeasureCutoffs(model, horizon, fault, plain);
}

//----------------------------------------------------------------------------------------------------------------------
CutoffErrors MeasureCutoffs(
  const CutoffModel& model, std::size_t horizon, const FaultPlate& fault, const HorizonCutoffs& cutoffs)
{
  CutoffErrors errors;
  for (const CutoffPiece& piece : cutoffs.Pieces)
  {
    for (const CutoffPair& pair : piece.Pairs)
    {
      for (const FaultWall wall : { Footwall, HangingWall })
      {
        const CutoffPlace& own = pair.Wall[wall];
        const Eigen::Vector3d place = fault.ToWorld({ pair.S, own.Offset, own.Height });
        if (place.x() < 0.0 || place.x() > 2000.0 || place.y() < 0.0 || place.y() > 2000.0)
        {
          continue;
        }
        const double off = std::abs(place.z() - model.Height(horizon, wall, place.x(), place.y()));
        errors.Mean += off * off;
        errors.Largest = std::max(errors.Largest, off);
        errors.OffFault = std::max(errors.OffFault, std::abs(model.Distance(place)));
        ++errors.Places;
      }
    }
  }
  errors.Mean = errors.Places > 0 ? std::sqrt(errors.Mean / double(errors.Places)) : NoValue;
  return errors;
}
}
