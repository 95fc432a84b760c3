// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The processes that run a pipeline together, each on its part of the data ("ranks" of MPI). Where a function is called
// collective here, all of them have to call it, in the same order.

#ifndef SeismicHorizonsRanks_h
#define SeismicHorizonsRanks_h

#include "Common/Monitor.h"

#include <exception>
#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

namespace SeismicHorizons
{
class Ranks
{
public:
  /// This process alone.
  Ranks() = default;

  /// All of a controller, which may be null. Keeps the pointer.
  explicit Ranks(vtkMultiProcessController* controller);

  /// Those that answer a request of the pipeline together: all of a controller, which may be null, when the request is
  /// for as many pieces as it has processes, which is how ParaView asks; else this one alone, as when a program on one
  /// process calls Update(). Keeps the pointer.
  Ranks(vtkMultiProcessController* controller, vtkInformation* request, vtkInformationVector* outputs);

  /// How many there are, and which of them, from 0, this one is.
  int Size() const { return this->Count; }
  int Own() const { return this->Number; }

  /// Whether a value is true on any rank. Collective.
  bool Any(bool value) const;

  /// The texts of all ranks, on each of them. Collective.
  std::vector<std::string> Gather(const std::string& text) const;

  /// Runs work() on all ranks. Throws what it throws, and Aborted where it throws on another rank only. Collective; the
  /// work need not be the same.
  template <typename Work>
  void Together(Work&& work) const
  {
    std::exception_ptr problem;
    try
    {
      work();
    }
    catch (...)
    {
      problem = std::current_exception();
    }
    const bool failed = this->Any(problem != nullptr);
    if (problem)
    {
      std::rethrow_exception(problem);
    }
    if (failed)
    {
      throw Aborted();
    }
  }

  /// To be called where all ranks find the same thing wrong: throws InputError on the first, and Aborted on the others,
  /// so that it is reported once.
  [[noreturn]] void Refuse(const std::string& problem) const;

  /// Sends a dataset to another rank, which has to receive it.
  void Send(vtkDataObject* data, int rank) const;
  void Receive(vtkDataObject* data, int rank) const;

private:
  vtkMultiProcessController* Controller = nullptr; // null where there is one rank
  int Count = 1;
  int Number = 0;
};
}

#endif
