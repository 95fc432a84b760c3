// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqSpecialValueDecorator.h"

#include "ShownAxis.h"

#include "pqPropertyWidget.h"
#include "vtkPVXMLElement.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStringList>
#include <pqCoreUtilities.h>
#include <vtkCommand.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMUncheckedPropertyHelper.h>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
pqSpecialValueDecorator::pqSpecialValueDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
  , Fields(parent->findChildren<QLineEdit*>())
  , Special(xml->GetAttributeOrEmpty("text"))
  , Unit(xml->GetAttributeOrEmpty("unit"))
{
  for (const QString& value : QString(xml->GetAttributeOrEmpty("value")).split(' ', Qt::SkipEmptyParts))
  {
    this->Values.append(value.toDouble());
  }
  if (this->Fields.isEmpty() || (!this->Values.isEmpty() && this->Fields.size() != this->Values.size()))
  {
    return;
  }
  QLineEdit* const last = this->Fields.last();
  this->Text = new QLabel(last);
  this->Text->setObjectName("SpecialValue");
  this->Text->setEnabled(false);
  this->Text->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* const layout = new QHBoxLayout(last);
  layout->setContentsMargins(0, 0, 6, 0);
  layout->addStretch();
  layout->addWidget(this->Text);
  for (QLineEdit* const field : this->Fields)
  {
    this->connect(field, SIGNAL(textChanged(QString)), SLOT(showText()));
  }
  this->followInput();
  this->showText();
}

//------------------------------------------------------------------------------
pqSpecialValueDecorator::~pqSpecialValueDecorator() = default;

//------------------------------------------------------------------------------
void pqSpecialValueDecorator::followInput()
{
  vtkSMProxy* const proxy = this->parentWidget()->proxy();
  vtkSMProperty* const unit = proxy->GetProperty(this->Unit.constData());
  vtkSMProperty* const input = proxy->GetProperty("Input");
  if (unit && input)
  {
    pqCoreUtilities::connect(unit, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(showText()));
    pqCoreUtilities::connect(unit, vtkCommand::ModifiedEvent, this, SLOT(showText()));
    pqCoreUtilities::connect(input, vtkCommand::ModifiedEvent, this, SLOT(followSource()));
    this->followSource();
  }
}

//------------------------------------------------------------------------------
void pqSpecialValueDecorator::followSource()
{
  if (vtkSMProxy* const source = vtkSMPropertyHelper(this->parentWidget()->proxy(), "Input", true).GetAsProxy())
  {
    pqCoreUtilities::connect(source, vtkCommand::UpdateDataEvent, this, SLOT(showText()));
  }
  this->showText();
}

//------------------------------------------------------------------------------
QString pqSpecialValueDecorator::convert(double height) const
{
  vtkSMProxy* const proxy = this->parentWidget()->proxy();
  vtkSMProperty* const unit = proxy->GetProperty(this->Unit.constData());
  const vtkSMPropertyHelper input(proxy, "Input", true);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!unit || !source)
  {
    return QString();
  }
  const SeismicHorizons::VerticalAxis axis =
    SeismicHorizons::ReadVerticalAxis(source->GetDataInformation(input.GetOutputPort()));
  const int chosen = vtkSMUncheckedPropertyHelper(unit).GetAsInt();
  if (axis.Step == 0.0 || (axis.Step == 1.0 && axis.Unit.empty()) || chosen > 1)
  {
    return QString();
  }
  const double other = chosen == 1 ? height / axis.Step : height * axis.Step;
  const QString number =
    QString::number(other, std::fabs(other) < 1000.0 ? 'g' : 'f', std::fabs(other) < 1000.0 ? 3 : 0);
  return "= " + number + " " + (chosen == 1 ? QString("steps") : QString::fromStdString(axis.Unit));
}

//------------------------------------------------------------------------------
void pqSpecialValueDecorator::showText()
{
  bool isNumber = false;
  const double last = this->Fields.last()->text().toDouble(&isNumber);
  const bool isSpecial = !this->Values.isEmpty() &&
    std::equal(this->Fields.begin(), this->Fields.end(), this->Values.begin(),
      [](QLineEdit* field, double value)
      {
        bool isOne = false;
        return field->text().toDouble(&isOne) == value && isOne;
      });
  this->Text->setText(isSpecial ? this->Special : isNumber ? this->convert(last) : QString());
  this->Text->setVisible(!this->Text->text().isEmpty());
}
