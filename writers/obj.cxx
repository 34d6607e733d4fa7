// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/obj.h"

#include "writers/text_line.h"

#include <cstddef>
#include <cstdint>

namespace scan
{

void writeObj(const TriMesh& mesh, OutputFile& file, Execution& execution)
{
  constexpr std::size_t kStep = 1U << 15U;
  const std::size_t total = mesh.points.size() + mesh.triangles.size();
  std::size_t done = 0;
  const auto report = [&]
  {
    if (done++ % kStep == 0)
    {
      execution.step("write", done, total);
    }
  };
  file.write("# OBJ by Scanwrap\n");
  for (const Vec3& point : mesh.points)
  {
    report();
    file.write(TextLine("v").number(point.x).number(point.y).number(point.z).text("\n"));
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    report();
    constexpr std::uint64_t kFirst = 1; // OBJ counts from 1
    file.write(TextLine("f").number(kFirst + a).number(kFirst + b).number(kFirst + c).text("\n"));
  }
}

} // namespace scan
