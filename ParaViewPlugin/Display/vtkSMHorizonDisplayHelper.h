// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMHorizonDisplayHelper
 * @brief   how the output of a filter looks when it is shown first
 *
 * Runs when a HorizonRepresentation is made, in the window and in scripts alike, and looks for hints of the filter that
 * is shown:
 *
 * @code{.xml}
 * <Hints>
 *   <Representation view="RenderView" type="HorizonRepresentation" port="0"/>
 *   <FirstSight port="0" array="Filled" association="points" colors="Filled Points"/>
 *   <FirstSight port="0" line_width="3"/>
 * </Hints>
 * @endcode
 *
 * Lines and points are as wide as hints for the port say, in pixels (`line_width`, `point_size`; points no wider than
 * leaves them apart where there is a `least_point_size`), and drawn with depth where `tubes` (before VTK 9.6) or
 * `spheres` is 1: an outline then stands out from points on it. With an `ambient` of 1 and a `diffuse` of 0, light
 * changes no colour. Of hints with an array the first one counts whose array is in the data with more than one value;
 * where there is none, ParaView colours by the active scalars. The array "heights" is that of vtkHorizonRepresentation,
 * and `shown_as` the name that an array has there, with colours of its own. `port` may be left out: the hint is for all
 * of them then.
 *
 * `range` is "data" where it is not given; "fraction", from 0 to 1; "centred", as far below zero as above, but no farther than the figure
 * `ends_at` of the field data; or a figure in the field data (of its components, that of the filter's property `unit`)
 * where the colours end, with one more colour for what is above. Ranges but "data" follow what a window shows until
 * somebody sets another one.
 *
 * `colors` is the name of a ColorMap in the hint of the representation, in ParaView's format of colour maps in XML,
 * from low to high. Categories are those of the elements Annotation of the map. Colours that somebody has chosen for an
 * array before are left alone.
 *
 * Where `hides_inputs` is 1, what led to a stage is hidden in a view once the stage is shown there, not only its input;
 * where `hides_outputs` is 1, other outputs of the stage are.
 *
 * `representation` is the way to draw, as "Volume"; of several the first one counts whose array, if it names one, is
 * there. A "Slice" is the middle one of the wider vertical sections of a cube. A volume is clear at the least value of
 * the array, and has the `opacity` at all others. Hints with `data` are for data of that class alone, and those with
 * `most_points` for data of no more points.
 */

#ifndef vtkSMHorizonDisplayHelper_h
#define vtkSMHorizonDisplayHelper_h

#include "vtkSMProxyInitializationHelper.h"

class vtkSMHorizonDisplayHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMHorizonDisplayHelper* New();
  vtkTypeMacro(vtkSMHorizonDisplayHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets ParaView make objects of this class, by its name in the hint of the representation.
  static void Register();

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

  /// Does the same once data have come where there were none at first: after an error, or a stop. True where it was
  /// done.
  static bool ShowLate(vtkSMProxy* representation);

  /// Gives a separate colour map, which ParaView makes with its default colours, those of the hints, once.
  static void ColorSeparately(vtkSMProxy* representation);

protected:
  vtkSMHorizonDisplayHelper();
  ~vtkSMHorizonDisplayHelper() override;

private:
  vtkSMHorizonDisplayHelper(const vtkSMHorizonDisplayHelper&) = delete;
  void operator=(const vtkSMHorizonDisplayHelper&) = delete;
};

#endif
