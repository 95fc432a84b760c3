// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Ranks.h"

#include "Common/Base/Errors.h"

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr int DatasetTag = 5011;
constexpr int SizeTag = 5012;
constexpr int BytesTag = 5013;
}

//----------------------------------------------------------------------------------------------------------------------
Ranks::Ranks(vtkMultiProcessController* controller)
{
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    this->Controller = controller;
    this->Count = controller->GetNumberOfProcesses();
    this->Number = controller->GetLocalProcessId();
  }
}

//----------------------------------------------------------------------------------------------------------------------
Ranks::Ranks(vtkMultiProcessController* controller, vtkInformation* request, vtkInformationVector* outputs)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  const int pieces =
    outputs->GetInformationObject(port)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
  if (controller && controller->GetNumberOfProcesses() == pieces)
  {
    *this = Ranks(controller);
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool Ranks::Any(bool value) const
{
  const int here = value ? 1 : 0;
  int any = here;
  if (this->Controller)
  {
    this->Controller->AllReduce(&here, &any, 1, vtkCommunicator::MAX_OP);
  }
  return any != 0;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> Ranks::Gather(const std::string& text) const
{
  if (!this->Controller)
  {
    return { text };
  }
  const auto length = vtkIdType(text.size());
  std::vector<vtkIdType> lengths(std::size_t(this->Count));
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(lengths.size() + 1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), offsets.begin() + 1);
  std::string all(std::size_t(offsets.back()), '\0');
  this->Controller->AllGatherV(text.data(), &all[0], length, lengths.data(), offsets.data());
  std::vector<std::string> texts;
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
  {
    texts.push_back(all.substr(std::size_t(offsets[rank]), std::size_t(lengths[rank])));
  }
  return texts;
}

//----------------------------------------------------------------------------------------------------------------------
void Ranks::Refuse(const std::string& problem) const
{
  if (this->Number == 0)
  {
    throw InputError(problem);
  }
  throw Aborted();
}

//----------------------------------------------------------------------------------------------------------------------
void Ranks::Send(const std::vector<char>& bytes, int rank) const
{
  assert(this->Controller && rank != this->Number);
  const auto size = vtkIdType(bytes.size());
  this->Controller->Send(&size, 1, rank, SizeTag);
  this->Controller->Send(bytes.data(), size, rank, BytesTag);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<char> Ranks::ReceiveBytes(int rank) const
{
  assert(this->Controller && rank != this->Number);
  vtkIdType size = 0;
  this->Controller->Receive(&size, 1, rank, SizeTag);
  std::vector<char> bytes(static_cast<std::size_t>(size));
  this->Controller->Receive(bytes.data(), size, rank, BytesTag);
  return bytes;
}

//----------------------------------------------------------------------------------------------------------------------
void Ranks::Send(vtkDataObject* data, int rank) const
{
  assert(this->Controller && rank != this->Number);
  this->Controller->Send(data, rank, DatasetTag);
}

//----------------------------------------------------------------------------------------------------------------------
void Ranks::Receive(vtkDataObject* data, int rank) const
{
  assert(this->Controller && rank != this->Number);
  this->Controller->Receive(data, rank, DatasetTag);
}
}
