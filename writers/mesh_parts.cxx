// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/mesh_parts.h"

namespace scan
{

PartNumbering::PartNumbering(const TriMesh& mesh)
  : Numbers(mesh.points.size())
{
}

void PartNumbering::startPart()
{
  this->Points.clear();
}

bool PartNumbering::has(Index point) const
{
  const Index number = this->Numbers[point];
  return number < this->Points.size() && this->Points[number] == point;
}

Index PartNumbering::numberOf(Index point)
{
  if (!this->has(point))
  {
    this->Numbers[point] = static_cast<Index>(this->Points.size());
    this->Points.push_back(point);
  }
  return this->Numbers[point];
}

std::size_t PartNumbering::newPoints(const Triangle& triangle) const
{
  std::size_t count = 0;
  for (const Index corner : triangle)
  {
    count += this->has(corner) ? 0 : 1;
  }
  return count;
}

std::vector<MeshPart> splitIntoParts(
  const TriMesh& mesh, std::size_t maxPoints, std::size_t maxTriangles, Execution& execution)
{
  std::vector<MeshPart> parts;
  PartNumbering numbering(mesh);
  MeshPart part;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    constexpr std::size_t kStep = 1U << 18U;
    if (i % kStep == 0)
    {
      execution.step("write", 0, mesh.triangles.size());
    }
    const Triangle& triangle = mesh.triangles[i];
    if (i - part.begin == maxTriangles ||
      numbering.points().size() + numbering.newPoints(triangle) > maxPoints)
    {
      parts.push_back(part);
      part = { .begin = i };
      numbering.startPart();
    }
    for (const Index corner : triangle)
    {
      numbering.numberOf(corner);
    }
    part.end = i + 1;
    part.pointCount = numbering.points().size();
  }
  if (part.end > part.begin)
  {
    parts.push_back(part);
  }
  return parts;
}

} // namespace scan
