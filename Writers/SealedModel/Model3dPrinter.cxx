// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers in the file start at 1: those of TFACE and REGION together, and those of VRTX and BORDER of each TSurf.

#include "ModelPrinters.h"

#include "Writers/GOCADTSurf/TSurfPrinter.h"

#include <map>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 4> Model3dTypes = { "top", "fault", "boundary", "boundary" };
constexpr const char* NotInWords = " {}";

class Model3dPrinter
{
public:
  Model3dPrinter(const ClosedModel& model, const ModelTopology& topology, std::ostream& stream)
    : Model(model)
    , Topology(topology)
    , Names(NameDifferently(model.Surfaces, NotInWords))
    , Numbers(topology.Vertices.size())
    , AreCorners(model.Points.size())
    , Out(stream)
  {
    std::for_each(topology.Corners.begin(), topology.Corners.end(),
      [this](PointId point) { this->AreCorners[std::size_t(point)] = 1; });
  }

  void Print(const Monitor& monitor)
  {
    this->PrintHeader("Model3d", "SealedModel");
    for (const std::string& name : this->Names)
    {
      this->Out.PrintLine(" ", "TSURF", name);
    }
    for (std::size_t face = 0; face < this->Topology.Faces.size(); ++face)
    {
      const std::size_t surface = this->Topology.Faces[face].Surface;
      this->Out.PrintLine(" ", "TFACE", face + 1, this->TypeOf(surface), this->Names[surface]);
      for (const PointId point : this->Topology.Triangles[this->Topology.Faces[face].Triangles.front()])
      {
        this->PrintPlace(" ", point);
      }
    }
    this->PrintRegions();
    this->Out.Print("END\n");
    std::size_t face = 0;
    for (std::size_t surface = 0; surface < this->Names.size(); ++surface)
    {
      face = this->PrintSurface(surface, face, monitor);
    }
    this->Out.Flush();
    monitor.Progress(1.0);
  }

private:
  const char* TypeOf(std::size_t surface) const
  {
    return Model3dTypes[std::size_t(this->Model.Surfaces[surface].Type)];
  }

  void PrintHeader(const char* kind, const std::string& name)
  {
    this->Out.Print("GOCAD ", kind, " 1\nHEADER {\nname:", name, "\n}\n");
    PrintCoordinateSystem(this->Model.Survey, false, this->Out);
  }

  template <typename Text>
  void PrintPlace(const Text& before, PointId point)
  {
    const std::array<double, 3>& place = this->Model.Points[std::size_t(point)];
    this->Out.PrintLine(" ", before, place[0], place[1], place[2]);
  }

  void PrintList(const std::vector<std::string>& items)
  {
    for (std::size_t n = 0; n < items.size(); ++n)
    {
      this->Out.Print("  ", items[n], n % 5 == 4 ? "\n" : "");
    }
    this->Out.Print("  0\n");
  }

  void PrintRegions()
  {
    std::vector<std::vector<std::string>> around(this->Model.Bodies.size() + 1); // by body, from outside on
    std::size_t number = 0;
    for (const ModelTopology::Face& face : this->Topology.Faces)
    {
      ++number;
      around[std::size_t(face.Bodies[0] + 1)].push_back('+' + std::to_string(number));
      around[std::size_t(face.Bodies[1] + 1)].push_back('-' + std::to_string(number));
    }
    const std::vector<std::string> words = NameDifferently(this->Model.Bodies, NotInWords, { "Universe" });
    std::map<int, std::vector<std::string>> layers;
    std::map<int, std::vector<std::string>> blocks;
    for (std::size_t n = 0; n < around.size(); ++n)
    {
      this->Out.PrintLine(" ", "REGION", ++number, n == 0 ? "Universe" : words[n - 1]);
      this->PrintList(around[n]);
      if (n > 0)
      {
        layers[this->Model.Bodies[n - 1].Layer].push_back(std::to_string(number));
        blocks[this->Model.Bodies[n - 1].Block].push_back(std::to_string(number));
      }
    }
    for (const auto& [kind, groups] : { std::pair("LAYER layer_", layers), std::pair("FAULT_BLOCK block_", blocks) })
    {
      for (const auto& [group, regions] : groups)
      {
        this->Out.Print(kind, group, "\n");
        this->PrintList(regions);
      }
    }
  }

  /// Returns the first face behind those of the surface.
  std::size_t PrintSurface(std::size_t surface, std::size_t face, const Monitor& monitor)
  {
    this->PrintHeader("TSurf", this->Names[surface]);
    this->Out.Print("GEOLOGICAL_FEATURE ", this->Names[surface], "\nGEOLOGICAL_TYPE ", this->TypeOf(surface), "\n");
    this->Vertices = 0;
    this->Stones.clear();
    std::vector<std::array<std::int64_t, 2>> borders;
    for (; face < this->Topology.Faces.size() && this->Topology.Faces[face].Surface == surface; ++face)
    {
      monitor.Progress(double(face) / double(this->Topology.Faces.size()));
      this->PrintFace(this->Topology.Faces[face].Triangles, borders);
    }
    for (const std::int64_t stone : this->Stones)
    {
      this->Out.PrintLine(" ", "BSTONE", stone);
    }
    for (const auto& [corner, next] : borders)
    {
      this->Out.PrintLine(" ", "BORDER", ++this->Vertices, corner, next);
    }
    this->Out.Print("END\n");
    return face;
  }

  void PrintFace(const std::vector<std::size_t>& triangles, std::vector<std::array<std::int64_t, 2>>& borders)
  {
    this->Out.Print("TFACE\n");
    for (const std::size_t triangle : triangles)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        std::int64_t& number = this->NumberOf(triangle, corner);
        const PointId point = this->Topology.Triangles[triangle][corner];
        if (number == 0)
        {
          number = ++this->Vertices;
          this->PrintPlace("VRTX " + std::to_string(number), point);
          if (this->AreCorners[std::size_t(point)])
          {
            this->Stones.push_back(number);
          }
        }
      }
    }
    for (const std::size_t triangle : triangles)
    {
      std::array<std::int64_t, 3> numbers;
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        numbers[corner] = this->NumberOf(triangle, corner);
        if (this->Topology.AreLines[3 * triangle + corner] &&
          this->AreCorners[std::size_t(this->Topology.Triangles[triangle][corner])])
        {
          borders.push_back({ numbers[corner], this->NumberOf(triangle, (corner + 1) % 3) });
        }
      }
      this->Out.PrintLine(" ", "TRGL", numbers[0], numbers[1], numbers[2]);
    }
  }

  std::int64_t& NumberOf(std::size_t triangle, std::size_t corner)
  {
    return this->Numbers[std::size_t(this->Topology.Vertices[3 * triangle + corner])];
  }

  const ClosedModel& Model;
  const ModelTopology& Topology;
  const std::vector<std::string> Names;
  std::vector<std::int64_t> Numbers; // of VRTX, by vertex
  std::vector<char> AreCorners; // by point
  std::int64_t Vertices = 0; // of this TSurf
  std::vector<std::int64_t> Stones;
  TextPrinter Out;
};
}

//----------------------------------------------------------------------------------------------------------------------
void PrintModel3d(const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor)
{
  Model3dPrinter(model, topology, stream).Print(monitor);
}
}
