// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsXMLPrinter_h
#define SeismicHorizonsXMLPrinter_h

#include "Common/Base/Errors.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkXMLWriter.h"

#include <ostream>

namespace SeismicHorizons
{
/// VTK's writer would destroy an existing file if the disk is full. Appended data, the default, fail in readers of VTK
/// up to 9.2 with a recent Expat library.
template <typename Writer>
void PrintXML(vtkDataObject* data, std::ostream& stream)
{
  vtkNew<Writer> writer;
  writer->SetInputDataObject(data);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError("VTK cannot write the data as XML, expected memory for their text");
  }
  stream << writer->GetOutputString();
}
}

#endif
