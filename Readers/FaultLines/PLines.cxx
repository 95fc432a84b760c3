// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// GOCAD PLine: objects with ILINE, vertices, and SEG lines that connect two vertices. Objects of other types are
// skipped.

#include "FaultLineFormats.h"

#include "Common/Horizon/Types.h"
#include "Common/Survey/Units.h"
#include "Common/Text/TextWords.h"
#include "Readers/GOCADTSurf/VertexIds.h"

#include <array>
#include <charconv>
#include <optional>

namespace SeismicHorizons
{
namespace
{
class PLineParser : public FaultLineParser
{
public:
  void Take(const NumberedLine& line) override
  {
    const std::vector<std::string_view> words = SplitFields(line.Text, FieldSeparator::Blanks);
    this->Line = line.Number;
    if (words.empty() || StartsWith(words[0], "#"))
    {
      return;
    }
    this->Keyword = ToLower(words[0]); // Programs write keywords in either case.
    if (this->IsInBlock)
    {
      this->TakeOfBlock(Trim(line.Text));
    }
    else if (this->Keyword == "gocad")
    {
      this->StartObject(words);
    }
    else if (this->Keyword == "end")
    {
      this->EndLine();
      this->IsPLine = false;
    }
    else
    {
      this->TakeOfObject(words, Trim(line.Text));
    }
  }

  FaultLineFile Finish() override
  {
    if (this->IsPLine)
    {
      throw CutOffAt(this->Line, "end of file, expected END of the GOCAD object");
    }
    this->File.IsUpright = !this->IsDown.value_or(false);
    this->File.SaysDirection = true;
    return std::move(this->File);
  }

private:
  void StartObject(const std::vector<std::string_view>& words)
  {
    if (this->IsPLine)
    {
      throw ErrorAt(this->Line, Quote("GOCAD") + ", expected END of the GOCAD object");
    }
    this->IsPLine = words.size() > 1 && ToLower(words[1]) == "pline";
    this->IsDepth = false;
    this->Name.clear();
    this->Ids = VertexIds();
    this->Vertices.clear();
  }

  void TakeOfBlock(std::string_view text)
  {
    this->TakeName(text);
    this->IsInBlock = text.back() != '}';
  }

  void TakeName(std::string_view text)
  {
    if (ToLower(text.substr(0, 5)) == "name:")
    {
      text.remove_prefix(5);
      this->Name = std::string(Trim(text.substr(0, text.find('}'))));
    }
  }

  void TakeOfObject(const std::vector<std::string_view>& words, std::string_view text)
  {
    if (text.find('{') != std::string_view::npos)
    {
      if (StartsWith(this->Keyword, "header"))
      {
        this->TakeName(Trim(text.substr(text.find('{') + 1)));
      }
      this->IsInBlock = text.back() != '}';
    }
    else if (this->Keyword == "axis_unit" && words.size() > 3 && this->IsPLine)
    {
      this->TakeUnit(KnownUnit(Unquote(words[3])));
    }
    else if (this->Keyword == "zpositive")
    {
      this->IsDepth = words.size() > 1 && ToLower(words[1]) == "depth";
    }
    else if (this->IsPLine)
    {
      this->TakeGeometry(words);
    }
  }

  void TakeUnit(const std::string& own)
  {
    const std::string& first = this->File.Survey.VerticalUnit;
    if (!first.empty() && !own.empty() && own != first)
    {
      throw ErrorAt(this->Line, "z in " + own + ", expected " + first + " as in the polylines before");
    }
    if (first.empty())
    {
      SetVerticalUnit(this->File.Survey, own);
    }
  }

  void TakeGeometry(const std::vector<std::string_view>& words)
  {
    if (this->Keyword == "iline")
    {
      this->EndLine();
    }
    else if (this->Keyword == "vrtx" || this->Keyword == "pvrtx")
    {
      this->TakeVertex(words);
    }
    else if (this->Keyword == "seg")
    {
      this->TakeSegment(words);
    }
  }

  void TakeVertex(const std::vector<std::string_view>& words)
  {
    if (words.size() < 5)
    {
      throw ErrorAt(this->Line, std::to_string(words.size()) + " words, expected a vertex: id, x, y and z");
    }
    const double z = ReadFinite(words[4], this->Line, "z");
    this->IsDown = this->IsDown.value_or(this->IsDepth);
    this->Vertices.push_back({ ReadFinite(words[2], this->Line, "x"), ReadFinite(words[3], this->Line, "y"),
      this->IsDepth == *this->IsDown ? z : -z });
    if (!this->Ids.Add(this->ReadId(words[1])))
    {
      throw ErrorAt(this->Line, "vertex id " + Excerpt(words[1]) + " repeated, expected unique ids");
    }
  }

  /// A segment that starts at the end of the last one extends its polyline.
  void TakeSegment(const std::vector<std::string_view>& words)
  {
    if (words.size() < 3)
    {
      throw ErrorAt(this->Line, std::to_string(words.size()) + " words, expected SEG and two ids of vertices");
    }
    const PointId from = this->FindVertex(words[1]);
    const PointId to = this->FindVertex(words[2]);
    if (from != this->End)
    {
      this->EndLine();
      this->File.Append(this->Vertices[std::size_t(from)]);
    }
    this->File.Append(this->Vertices[std::size_t(to)]);
    this->End = to;
  }

  std::int64_t ReadId(std::string_view word) const
  {
    std::int64_t id = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error != std::errc() || end != word.data() + word.size())
    {
      throw ErrorAt(this->Line, Quote(word) + ", expected the id of a vertex");
    }
    return id;
  }

  PointId FindVertex(std::string_view word) const
  {
    const PointId vertex = this->Ids.Find(this->ReadId(word));
    if (vertex == NoPoint)
    {
      throw ErrorAt(this->Line, "vertex " + Excerpt(word) + ", expected the id of a vertex above");
    }
    return vertex;
  }

  void EndLine()
  {
    this->File.Close(this->Name);
    this->End = NoPoint;
  }

  FaultLineFile File;
  std::int64_t Line = 0;
  std::string Keyword;
  bool IsPLine = false;
  bool IsInBlock = false; // between braces
  bool IsDepth = false; // z of the object increases downwards.
  std::optional<bool> IsDown; // z of the first object, and of all lines, increases downwards.
  std::string Name;
  VertexIds Ids;
  std::vector<SpacePoint> Vertices;
  PointId End = NoPoint; // last vertex of the current polyline
};
}

//----------------------------------------------------------------------------------------------------------------------
std::unique_ptr<FaultLineParser> MakePLineParser()
{
  return std::make_unique<PLineParser>();
}
}
