// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <string>
#include <vector>

namespace samples
{

/// One file of this folder.
struct Sample
{
  std::string name;
  std::string bytes;
};

/// Standard deviation of the noise along the line of sight of multiview_scan.ply, mm.
inline constexpr double kScanNoise = 0.04;

/// Points of a link (multiview_scan_truth.h) seen by twelve range cameras, view by view.
std::vector<scan::Vec3> simulateScan();

/// The same of limb_scan.ply.
inline constexpr double kLimbNoise = 0.15;

/// Points of a leg (limb_scan_truth.h), likewise.
std::vector<scan::Vec3> simulateLimbScan();

/// Every sample, made from formulas and a fixed random sequence; the same bytes on every run.
std::vector<Sample> makeSamples();

} // namespace samples
