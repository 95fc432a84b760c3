// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Readers, stages and writers for numpy. Python classes give these functions data and options, and take what they
// return. Work runs without the interpreter's lock, and stops at Ctrl-C.

#include "Data.h"

#include "Common/Base/Parallel.h"
#include "Common/Text/FileErrors.h"

#include <algorithm>
#include <typeinfo>

NB_MODULE(_core, module)
{
  nb::register_exception_translator(
    [](const std::exception_ptr& raised, void*)
    {
      try
      {
        std::rethrow_exception(raised);
      }
      catch (const SeismicHorizons::FileError& error)
      {
        const bool isOfContent = error.Problem() == SeismicHorizons::FileProblem::WrongContent ||
          error.Problem() == SeismicHorizons::FileProblem::CutOff;
        PyErr_SetString(isOfContent ? PyExc_ValueError : PyExc_OSError, error.what());
      }
      catch (const SeismicHorizons::InputError& error)
      {
        PyErr_SetString(PyExc_ValueError, error.what());
      }
      catch (const std::bad_cast&)
      {
        PyErr_SetString(PyExc_ValueError, "a value of another kind than expected");
      }
    });
  module.def(
    "set_threads", [](int number) { SeismicHorizons::Detail::NumberOfThreads() = std::max(1, number); },
    nb::arg("number"));
  SeismicHorizons::BindReading(module);
  SeismicHorizons::BindStages(module);
  SeismicHorizons::BindLayers(module);
  SeismicHorizons::BindCutoffs(module);
  SeismicHorizons::BindSealed(module);
  SeismicHorizons::BindCubes(module);
  SeismicHorizons::BindWriting(module);
}
