// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Processes that mesh bands of one horizon together (SurfaceParts.h).

#ifndef SeismicHorizonsPartRanks_h
#define SeismicHorizonsPartRanks_h

#include "Common/Base/ByteBuffer.h"

#include <functional>

namespace SeismicHorizons
{
class PartRanks
{
public:
  virtual ~PartRanks() = default;

  virtual int Size() const = 0;
  /// Process 0 has the points.
  virtual int Own() const = 0;

  /// Waits until the other process receives.
  void Send(const ByteBuffer& bytes, int rank) const
  {
    this->AnySent = true;
    this->SendTo(rank, bytes);
  }
  virtual ByteBuffer Receive(int rank) const = 0;
  bool HasSent() const { return this->AnySent; }

  /// Throws an exception on all processes if work does on one. All must call this.
  virtual void Together(const std::function<void()>& work) const = 0;

protected:
  virtual void SendTo(int rank, const ByteBuffer& bytes) const = 0;

private:
  mutable bool AnySent = false;
};
}

#endif
