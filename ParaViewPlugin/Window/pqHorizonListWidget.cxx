// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqHorizonListWidget.h"

#include <QCollator>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <limits>
#include <map>
#include <pqCoreUtilities.h>
#include <string>
#include <vector>
#include <vtkCommand.h>
#include <vtkPVXMLElement.h>
#include <vtkSMArraySelectionDomain.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMStringVectorProperty.h>

namespace
{
constexpr int NameColumn = 0;
constexpr int SizeColumn = 1;
constexpr int RowsShown = 7;

/// Horizon 2 sorts before Horizon 10.
class Item : public QTreeWidgetItem
{
public:
  using QTreeWidgetItem::QTreeWidgetItem;

  bool operator<(const QTreeWidgetItem& other) const override
  {
    const int column = this->treeWidget()->sortColumn();
    if (column != NameColumn)
    {
      return this->data(column, Qt::DisplayRole).toLongLong() < other.data(column, Qt::DisplayRole).toLongLong();
    }
    QCollator collator;
    collator.setNumericMode(true);
    return collator.compare(this->text(NameColumn), other.text(NameColumn)) < 0;
  }
};

bool IsChecked(const QTreeWidgetItem* item)
{
  return item->checkState(NameColumn) == Qt::Checked;
}

void SetChecked(QTreeWidgetItem* item, bool isChecked)
{
  item->setCheckState(NameColumn, isChecked ? Qt::Checked : Qt::Unchecked);
}

qlonglong SizeOf(const QTreeWidgetItem* item)
{
  return item->data(SizeColumn, Qt::DisplayRole).toLongLong();
}

vtkPVXMLElement* FindHint(vtkSMProperty* property)
{
  vtkPVXMLElement* const hints = property->GetHints();
  return hints ? hints->FindNestedElementByName("HorizonList") : nullptr;
}

QTreeWidget* MakeTree(QWidget* parent, const QString& header)
{
  auto* const tree = new QTreeWidget(parent);
  tree->setObjectName("Horizons");
  tree->setColumnCount(2);
  tree->setHeaderLabels({ QObject::tr("Horizon"), header });
  tree->setRootIsDecorated(false);
  tree->setUniformRowHeights(true);
  tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
  // The file order applies until the user sorts; sizes then start with the largest.
  tree->header()->setSectionsClickable(true);
  QObject::connect(tree->header(), &QHeaderView::sectionClicked, tree,
    [tree](int column)
    {
      if (!tree->isSortingEnabled())
      {
        tree->header()->setSortIndicator(column, column == SizeColumn ? Qt::DescendingOrder : Qt::AscendingOrder);
        tree->setSortingEnabled(true);
      }
    });
  tree->header()->setStretchLastSection(false);
  tree->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
  tree->header()->setSectionResizeMode(SizeColumn, QHeaderView::ResizeToContents);
  tree->setFixedHeight(tree->fontMetrics().height() * (RowsShown + 2));
  return tree;
}
}

//------------------------------------------------------------------------------
pqHorizonListWidget::pqHorizonListWidget(vtkSMProxy* smproxy, vtkSMProperty* smproperty, QWidget* parentObject)
  : Superclass(smproxy, parentObject)
{
  vtkPVXMLElement* const hint = FindHint(smproperty);
  const QString header = hint ? hint->GetAttributeOrDefault("header", "Points") : "Points";
  this->SizesName = hint ? hint->GetAttributeOrEmpty("sizes") : "";
  this->setShowLabel(false);
  this->setProperty(smproperty);

  auto* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Search = new QLineEdit(this);
  this->Search->setObjectName("Search");
  this->Search->setPlaceholderText(tr("Search by name"));
  this->Search->setClearButtonEnabled(true);
  this->Tree = MakeTree(this, header);
  auto* const bar = new QWidget(this);
  bar->setObjectName("Buttons");
  this->makeButtons(bar, header.toLower());
  this->Summary = new QLabel(this);
  this->Summary->setObjectName("Summary");
  for (QWidget* const part : { static_cast<QWidget*>(this->Search), static_cast<QWidget*>(this->Tree), bar,
         static_cast<QWidget*>(this->Summary) })
  {
    layout->addWidget(part);
  }

  this->connect(this->Tree, SIGNAL(itemChanged(QTreeWidgetItem*, int)), SLOT(itemChanged(QTreeWidgetItem*, int)));
  this->connect(this->Search, SIGNAL(textChanged(const QString&)), SLOT(search(const QString&)));
  if (auto* const domain = smproperty->FindDomain<vtkSMArraySelectionDomain>())
  {
    pqCoreUtilities::connect(domain, vtkCommand::DomainModifiedEvent, this, SLOT(updateList()));
  }
  pqCoreUtilities::connect(smproperty, vtkCommand::ModifiedEvent, this, SLOT(updateChecks()));
  this->updateList();
}

//------------------------------------------------------------------------------
pqHorizonListWidget::~pqHorizonListWidget() = default;

