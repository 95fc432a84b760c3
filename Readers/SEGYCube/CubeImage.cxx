// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeImage.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/PipelineRequest.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace SeismicHorizons
{
namespace
{
void AddBlanking(const SEGYWindow& window, const CubeExtent& extent, vtkImageData* image)
{
  auto ghosts = NewArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), image->GetNumberOfPoints());
  unsigned char* const marks = ghosts->GetPointer(0);
  const std::size_t columns = window.Columns.size();
  ParallelFor(std::int64_t(extent[5]) - extent[4] + 1, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t level = first; level < last; ++level)
      {
        unsigned char* const mark = marks + std::size_t(level) * columns;
        const int k = extent[4] + int(level);
        for (std::size_t column = 0; column < columns; ++column)
        {
          const SampleRange& range = window.Columns[column];
          mark[column] = range.First <= k && k < range.End ? 0 : vtkDataSetAttributes::HIDDENPOINT;
        }
      }
    });
  image->GetPointData()->AddArray(ghosts);
}

void AddFields(const SEGYCube& cube, const CubeView& view, vtkFieldData* data)
{
  AddFrameFields(data, view.Frame);
  AddValue<vtkDoubleArray>(data, FieldArray::ImageDeviation, view.Image.Deviation);
  AddValue<vtkDoubleArray>(data, FieldArray::StrongAmplitude, double(FindStrongAmplitude(cube)));
  auto text = NewArray<vtkStringArray>(FieldArray::TextHeader, vtkIdType(cube.Header.Text.size()));
  for (std::size_t line = 0; line < cube.Header.Text.size(); ++line)
  {
    text->SetValue(vtkIdType(line), cube.Header.Text[line]);
  }
  data->AddArray(text);
}
}

//----------------------------------------------------------------------------------------------------------------------
void Announce(const CubeView& view, const CubeExtent& extent, vtkInformation* info)
{
  AnnounceImage(extent, view.Image, info);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t FillImage(
  const SEGYCube& cube, const CubeView& view, const CubeExtent& extent, vtkImageData* image, const Monitor& monitor)
{
  image->SetExtent(const_cast<int*>(extent.data()));
  PlaceImage(image, view.Image);
  AddFields(cube, view, image->GetFieldData());
  if (image->GetNumberOfPoints() == 0)
  {
    return 0;
  }
  auto amplitude = NewArray<vtkFloatArray>(PointArray::Amplitude, image->GetNumberOfPoints());
  const SEGYWindow window = ReadSEGYWindow(cube, extent, amplitude->GetPointer(0), monitor);
  image->GetPointData()->SetScalars(amplitude);
  if (!window.IsFull)
  {
    AddBlanking(window, extent, image);
  }
  return window.NotFinite;
}

//----------------------------------------------------------------------------------------------------------------------
void AnnounceLine(const SEGYCube& cube, const CubeExtent& extent, vtkInformation* info)
{
  AnnounceExtent(cube.Places.empty() ? CubeExtent{ 0, -1, 0, -1, 0, -1 } : extent, info);
}

//----------------------------------------------------------------------------------------------------------------------
void FillLine(const SEGYCube& cube, const CubeView& view, vtkImageData* image, vtkStructuredGrid* line)
{
  if (cube.Places.empty() || image->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // Coordinates of surveys are millions of metres.
  points->SetNumberOfPoints(image->GetNumberOfPoints());
  const int* const extent = image->GetExtent();
  vtkIdType point = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const Eigen::Vector2d& place = cube.Places[cube.Column(i, j)];
        points->SetPoint(point++, place.x(), place.y(), view.Frame.Elevation(k));
      }
    }
  }
  line->SetExtent(image->GetExtent());
  line->SetPoints(points);
  line->GetPointData()->ShallowCopy(image->GetPointData());
  line->GetFieldData()->ShallowCopy(image->GetFieldData());
}
}
