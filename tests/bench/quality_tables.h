// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/quality_measures.h"
#include "tests/bench/quality_scans.h"

namespace quality
{

/// One method on one scan.
struct Result
{
  std::string failure;    ///< why there is no surface; empty when there is one
  double seconds = 0.0;   ///< of the processor, for the method alone
  double megabytes = 0.0; ///< peak of its process
  Quality quality;
};

/// One scan and what became of it, a result for each of methods(), in their order.
struct Comparison
{
  ScanSource source;
  std::size_t points = 0;
  double spacing = 0.0; ///< mean, in the unit of the file
  std::vector<Result> results;
};

/// Whether the surface has the right shape and is, on average, within a spacing of points and
/// truth: "yes", or the first thing that is wrong.
std::string verdict(const Result& result, const Shape& shape);

/// The line of a method in the table of a scan, in Markdown.
std::string methodLine(const Method& method, const Result& result);

/// A table of verdicts, then a section with a table for every scan, in Markdown.
std::string page(const std::vector<Comparison>& comparisons);

/// Replaces what stands between the two marks in a file. Throws Error where they are missing.
void rewriteTables(const std::filesystem::path& file, const std::string& tables);

} // namespace quality
