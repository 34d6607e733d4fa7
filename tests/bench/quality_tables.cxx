// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_tables.h"

#include "filters/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace quality
{
namespace
{

std::string cell(const std::optional<Deviation>& deviation)
{
  return deviation ? fmt::format("{:.3f} / {:.1f}", deviation->mean, deviation->max) : "";
}

std::string pointsCell(const Quality& quality)
{
  const double share = std::floor(1e4 * quality.pointsOnSurface) / 100.0; // 100 % means all
  return share > 0.0 ? fmt::format("{:.2f} %", share) : "moved";
}

std::string manifoldCell(const scan::MeshReport& mesh)
{
  return mesh.isManifold
    ? "yes"
    : fmt::format("{} edges, {} points", mesh.nonManifoldEdges, mesh.nonManifoldVertices);
}

std::string genusCell(const scan::MeshReport& mesh)
{
  return mesh.genus ? fmt::format("{}", *mesh.genus)
                    : fmt::format("χ = {}", mesh.eulerCharacteristic);
}

/// How many, and the share of the triangles that the largest has.
std::string partsCell(const scan::MeshReport& mesh)
{
  const std::size_t count = mesh.components.size();
  if (count < 2)
  {
    return fmt::format("{}", count);
  }
  const double largest = mesh.components.front().triangles;
  return fmt::format("{}, largest {:.1f} %", count, 100.0 * largest / mesh.triangles);
}

/// The largest of the mean distances.
double farthestMean(const Quality& quality)
{
  return std::max({ quality.ofPoints.mean, quality.fromTruth.value_or(Deviation{}).mean,
    quality.ofTruth.value_or(Deviation{}).mean });
}

std::string overview(const std::vector<Comparison>& comparisons)
{
  std::string head = "| scan |";
  std::string rule = "| --- |";
  for (const Method& method : methods())
  {
    head += fmt::format(" {} |", method.name);
    rule += " --- |";
  }
  std::string lines;
  for (const Comparison& comparison : comparisons)
  {
    if (comparison.source.shape)
    {
      lines += fmt::format("| {} |", comparison.source.name);
      for (const Result& result : comparison.results)
      {
        lines += fmt::format(" {} |", verdict(result, *comparison.source.shape));
      }
      lines += '\n';
    }
  }
  return "### Right shape?\n\n" + head + "\n" + rule + "\n" + lines + "\n";
}

std::string section(const Comparison& comparison)
{
  std::string text = fmt::format("### {}\n\n{} {} points, mean spacing {:.4g}.\n\n",
    comparison.source.name, comparison.source.about, comparison.points, comparison.spacing);
  text += "| method | seconds | MB | points on it | points to it | closed | manifold | open edges "
          "| parts | genus | it to truth | truth to it |\n"
          "| --- | ---: | ---: | ---: | ---: | --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
  for (std::size_t i = 0; i < comparison.results.size(); ++i)
  {
    text += methodLine(methods()[i], comparison.results[i]);
  }
  return text + "\n";
}

} // namespace

std::string verdict(const Result& result, const Shape& shape)
{
  if (!result.failure.empty())
  {
    return result.failure;
  }
  const scan::MeshReport& mesh = result.quality.topology;
  if (!mesh.isManifold)
  {
    return "not manifold";
  }
  if (mesh.components.size() != 1)
  {
    return fmt::format("{} parts", mesh.components.size());
  }
  if (mesh.genus != shape.genus)
  {
    return mesh.genus ? fmt::format("genus {}", *mesh.genus) : "not orientable";
  }
  if (shape.closed && *shape.closed != mesh.isClosed)
  {
    return mesh.isClosed ? "closed" : fmt::format("{} open edges", mesh.boundaryEdges);
  }
  const double off = farthestMean(result.quality);
  return off > 1.0 ? fmt::format("{:.1f} spacings off", off) : "**yes**";
}

std::string methodLine(const Method& method, const Result& result)
{
  if (!result.failure.empty())
  {
    return fmt::format("| {} | {} | | | | | | | | | | |\n", method.name, result.failure);
  }
  const Quality& quality = result.quality;
  const scan::MeshReport& mesh = quality.topology;
  return fmt::format("| {} | {:.2f} | {:.0f} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
    method.name, result.seconds, result.megabytes, pointsCell(quality), cell(quality.ofPoints),
    mesh.isClosed ? "yes" : "no", manifoldCell(mesh), mesh.boundaryEdges, partsCell(mesh),
    genusCell(mesh), cell(quality.fromTruth), cell(quality.ofTruth));
}

std::string page(const std::vector<Comparison>& comparisons)
{
  std::string text = overview(comparisons);
  for (const Comparison& comparison : comparisons)
  {
    text += section(comparison);
  }
  return text;
}

void rewriteTables(const std::filesystem::path& file, const std::string& tables)
{
  const std::string begin = "<!-- tables: written by quality_bench -->\n";
  const std::string end = "<!-- end of the tables -->\n";
  std::ifstream in(file);
  std::string text{ std::istreambuf_iterator<char>(in), {} };
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(end);
  if (from == std::string::npos || to == std::string::npos || to < from)
  {
    throw scan::Error(
      scan::ErrorCode::badInput, file.string() + ": the marks around the tables are missing");
  }
  text.replace(from + begin.size(), to - from - begin.size(), "\n" + tables);
  std::ofstream(file) << text;
}

} // namespace quality
