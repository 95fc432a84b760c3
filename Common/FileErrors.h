// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFileErrors_h
#define SeismicHorizonsFileErrors_h

#include "Errors.h"

#include <string>

namespace SeismicHorizons
{
/// What is wrong with a file, for programs that do not read messages: readers and writers make a vtkErrorCode of it.
enum class FileProblem
{
  NoName,
  NotFound,
  CannotOpen,
  CutOff, ///< it ends before it should
  WrongContent,
  NoRoom ///< it could not be written to its end
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

/// Runs work on a file, and gives what it returns. The InputErrors it throws begin with the name; those that say
/// nothing else are about the contents of the file.
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
