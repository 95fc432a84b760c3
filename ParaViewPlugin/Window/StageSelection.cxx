// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StageSelection.h"

#include "ViewContents.h"

#include <QPointer>
#include <QTimer>
#include <pqActiveObjects.h>
#include <pqOutputPort.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>
#include <vtkPVDataInformation.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr int LaterBy = 100; // milliseconds; the browser changes the selection by events of its own
/// The pipeline browser loses the selection of a source that moves.
void KeepSelected(pqPipelineSource* moved)
{
  const QPointer<pqServerManagerModelItem> kept = moved->getNumberOfOutputPorts() > 1
    ? static_cast<pqServerManagerModelItem*>(pqActiveObjects::instance().activePort())
    : moved;
  if (pqActiveObjects::instance().activeSource() == moved)
  {
    QTimer::singleShot(LaterBy, moved,
      [kept]()
      {
        pqActiveObjects& active = pqActiveObjects::instance();
        if (kept && (active.selection().empty() || !active.activeSource()))
        {
          active.setSelection({}, nullptr); // Otherwise nothing would change.
          active.setSelection({ kept.data() }, kept);
        }
      });
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void SelectShown(vtkSMProxy* view, vtkSMProxy* representation)
{
  const vtkSMPropertyHelper input(representation, "Input", true);
  pqOutputPort* const selected = pqActiveObjects::instance().activePort();
  if (!selected || selected->getSourceProxy() != input.GetAsProxy() || input.GetAsProxy()->GetNumberOfProducers() == 0)
  {
    return; // A reader of a seismic line shows its outline, but stages take its traces.
  }
  const std::vector<vtkSMProxy*> all = ListRepresentations(view);
  const auto isOfSelected = [selected](vtkSMProxy* other)
  {
    const vtkSMPropertyHelper shown(other, "Input", true);
    return FindShownData(other) && shown.GetAsProxy() == selected->getSourceProxy() &&
      int(shown.GetOutputPort()) == selected->getPortNumber();
  };
  if (std::none_of(all.begin(), all.end(), isOfSelected))
  {
    pqActiveObjects::instance().setActivePort(selected->getSource()->getOutputPort(int(input.GetOutputPort())));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void KeepSelection(pqServerManagerModel* model)
{
  const auto keep = [](pqPipelineSource*, pqPipelineSource* moved) { KeepSelected(moved); };
  for (const auto signal :
    { QOverload<pqPipelineSource*, pqPipelineSource*, int>::of(&pqServerManagerModel::preConnectionAdded),
      QOverload<pqPipelineSource*, pqPipelineSource*, int>::of(&pqServerManagerModel::preConnectionRemoved) })
  {
    QObject::connect(model, signal, model, keep);
  }
}
}
