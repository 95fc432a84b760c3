// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of readers share: files of their own, the horizons of a reader, and its errors.

#ifndef SeismicHorizonsReaderFixtures_h
#define SeismicHorizonsReaderFixtures_h

#include "FileFixtures.h"
#include "Tools/Check.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"

#include <iostream>
#include <string>

namespace ReaderFixtures
{
using Reader = vtkPartitionedDataSetCollectionAlgorithm;

using FileFixtures::MakeFolder;
using FileFixtures::TakeString;
using FileFixtures::WriteText;

inline vtkPolyData* GetHorizon(Reader* reader, unsigned int position)
{
  return FileFixtures::GetHorizon(reader->GetOutput(), position);
}

inline std::string GetName(Reader* reader, unsigned int position)
{
  return FileFixtures::GetName(reader->GetOutput(), position);
}

inline bool IsEmpty(Reader* reader)
{
  return reader->GetOutput()->GetNumberOfPartitionedDataSets() == 0;
}

template <typename Array>
Array* GetArray(vtkFieldData* data, const char* name, vtkIdType numberOfTuples, int numberOfComponents)
{
  Array* const array = Array::SafeDownCast(data->GetAbstractArray(name));
  CHECK(array && array->GetNumberOfTuples() == numberOfTuples);
  CHECK(array && array->GetNumberOfComponents() == numberOfComponents);
  return array;
}

/// Counts and keeps the messages of a reader: its errors, or its warnings. Those of its executive only repeat that it
/// failed.
class Messages
{
public:
  explicit Messages(vtkAlgorithm* reader, vtkCommand::EventIds event = vtkCommand::ErrorEvent)
    : IsOfWarnings(event == vtkCommand::WarningEvent)
  {
    reader->AddObserver(event, this->Observer);
    reader->AddObserver(event, this->Counter);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
    this->Counter->SetClientData(&this->Count);
    this->Counter->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  }

  /// Whether there was one since the last call, and what it says.
  bool WasOne(const std::string& text)
  {
    const std::string message =
      this->IsOfWarnings ? this->Observer->GetWarningMessage() : this->Observer->GetErrorMessage();
    const bool found = this->Count == 1 && message.find(text) != std::string::npos;
    if (!found)
    {
      std::cerr << this->Count << " messages, expected one with \"" << text << "\":\n" << message << '\n';
    }
    this->Count = 0;
    this->Observer->Clear();
    return found;
  }

  int Number() const { return this->Count; }

private:
  const bool IsOfWarnings;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> Quiet;
  vtkNew<vtkCallbackCommand> Counter;
  int Count = 0;
};
}

#endif
