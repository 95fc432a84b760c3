// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqStageAbort.h"

#include <QCoreApplication>
#include <QEvent>
#include <QInputEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqDataRepresentation.h>
#include <pqOutputPort.h>
#include <pqPipelineFilter.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqProgressWidget.h>
#include <pqPropertiesPanel.h>
#include <pqServerManagerModel.h>
#include <utility>
#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkSMProxy.h>

namespace
{
constexpr int ListeningInterval = 50; // ms

bool IsStage(vtkObjectBase* object)
{
  const auto bases = { "vtkHorizonStage", "vtkHorizonSource", "vtkSEGYCubeReader" };
  return object && std::any_of(bases.begin(), bases.end(), [object](const char* name) { return object->IsA(name); });
}

/// Excludes events that redraw windows.
bool IsInput(QEvent* event)
{
  const auto others = { QEvent::Shortcut, QEvent::DragEnter, QEvent::DragMove, QEvent::Drop, QEvent::Close };
  return dynamic_cast<QInputEvent*>(event) || std::find(others.begin(), others.end(), event->type()) != others.end();
}

QPoint PlaceOf(const QMouseEvent* event)
{
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  return event->globalPos();
#else
  return event->globalPosition().toPoint();
#endif
}

bool IsEscape(QEvent* event)
{
  return event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
}
}

//------------------------------------------------------------------------------
pqStageAbort::pqStageAbort(QObject* parentObject)
  : Superclass(parentObject)
{
}

//------------------------------------------------------------------------------
pqStageAbort::~pqStageAbort() = default;

