// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqSpecialValueDecorator
 * @brief   shows in a field what its number means: "automatic" for 0, or 0.38 ms for 0.75 vertical indices
 *
 * @code{.xml}
 * <PropertyWidgetDecorator type="HorizonSpecialValue" value="0" text="automatic" unit="ErrorUnit"/>
 * @endcode
 *
 * The text is at the right of the last field of a property while its fields have the value, one number per field. Other
 * heights are in vertical indices where the property `unit` is 0, in the unit of z where it is 1: the text is the same
 * height in the other unit, by the lattice of the input.
 */

#ifndef pqSpecialValueDecorator_h
#define pqSpecialValueDecorator_h

#include "pqPropertyWidgetDecorator.h"

#include <QByteArray>
#include <QList>
#include <QString>

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
  void followSource();

private:
  Q_DISABLE_COPY(pqSpecialValueDecorator)

  void followInput();
  QString convert(double height) const;

  QList<QLineEdit*> Fields;
  QList<double> Values;
  QString Special;
  QByteArray Unit; ///< A property, or empty.
  QLabel* Text = nullptr;
};

#endif
