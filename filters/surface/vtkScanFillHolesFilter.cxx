// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/surface/vtkScanFillHolesFilter.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

vtkStandardNewMacro(vtkScanFillHolesFilter);

namespace
{

/// Those that a note tells about.
constexpr std::array<std::pair<scan::HoleFate, const char*>, 5> kReasons{ {
  { scan::HoleFate::outerRim, "the rim of an open surface" },
  { scan::HoleFate::tooLong, "longer than the limit" },
  { scan::HoleFate::tooManyEdges, "with more edges than the limit" },
  { scan::HoleFate::notManifold, "the surface is no manifold there" },
  { scan::HoleFate::noRoom, "a patch would cut the surface" },
} };

std::string textOf(const scan::Vec3& place)
{
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%g,%g,%g", place.x, place.y, place.z);
  return text.data();
}

} // namespace

std::vector<scan::Phase> vtkScanFillHolesFilter::Phases() const
{
  return { { "fill", 1.0 }, { "check", 1.0 } };
}

/// How many holes are left and why, with some of their places.
std::string vtkScanFillHolesFilter::Left() const
{
  constexpr int kMostPlaces = 5;
  std::string text;
  for (const auto& [fate, reason] : kReasons)
  {
    const auto count = std::ranges::count(this->Result.holes, fate, &scan::Hole::fate);
    if (count == 0)
    {
      continue;
    }
    text.append(text.empty() ? "left " : "; ").append(std::to_string(count));
    text.append(" (").append(reason).append(") at ");
    int told = 0;
    for (const scan::Hole& hole : this->Result.holes)
    {
      if (hole.fate == fate && told++ < kMostPlaces)
      {
        text.append(told > 1 ? "; " : "").append(textOf(hole.place));
      }
    }
    text.append(count > kMostPlaces ? "; ..." : "");
  }
  return text;
}

scan::SurfaceEdit vtkScanFillHolesFilter::Edit(const Surface& surface, scan::Execution& execution)
{
  scan::FillHolesOptions options = this->Options;
  options.maxPerimeter = InModelUnits(this->MaxPerimeter, surface);
  options.maxDeviation = surface.maxDeviation;
  const std::vector<std::uint8_t> inRegion = this->PointsInRegion(surface, execution);
  this->Result = scan::fillHoles(surface.mesh, inRegion, options, execution);
  const auto flatter = std::ranges::count_if(this->Result.holes,
    [&](const scan::Hole& hole)
    { return hole.fate == scan::HoleFate::filled && hole.shape != options.shape; });
  if (flatter > 0)
  {
    this->AddNote(std::to_string(flatter) +
      " filled flatter than asked for, where that would have cut the surface or bulged too far");
  }
  this->AddNote(this->Left());
  return std::exchange(this->Result.edit, {});
}
