// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The processes of a parallel pipeline, as in MPI. All ranks must call collective functions, in the same order.

#ifndef SeismicHorizonsRanks_h
#define SeismicHorizonsRanks_h

#include "Common/Base/Monitor.h"

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

  /// All processes of a controller, which may be null and must outlive the ranks.
  explicit Ranks(vtkMultiProcessController* controller);

  /// All processes of a controller if the request is for as many pieces, as in ParaView; else this process alone, as
  /// when a program calls Update().
  Ranks(vtkMultiProcessController* controller, vtkInformation* request, vtkInformationVector* outputs);

  /// Own counts from 0.
  int Size() const { return this->Count; }
  int Own() const { return this->Number; }

  /// Collective.
  bool Any(bool value) const;

  /// Collective.
  std::vector<std::string> Gather(const std::string& text) const;

  /// Throws Aborted if work fails on another rank. Collective; work may differ.
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

  /// All ranks call this for a common problem, which only the first reports; further ranks throw Aborted.
  [[noreturn]] void Refuse(const std::string& problem) const;

  /// Wait until the other rank receives.
  void Send(const std::vector<char>& bytes, int rank) const;
  std::vector<char> ReceiveBytes(int rank) const;
  void Send(vtkDataObject* data, int rank) const;
  void Receive(vtkDataObject* data, int rank) const;

private:
  vtkMultiProcessController* Controller = nullptr;
  int Count = 1;
  int Number = 0;
};
}

#endif
