// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqHorizonToolBar
 * @brief   sets the vertical exaggeration of a view, the meaning of its axes, its first camera, and what is hidden
 *
 * See Display/ViewAxes.h. The factor also applies to data shown later.
 */

#ifndef pqHorizonToolBar_h
#define pqHorizonToolBar_h

#include <QSet>
#include <QToolBar>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <algorithm>
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
    pqView* View;
    vtkSmartPointer<vtkSMProxy> Representation;
    std::vector<vtkSmartPointer<vtkSMProxy>> Inputs; // that were shown
    std::vector<vtkSmartPointer<vtkSMProxy>> ShownAgain; // inputs, as the stage made nothing
  };

  void take(pqView* view, vtkSMProxy* representation);
  void refresh(pqView* view);
  void arrange(pqView* view);
  void showHidden(vtkSMProxy* representation);

  template <typename Predicate>
  void forget(Predicate&& isForgotten)
  {
    this->Added.erase(std::remove_if(this->Added.begin(), this->Added.end(), isForgotten), this->Added.end());
  }

  void showFactor();
  void setFactor(double factor);

  QComboBox* Factor;
  QAction* Axes;
  QSet<pqView*> Updated; // views whose colour ranges may be outdated
  std::vector<std::pair<vtkWeakPointer<vtkSMProxy>, vtkWeakPointer<vtkSMProxy>>> Hidden; // by a result
  std::vector<AddedRepresentation> Added; // in their order, until they are rendered and have points
};

#endif
