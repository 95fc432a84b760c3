// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names of arrays. Documentation/DataModel.md gives their meaning.

#ifndef SeismicHorizonsDataModel_h
#define SeismicHorizonsDataModel_h

namespace SeismicHorizons
{
namespace PointArray
{
constexpr const char* SurfaceId = "SurfaceId";
constexpr const char* Column = "Column";
constexpr const char* Elevation = "Elevation";
constexpr const char* VerticalIndex = "VerticalIndex";
constexpr const char* Thickness = "Thickness";
constexpr const char* Amplitude = "Amplitude";
constexpr const char* RealZ = "RealZ";
constexpr const char* Inline = "Inline";
constexpr const char* Crossline = "Crossline";
constexpr const char* PatchId = "PatchId";
constexpr const char* Boundary = "Boundary";
constexpr const char* PointCount = "PointCount";
constexpr const char* CellOrigin = "CellOrigin";
constexpr const char* Flatness = "Flatness";
constexpr const char* Distance = "Distance";
constexpr const char* VerticalDistance = "VerticalDistance";
constexpr const char* Throw = "Throw";
constexpr const char* Heave = "Heave";
constexpr const char* Spread = "Spread";
constexpr const char* Guessed = "Guessed";
constexpr const char* Along = "Along";
constexpr const char* Filled = "Filled";
constexpr const char* Spike = "Spike";
constexpr const char* Origin = "Origin";
constexpr const char* GuideDistance = "GuideDistance";
constexpr const char* Confidence = "Confidence";
constexpr const char* Correlation = "Correlation";
constexpr const char* Block = "Block";
constexpr const char* Seed = "Seed";
constexpr const char* Isochore = "Isochore";
constexpr const char* Isopach = "Isopach";
constexpr const char* Moved = "Moved";
constexpr const char* Ghosts = "vtkGhostType";
}

/// Bits of the array of ghosts.
namespace GhostMark
{
constexpr unsigned char Copy = 1; // Another process has the original.
constexpr unsigned char HiddenPoint = 2;
constexpr unsigned char HiddenCell = 32;
}

namespace CellArray
{
constexpr const char* CellSize = "CellSize";
constexpr const char* Compactness = "Compactness";
constexpr const char* Quality = "Quality";
constexpr const char* Dilatation = "Dilatation";
constexpr const char* Error = "Error";
constexpr const char* Part = "Part";
constexpr const char* BodyAbove = "BodyAbove";
constexpr const char* BodyBelow = "BodyBelow";
constexpr const char* FaultLine = "FaultLine";
constexpr const char* FaultName = "FaultName";
constexpr const char* FaultStick = "FaultStick";
constexpr const char* Fault = "Fault";
constexpr const char* Level = "Level";
constexpr const char* IndexContour = "IndexContour";
constexpr const char* Label = "Label";
constexpr const char* Juxtaposition = "Juxtaposition";
constexpr const char* Footwall = "Footwall";
constexpr const char* HangingWall = "HangingWall";
constexpr const char* IsSame = "IsSame";
constexpr const char* Layer = "Layer";
constexpr const char* LayerAbove = "LayerAbove";
constexpr const char* LayerBelow = "LayerBelow";
constexpr const char* LineType = "LineType";
constexpr const char* SurfaceName = "SurfaceName";
constexpr const char* SurfaceType = "SurfaceType";
constexpr const char* Sublayer = "Sublayer";
constexpr const char* FaultFaces = "FaultFaces";
constexpr const char* Triangle = "Triangle";
constexpr const char* Thickness = "Thickness";
constexpr const char* Volume = "Volume";
constexpr const char* Face = "Face";
}

namespace FieldArray
{
constexpr const char* LatticeDimensions = "LatticeDimensions";
constexpr const char* LatticeToWorld = "LatticeToWorld";
constexpr const char* VerticalDirection = "VerticalDirection";
constexpr const char* Colour = "Colour";
constexpr const char* DroppedDuplicates = "DroppedDuplicates";
constexpr const char* DroppedNulls = "DroppedNulls";
constexpr const char* DroppedRepeats = "DroppedRepeats";
constexpr const char* LargestConflict = "LargestConflict";
constexpr const char* LineNumbers = "LineNumbers";
constexpr const char* LatticeDeviation = "LatticeDeviation";
constexpr const char* VerticalUnit = "VerticalUnit";
constexpr const char* VerticalDomain = "VerticalDomain";
constexpr const char* HorizontalUnit = "HorizontalUnit";
constexpr const char* CoordinateSystem = "CoordinateSystem";
constexpr const char* ImageDeviation = "ImageDeviation";
constexpr const char* StrongAmplitude = "StrongAmplitude";
constexpr const char* TextHeader = "TextHeader";
constexpr const char* NumberOfPatches = "NumberOfPatches";
constexpr const char* NumberOfHoles = "NumberOfHoles";
constexpr const char* DroppedSmallPatchPoints = "DroppedSmallPatchPoints";
constexpr const char* BoundaryDeviation = "BoundaryDeviation";
constexpr const char* OutlineDeviation = "OutlineDeviation";
constexpr const char* OutlineHeightDeviation = "OutlineHeightDeviation";
constexpr const char* NumberOfOutsidePoints = "NumberOfOutsidePoints";
constexpr const char* TriangleCount = "TriangleCount";
constexpr const char* FaultTriangleCount = "FaultTriangleCount";
constexpr const char* BoundaryEdgeCount = "BoundaryEdgeCount";
constexpr const char* NonDelaunayEdgeCount = "NonDelaunayEdgeCount";
constexpr const char* SmallestAngle = "SmallestAngle";
constexpr const char* SliverCount = "SliverCount";
constexpr const char* LargestError = "LargestError";
constexpr const char* MeanError = "MeanError";
constexpr const char* LargestEdgeError = "LargestEdgeError";
constexpr const char* LargestLoopError = "LargestLoopError";
constexpr const char* ChosenRadius = "ChosenRadius";
constexpr const char* ChosenSmallestHoleSize = "ChosenSmallestHoleSize";
constexpr const char* ChosenOutlineTolerance = "ChosenOutlineTolerance";
constexpr const char* ChosenDistanceThreshold = "ChosenDistanceThreshold";
constexpr const char* ChosenMaximumError = "ChosenMaximumError";
constexpr const char* HeightNoise = "HeightNoise";
constexpr const char* HeightRounding = "HeightRounding";
constexpr const char* ChosenMaximumNumberOfPoints = "ChosenMaximumNumberOfPoints";
constexpr const char* ChosenCellSize = "ChosenCellSize";
constexpr const char* ChosenFlatnessThreshold = "ChosenFlatnessThreshold";
constexpr const char* NumberOfFilledHoles = "NumberOfFilledHoles";
constexpr const char* NumberOfFilledPoints = "NumberOfFilledPoints";
constexpr const char* RimSmoothing = "RimSmoothing";
constexpr const char* RimWidth = "RimWidth";
constexpr const char* NumberOfOpenHoles = "NumberOfOpenHoles";
constexpr const char* ContourInterval = "ContourInterval";
constexpr const char* NumberOfContours = "NumberOfContours";
constexpr const char* NumberOfSpikes = "NumberOfSpikes";
constexpr const char* SpikeThreshold = "SpikeThreshold";
constexpr const char* NumberOfSpurPoints = "NumberOfSpurPoints";
constexpr const char* FaultedLinks = "FaultedLinks";
constexpr const char* FaultThrow = "FaultThrow";
constexpr const char* BodyBlock = "BodyBlock";
constexpr const char* BodyLayer = "BodyLayer";
constexpr const char* BodyName = "BodyName";
constexpr const char* BodyVolume = "BodyVolume";
constexpr const char* FaultLine = "FaultLine";
constexpr const char* FaultNames = "FaultNames";
constexpr const char* OldFaultedLinks = "CutLinks"; // Files of version 0.2 have these names.
constexpr const char* OldFaultThrow = "CutThrow";
constexpr const char* OldFaultLine = "CutLine";
constexpr const char* CrackOpenEnds = "CrackOpenEnds";
constexpr const char* OldCrackOpenEnds = "CutMouths";
constexpr const char* CrackLoops = "CrackLoops";
constexpr const char* BlankedPoints = "BlankedPoints";
constexpr const char* FaultNoise = "FaultNoise";
constexpr const char* SmallestFaultThrow = "SmallestFaultThrow";
constexpr const char* IsochoreLeast = "IsochoreLeast";
constexpr const char* IsochoreMean = "IsochoreMean";
constexpr const char* IsochoreLargest = "IsochoreLargest";
constexpr const char* IsochoreVolume = "IsochoreVolume";
constexpr const char* IsochoreCrossings = "IsochoreCrossings";
constexpr const char* LayerNames = "LayerNames";
constexpr const char* HorizonNames = "HorizonNames";
constexpr const char* MovedColumns = "MovedColumns";
constexpr const char* FarthestMove = "FarthestMove";
constexpr const char* LargestDistance = "LargestDistance";
constexpr const char* LargestDistanceFound = "LargestDistanceFound";
constexpr const char* MeanDistance = "MeanDistance";
constexpr const char* RmsDistance = "RmsDistance";
constexpr const char* DistancePercentile = "DistancePercentile"; // A number follows.
constexpr const char* OutlineDistance = "OutlineDistance";
constexpr const char* Grading = "Grading";
constexpr const char* LedgerColumns = "LedgerColumns";
constexpr const char* LedgerArea = "LedgerArea";
constexpr const char* LedgerVolume = "LedgerVolume";
}

enum class BoundaryKind : unsigned char
{
  Inside = 0,
  Exterior = 1, // Takes precedence over Hole.
  Hole = 2
};
}

#endif
