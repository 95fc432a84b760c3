// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads triangulated surfaces from GOCAD's text format: objects of the type TSurf, of which a file may hold several
// (Documentation/GOCADTSurfReader.md). Objects of other types are skipped.
//
// A file is parsed piece by piece: some megabytes of it are in memory at a time, beside the result. Time is linear in
// the bytes. Numbers are read independently of the locale and rounded correctly.
//
// A file that breaks the format gives an InputError whose text starts with the number of the line, as "line 17: ".

#ifndef SeismicHorizonsTSurfParser_h
#define SeismicHorizonsTSurfParser_h

#include "Common/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// How many bytes of a file are held at a time. A longer line makes the buffer grow.
constexpr std::size_t TSurfBufferSize = 4 * 1024 * 1024;

/// The type of the first object, in lower case, where the first line that is neither blank nor a comment begins with
/// the word GOCAD, within the first 4096 bytes. Leaves the stream where it was.
std::optional<std::string> FirstTypeOfGOCAD(std::istream& stream);

struct TSurfList
{
  std::vector<std::string> Names; ///< of all TSurfs in the order of the file; empty for one without a name
  std::vector<std::int64_t> Lines; ///< how many each of them has, with blank ones: mostly vertices and triangles
  std::int64_t OtherObjects = 0; ///< how many objects of other types the file has
};

/// Lists the TSurfs of a file. Of their content only the headers are looked at.
TSurfList ListTSurfs(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = TSurfBufferSize);

/// Whether a TSurf is to be loaded, by its position among those of the file, from 0.
using TSurfChoice = std::function<bool(std::size_t)>;

/// Loads the chosen TSurfs, in the order of the file.
std::vector<TSurf> LoadTSurfs(std::istream& stream, const TSurfChoice& choice, const Monitor& monitor = Monitor(),
  std::size_t bufferSize = TSurfBufferSize);
}

#endif
