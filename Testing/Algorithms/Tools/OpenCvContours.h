// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A horizon as an image for OpenCV.

#ifndef SeismicHorizonsOpenCvContours_h
#define SeismicHorizonsOpenCvContours_h

#include "Common/Horizon/Types.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace OpenCvContours
{
using Contours = std::vector<std::vector<cv::Point>>;

/// One pixel per column; columns count from 0.
inline cv::Mat ToImage(const std::vector<SeismicHorizons::PlanePoint>& columns)
{
  int width = 0;
  int height = 0;
  for (const SeismicHorizons::PlanePoint& column : columns)
  {
    width = std::max(width, column.X + 1);
    height = std::max(height, column.Y + 1);
  }
  cv::Mat image = cv::Mat::zeros(height, width, CV_8U);
  for (const SeismicHorizons::PlanePoint& column : columns)
  {
    image.at<unsigned char>(column.Y, column.X) = 255;
  }
  return image;
}
}

#endif
