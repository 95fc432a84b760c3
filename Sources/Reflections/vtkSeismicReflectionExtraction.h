// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeismicReflectionExtraction
 * @brief   extracts horizons from a seismic cube by joining reflections of neighbouring traces into surfaces
 *
 * Input 0: a vtkImageData with amplitudes at its points, of any type of numbers (SetInputArrayToProcess; by default the
 * active scalars, or else the point array Amplitude), with vertical traces along k. Points that vtkGhostType hides, and
 * numbers that are not finite, are ignored. Input 1, optional: picks of the horizons wanted. Input 2, optional:
 * horizons that limit the search.
 *
 * A reflection is a run of samples of one sign on a trace (thesis 2.2.1, after Verney 2009), or its end. Strong ones
 * are reduced to a pick, and picks of neighbouring traces are joined into surfaces, "Horizon 1" and on, the strongest
 * first; with picks at input 1, the horizons through these.
 *
 * The output is as of vtkVerneySparseMatrixReader: a vtkPartitionedDataSetCollection of vtkPolyData with one point and
 * one vertex cell per pick, at most one per column. Point data: VerticalIndex, the sample nearest to the pick;
 * Thickness (in samples) and Amplitude of its run; RealZ, its exact position; with picks at input 1 also Origin (0 at a
 * pick, 1 on a surface taken, 2 where the horizon grew) and GuideDistance, to the nearest pick, in columns. Field data
 * are those of the input, or else made from its origin, spacing, direction and extent.
 *
 * The result is the same for any number of threads. With several processes, each processes the whole cube, and gives a
 * part of the horizons. An error leaves the output empty. Memory is about 30 bytes per pick, 100 with picks at input 1.
 */

#ifndef vtkSeismicReflectionExtraction_h
#define vtkSeismicReflectionExtraction_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for the description

namespace SeismicHorizons
{
struct ExtractionOptions;
}
class vtkDataArray;
class vtkImageData;

