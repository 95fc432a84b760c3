// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqSpecialValueDecorator
 * @brief   shows the meaning of a special value in a field: 0 for "automatic", or -1 for "the last one"
 *
 * @code{.xml}
 * <PropertyWidgetDecorator type="HorizonSpecialValue" value="0" text="automatic"/>
 * @endcode
 *
 * The text is at the right of the last field of a property while its fields have the value, one number per field.
 */

#ifndef pqSpecialValueDecorator_h
#define pqSpecialValueDecorator_h

#include "pqPropertyWidgetDecorator.h"

#include <QList>

class QLabel;
class QLineEdit;

class pqSpecialValueDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  using Superclass = pqPropertyWidgetDecorator;

public:
  pqSpecialValueDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);
  ~pqSpecialValueDecorator() override;

private Q_SLOTS:
  void showText();

private:
  Q_DISABLE_COPY(pqSpecialValueDecorator)

  QList<QLineEdit*> Fields;
  QList<double> Values;
  QLabel* Text = nullptr;
};

#endif
