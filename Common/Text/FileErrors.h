// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFileErrors_h
#define SeismicHorizonsFileErrors_h

#include "Common/Base/Errors.h"

#include <string>

namespace SeismicHorizons
{
/// Readers and writers convert these to vtkErrorCode.
enum class FileProblem
{
  NoName,
  NotFound,
  CannotOpen,
  CutOff,
  WrongContent,
  NoRoom ///< Writing did not complete.
};

class FileError : public InputError
{
public:
  FileError(FileProblem problem, const std::string& text)
    : InputError(text)
    , Kind(problem)
  {
  }

  FileProblem Problem() const { return this->Kind; }

private:
  FileProblem Kind;
};

/// Adds the file name to InputErrors, which become FileErrors on contents.
template <typename Work>
auto PrefixFileErrors(const std::string& name, Work&& work)
{
  try
  {
    return work();
  }
  catch (const FileError& error)
  {
    throw FileError(error.Problem(), name + ": " + error.what());
  }
  catch (const InputError& error)
  {
    throw FileError(FileProblem::WrongContent, name + ": " + error.what());
  }
}
}

#endif
