// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqStageAbort
 * @brief   lets the button beside the progress bar, and the Escape key, stop a stage
 *
 * ParaView 5.11 never enables this button, and processes no events while a filter runs. While a stage of this plugin
 * runs in the process of the window, this class enables the button, and processes its events at each progress report.
 * Timers and connections wait, and other input is dropped, as ParaView does while it shows progress.
 *
 * A stopped stage has an empty output. Apply is enabled and runs it again.
 */

#ifndef pqStageAbort_h
#define pqStageAbort_h

#include <QElapsedTimer>
#include <QHash>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QSet>

class pqDataRepresentation;
class pqPipelineSource;
class pqProgressManager;
class pqProxy;
class vtkAlgorithm;
class vtkObject;

class pqStageAbort : public QObject
{
  Q_OBJECT
  using Superclass = QObject;

public:
  explicit pqStageAbort(QObject* parent = nullptr);
  ~pqStageAbort() override;

  void startup();
  void shutdown() {}

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void forget(pqPipelineSource* source);
  void begin(vtkObject* stage);
  void progress(vtkObject* stage);
  void end(vtkObject* stage);
  void abort();
  void allowApply();
  void apply(pqProxy* proxy);

private:
  bool eventFilter(QObject* receiver, QEvent* event) override;
  bool isOnButton(QObject* receiver, QEvent* event) const;
  void listen();
  /// Shows the inputs of a stopped stage in its place until it has run.
  void showInputs(pqPipelineSource* source, vtkObject* stage);
  void hideInputs(vtkObject* stage);

  pqProgressManager* Manager = nullptr;
  QPointer<QWidget> Button;
  vtkAlgorithm* Running = nullptr;
  vtkAlgorithm* Stopping = nullptr; // Set until everything that requested the stage has ended.
  QHash<vtkObject*, pqPipelineSource*> Sources;
  QSet<vtkObject*> Stopped;
  QHash<vtkObject*, QList<QPointer<pqDataRepresentation>>> Shown; // inputs in place of stopped stages
  QElapsedTimer SinceListened;
  bool IsShowingProgress = false;
  bool IsListening = false;
};

#endif
