// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scan::test
{

using Parser = Model (*)(std::span<const char>, std::string_view, Execution&);

/// Parses a copy of the text that ends exactly at the end of its storage.
/// @param parser (bytes, name, execution) -> model
template <class Parser>
auto parse(Parser parser, std::string_view text, unsigned threads = 1)
{
  const std::vector<char> bytes(text.begin(), text.end());
  Execution execution(threads);
  return parser(bytes, "file", execution);
}

/// The areas of the triangles, each counted positive.
inline double areaOf(const TriMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3 n = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    sum += 0.5 * std::sqrt(dot(n, n));
  }
  return sum;
}

/// The message of the Error parse that the text ends in; empty when it is accepted.
template <class Parser>
std::string parseError(Parser parser, std::string_view text)
{
  try
  {
    parse(parser, text);
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::parse ? error.what() : "not a parse error";
  }
  return {};
}

} // namespace scan::test
