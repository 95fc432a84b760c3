// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqHorizonToolBar
 * @brief   how a view shows horizons: by how much heights are exaggerated, and what its axes count
 *
 * Display/VerticalExaggeration.h and Display/SurveyAxes.h have what it does to the view. What is shown in the view
 * later gets its factor, too.
 */

#ifndef pqHorizonToolBar_h
#define pqHorizonToolBar_h

#include <QSet>
#include <QToolBar>

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
  /// Watches what comes into a view.
  void watch(pqView* view);
  /// Shows the factor of the active view, and whether its axes count lines.
  void showState();
  void showAxes(bool areShown);

private:
  /// Shows in a view what has come into it as it looks best there.
  void take(pqView* view, vtkSMProxy* representation);
  /// Suits a view to data that have changed.
  void refresh(pqView* view);
  void showFactor();
  void setFactor(double factor);
  /// Says why there are no axes that count lines.
  void refuseAxes(const QString& reason);

  QComboBox* Factor;
  QAction* Axes;
  QSet<pqView*> Updated; // whose colours may not suit the data any more
};

#endif
