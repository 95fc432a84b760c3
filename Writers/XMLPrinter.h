// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsXMLPrinter_h
#define SeismicHorizonsXMLPrinter_h

#include "Common/Errors.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkXMLWriter.h"

#include <ostream>

namespace SeismicHorizons
{
/// Data in an XML format of VTK, by its writer but not into a file, which it would destroy where a disk is full. Not with
/// appended bytes, the default: readers of VTK up to 9.2 stumble over them with a recent Expat library.
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
