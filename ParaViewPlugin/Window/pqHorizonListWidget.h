// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqHorizonListWidget
 * @brief   a list of horizons and their sizes in the panel, to choose from
 *
 * For a property of names and their status, with panel_widget="horizon_list" and this hint:
 *
 * @code{.xml}
 * <Hints><HorizonList sizes="HorizonSizes" header="Points"/></Hints>
 * @endcode
 *
 * `sizes` is the information property with the sizes, `header` the title of their column. Sizes are hidden unless
 * their number equals the number of names.
 *
 * The list can be sorted by name and size, and searched. Buttons check all, none, or those of a size; what the search
 * has hidden stays as it is. Checking one of several selected horizons checks all of them.
 */

#ifndef pqHorizonListWidget_h
#define pqHorizonListWidget_h

#include <QString>
#include <functional>
#include <pqPropertyWidget.h>

class QLabel;
class QLineEdit;
class QToolButton;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

class pqHorizonListWidget : public pqPropertyWidget
{
  Q_OBJECT
  using Superclass = pqPropertyWidget;

public:
  pqHorizonListWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqHorizonListWidget() override;

  void apply() override;
  void reset() override;

private Q_SLOTS:
  void updateList();
  void updateChecks();
  void itemChanged(QTreeWidgetItem* item, int column);
  void search(const QString& text);

private:
  void makeButtons(QWidget* bar, const QString& header);
  void check(const std::function<bool(const QTreeWidgetItem*)>& isChosen);
  void summarize();
  void finishChange();

  QTreeWidget* Tree;
  QLineEdit* Search;
  QSpinBox* SmallestSize;
  QToolButton* AtLeast;
  QLabel* Summary;
  QString SizesName;
};

#endif
