// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurfacePositions_h
#define SeismicHorizonsSurfacePositions_h

#include <array>
#include <unordered_map>

namespace SeismicHorizons
{
/// Finds the position of a horizon, in a list of them, by its surface ID. All columns of a file have the same few IDs,
/// so the last answers are kept: looking at them is quicker than the map.
class SurfacePositions
{
public:
  static constexpr int None = -1;

  /// The position of a surface ID, or None.
  int Find(int surfaceId)
  {
    Answer& answer = this->LastAnswer(surfaceId);
    if (!answer.IsKnown || answer.SurfaceId != surfaceId)
    {
      const auto found = this->Positions.find(surfaceId);
      answer = { true, surfaceId, found == this->Positions.end() ? None : found->second };
    }
    return answer.Position;
  }

  void Insert(int surfaceId, int position)
  {
    this->Positions.emplace(surfaceId, position);
    this->LastAnswer(surfaceId) = { true, surfaceId, position };
  }

private:
  struct Answer
  {
    bool IsKnown = false;
    int SurfaceId = 0;
    int Position = None;
  };

  Answer& LastAnswer(int surfaceId)
  {
    return this->Answers[static_cast<unsigned int>(surfaceId) % this->Answers.size()];
  }

  std::unordered_map<int, int> Positions;
  std::array<Answer, 64> Answers; // one for all IDs of the same remainder
};
}

#endif