//------------------------------------------------------------------------------
void pqStageAbort::startup()
{
  auto* const core = pqApplicationCore::instance();
  this->Manager = core->getProgressManager();
  this->connect(this->Manager, &pqProgressManager::enableProgress, this,
    [this](bool isShown) { this->IsShowingProgress = isShown; });
  pqServerManagerModel* const model = core->getServerManagerModel();
  this->connect(model, SIGNAL(sourceAdded(pqPipelineSource*)), SLOT(watch(pqPipelineSource*)));
  this->connect(model, SIGNAL(sourceRemoved(pqPipelineSource*)), SLOT(forget(pqPipelineSource*)));
  for (pqPipelineSource* const source : model->findItems<pqPipelineSource*>())
  {
    this->watch(source);
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::watch(pqPipelineSource* source)
{
  // A stage in another process cannot be stopped before it ends.
  auto* const stage = vtkObject::SafeDownCast(source->getProxy()->GetClientSideObject());
  if (!IsStage(stage))
  {
    return;
  }
  this->Sources[stage] = source;
  pqCoreUtilities::connect(stage, vtkCommand::StartEvent, this, SLOT(begin(vtkObject*)));
  pqCoreUtilities::connect(stage, vtkCommand::ProgressEvent, this, SLOT(progress(vtkObject*)));
  pqCoreUtilities::connect(stage, vtkCommand::EndEvent, this, SLOT(end(vtkObject*)));
  // Plugins that load automatically precede the windows.
  if (auto* const panel = pqCoreUtilities::mainWidget()->findChild<pqPropertiesPanel*>())
  {
    this->connect(panel, SIGNAL(applied(pqProxy*)), SLOT(apply(pqProxy*)), Qt::UniqueConnection);
  }
  if (auto* const progressWidget = pqCoreUtilities::mainWidget()->findChild<pqProgressWidget*>())
  {
    this->Button = progressWidget->abortButton();
    this->connect(this->Button, SIGNAL(pressed()), SLOT(abort()), Qt::UniqueConnection);
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::forget(pqPipelineSource* source)
{
  vtkObject* const stage = this->Sources.key(source);
  this->Sources.remove(stage);
  this->Stopped.remove(stage);
  this->Shown.remove(stage);
}

//------------------------------------------------------------------------------
void pqStageAbort::begin(vtkObject* stage)
{
  this->Running = vtkAlgorithm::SafeDownCast(stage);
  this->SinceListened.start();
  if (this->Stopped.remove(stage))
  {
    this->Running->SetAbortExecute(0);
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::end(vtkObject* stage)
{
  this->Running = nullptr;
  this->Manager->setEnableAbort(false);
  if (this->Stopping)
  {
    QTimer::singleShot(0, this, SLOT(allowApply()));
  }
  else if (this->Shown.contains(stage))
  {
    QTimer::singleShot(0, this, [this, stage]() { this->hideInputs(stage); });
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::allowApply()
{
  vtkAlgorithm* const stage = std::exchange(this->Stopping, nullptr);
  if (pqPipelineSource* const source = this->Sources.value(stage))
  {
    this->Stopped.insert(stage);
    source->setModifiedState(pqProxy::MODIFIED);
    this->showInputs(source, stage);
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::showInputs(pqPipelineSource* source, vtkObject* stage)
{
  const auto* const filter = qobject_cast<pqPipelineFilter*>(source);
  const QList<pqOutputPort*> inputs = filter ? filter->getAllInputs() : QList<pqOutputPort*>();
  const QList<pqDataRepresentation*> outputs = source->getRepresentations(nullptr);
  for (pqDataRepresentation* const output : outputs)
  {
    for (pqOutputPort* const input : inputs)
    {
      pqDataRepresentation* const shown = input->getRepresentation(output->getView());
      if (output->isVisible() && shown && !shown->isVisible())
      {
        shown->setVisible(true);
        shown->renderViewEventually();
        this->Shown[stage].append(shown);
      }
    }
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::hideInputs(vtkObject* stage)
{
  const QList<QPointer<pqDataRepresentation>> inputs = this->Shown.take(stage);
  for (const QPointer<pqDataRepresentation>& input : inputs)
  {
    if (input)
    {
      input->setVisible(false);
      input->renderViewEventually();
    }
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::progress(vtkObject* stage)
{
  if (stage == this->Running && this->Button && this->IsShowingProgress && !this->IsListening &&
    stage != this->Stopping && this->SinceListened.hasExpired(ListeningInterval))
  {
    this->Manager->setEnableAbort(true);
    this->listen();
    this->SinceListened.restart();
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::listen()
{
  this->IsListening = true;
  const bool wereUnblocked = this->Manager->unblockEvents(true); // The filter of Manager drops events.
  qApp->installEventFilter(this);
  QCoreApplication::processEvents(QEventLoop::ExcludeSocketNotifiers | QEventLoop::X11ExcludeTimers);
  qApp->removeEventFilter(this);
  this->Manager->unblockEvents(wereUnblocked);
  this->IsListening = false;
}

//------------------------------------------------------------------------------
bool pqStageAbort::eventFilter(QObject* receiver, QEvent* event)
{
  if (IsEscape(event))
  {
    this->abort();
  }
  // Painting would access data while the stage writes them.
  const bool drawsView = event->type() == QEvent::Paint && receiver->inherits("QOpenGLWidget");
  return drawsView || (IsInput(event) && !this->isOnButton(receiver, event));
}

//------------------------------------------------------------------------------
/// The window receives mouse events first, and forwards them.
bool pqStageAbort::isOnButton(QObject* receiver, QEvent* event) const
{
  if (receiver == this->Button)
  {
    return true;
  }
  const auto* const mouseEvent = dynamic_cast<QMouseEvent*>(event);
  return mouseEvent && receiver->isWindowType() &&
    this->Button->rect().contains(this->Button->mapFromGlobal(PlaceOf(mouseEvent)));
}

//------------------------------------------------------------------------------
void pqStageAbort::abort()
{
  if (this->Running && this->Running != this->Stopping)
  {
    this->Stopping = this->Running;
    this->Stopping->SetAbortExecuteAndUpdateTime();
    this->Manager->setEnableAbort(false);
  }
}

//------------------------------------------------------------------------------
void pqStageAbort::apply(pqProxy* proxy)
{
  auto* const stage = vtkAlgorithm::SafeDownCast(proxy->getProxy()->GetClientSideObject());
  if (this->Stopped.remove(stage))
  {
    stage->SetAbortExecute(0);
    proxy->getProxy()->MarkDirty(nullptr);
  }
}