class VTKSEISMICHORIZONS_EXPORT vtkSeismicReflectionExtraction : public vtkHorizonSource
{
public:
  static vtkSeismicReflectionExtraction* New();
  vtkTypeMacro(vtkSeismicReflectionExtraction, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The angle by which the phase of the wavelet is rotated first: minus the EstimatedPhase of the cube puts picks on
   * interfaces. Unit: degrees. Range: -180 to 180. Default: 0.
   */
  vtkHorizonNumberMacro(PhaseRotation, double);

  /**
   * The sign of the reflections that are used. Default: Both.
   */
  vtkHorizonChoice3Macro(Polarity, Polarities, Both, Positive, Negative);

  /**
   * Where the pick of a reflection is. Middle: in the middle of its samples at or above the threshold. Peak: at each
   * local maximum of the absolute amplitude, interpolated. ZeroCrossing: where amplitudes change sign; positive ones
   * become positive downwards. Default: Peak.
   */
  vtkHorizonChoice3Macro(Position, Positions, Middle, Peak, ZeroCrossing);

  /**
   * Whether AmplitudeThreshold or AmplitudePercentile selects strong reflections. Default: Percentile.
   */
  vtkHorizonChoice2Macro(ThresholdType, ThresholdTypes, Amplitude, Percentile);

  /**
   * The least absolute amplitude of a peak; with Middle, of all samples of a reflection; at a zero crossing, of the
   * mean of the peaks beside it. Unit: that of the amplitudes. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(AmplitudeThreshold, double);

  /**
   * Peaks are too weak below the absolute amplitude that this percentage of samples has, those of the polarity and
   * other than 0. With guides all peaks are used. Unit: percent. Range: 0 to 100. Default: 40.
   */
  vtkHorizonNumberMacro(AmplitudePercentile, double);

  /// Values of Joining; 1 was Continuous in version 0.2.
  enum Joinings
  {
    BestFirst = 0,
    Components = 2
  };

  ///@{
  /**
   * How picks become surfaces. BestFirst: the most similar waveforms are linked first. Components: all that touch. See
   * "Two ways to join" in SeismicReflectionExtraction.md. Default: BestFirst.
   */
  vtkHorizonNumberMacro(Joining, int);
  void SetJoiningToBestFirst() { this->SetJoining(BestFirst); }
  void SetJoiningToComponents() { this->SetJoining(Components); }
  ///@}

  /**
   * Which columns are neighbours: the next ones along i and j, or also the diagonal ones. Default: Four.
   */
  vtkHorizonChoice2Macro(Connectivity, Connectivities, Four, Eight);

  /**
   * The largest vertical step between neighbouring picks of a surface. 0: 0.3 of the dominant period, at least 2. Unit:
   * samples. Range: 0 to 262143. Default: 0.
   */
  vtkHorizonNumberMacro(LargestStep, double);

  /**
   * The least correlation of the waveforms of neighbouring picks, as a fraction of the median over all links. Not with
   * Components. Unit: fraction of the median. Range: 0 to 1. Default: 0.85.
   */
  vtkHorizonNumberMacro(SmallestCorrelation, double);

  /**
   * With BestFirst, the least fraction of links among the pairs of picks along which two parts of a surface face each
   * other. Unit: fraction of the pairs. Range: 0 to 1. Default: 0.5.
   */
  vtkHorizonNumberMacro(SmallestContact, double);

  /**
   * The smallest surface. 0: a twentieth of the traces, 10 to 100. Unit: picks. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(SmallestSize, vtkIdType);

  /**
   * The largest number of horizons. Unit: surfaces. Range: at least 1. Default: 100.
   */
  vtkHorizonNumberMacro(LargestNumber, int);

  /**
   * Which surfaces come first. Strength: those with the largest sum of cubed absolute amplitudes, the main reflectors.
   * Size: those with the most picks. Default: Strength.
   */
  vtkHorizonChoice2Macro(Order, Orders, Strength, Size);

  ///@{
  /**
   * Some picks of each horizon wanted, in the coordinates of the cube, or by its line numbers; optional. Blocks, or the
   * point array Horizon of numbers or texts, separate horizons. Range: points. Default: none.
   *
   * Input 1.
   */
  void SetGuidesConnection(vtkAlgorithmOutput* guides) { this->SetInputConnection(1, guides); }
  void RemoveGuides() { this->SetInputConnection(1, nullptr); }
  ///@}

  /**
   * The largest distance of a pick of a guide from its reflection. 0: 0.2 of the dominant period, at least 1.5. Unit:
   * samples. Range: 0 to 262143. Default: 0.
   */
  vtkHorizonNumberMacro(GuideTolerance, double);

  /**
   * The least correlation of waveforms for a guided horizon to grow to a neighbour. Range: 0 to 1. Default: 0.6.
   */
  vtkHorizonNumberMacro(GrowthCorrelation, double);

  /**
   * How far a guided horizon grows from its picks; from surfaces taken, 60 at most. 0: no growth, which is safest.
   * Unit: columns. Range: at least 0. Default: 1000.
   */
  vtkHorizonNumberMacro(GrowthReach, int);

  /**
   * Points of guided horizons with less Confidence are left out, except for picks of the guide. Range: 0 to 1.
   * Default: 0.
   */
  vtkHorizonNumberMacro(LeastConfidence, double);

  /**
   * Whether the output also has the surfaces without a guide, after the others. Range: on, off. Default: off.
   */
  vtkHorizonNumberMacro(KeepOthers, bool);

  ///@{
  /**
   * One or two older horizons: only what lies between them, or on the LimitSide of one, is searched; optional. ParaView's
   * panel takes one source: for two, a file with both horizons, or Group Datasets of two. Range: points. Default: none.
   *
   * Input 2, of several connections.
   */
  void AddLimitsConnection(vtkAlgorithmOutput* limits) { this->AddInputConnection(2, limits); }
  void RemoveLimits() { this->SetInputConnection(2, nullptr); }
  ///@}

  /**
   * The side of a single limit that is searched. Below: at and after it, in the order of samples. Default: Below.
   */
  vtkHorizonChoice2Macro(LimitSide, LimitSides, Below, Above);

  /**
   * z of the points. VerticalIndex: that of the nearest sample. RealZ: that of the pick itself. Default: RealZ.
   */
  vtkHorizonChoice2Macro(ZFrom, ZSource, VerticalIndex, RealZ);

  /// What was found in the cube, as text. Empty before the first update.
  const char* GetDescription() { return this->Description.c_str(); }

  ///@{
  /**
   * Of the last update: the number of surfaces that are large enough, the dominant period in samples, the phase after
   * the rotation, -90 to 90 degrees, and how far those of parts of the traces are from it. 0 before any update.
   */
  vtkGetMacro(NumberOfSurfaces, vtkIdType);
  vtkGetMacro(DominantPeriod, double);
  vtkGetMacro(EstimatedPhase, double);
  vtkGetMacro(PhaseDeviation, double);
  ///@}

  /// The cube.
  vtkHorizonInputMacro();

protected:
  vtkSeismicReflectionExtraction();
  ~vtkSeismicReflectionExtraction() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void CheckParameters() override;
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountHorizonPoints() override;
  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) override;

private:
  vtkSeismicReflectionExtraction(const vtkSeismicReflectionExtraction&) = delete;
  void operator=(const vtkSeismicReflectionExtraction&) = delete;

  SeismicHorizons::ExtractionOptions MakeOptions() const;
  vtkImageData* GetCube();
  vtkDataArray* FindAmplitudes(vtkImageData* cube);

  double PhaseRotation = 0.0;
  int Polarity = Both;
  int Position = Peak;
  int ThresholdType = Percentile;
  double AmplitudeThreshold = 0.0;
  double AmplitudePercentile = 40.0;
  int Joining = BestFirst;
  int Connectivity = Four;
  double LargestStep = 0.0;
  double SmallestCorrelation = 0.85;
  double SmallestContact = 0.5;
  vtkIdType SmallestSize = 0;
  int LargestNumber = 100;
  int Order = Strength;
  double GuideTolerance = 0.0;
  double GrowthCorrelation = 0.6;
  int GrowthReach = 1000;
  double LeastConfidence = 0.0;
  bool KeepOthers = false;
  int LimitSide = Below;
  int ZFrom = RealZ;

  vtkIdType NumberOfSurfaces = 0;
  double DominantPeriod = 0.0;
  double EstimatedPhase = 0.0;
  double PhaseDeviation = 0.0;
  std::string Description;

  struct Surfaces;
  std::unique_ptr<Surfaces> Found; // Set from listing horizons until they are made.
  struct Kept;
  std::unique_ptr<Kept> Joined; // What guides share, for other guides.
};

#endif
