// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqSpecialValueDecorator
 * @brief   says in a field what a number stands for that is none: 0 for "automatic", or -1 for "the last one"
 *
 * @code{.xml}
 * <PropertyWidgetDecorator type="HorizonSpecialValue" value="0" text="automatic"/>
 * @endcode
 *
 * The text stands at the right of the last field of a property while its fields have that value, one number for each.
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
