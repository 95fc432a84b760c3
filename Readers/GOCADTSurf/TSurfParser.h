// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads objects of type TSurf from GOCAD's text format (Documentation/GOCADTSurf.md), and skips others.
//
// A few megabytes of the file are in memory besides the result; time is linear in its size. Numbers are read
// independently of the locale and rounded correctly. Errors are InputError, with the number of the line: "line 17: ".

#ifndef SeismicHorizonsTSurfParser_h
#define SeismicHorizonsTSurfParser_h

#include "Common/Base/Monitor.h"
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
/// A longer line enlarges the buffer.
constexpr std::size_t TSurfBufferSize = 4 * 1024 * 1024;

/// Returns the type in lower case if the first line that is neither blank nor a comment starts with GOCAD, within 4096
/// bytes. Leaves the stream where it was.
std::optional<std::string> FirstTypeOfGOCAD(std::istream& stream);

struct TSurfList
{
  std::vector<std::string> Names; ///< Names in the order of the file; empty if missing.
  std::vector<std::int64_t> Lines; ///< Lines of each object, as an estimate of its size.
  std::int64_t OtherObjects = 0;
};

/// Parses headers only.
TSurfList ListTSurfs(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = TSurfBufferSize);

/// Selects TSurfs by their position in the file, from 0.
using TSurfChoice = std::function<bool(std::size_t)>;

/// Objects of another type, such as VSet, have what a TSurf has of them: vertices and properties.
std::vector<TSurf> LoadTSurfs(std::istream& stream, const TSurfChoice& choice, const Monitor& monitor = Monitor(),
  std::size_t bufferSize = TSurfBufferSize, const char* type = "tsurf");
}

#endif
