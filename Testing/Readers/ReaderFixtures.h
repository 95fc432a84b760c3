// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of readers share: files of their own, the horizons of a reader, and its errors.

#ifndef SeismicHorizonsReaderFixtures_h
#define SeismicHorizonsReaderFixtures_h

#include "Tools/Check.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"
#include "vtkTestUtilities.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace ReaderFixtures
{
using Reader = vtkPartitionedDataSetCollectionAlgorithm;

/// Takes over a text that VTK has allocated.
inline std::string TakeString(char* text)
{
  const std::string taken = text ? text : "";
  delete[] text;
  return taken;
}

/// The folder for files of a test, which is made here.
inline std::string MakeFolder(const char* test, int argc, char* argv[])
{
  const std::string folder =
    TakeString(vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary")) + "/" +
    test;
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

inline vtkPolyData* GetHorizon(Reader* reader, unsigned int position)
{
  return vtkPolyData::SafeDownCast(reader->GetOutput()->GetPartition(position, 0));
}

inline std::string GetName(Reader* reader, unsigned int position)
{
  const char* name = reader->GetOutput()->GetMetaData(position)->Get(vtkCompositeDataSet::NAME());
  return name ? name : "";
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
  explicit Messages(Reader* reader, vtkCommand::EventIds event = vtkCommand::ErrorEvent)
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
