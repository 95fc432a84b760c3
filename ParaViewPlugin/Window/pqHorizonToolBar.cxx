// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqHorizonToolBar.h"

#include "ColorRange.h"
#include "ContourInterval.h"
#include "FirstView.h"
#include "StageSelection.h"
#include "ViewAxes.h"
#include "ViewContents.h"
#include "vtkSMHorizonDisplayHelper.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleValidator>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMessageBox>
#include <QTimer>
#include <pqActiveObjects.h>
#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>
#include <vtkNew.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMParaViewPipelineControllerWithRendering.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMViewProxy.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr double Largest = 1e6;

/// Sources that a stage is made from directly, where they are shown.
std::vector<vtkSmartPointer<vtkSMProxy>> ListShownInputs(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkSMSourceProxy* const producer = FindProducer(representation);
  std::vector<vtkSmartPointer<vtkSMProxy>> inputs;
  for (vtkSMProxy* const other : ListRepresentations(view))
  {
    for (unsigned int n = 0; producer && FindShownData(other) && n < producer->GetNumberOfProducers(); ++n)
    {
      if (producer->GetProducerProxy(n) == FindProducer(other))
      {
        inputs.push_back(other);
      }
    }
  }
  return inputs;
}

void SetVisibility(const std::vector<vtkSmartPointer<vtkSMProxy>>& representations, bool areShown)
{
  for (const vtkSmartPointer<vtkSMProxy>& representation : representations)
  {
    vtkSMPropertyHelper(representation, "Visibility").Set(areShown ? 1 : 0);
    representation->UpdateVTKObjects();
  }
}

/// Whether no output of the source has points, as after an error.
bool ShowsNothing(vtkSMProxy* view, vtkSMProxy* representation)
{
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  return std::all_of(all.begin(), all.end(),
    [representation](vtkSMProxy* other)
    {
      vtkPVDataInformation* const data = FindShownData(other);
      return !data || FindProducer(other) != FindProducer(representation) || data->GetNumberOfPoints() == 0;
    });
}

// ---- The tool bar ---------------------------------------------------------------------------------------------------

pqRenderView* ActiveView()
{
  return qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
}
}

//------------------------------------------------------------------------------
pqHorizonToolBar::pqHorizonToolBar(QWidget* parentObject)
  : Superclass(tr("Horizon View"), parentObject)
{
  this->setObjectName("HorizonToolBar");
  this->addWidget(new QLabel(tr("Heights x "), this));
  this->Factor = new QComboBox(this);
  this->Factor->setObjectName("VerticalExaggeration");
  this->Factor->setToolTip(tr("Vertical exaggeration: how many times larger heights are drawn in the active view. "
                              "Data and figures stay as they are."));
  this->Factor->setEditable(true);
  this->Factor->setInsertPolicy(QComboBox::NoInsert);
  this->Factor->addItems({ "1", "2", "5", "10", "20", "50", "100" });
  auto* const validator = new QDoubleValidator(1.0 / Largest, Largest, 6, this->Factor);
  validator->setLocale(QLocale::c());
  this->Factor->setValidator(validator);
  this->addWidget(this->Factor);
  QAction* const fit = this->addAction(tr("Fit Heights"));
  fit->setObjectName("FitHeights");
  fit->setToolTip(tr("Exaggerate heights so that what is shown is about a quarter as high as it is wide; not where it "
                     "is not flat."));
  this->Axes = this->addAction(tr("Survey Axes"));
  this->Axes->setObjectName("SurveyAxes");
  this->Axes->setCheckable(true);
  this->Axes->setToolTip(
    tr("Axes that count inlines and crosslines, or columns and rows where their numbers are not known."));

  const auto setText = [this]() { this->setFactor(this->Factor->currentText().toDouble()); };
  this->connect(this->Factor, QOverload<int>::of(&QComboBox::activated), this, setText);
  this->connect(this->Factor, QOverload<int>::of(&QComboBox::currentIndexChanged), this, setText);
  this->connect(this->Factor->lineEdit(), &QLineEdit::editingFinished, this, setText);
  this->connect(fit, &QAction::triggered, this,
    [this]()
    {
      if (pqView* const view = ActiveView())
      {
        this->setFactor(SuggestVerticalExaggeration(view->getProxy()));
      }
    });

  this->connect(this->Axes, SIGNAL(triggered(bool)), SLOT(showAxes(bool)));

  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, SIGNAL(viewAdded(pqView*)), SLOT(watch(pqView*)));
  KeepSelection(model);
  this->connect(&pqActiveObjects::instance(), SIGNAL(viewChanged(pqView*)), SLOT(showState()));
  for (pqView* const view : model->findItems<pqView*>())
  {
    this->watch(view);
  }
  this->showState();

  // ParaView adds toolbars of plugins to the row of filters, which is full.
  QTimer::singleShot(0, this,
    [this]()
    {
      if (auto* const window = qobject_cast<QMainWindow*>(this->window()))
      {
        window->addToolBar(Qt::TopToolBarArea, this);
      }
    });
}

