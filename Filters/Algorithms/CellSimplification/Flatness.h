// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much a set of points deviates from a plane: principal component analysis (thesis 4.3.2.4.1, eq. 4.4 and 4.5).
// The measure is known as surface variation (Pauly, Gross, Kobbelt 2002).

#ifndef SeismicHorizonsFlatness_h
#define SeismicHorizonsFlatness_h

#include <Eigen/Core>

namespace SeismicHorizons
{
/// Sums up weighted points.
class Covariance
{
public:
  /// Sums are taken relative to `origin`: one of the points, so that little is lost to rounding.
  explicit Covariance(const Eigen::Vector3d& origin)
    : Origin(origin)
  {
  }

  void Add(const Eigen::Vector3d& place, double weight)
  {
    const Eigen::Vector3d offset = place - this->Origin;
    const Eigen::Vector3d weighted = weight * offset;
    this->Weight += weight;
    this->Sum += weighted;
    this->Products += weighted * offset.transpose();
  }

  /// The covariance matrix (eq. 4.4) of the points, at least one.
  Eigen::Matrix3d Matrix() const
  {
    const Eigen::Vector3d mean = this->Sum / this->Weight;
    return this->Products / this->Weight - mean * mean.transpose();
  }

private:
  Eigen::Vector3d Origin;
  double Weight = 0.0;
  Eigen::Vector3d Sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d Products = Eigen::Matrix3d::Zero();
};

/// The least eigenvalue of a covariance matrix, divided by the sum of the three (eq. 4.5): 0 on a plane, 1/3 at most.
/// 0 for a matrix without extent.
double Flatness(const Eigen::Matrix3d& covariance);

/// Whether Flatness(covariance) <= threshold, up to rounding: a plane is flat with a threshold of 0.
bool IsFlatWithin(const Eigen::Matrix3d& covariance, double threshold);
}

#endif
