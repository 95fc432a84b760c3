// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that programs wrote, from the folder that the environment variable SEISMICHORIZONS_REAL_DATA names. The samples
// and places below were decoded from their bytes by a program of its own.

#include "Tools/Check.h"
#include "WindowSample.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

using namespace SEGYSample;

namespace
{
constexpr int Skipped = 77;

std::filesystem::path Folder()
{
  const char* const folder = std::getenv("SEISMICHORIZONS_REAL_DATA");
  return folder ? std::filesystem::path(folder) / "segy" : std::filesystem::path();
}

/// A sample, and where its trace says that it is.
struct Spot
{
  const char* File;
  int Inline, Crossline, Sample;
  float Value;
  double X, Y;
};

const std::vector<Spot> Spots = {
  { "f3.sgy", 113, 891, 50, -1036.0f, 620595.7, 6074294.0 },
  { "f3.sgy", 117, 887, 61, -1883.0f, 620492.9, 6074391.2 },
  { "f3.sgy", 119, 886, 19, -2869.0f, 620466.5, 6074440.5 },
  { "f3-withdead.sgy", 112, 883, 50, -1370.0f, 620396.5, 6074263.6 },
  { "f3-withdead.sgy", 114, 881, 61, -1743.0f, 620345.1, 6074312.0 },
  { "f3-withdead.sgy", 115, 880, 19, -1250.0f, 620319.4, 6074336.4 },
  { "f3-ebcidctest.sgy", 105, 326, 369, -1177.0f, 606481.8, 6073699.6 },
  { "f3-ebcidctest.sgy", 105, 360, 202, 2058.0f, 607331.4, 6073723.6 },
  { "f3-ebcidctest.sgy", 105, 377, 245, 48.0f, 607756.3, 6073735.6 },
  { "ex1_missing_traces_75x71x26.segy", 11374, 2578, 23, 0.13370710611343384f, 449713, 6812288 },
  { "ex1_missing_traces_75x71x26.segy", 11406, 2562, 12, 0.009041920304298401f, 449613, 6812488 },
  { "ex1_missing_traces_75x71x26.segy", 11424, 2490, 15, -0.021286170929670334f, 449163, 6812600 },
  { "ex2_complete_3d_75x71x26.segy", 10772, 2728, 23, -0.29876458644866943f, 450650, 6808525 },
  { "ex2_complete_3d_75x71x26.segy", 10804, 2632, 12, -0.06802129745483398f, 450050, 6808725 },
  { "ex2_complete_3d_75x71x26.segy", 10818, 2740, 15, 0.05638042464852333f, 450725, 6808813 },
  { "penobscot_xl1155.sgy", 1105, 1155, 1477, -252.0f, 734808.2, 4893067.7 },
  { "penobscot_xl1155.sgy", 1241, 1155, 811, -611.0f, 734020.3, 4894573.5 },
  { "penobscot_xl1155.sgy", 1310, 1155, 980, -1141.0f, 733620.6, 4895337.4 },
};

/// What is known of a file.
struct Expected
{
  const char* File;
  int Crosslines, Inlines, Samples;
  double Delay;
  int Missing;
  SEGYFormat Format;
  double LargestDistance; // of traces to their columns, in columns
};

const std::vector<Expected> Files = {
  { "f3.sgy", 18, 23, 75, 4.0, 0, SEGYFormat::Integer16, 0.003 },
  { "f3-withdead.sgy", 18, 23, 75, 4.0, 175, SEGYFormat::IbmFloat, 0.033 },
  { "f3-ebcidctest.sgy", 100, 2, 463, 0.0, 0, SEGYFormat::IbmFloat, 0.022 },
  { "ex1_missing_traces_75x71x26.segy", 71, 75, 26, 0.0, 387, SEGYFormat::IeeeFloat, 0.021 },
  { "ex2_complete_3d_75x71x26.segy", 71, 75, 26, 0.0, 0, SEGYFormat::IeeeFloat, 0.021 },
  { "penobscot_xl1155.sgy", 1, 601, 1501, 0.0, 0, SEGYFormat::IbmFloat, 0.005 },
};

void HeadersAreUnderstood()
{
  for (const Expected& expected : Files)
  {
    const SEGYCube cube = ReadSEGYCube((Folder() / expected.File).u8string(), {});
    CHECK_EQUAL(cube.LineFields.First, 189);
    CHECK_EQUAL(cube.LineFields.Second, 193);
    CHECK_EQUAL(cube.PlaceFields.First, 181);
    CHECK_EQUAL(cube.Lattice.Columns[0], expected.Crosslines);
    CHECK_EQUAL(cube.Lattice.Columns[1], expected.Inlines);
    CHECK_EQUAL(cube.Sampling.Indices, expected.Samples);
    CHECK_EQUAL(cube.Sampling.First, expected.Delay);
    CHECK_EQUAL(cube.Sampling.Step, 4.0);
    CHECK_EQUAL(cube.MissingTraces, expected.Missing);
    CHECK(cube.Header.Format == expected.Format);
    CHECK(cube.LargestDistance < expected.LargestDistance);
    CHECK_EQUAL(WarningText(cube), std::string());
    const Window window = ReadWindow(cube, Whole(cube));
    CHECK_EQUAL(std::count_if(window.Marks.Columns.begin(), window.Marks.Columns.end(),
                  [](const SampleRange& range) { return range.First == range.End; }),
      expected.Missing);
    CHECK_EQUAL(window.Marks.Nulls, 0);
  }
}

void SamplesAreThoseOfTheFile()
{
  for (const Spot& spot : Spots)
  {
    const SEGYCube cube = ReadSEGYCube((Folder() / spot.File).u8string(), {});
    const LineNumbering& lines = *cube.Lattice.Lines;
    const int i = int((spot.Crossline - lines.FirstCrossline) / lines.CrosslineStep);
    const int j = int((spot.Inline - lines.FirstInline) / lines.InlineStep);
    const Window window = ReadWindow(cube, { i, i, j, j, spot.Sample, spot.Sample });
    CHECK_EQUAL(window.Values.front(), spot.Value);
    const Eigen::Vector2d place = cube.Lattice.Origin + i * cube.Lattice.ColumnStep + j * cube.Lattice.RowStep;
    CHECK((place - Eigen::Vector2d(spot.X, spot.Y)).norm() < 0.8); // metres; some files have whole ones
  }
}

void TextsAreReadable()
{
  const auto text = [](const char* name) { return ReadSEGYCube((Folder() / name).u8string(), {}).Header.Text; };
  CHECK_EQUAL(text("f3.sgy")[0], std::string("C 1 Cropped F3 2-byte integer data set"));
  CHECK_EQUAL(text("penobscot_xl1155.sgy")[1], std::string("C02  Survey: 'Penobscot'"));
}

/// The f3 files have the same fields of lines in other places, too.
void OtherBytesGiveTheSameLattice()
{
  SEGYOptions options;
  options.LineFields = { 9, 21 };
  options.PlaceFields = { 73, 77 };
  const std::string name = (Folder() / "f3.sgy").u8string();
  const SEGYCube given = ReadSEGYCube(name, options);
  const SEGYCube found = ReadSEGYCube(name, {});
  CHECK(given.Traces == found.Traces);
  CHECK(given.Lattice.Origin == found.Lattice.Origin);
  CHECK(given.Lattice.ColumnStep == found.Lattice.ColumnStep);
  options.LineFields = { 5, 21 }; // a number for each trace
  CHECK_THROWS_WITH(ReadSEGYCube(name, options), "expected a grid that is at least one sixteenth full");
}
}

int TestRealSEGY(int, char*[])
{
  if (!std::filesystem::is_directory(Folder()))
  {
    return Skipped;
  }
  HeadersAreUnderstood();
  SamplesAreThoseOfTheFile();
  TextsAreReadable();
  OtherBytesGiveTheSameLattice();
  return Check::Result();
}
