// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqStageAbort
 * @brief   makes the button beside the progress bar stop a stage, and the Escape key as well
 *
 * ParaView 5.11 has this button, but never enables it, and looks at no event until a filter has ended. While a stage of
 * this plugin runs in the process of the window, this class enables it, and whenever the stage tells its progress looks
 * at what has happened to the button. Timers and connections have to wait, and what else is pressed or typed is
 * dropped, as ParaView itself does while it shows progress.
 *
 * A stage that was stopped has an empty output. Apply is enabled again, and runs it once more.
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

  /// Called when the plugin has been loaded.
  void startup();
  void shutdown() {}

private Q_SLOTS:
  /// Watches a source, if it is a stage that runs in this process.
  void watch(pqPipelineSource* source);
  void forget(pqPipelineSource* source);
  void begin(vtkObject* stage);
  void progress(vtkObject* stage);
  void end(vtkObject* stage);
  /// Stops the stage that runs.
  void abort();
  /// Enables Apply for a stage that was stopped.
  void allowApply();
  /// Lets a stage that was stopped run again.
  void apply(pqProxy* proxy);

private:
  bool eventFilter(QObject* receiver, QEvent* event) override;
  bool isOnButton(QObject* receiver, QEvent* event) const;
  void listen();
  /// Shows the inputs of a stage that was stopped where the stage is shown, until it has run.
  void showInputs(pqPipelineSource* source, vtkObject* stage);
  void hideInputs(vtkObject* stage);

  pqProgressManager* Manager = nullptr;
  QPointer<QWidget> Button;
  vtkAlgorithm* Running = nullptr;
  vtkAlgorithm* Stopping = nullptr; // until all that asked it to run has ended
  QHash<vtkObject*, pqPipelineSource*> Sources; // of the stages that are watched
  QSet<vtkObject*> Stopped; // stages, until they run again
  QHash<vtkObject*, QList<QPointer<pqDataRepresentation>>> Shown; // inputs in place of what stages have not made
  QElapsedTimer SinceListened;
  bool IsShowingProgress = false;
  bool IsListening = false;
};

#endif
