// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "writers/output_file.h"
#include "writers/write_progress.h"

#include <string>

namespace scan
{

/// The lists that Open Inventor, VRML 1.0 and VRML97 have in common.

/// Throws Error badInput without points; Error limit for coordinates beyond float32 and for more
/// than 2^31 points.
void requireSceneLimits(const Model& model, const OutputFile& file, const std::string& format);

/// How many times the lists call next().
std::size_t sceneRecords(const Model& model);

/// "[ x y z, ... ]", every digit of the model.
void writePointList(const Model& model, OutputFile& file, WriteProgress& progress);

/// "[ r g b, ... ]" from 0.0 to 1.0.
void writeColorList(const Model& model, OutputFile& file, WriteProgress& progress);

/// "[ a, b, c, d, -1, ... ]", the points of each curve, counted from 0.
void writeCurveList(const Model& model, OutputFile& file, WriteProgress& progress);

/// "[ a, b, c, -1, ... ]", counted from 0.
void writeTriangleList(const Model& model, OutputFile& file, WriteProgress& progress);

} // namespace scan
