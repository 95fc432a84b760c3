// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkHorizonProperty.h
 * @brief   macros for the methods of a property
 *
 * As VTK's macros they go by the member of the same name, but one stands for the setter, the getter and what goes with
 * them, so that a property is a comment and a line.
 */

#ifndef vtkHorizonProperty_h
#define vtkHorizonProperty_h

#include "vtkSetGet.h" // for VTK's macros

/// A number: SetName(), GetName().
#define vtkHorizonNumberMacro(name, type)                                                                              \
  vtkSetMacro(name, type);                                                                                             \
  vtkGetMacro(name, type)

/// Several numbers in an array, of 2, 3, 4 or 6.
#define vtkHorizonVectorMacro(name, type, size)                                                                        \
  vtkSetVector##size##Macro(name, type);                                                                               \
  vtkGetVector##size##Macro(name, type)

/// A bool: SetName(), GetName(), NameOn(), NameOff().
#define vtkHorizonFlagMacro(name)                                                                                      \
  vtkSetMacro(name, bool);                                                                                             \
  vtkGetMacro(name, bool);                                                                                             \
  vtkBooleanMacro(name, bool)

/// A text in a char*, which the destructor frees by SetName(nullptr).
#define vtkHorizonTextMacro(name)                                                                                      \
  vtkSetStringMacro(name);                                                                                             \
  vtkGetStringMacro(name)

///@{
/**
 * A choice: the enumeration `kind` of its values, from 0, which SetName() stays within, and SetNameToValue() for each.
 * The member is an int.
 */
#define vtkHorizonChoice2Macro(name, kind, a, b)                                                                       \
  vtkHorizonChoiceMacro(name, kind, a, b, a, b);                                                                       \
  vtkHorizonSetToMacro(name, a);                                                                                       \
  vtkHorizonSetToMacro(name, b)

#define vtkHorizonChoice3Macro(name, kind, a, b, c)                                                                    \
  vtkHorizonChoiceMacro(name, kind, a, c, a, b, c);                                                                    \
  vtkHorizonSetToMacro(name, a);                                                                                       \
  vtkHorizonSetToMacro(name, b);                                                                                       \
  vtkHorizonSetToMacro(name, c)

#define vtkHorizonChoice4Macro(name, kind, a, b, c, d)                                                                 \
  vtkHorizonChoiceMacro(name, kind, a, d, a, b, c, d);                                                                 \
  vtkHorizonSetToMacro(name, a);                                                                                       \
  vtkHorizonSetToMacro(name, b);                                                                                       \
  vtkHorizonSetToMacro(name, c);                                                                                       \
  vtkHorizonSetToMacro(name, d)

#define vtkHorizonChoice5Macro(name, kind, a, b, c, d, e)                                                              \
  vtkHorizonChoiceMacro(name, kind, a, e, a, b, c, d, e);                                                              \
  vtkHorizonSetToMacro(name, a);                                                                                       \
  vtkHorizonSetToMacro(name, b);                                                                                       \
  vtkHorizonSetToMacro(name, c);                                                                                       \
  vtkHorizonSetToMacro(name, d);                                                                                       \
  vtkHorizonSetToMacro(name, e)

#define vtkHorizonSetToMacro(name, value)                                                                              \
  void Set##name##To##value()                                                                                          \
  {                                                                                                                    \
    this->Set##name(value);                                                                                            \
  }

// The enumeration comes last: VTK's wrappers give the comment to what comes first.
#define vtkHorizonChoiceMacro(name, kind, first, last, ...)                                                            \
  vtkSetClampMacro(name, int, first, last);                                                                            \
  vtkGetMacro(name, int);                                                                                              \
  enum kind                                                                                                            \
  {                                                                                                                    \
    __VA_ARGS__                                                                                                        \
  }
///@}

#endif
