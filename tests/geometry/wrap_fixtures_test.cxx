// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The exact answers of an independent brute-force program in rational arithmetic, as sets.
#include "filters/geometry/rooms.h"
#include "tests/geometry/complex_corpus.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace scan::test
{
namespace
{

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::vector<fs::path> fixtureFiles()
{
  std::vector<fs::path> files;
  const fs::path folder = fs::path(SCAN_SHARED_DIR) / "fixtures" / "wrap";
  if (fs::is_directory(folder))
  {
    for (const auto& entry : fs::directory_iterator(folder))
    {
      if (entry.path().extension() == ".json")
      {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Everything computed for one fixture, in the fixture's point numbers.
class Fixture
{
public:
  explicit Fixture(const fs::path& file)
    : Expected(Json::parse(std::ifstream(file)))
    , Complex(buildDelaunayComplex(points(Expected), Run))
    , Flow(Complex, Run)
  {
  }

  Simplex original(Simplex simplex) const
  {
    for (Index& v : simplex)
    {
      v = this->Complex.scanPoint[v];
    }
    return sorted(simplex);
  }

  static std::set<Simplex> setOf(const Json& list)
  {
    std::set<Simplex> set;
    for (const Json& item : list)
    {
      set.insert(sorted(item.get<Simplex>()));
    }
    return set;
  }

  static std::vector<Vec3> points(const Json& fixture)
  {
    std::vector<Vec3> list;
    for (const Json& p : fixture["points"])
    {
      list.push_back({ p[0], p[1], p[2] });
    }
    return list;
  }

  Execution Run;
  Json Expected;
  DelaunayComplex Complex;
  FlowComplex Flow;
};

class WrapFixtures : public testing::TestWithParam<fs::path>
{
};

TEST_P(WrapFixtures, DelaunayTetrahedraAreEqual)
{
  const Fixture fixture(GetParam());
  std::set<Simplex> tetrahedra;
  for (const auto& v : fixture.Complex.tetrahedra)
  {
    tetrahedra.insert(fixture.original({ v.begin(), v.end() }));
  }
  EXPECT_EQ(tetrahedra, Fixture::setOf(fixture.Expected["delaunay_tetrahedra"]));
}

TEST_P(WrapFixtures, IntervalsAndCriticalSimplicesAreEqual)
{
  const Fixture fixture(GetParam());
  std::set<std::pair<Simplex, Simplex>> intervals;
  std::set<Simplex> critical;
  for (const auto& [lower, upper] : intervalsOf(fixture.Flow))
  {
    intervals.emplace(fixture.original(lower), fixture.original(upper));
    if (lower == upper && lower.size() > 1)
    {
      critical.insert(fixture.original(lower));
    }
  }
  std::set<std::pair<Simplex, Simplex>> expected;
  for (const Json& interval : fixture.Expected["intervals"])
  {
    expected.emplace(interval[0].get<Simplex>(), interval[1].get<Simplex>());
  }
  EXPECT_EQ(intervals, expected);

  std::set<Simplex> expectedCritical;
  for (const Json& item : fixture.Expected["critical"])
  {
    const Simplex simplex = item["simplex"].get<Simplex>();
    expectedCritical.insert(simplex);
  }
  EXPECT_EQ(critical, expectedCritical);
}

TEST_P(WrapFixtures, ClassicWrapIsEqual)
{
  Fixture fixture(GetParam());
  const DelaunayComplex& complex = fixture.Complex;
  const WrapComplex wrap = collapseFromOutside(fixture.Flow, fixture.Run);
  std::set<Simplex> tetrahedra;
  std::set<Simplex> boundary;
  std::set<Simplex> sheets;
  std::size_t edges = 0;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    if (wrap.keepsTet(tet))
    {
      const auto& v = complex.tetrahedra[tet];
      tetrahedra.insert(fixture.original({ v.begin(), v.end() }));
    }
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      const Triangle v = complex.facetVertices(facet);
      if (wrap.keptSides(facet) == 1)
      {
        boundary.insert(fixture.original({ v.begin(), v.end() }));
      }
      if (wrap.isSheet(facet))
      {
        sheets.insert(fixture.original({ v.begin(), v.end() }));
      }
    }
  }
  for (const Simplex& simplex : simplicesOf(wrap))
  {
    edges += simplex.size() == 2 ? 1 : 0;
  }
  EXPECT_EQ(tetrahedra, Fixture::setOf(fixture.Expected["wrap_tetrahedra"]));
  EXPECT_EQ(boundary, Fixture::setOf(fixture.Expected["wrap_boundary_triangles"]));
  EXPECT_EQ(sheets, Fixture::setOf(fixture.Expected["wrap_sheet_triangles"]));
  EXPECT_EQ(edges, fixture.Expected["wrap_edges"].get<std::size_t>());
}

TEST_P(WrapFixtures, PersistencePairsAreEqual)
{
  Fixture fixture(GetParam());
  struct Pair
  {
    double birth;
    double death;
    Simplex triangle;
    Simplex tetrahedron;
  };
  const auto rounded = [](double radius2) { return std::round(radius2 * 1e9) / 1e9; };
  const auto byRadii = [](const Pair& p, const Pair& q)
  { return p.birth != q.birth ? p.birth < q.birth : p.death < q.death; };
  std::vector<Pair> found;
  const Basins basins = findBasins(fixture.Flow, fixture.Run);
  const std::vector<Wall> walls = findWalls(fixture.Flow, basins, fixture.Run);
  for (const PersistencePair& pair : voidPersistence(fixture.Flow, basins, walls, fixture.Run))
  {
    const Triangle t = fixture.Complex.facetVertices(pair.triangle);
    const auto& v = fixture.Complex.tetrahedra[pair.sink];
    found.push_back({ pair.birth, pair.death, fixture.original({ t.begin(), t.end() }),
      fixture.original({ v.begin(), v.end() }) });
  }
  std::vector<Pair> expected;
  for (const Json& pair : fixture.Expected["h2_pairs"])
  {
    expected.push_back({ pair["birth_r2"], pair["death_r2"],
      sorted(pair["triangle"].get<Simplex>()), sorted(pair["tetrahedron"].get<Simplex>()) });
  }
  ASSERT_EQ(found.size(), expected.size());
  // radii agree up to rounding; round before sorting so that equal ones sort alike
  for (auto* list : { &found, &expected })
  {
    for (Pair& pair : *list)
    {
      pair.birth = rounded(pair.birth);
      pair.death = rounded(pair.death);
    }
    std::sort(list->begin(), list->end(), byRadii);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].birth, expected[i].birth);
    EXPECT_EQ(found[i].death, expected[i].death);
    // the pairing is unique only where no other simplex has the same radius; a pair of simplices
    // that are not critical shares theirs with one that is
    const auto isUnique = [&](const Simplex& simplex, double radius2)
    {
      Json same;
      for (const Json& item : fixture.Expected["critical"])
      {
        if (item["simplex"].size() == simplex.size() && rounded(item["squared_radius"]) == radius2)
        {
          same.push_back(item["simplex"]);
        }
      }
      return same.size() == 1 && sorted(same[0].get<Simplex>()) == simplex;
    };
    if (isUnique(expected[i].triangle, expected[i].birth) &&
      isUnique(expected[i].tetrahedron, expected[i].death))
    {
      EXPECT_EQ(found[i].triangle, expected[i].triangle);
      EXPECT_EQ(found[i].tetrahedron, expected[i].tetrahedron);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Exact, WrapFixtures, testing::ValuesIn(fixtureFiles()),
  [](const auto& test) { return test.param.stem().string(); });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(WrapFixtures);

TEST(WrapFixtureFolder, IsThere)
{
  if (fixtureFiles().empty())
  {
    GTEST_SKIP() << "no fixtures in " << SCAN_SHARED_DIR << "/fixtures/wrap";
  }
}

} // namespace
} // namespace scan::test
