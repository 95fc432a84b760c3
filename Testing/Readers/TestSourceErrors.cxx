// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whatever leaves the work of an algorithm becomes one error and an empty output.

#include "ReaderFixtures.h"
#include "Tools/Check.h"

#include "vtkDataAssembly.h"
#include "vtkErrorCode.h"
#include "vtkHorizonSource.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace
{
/// Makes horizons of some names, and does what it is told while it lists them, or makes them.
class vtkFailingSource : public vtkHorizonSource
{
public:
  static vtkFailingSource* New();
  vtkTypeMacro(vtkFailingSource, vtkHorizonSource);

  std::vector<std::string> Names = { "Top" };
  std::function<void()> OnList = [] {};
  std::function<void()> OnMake = [] {};

protected:
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor&) override
  {
    this->OnList();
    return this->Names;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor&) override
  {
    this->OnMake();
    std::vector<vtkSmartPointer<vtkDataObject>> horizons;
    for (std::size_t n = 0; n < numbers.size(); ++n)
    {
      horizons.push_back(vtkSmartPointer<vtkPolyData>::New());
    }
    return horizons;
  }
};
vtkStandardNewMacro(vtkFailingSource);

constexpr auto UnknownError = static_cast<unsigned long>(vtkErrorCode::UnknownError);
constexpr auto NoError = static_cast<unsigned long>(vtkErrorCode::NoError);

/// One error with that text, whether it leaves on a request for information or for data; all is well again after it.
void CheckOneError(const std::function<void()>& fail, const std::string& text)
{
  vtkNew<vtkFailingSource> source;
  ReaderFixtures::Messages errors(source);
  for (std::function<void()>* const step : { &source->OnList, &source->OnMake })
  {
    *step = fail;
    source->Modified();
    source->Update();
    CHECK(errors.WasOne(text));
    CHECK(ReaderFixtures::IsEmpty(source));
    CHECK_EQUAL(source->GetErrorCode(), UnknownError);
    *step = [] {};
    source->Modified();
    source->Update();
    CHECK_EQUAL(errors.Number(), 0);
    CHECK_EQUAL(source->GetOutput()->GetNumberOfPartitionedDataSets(), 1u);
    CHECK_EQUAL(source->GetErrorCode(), NoError);
  }
}

void WhateverIsThrownIsOneError()
{
  const std::string noMemory = "more data than memory, expected fewer or smaller horizons";
  CheckOneError([] { throw std::bad_alloc(); }, noMemory);
  CheckOneError([] { std::vector<int>().reserve(std::vector<int>().max_size() + 1); }, noMemory);
  CheckOneError([] { throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)); },
    "the system reports \"Resource temporarily unavailable\", expected enough threads and files for this");
  CheckOneError([] { static_cast<void>(std::filesystem::file_size("/no/such/file")); },
    "No such file or directory [/no/such/file]\", expected enough threads and files for this");
  CheckOneError([] { static_cast<void>(std::vector<int>().at(7)); }, "please report it");
  CheckOneError([] { throw std::runtime_error("lost"); }, "internal error \"lost\", expected none: please report it");
  CheckOneError([] { throw std::exception(); }, "please report it");
}

/// Names of nodes are made valid; the horizons' own are their labels.
void AssembliesHaveANodeForEachHorizon()
{
  vtkNew<vtkFailingSource> source;
  source->Names = { "Top Reek (2)", "7", "Lias \xce\xb1", "\xce\xb1\xce\xb2", "dataset", "" };
  source->Update();
  vtkDataAssembly* const assembly = source->GetOutput()->GetDataAssembly();
  if (!CHECK(assembly != nullptr))
  {
    return;
  }
  CHECK_EQUAL(std::string(assembly->GetRootNodeName()), "Horizons");
  CHECK_EQUAL(assembly->GetNumberOfChildren(0), 6);
  for (int n = 0; n < assembly->GetNumberOfChildren(0); ++n)
  {
    const int node = assembly->GetChild(0, n);
    CHECK(vtkDataAssembly::IsNodeNameValid(assembly->GetNodeName(node)));
    CHECK(assembly->GetDataSetIndices(node) == std::vector<unsigned int>({ static_cast<unsigned int>(n) }));
    CHECK_EQUAL(std::string(assembly->GetAttributeOrDefault(node, "label", "")), source->Names[n]);
  }
  source->SetHorizonStatus("7", 0);
  source->Update();
  CHECK_EQUAL(source->GetOutput()->GetDataAssembly()->GetNumberOfChildren(0), 5);
}
}

int TestSourceErrors(int, char*[])
{
  WhateverIsThrownIsOneError();
  AssembliesHaveANodeForEachHorizon();
  return Check::Result();
}
