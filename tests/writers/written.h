// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/writers/models.h"
#include "writers/ply.h"
#include "writers/stl.h"

#include <functional>
#include <numbers>
#include <string>

namespace scan::test
{

using Format = std::function<void(const Model&, OutputFile&, Execution&)>;

inline Format stlFormat(Encoding encoding)
{
  return [encoding](const Model& model, OutputFile& file, Execution& execution)
  { writeStl(model, { .encoding = encoding }, file, execution); };
}

inline Format plyFormat(Encoding encoding)
{
  return [encoding](const Model& model, OutputFile& file, Execution& execution)
  { writePly(model, { .encoding = encoding }, file, execution); };
}

inline std::string bytesOf(const TriMesh& mesh, const Format& format)
{
  return modelBytes(Model{ mesh }, format);
}

/// A bent strip of 2 (n - 1) triangles far from the origin, whose coordinates need all digits.
inline TriMesh bentStrip(Index n)
{
  TriMesh mesh;
  for (Index i = 0; i < n; ++i)
  {
    const double t = std::numbers::pi * i / n;
    mesh.points.push_back({ 665187.522077 + t, -5648349.895035 - t, t * t / 3.0 });
    mesh.points.push_back({ 665187.522077 + t, -5648349.895035 - t, t * t / 3.0 + 0.1 });
  }
  for (Index i = 0; i + 1 < n; ++i)
  {
    mesh.triangles.push_back({ 2 * i, 2 * i + 1, 2 * i + 2 });
    mesh.triangles.push_back({ 2 * i + 1, 2 * i + 3, 2 * i + 2 });
  }
  return mesh;
}

/// The same with coordinates that float32 holds exactly.
inline TriMesh rounded(TriMesh mesh)
{
  for (Vec3& p : mesh.points)
  {
    p = roundedToFloat(p);
  }
  return mesh;
}

} // namespace scan::test
