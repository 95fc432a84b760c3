// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPlaceText_h
#define SeismicHorizonsPlaceText_h

#include <Eigen/Core>

#include <string>

namespace SeismicHorizons
{
/// World coordinates in messages, as "(603, 2210) and 1204 down": files and scripts may count z either way.
std::string PlaceText(const Eigen::Vector3d& world);
}

#endif
