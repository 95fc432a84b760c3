// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "pqHorizonToolBar.h"

#include "ColorRange.h"
#include "Common/Horizon/DataModel.h"
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
#include <pqRenderView.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMParaViewPipelineControllerWithRendering.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMTrace.h>
#include <vtkSMViewProxy.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace SeismicHorizons;

constexpr double Largest = 1e6;

// ---- The first view -------------------------------------------------------------------------------------------------

using ViewDirection = std::array<double, 3>;

constexpr const char* OwnCamera = "SeismicHorizons.Camera";
constexpr ViewDirection Oblique = { 0.35, -0.75, 0.56 }; // Direction to the eye.

bool IsOfSurvey(vtkPVDataInformation* data)
{
  return !ReadField(data, FieldArray::LatticeDimensions, 3).empty();
}

bool Has(vtkSMProxy* proxy, const char* property, const std::string& text)
{
  return proxy->GetProperty(property) && vtkSMPropertyHelper(proxy, property).GetAsString() == text;
}

/// Returns 0 for a line along i, 1 along j, else -1.
int FindLine(const std::vector<double>& dimensions, vtkSMProxy* representation)
{
  if (dimensions[0] == 1.0 || dimensions[1] == 1.0)
  {
    return dimensions[0] > 1.0 ? 0 : 1;
  }
  if (!Has(representation, "Representation", "Slice"))
  {
    return -1;
  }
  return Has(representation, "SliceMode", "XZ Plane") ? 0 : Has(representation, "SliceMode", "YZ Plane") ? 1 : -1;
}

/// Looks at a line from its side, at a survey from above, and at a section of a cube from between.
ViewDirection FindDirection(
  const std::vector<double>& dimensions, const std::vector<double>& toWorld, vtkSMProxy* representation)
{
  const int along = FindLine(dimensions, representation);
  const std::array<double, 2> line = along < 0
    ? std::array<double, 2>()
    : std::array<double, 2>{ toWorld[std::size_t(along)], toWorld[std::size_t(4 + along)] };
  const double length = std::hypot(line[0], line[1]);
  if (!(length > 0.0))
  {
    return Oblique;
  }
  // Looks from the south, or from the east of a line that runs north, so that it starts on the left.
  const double side = line[0] > 0.0 || (line[0] == 0.0 && line[1] > 0.0) ? 1.0 : -1.0;
  const std::array<double, 2> right = { side * line[0] / length, side * line[1] / length };
  const bool isOfCube = std::min(dimensions[0], dimensions[1]) > 1.0;
  const double turn = isOfCube ? 0.35 : 0.0;
  return { right[1] + turn * right[0], -right[0] + turn * right[1], turn };
}

std::string DescribeCamera(vtkSMProxy* view)
{
  auto* const rendered = vtkSMRenderViewProxy::SafeDownCast(view);
  vtkCamera* const camera = rendered ? rendered->GetActiveCamera() : nullptr;
  std::string text;
  for (const double* const place : camera
      ? std::vector<const double*>{ camera->GetPosition(), camera->GetFocalPoint(), camera->GetViewUp() }
      : std::vector<const double*>())
  {
    text += std::to_string(place[0]) + " " + std::to_string(place[1]) + " " + std::to_string(place[2]) + " ";
  }
  return text;
}

void LookFrom(vtkSMProxy* view, const ViewDirection& direction)
{
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", view);
  const ViewDirection focus = { 0.0, 0.0, 0.0 };
  const ViewDirection up = { 0.0, 0.0, 1.0 };
  vtkSMPropertyHelper(view, "CameraPosition").Set(direction.data(), 3);
  vtkSMPropertyHelper(view, "CameraFocalPoint").Set(focus.data(), 3);
  vtkSMPropertyHelper(view, "CameraViewUp").Set(up.data(), 3);
  view->UpdateVTKObjects();
}

/// Ignores other outputs of the same source, and maps or points that it was made from.
bool ShowsOthers(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkSMProxy* const producer = representation ? FindProducer(representation) : nullptr;
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  return std::any_of(all.begin(), all.end(),
    [representation, producer](vtkSMProxy* other)
    {
      const bool isOwn = other == representation || (producer && FindProducer(other) == producer);
      vtkPVDataInformation* const data = isOwn ? nullptr : FindShownData(other);
      // The map or the points from which a horizon was made were seen from above.
      const bool isRaw = data && producer && !IsOfSurvey(data) && LeadsTo(FindProducer(other), producer);
      return data && !isRaw;
    });
}

