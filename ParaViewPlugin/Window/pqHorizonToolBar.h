// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqHorizonToolBar
 * @brief   sets the vertical exaggeration of a view and the meaning of its axes
 *
 * See Display/ViewAxes.h. The factor also applies to data shown later.
 */

#ifndef pqHorizonToolBar_h
#define pqHorizonToolBar_h

#include <QMultiHash>
#include <QSet>
#include <QToolBar>
#include <vtkSmartPointer.h>

#include <vector>

class QAction;
class QComboBox;
class pqView;
class vtkSMProxy;

class pqHorizonToolBar : public QToolBar
{
  Q_OBJECT
  using Superclass = QToolBar;

public:
  explicit pqHorizonToolBar(QWidget* parent = nullptr);
  ~pqHorizonToolBar() override;

private Q_SLOTS:
  void watch(pqView* view);
  void showState();
  void showAxes(bool areShown);

private:
  struct AddedRepresentation
  {
    vtkSmartPointer<vtkSMProxy> Representation;
    std::vector<vtkSmartPointer<vtkSMProxy>> Inputs; // that were shown
  };

  void take(pqView* view, vtkSMProxy* representation);
  void refresh(pqView* view);
  void showFactor();
  void setFactor(double factor);

  QComboBox* Factor;
  QAction* Axes;
  QSet<pqView*> Updated; // views whose colour ranges may be outdated
  QMultiHash<pqView*, AddedRepresentation> Added; // since the last rendering
};

#endif
