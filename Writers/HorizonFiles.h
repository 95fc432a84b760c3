// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonFiles_h
#define SeismicHorizonsHorizonFiles_h

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Text/OutputFile.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Paths for several horizons, such as "reek_Top.irap" for "reek.irap"; underscores replace characters that some file
/// systems forbid.
std::vector<std::string> NameFiles(const std::string& path, const std::vector<std::string>& horizons);

/// Calls print(number, stream, monitor) for each file. All are kept, or none. `subject` becomes the file at work.
void WriteFiles(const std::vector<std::string>& paths,
  const std::function<void(std::size_t, std::ostream&, const Monitor&)>& print, const Monitor& monitor,
  std::string& subject);

/// Calls print(horizons, stream, monitor) with all horizons, which have a Name, or, `oneForEach`, with one for each
/// file. A file appears complete or not at all. Throws InputError without horizons.
template <typename Named, typename Print>
void WriteHorizonFiles(const std::string& path, const std::vector<Named>& horizons, bool oneForEach, Print&& print,
  const Monitor& monitor, std::string& subject)
{
  if (horizons.empty())
  {
    throw InputError("no horizon with points, expected something to write");
  }
  if (!oneForEach || horizons.size() == 1)
  {
    WriteOutputFile(path, [&](std::ostream& stream) { print(horizons, stream, monitor); });
    return;
  }
  std::vector<std::string> names;
  for (const Named& horizon : horizons)
  {
    names.push_back(horizon.Name);
  }
  WriteFiles(
    NameFiles(path, names),
    [&](std::size_t n, std::ostream& stream, const Monitor& step)
    { print(std::vector<Named>{ horizons[n] }, stream, step); },
    monitor, subject);
}
}

#endif