//------------------------------------------------------------------------------
pqHorizonToolBar::~pqHorizonToolBar() = default;

//------------------------------------------------------------------------------
void pqHorizonToolBar::watch(pqView* view)
{
  if (!qobject_cast<pqRenderView*>(view))
  {
    return; // Tables have no directions.
  }
  this->connect(view, &QObject::destroyed, this,
    [this, view]()
    {
      this->Updated.remove(view);
      this->forget([view](const AddedRepresentation& added) { return added.View == view; });
    });
  this->connect(view, &pqView::representationAdded, this,
    [this, view](pqRepresentation* representation) { this->take(view, representation->getProxy()); });
  this->connect(view, &pqView::representationRemoved, this,
    [this, view](pqRepresentation* representation)
    {
      this->forget([representation](const AddedRepresentation& added)
        { return added.Representation == representation->getProxy(); });
      this->showHidden(representation->getProxy());
      if (!ShowsOthers(view->getProxy(), nullptr) && GetVerticalExaggeration(view->getProxy()) != 1.0)
      {
        SetVerticalExaggeration(view->getProxy(), 1.0);
      }
      this->Updated.insert(view);
    });
  this->connect(view, &pqView::updateDataEvent, this,
    [this, view]()
    {
      RefreshSurveyAxes(view->getProxy());
      this->Updated.insert(view);
    });
  // Runs after ParaView has set its ranges.
  this->connect(view, &pqView::beginRender, this,
    [this, view]()
    {
      if (this->Updated.remove(view))
      {
        this->refresh(view);
      }
      const std::vector<vtkSMProxy*> all = ListRepresentations(view->getProxy());
      std::for_each(all.begin(), all.end(), vtkSMHorizonDisplayHelper::ColorSeparately);
    });
  // Scripts, state files and undo may change the view.
  this->connect(view, SIGNAL(endRender()), SLOT(showState()));
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::take(pqView* view, vtkSMProxy* representation)
{
  const bool isFirst = IsFirst(view->getProxy(), representation);
  if (isFirst || MayFollow(view->getProxy(), representation))
  {
    // Runs after ParaView, which looks along an axis at flat data.
    const vtkSmartPointer<vtkSMProxy> shown = representation;
    QTimer::singleShot(0, view,
      [view, shown, isFirst]()
      {
        if (!isFirst || SetFirstView(view->getProxy(), shown))
        {
          view->resetDisplay(true);
        }
        MarkCamera(view->getProxy());
      });
  }
  this->Added.push_back({ view, representation, ListShownInputs(view->getProxy(), representation), {} });
  this->Updated.insert(view);
  ExaggerateRepresentation(representation, view->getProxy());
}

//------------------------------------------------------------------------------
// By Undo or Delete what a result has hidden comes back.
void pqHorizonToolBar::showHidden(vtkSMProxy* representation)
{
  std::vector<vtkSmartPointer<vtkSMProxy>> shown;
  const auto isOf = [&](const std::pair<vtkWeakPointer<vtkSMProxy>, vtkWeakPointer<vtkSMProxy>>& entry)
  {
    const bool isOwn = entry.first == representation || !entry.first;
    if (isOwn && entry.second)
    {
      shown.emplace_back(entry.second);
    }
    return isOwn;
  };
  this->Hidden.erase(std::remove_if(this->Hidden.begin(), this->Hidden.end(), isOf), this->Hidden.end());
  SetVisibility(shown, true);
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::refresh(pqView* view)
{
  for (vtkSMProxy* const representation : ListRepresentations(view->getProxy()))
  {
    auto* const shown = vtkSMPVRepresentationProxy::SafeDownCast(representation);
    if (shown && FindShownData(shown) && vtkSMHorizonDisplayHelper::ShowLate(shown))
    {
      shown->SetScalarBarVisibility(view->getProxy(), true);
      this->take(view, shown);
    }
  }
  this->arrange(view);
  RefreshRanges(view->getProxy());
  DescribeContours(view->getProxy());
  NameVerticalAxis(view->getProxy());
}

//------------------------------------------------------------------------------
// Runs after ParaView has checked what else is shown: it resets the camera where that is nothing.
void pqHorizonToolBar::arrange(pqView* view)
{
  std::vector<AddedRepresentation> left; // of other views, or whose stages have made nothing
  for (AddedRepresentation& added : std::exchange(this->Added, {}))
  {
    if (added.View != view)
    {
      left.push_back(added);
    }
    else if (!FindShownData(added.Representation))
    {
      continue; // It has been hidden since.
    }
    else if (!ShowsNothing(view->getProxy(), added.Representation))
    {
      for (vtkSMProxy* const hidden : HideOthers(view->getProxy(), added.Representation))
      {
        this->Hidden.emplace_back(added.Representation.Get(), hidden);
      }
      SelectShown(view->getProxy(), added.Representation);
      SetVisibility(added.ShownAgain, false);
    }
    else
    {
      SetVisibility(added.Inputs, true); // ParaView has hidden them.
      added.ShownAgain.insert(added.ShownAgain.end(), added.Inputs.begin(), added.Inputs.end());
      added.Inputs.clear();
      left.push_back(added);
    }
  }
  this->Added.swap(left);
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::showState()
{
  pqView* const view = ActiveView();
  this->setEnabled(view != nullptr);
  this->Axes->setChecked(view && HasSurveyAxes(view->getProxy()));
  if (!this->Factor->lineEdit()->hasFocus()) // Otherwise the user is typing.
  {
    this->showFactor();
  }
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::showFactor()
{
  pqView* const view = ActiveView();
  this->Factor->setEditText(QString::number(view ? GetVerticalExaggeration(view->getProxy()) : 1.0));
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::setFactor(double factor)
{
  pqView* const view = ActiveView();
  if (view && factor > 0.0 && factor != GetVerticalExaggeration(view->getProxy()))
  {
    SCOPED_UNDO_SET(tr("Vertical Exaggeration"));
    SetVerticalExaggeration(view->getProxy(), factor);
    RefreshSurveyAxes(view->getProxy());
    view->resetDisplay();
    view->render();
  }
  this->showFactor();
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::showAxes(bool areShown)
{
  if (pqView* const view = ActiveView())
  {
    SCOPED_UNDO_SET(tr("Survey Axes"));
    if (!areShown)
    {
      HideSurveyAxes(view->getProxy());
    }
    else if (const std::string reason = ShowSurveyAxes(view->getProxy()); !reason.empty())
    {
      auto* const message = new QMessageBox(QMessageBox::Information, tr("Survey Axes"),
        tr("No survey axes: %1.").arg(QString::fromStdString(reason)), QMessageBox::Ok, this->window());
      message->setObjectName("SurveyAxesMessage");
      message->setAttribute(Qt::WA_DeleteOnClose);
      message->open();
    }
    view->render();
  }
  this->showState();
}
