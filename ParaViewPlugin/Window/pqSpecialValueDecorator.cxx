// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqSpecialValueDecorator.h"

#include "pqPropertyWidget.h"
#include "vtkPVXMLElement.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStringList>

#include <algorithm>

//------------------------------------------------------------------------------
pqSpecialValueDecorator::pqSpecialValueDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : Superclass(xml, parent)
  , Fields(parent->findChildren<QLineEdit*>())
{
  for (const QString& value : QString(xml->GetAttributeOrEmpty("value")).split(' '))
  {
    this->Values.append(value.toDouble());
  }
  if (this->Fields.size() != this->Values.size())
  {
    return;
  }
  QLineEdit* const last = this->Fields.last();
  this->Text = new QLabel(xml->GetAttributeOrEmpty("text"), last);
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
  this->showText();
}

//------------------------------------------------------------------------------
pqSpecialValueDecorator::~pqSpecialValueDecorator() = default;

//------------------------------------------------------------------------------
void pqSpecialValueDecorator::showText()
{
  this->Text->setVisible(std::equal(this->Fields.begin(), this->Fields.end(), this->Values.begin(),
    [](QLineEdit* field, double value)
    {
      bool isNumber = false;
      return field->text().toDouble(&isNumber) == value && isNumber;
    }));
}
