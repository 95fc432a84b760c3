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
   * Phase rotation applied first; minus EstimatedPhase puts picks on interfaces. Unit: degrees. Range: -180 to 180.
   * Default: 0.
   */
  vtkHorizonNumberMacro(PhaseRotation, double);

  /**
   * Sign of the reflections used. Default: Both.
   */
  vtkHorizonChoice3Macro(Polarity, Polarities, Both, Positive, Negative);

  /**
   * Where reflections are picked. Middle: midway along their samples at or above the threshold. Peak: at maxima of
   * absolute amplitude. ZeroCrossing: at changes of sign; Positive means to positive amplitudes downwards. Default:
   * Peak.
   */
  vtkHorizonChoice3Macro(Position, Positions, Middle, Peak, ZeroCrossing);

  /**
   * Selects strong reflections by AmplitudeThreshold or AmplitudePercentile. Default: Percentile.
   */
  vtkHorizonChoice2Macro(ThresholdType, ThresholdTypes, Amplitude, Percentile);

  /**
   * Smallest absolute amplitude of a peak; for Middle, of each sample; for ZeroCrossing, of the mean of adjacent peaks.
   * Unit: that of the amplitudes. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(AmplitudeThreshold, double);

  /**
   * Ignores peaks below this percentile of nonzero absolute amplitudes of the polarity; not with guides. Unit: percent.
   * Range: 0 to 100. Default: 40.
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
   * Whether columns are neighbours along i and j only, or also diagonally. Default: Four.
   */
  vtkHorizonChoice2Macro(Connectivity, Connectivities, Four, Eight);

  /**
   * Largest vertical step between neighbouring picks. 0: 0.3 of the dominant period, at least 2. Unit: samples. Range:
   * 0 to 262143. Default: 0.
   */
  vtkHorizonNumberMacro(LargestStep, double);

  /**
   * With BestFirst, the smallest waveform correlation of neighbouring picks. Unit: fraction of the median over all
   * links. Range: 0 to 1. Default: 0.85.
   */
  vtkHorizonNumberMacro(SmallestCorrelation, double);

  /**
   * With BestFirst, the smallest fraction of facing picks of two pieces that must be linked. Unit: fraction of the
   * pairs. Range: 0 to 1. Default: 0.5.
   */
  vtkHorizonNumberMacro(SmallestContact, double);

  /**
   * Smallest surface kept. 0: a twentieth of the traces, 10 to 100. Unit: picks. Range: at least 0. Default: 0.
   */
  vtkHorizonNumberMacro(SmallestSize, vtkIdType);

  /**
   * Largest number of horizons. Unit: surfaces. Range: at least 1. Default: 100.
   */
  vtkHorizonNumberMacro(LargestNumber, int);

  /**
   * Which surfaces come first. Strength: the main reflectors. Size: those with most picks. Default: Strength.
   *
   * Strength is the sum of cubed absolute amplitudes.
   */
  vtkHorizonChoice2Macro(Order, Orders, Strength, Size);

  ///@{
  /**
   * Picks of the horizons wanted, in coordinates or line numbers of the cube; optional. Blocks, or the point array
   * Horizon (numbers or text), separate horizons. Range: points. Default: none.
   *
   * Input 1.
   */
  void SetGuidesConnection(vtkAlgorithmOutput* guides) { this->SetInputConnection(1, guides); }
  void RemoveGuides() { this->SetInputConnection(1, nullptr); }
  ///@}

  /**
   * Largest distance of a guide's picks from their reflections. 0: 0.2 of the dominant period, at least 1.5. Unit:
   * samples. Range: 0 to 262143. Default: 0.
   */
  vtkHorizonNumberMacro(GuideTolerance, double);

  /**
   * Smallest waveform correlation at which guided horizons grow. Range: 0 to 1. Default: 0.6.
   */
  vtkHorizonNumberMacro(GrowthCorrelation, double);

  /**
   * How far guided horizons grow from picks; from surfaces taken, at most 60. 0: no growth, the safest. Unit: columns.
   * Range: at least 0. Default: 1000.
   */
  vtkHorizonNumberMacro(GrowthReach, int);

  /**
   * Smallest Confidence of guided points; picks of guides are always kept. Range: 0 to 1. Default: 0.
   */
  vtkHorizonNumberMacro(LeastConfidence, double);

  /**
   * Adds the surfaces without a guide, after the others. Range: on, off. Default: off.
   */
  vtkHorizonNumberMacro(KeepOthers, bool);

  ///@{
  /**
   * Searches only between two older horizons, or on the LimitSide of one; optional. In the panel, give two as one file
   * or by Group Datasets. Range: points. Default: none.
   *
   * Input 2, of several connections.
   */
  void AddLimitsConnection(vtkAlgorithmOutput* limits) { this->AddInputConnection(2, limits); }
  void RemoveLimits() { this->SetInputConnection(2, nullptr); }
  ///@}

  /**
   * Side of a single limit to search. Below: at and after it, in sample order. Default: Below.
   */
  vtkHorizonChoice2Macro(LimitSide, LimitSides, Below, Above);

  /**
   * World z of points. VerticalIndex: of the nearest sample. RealZ: of the pick itself. Default: RealZ.
   */
  vtkHorizonChoice2Macro(ZFrom, ZSource, VerticalIndex, RealZ);

  /// What was found in the cube. Empty before the first update.
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