//------------------------------------------------------------------------------
void pqHorizonListWidget::makeButtons(QWidget* bar, const QString& header)
{
  auto* const layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  const auto addButton = [&](const char* name, const QString& text, const QString& help)
  {
    auto* const button = new QToolButton(bar);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(help);
    layout->addWidget(button);
    return button;
  };
  QToolButton* const all = addButton("All", tr("All"), tr("Check all horizons that are shown"));
  QToolButton* const none = addButton("None", tr("None"), tr("Check no horizon of those that are shown"));
  this->AtLeast = addButton(
    "AtLeast", tr("At least"), tr("Check the horizons that have at least so many %1, and no others").arg(header));
  this->SmallestSize = new QSpinBox(bar);
  this->SmallestSize->setObjectName("SmallestSize");
  this->SmallestSize->setRange(1, std::numeric_limits<int>::max());
  this->SmallestSize->setValue(1000);
  this->SmallestSize->setMinimumWidth(this->fontMetrics().averageCharWidth() * 8);
  layout->addWidget(this->SmallestSize);

  this->connect(all, &QToolButton::clicked, this, [this]() { this->check([](const auto*) { return true; }); });
  this->connect(none, &QToolButton::clicked, this, [this]() { this->check([](const auto*) { return false; }); });
  this->connect(this->AtLeast, &QToolButton::clicked, this,
    [this]()
    {
      const int smallest = this->SmallestSize->value();
      this->check([smallest](const QTreeWidgetItem* item) { return SizeOf(item) >= smallest; });
    });
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::updateList()
{
  auto* const domain = this->property()->FindDomain<vtkSMArraySelectionDomain>();
  vtkSMProperty* const information = this->proxy()->GetProperty(this->SizesName.toUtf8().data());
  std::vector<vtkIdType> sizes;
  if (information)
  {
    this->proxy()->UpdatePropertyInformation(information);
    sizes = vtkSMPropertyHelper(information).GetIdTypeArray();
  }
  const unsigned int count = domain ? domain->GetNumberOfStrings() : 0;
  const bool areKnown = count > 0 && sizes.size() == count;
  {
    const QSignalBlocker blocker(this->Tree);
    this->Tree->clear();
    QList<QTreeWidgetItem*> items;
    for (unsigned int n = 0; n < count; ++n)
    {
      auto* const item = new Item({ domain->GetString(n) });
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
      SetChecked(item, true);
      if (areKnown)
      {
        item->setData(SizeColumn, Qt::DisplayRole, static_cast<qlonglong>(sizes[n]));
        item->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
      }
      items.append(item);
    }
    this->Tree->addTopLevelItems(items);
    this->Tree->setColumnHidden(SizeColumn, !areKnown);
  }
  this->AtLeast->setVisible(areKnown);
  this->SmallestSize->setVisible(areKnown);
  this->updateChecks();
  this->search(this->Search->text());
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::updateChecks()
{
  const std::vector<std::string>& elements = vtkSMStringVectorProperty::SafeDownCast(this->property())->GetElements();
  std::map<std::string, bool> chosen;
  for (std::size_t n = 0; n + 1 < elements.size(); n += 2)
  {
    chosen[elements[n]] = elements[n + 1] != "0";
  }
  const QSignalBlocker blocker(this->Tree);
  for (int row = 0; row < this->Tree->topLevelItemCount(); ++row)
  {
    QTreeWidgetItem* const item = this->Tree->topLevelItem(row);
    const auto found = chosen.find(item->text(NameColumn).toStdString());
    SetChecked(item, found == chosen.end() || found->second);
  }
  this->summarize();
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::apply()
{
  std::vector<std::string> elements;
  for (int row = 0; row < this->Tree->topLevelItemCount(); ++row)
  {
    const QTreeWidgetItem* const item = this->Tree->topLevelItem(row);
    elements.push_back(item->text(NameColumn).toStdString());
    elements.emplace_back(IsChecked(item) ? "1" : "0");
  }
  vtkSMStringVectorProperty::SafeDownCast(this->property())->SetElements(elements);
  this->Superclass::apply();
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::reset()
{
  this->updateChecks();
  this->Superclass::reset();
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::itemChanged(QTreeWidgetItem* item, int)
{
  if (item->isSelected())
  {
    const QSignalBlocker blocker(this->Tree);
    for (QTreeWidgetItem* const other : this->Tree->selectedItems())
    {
      SetChecked(other, IsChecked(item));
    }
  }
  this->finishChange();
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::search(const QString& text)
{
  for (int row = 0; row < this->Tree->topLevelItemCount(); ++row)
  {
    QTreeWidgetItem* const item = this->Tree->topLevelItem(row);
    item->setHidden(!item->text(NameColumn).contains(text, Qt::CaseInsensitive));
  }
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::check(const std::function<bool(const QTreeWidgetItem*)>& isChosen)
{
  {
    const QSignalBlocker blocker(this->Tree);
    for (int row = 0; row < this->Tree->topLevelItemCount(); ++row)
    {
      QTreeWidgetItem* const item = this->Tree->topLevelItem(row);
      if (!item->isHidden())
      {
        SetChecked(item, isChosen(item));
      }
    }
  }
  this->Tree->viewport()->update(); // The signals that would update are blocked.
  this->finishChange();
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::summarize()
{
  int checked = 0;
  qlonglong size = 0;
  for (int row = 0; row < this->Tree->topLevelItemCount(); ++row)
  {
    const QTreeWidgetItem* const item = this->Tree->topLevelItem(row);
    checked += IsChecked(item) ? 1 : 0;
    size += IsChecked(item) ? SizeOf(item) : 0;
  }
  QString text = tr("%1 of %2").arg(checked).arg(this->Tree->topLevelItemCount());
  if (!this->Tree->isColumnHidden(SizeColumn))
  {
    const QString header = this->Tree->headerItem()->text(SizeColumn).toLower();
    text += tr(", %1 %2").arg(QLocale(QLocale::English).toString(size), header);
  }
  this->Summary->setText(text);
}

//------------------------------------------------------------------------------
void pqHorizonListWidget::finishChange()
{
  this->summarize();
  Q_EMIT this->changeAvailable();
  Q_EMIT this->changeFinished();
}
