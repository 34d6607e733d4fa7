// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzzer of the rules of regions: whatever the text, it ends in one line of an Error or in a rule
// that survives its text and can be applied.
#include "filters/geometry/region.h"
#include "tests/fuzz/outcome.h"

#include <cstdint>
#include <string_view>

namespace
{

using namespace scan;

/// A strip of triangles, a loose point and two points at one place.
const TriMesh kSurface{ { { 0, 0, 0 }, { 1, 0, 0.1 }, { 0, 1, 0 }, { 1, 1, 0.2 }, { 0, 2, 0 },
                          { 1, 2, 0 }, { 0, 3, 0.3 }, { 9, 9, 9 }, { 9, 9, 9 } },
  { { 0, 1, 2 }, { 1, 3, 2 }, { 2, 3, 4 }, { 3, 5, 4 }, { 4, 5, 6 } } };
const TriMesh kScan{ kSurface.points, {} };

std::vector<double> sameValues(const std::string&)
{
  return std::vector<double>(9, 1.0);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const RegionNames kNames{ { "a", SCAN_FUZZED("sphere(0,0,0,2) - box(0,0,0,1,1,1)") } };
  try
  {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const RegionRule rule = SCAN_FUZZED(text, kNames);
    test::require(SCAN_FUZZED(textOf(rule)) == rule, "another rule: " + textOf(rule));
    Execution execution(1);
    chooseElements(rule, { kScan, RegionElements::points, 0.0, sameValues }, execution);
    chooseElements(rule, { kSurface, RegionElements::points, 0.0, sameValues }, execution);
    chooseElements(rule, { kSurface, RegionElements::triangles, 0.0, sameValues }, execution);
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    test::require(message.find('\n') == std::string::npos, "not a line: " + message);
  }
  return 0;
}
