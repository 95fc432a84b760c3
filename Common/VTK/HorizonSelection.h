// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The horizons of a file by their names: which of them are to be loaded, and what they are called in the output.

#ifndef SeismicHorizonsHorizonSelection_h
#define SeismicHorizonsHorizonSelection_h

#include <string>
#include <vector>

class vtkDataArraySelection;
class vtkPartitionedDataSetCollection;

namespace SeismicHorizons
{
/// The names with " (2)", " (3)" and so on behind those that came before, so that each is there once.
std::vector<std::string> MakeDistinct(std::vector<std::string> names);

/// Lists the horizons. Those that were in the list before keep their choice, others are enabled.
void ListHorizons(const std::vector<std::string>& names, vtkDataArraySelection* selection);

/// For each of these names whether it is enabled.
std::vector<bool> FindEnabled(const std::vector<std::string>& names, vtkDataArraySelection* selection);

/// Adds an empty partitioned dataset for each horizon, with its name.
void AddHorizonNames(const std::vector<std::string>& names, vtkPartitionedDataSetCollection* collection);
}

#endif
