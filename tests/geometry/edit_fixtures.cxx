// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace scan::test
{
namespace
{

std::vector<Facet> surfaceNames(const WrapComplex& kept)
{
  std::vector<Facet> names;
  for (Facet facet = 0; facet < 4 * kept.flow().delaunay().tetCount(); ++facet)
  {
    if (kept.flow().delaunay().canonical(facet) == facet && isOnSurface(kept, facet))
    {
      names.push_back(facet);
    }
  }
  return names;
}

std::vector<Facet> onlyIn(const std::vector<Facet>& a, const std::vector<Facet>& b)
{
  std::vector<Facet> difference;
  std::ranges::set_difference(a, b, std::back_inserter(difference));
  return difference;
}

} // namespace

std::vector<Vec3> readPoints(const std::string& path)
{
  std::ifstream file(path);
  std::vector<Vec3> points;
  for (Vec3 p; file >> p.x >> p.y >> p.z;)
  {
    points.push_back(p);
  }
  EXPECT_FALSE(points.empty()) << path;
  return points;
}

WrapModel wrappedModel(const std::vector<Vec3>& points, WrapOptions::Mode mode)
{
  Execution execution(1);
  return wrap(points, { .mode = mode }, execution).model;
}

WrapModel wholeModel(const std::vector<Vec3>& points)
{
  WrapModel model = wrappedModel(points, WrapOptions::Mode::classic);
  auto whole = std::make_shared<WrapComplex>(model.scan->flow());
  for (Index tet = 0; tet < model.scan->delaunay().tetCount(); ++tet)
  {
    whole->keepTet(tet);
  }
  model.start = whole;
  model.current = whole;
  model.lines = std::make_shared<const std::vector<CriticalEdge>>();
  return model;
}

std::vector<Facet> surfaceFacets(const WrapModel& model)
{
  std::vector<Facet> facets = surfaceNames(*model.current);
  for (Facet& facet : facets)
  {
    const Facet mirror = model.scan->delaunay().mirror[facet / 4][facet % 4];
    facet = mirror != kNone && model.current->keepsTet(mirror / 4) ? mirror : facet;
  }
  return facets;
}

WrapChange countKept(const WrapModel& model)
{
  const DelaunayComplex& complex = model.scan->delaunay();
  WrapChange count;
  std::set<Segment> edges;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    count.tetrahedra += model.current->keepsTet(tet) ? 1 : 0;
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      if (complex.canonical(facet) == facet && model.current->keepsTriangle(facet))
      {
        Triangle v = complex.facetVertices(facet);
        std::ranges::sort(v);
        edges.insert({ Segment{ v[0], v[1] }, Segment{ v[0], v[2] }, Segment{ v[1], v[2] } });
        ++count.triangles;
      }
    }
  }
  for (const CriticalEdge& line : *model.lines)
  {
    edges.insert(line.vertices);
  }
  count.edges = static_cast<std::int64_t>(edges.size());
  return count;
}

void expectReported(const WrapModel& before, const EditReport& report, const WrapModel& now)
{
  for (Facet facet = 0; facet < 4 * now.scan->delaunay().tetCount(); ++facet)
  {
    const bool isSheet = now.current->isSheet(facet);
    EXPECT_FALSE(isSheet && (now.isSolid || now.current->keptSides(facet) > 0)) << facet;
  }
  const WrapChange was = countKept(before);
  const WrapChange is = countKept(now);
  EXPECT_EQ(report.change.tetrahedra, is.tetrahedra - was.tetrahedra);
  EXPECT_EQ(report.change.triangles, is.triangles - was.triangles);
  EXPECT_EQ(report.change.edges, is.edges - was.edges);
  EXPECT_EQ(
    report.change.eulerCharacteristic(), is.eulerCharacteristic() - was.eulerCharacteristic());
  const std::vector<Facet> oldSurface = surfaceNames(*before.current);
  const std::vector<Facet> newSurface = surfaceNames(*now.current);
  EXPECT_EQ(report.surface.gone, onlyIn(oldSurface, newSurface));
  EXPECT_EQ(report.surface.added, onlyIn(newSurface, oldSurface));
}

} // namespace scan::test