/// Sets the direction of the camera, which has to be moved to the data, and exaggerates flat heights. Returns false
/// unless the data have a survey.
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkPVDataInformation* const data = FindShownData(representation);
  if (!data)
  {
    return false;
  }
  const std::vector<double> dimensions = ReadField(data, FieldArray::LatticeDimensions, 3);
  const std::vector<double> toWorld = ReadField(data, FieldArray::LatticeToWorld, 16);
  if (dimensions.empty() || toWorld.empty())
  {
    return false;
  }
  LookFrom(view, FindDirection(dimensions, toWorld, representation));
  SetVerticalExaggeration(view, SuggestVerticalExaggeration(view));
  return true;
}

bool IsCameraMoved(vtkSMProxy* view)
{
  return !view->HasAnnotation(OwnCamera) || DescribeCamera(view) != view->GetAnnotation(OwnCamera);
}

/// Whether what comes sets the camera.
bool IsFirst(vtkSMProxy* view, vtkSMProxy* representation)
{
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  const bool isAnyShown = std::any_of(all.begin(), all.end(),
    [representation](vtkSMProxy* other) { return other != representation && FindShownData(other); });
  return !ShowsOthers(view, representation) && !(isAnyShown && IsCameraMoved(view));
}

/// Whether the data are of a survey and not derived, and nobody has moved the camera since it was set.
bool MayFollow(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkPVDataInformation* const data = FindShownData(representation);
  return data && IsOfSurvey(data) && FindProducer(representation)->GetNumberOfProducers() == 0 && !IsCameraMoved(view);
}

/// Hides inputs or other outputs of a stage if its hints say so.
void HideOthers(vtkSMProxy* view, vtkSMProxy* representation)
{
  vtkSMSourceProxy* const producer = FindProducer(representation);
  const int port = static_cast<int>(vtkSMPropertyHelper(representation, "Input", true).GetOutputPort());
  bool hidesInputs = false, hidesOutputs = false;
  for (vtkPVXMLElement* const hint : producer ? ListHints(producer, port) : std::vector<vtkPVXMLElement*>())
  {
    hidesInputs = hidesInputs || hint->GetAttribute("hides_inputs");
    hidesOutputs = hidesOutputs || hint->GetAttribute("hides_outputs");
  }
  for (vtkSMProxy* const other : ListRepresentations(view))
  {
    const bool isSame = FindProducer(other) == producer;
    if (FindShownData(other) && other != representation &&
      (isSame ? hidesOutputs && FindShownData(representation)->GetNumberOfPoints() > 0
              : hidesInputs && LeadsTo(FindProducer(other), producer)))
    {
      vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
      controller->Hide(other, vtkSMViewProxy::SafeDownCast(view));
    }
  }
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
  this->connect(view, &pqView::representationAdded, this,
    [this, view](pqRepresentation* representation) { this->take(view, representation->getProxy()); });
  this->connect(view, &pqView::representationRemoved, this,
    [this, view]()
    {
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
          view->getProxy()->SetAnnotation(OwnCamera, DescribeCamera(view->getProxy()).c_str());
        }
      });
  }
  this->Added.insert(view, representation);
  this->Updated.insert(view);
  ExaggerateRepresentation(representation, view->getProxy());
}

//------------------------------------------------------------------------------
void pqHorizonToolBar::refresh(pqView* view)
{
  // Once ParaView has looked what else is shown, as it resets the camera where that is nothing.
  for (const vtkSmartPointer<vtkSMProxy>& added : this->Added.values(view))
  {
    HideOthers(view->getProxy(), added);
  }
  this->Added.remove(view);
  for (vtkSMProxy* const representation : ListRepresentations(view->getProxy()))
  {
    auto* const shown = vtkSMPVRepresentationProxy::SafeDownCast(representation);
    if (shown && FindShownData(shown) && vtkSMHorizonDisplayHelper::ShowLate(shown))
    {
      shown->SetScalarBarVisibility(view->getProxy(), true);
      this->take(view, shown);
    }
  }
  RefreshRanges(view->getProxy());
  NameVerticalAxis(view->getProxy());
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
