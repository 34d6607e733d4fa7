// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_scans.h"

#include "filters/base/error.h"
#include "readers/mapped_file.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "tests/bench/quality_truths.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace quality
{
namespace
{

namespace fs = std::filesystem;
using scan::TriMesh;
using scan::Vec3;

TriMesh readScan(const fs::path& path)
{
  const scan::MappedFile file(path.string());
  scan::Execution execution;
  return path.extension() == ".ply" ? scan::parsePly(file.bytes(), path.string(), execution)
                                    : scan::parsePointsText(file.bytes(), path.string(), execution);
}

/// A triangle mesh in Geomview's format, without colours or comments.
TriMesh readOff(const fs::path& path)
{
  std::ifstream in(path);
  std::string magic;
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  in >> magic >> points >> triangles >> edges;
  TriMesh mesh;
  for (Vec3 p; mesh.points.size() < points && in >> p.x >> p.y >> p.z;)
  {
    mesh.points.push_back(p);
  }
  std::size_t sides = 3;
  for (scan::Triangle t{};
       mesh.triangles.size() < triangles && in >> sides >> t[0] >> t[1] >> t[2] && sides == 3;)
  {
    mesh.triangles.push_back(t);
  }
  if (mesh.points.size() != points || mesh.triangles.size() != triangles)
  {
    throw scan::Error(scan::ErrorCode::parse, path.string() + ": expected an OFF of triangles");
  }
  return mesh;
}

Scan pointsOnly(const fs::path& path)
{
  return { { readScan(path).points, {} }, std::nullopt };
}

std::function<Scan(const fs::path&)> withTruth(TriMesh (*truth)())
{
  return [truth](const fs::path& path) { return Scan{ { readScan(path).points, {} }, truth() }; };
}

/// The vertices of a mesh are the scan, the mesh is the truth.
Scan verticesOf(const fs::path& path)
{
  TriMesh mesh = path.extension() == ".off" ? readOff(path) : readScan(path);
  Cloud cloud{ mesh.points, {} };
  return { std::move(cloud), std::move(mesh) };
}

/// Six numbers a line: points and normals.
Scan pointsWithNormals(const fs::path& path)
{
  Scan scan;
  std::ifstream in(path);
  Vec3 n;
  for (Vec3 p; in >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z;)
  {
    scan.cloud.points.push_back(p);
    scan.cloud.normals.push_back(n);
  }
  return scan;
}

/// The ten range scans of the bunny in one frame, from bun.conf. Each line holds
/// `bmesh file tx ty tz qx qy qz qw`, the quaternion to be used transposed.
Scan rawBunny(const fs::path& conf)
{
  Scan scan;
  std::ifstream in(conf);
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    Vec3 t;
    Vec3 q;
    double w = 1.0;
    words >> keyword >> name >> t.x >> t.y >> t.z >> q.x >> q.y >> q.z >> w;
    if (keyword != "bmesh")
    {
      continue;
    }
    for (const Vec3& p : readScan(conf.parent_path() / name).points)
    {
      // rotated by the unit quaternion (-q, w)
      const Vec3 turn = cross(p, q) * (2.0 / (dot(q, q) + w * w));
      scan.cloud.points.push_back(p + turn * w + cross(turn, q) + t);
    }
  }
  scan.truth = readScan(conf.parent_path() / "../reconstruction/bun_zipper.ply");
  return scan;
}

/// Contours of a skull, plane by plane. The third column of the file is wrong in its second half;
/// there every plane has a header, `v COUNT z HEIGHT`, some behind slashes.
Scan skull(const fs::path& path)
{
  Scan scan;
  std::ifstream in(path);
  double height = std::numeric_limits<double>::quiet_NaN();
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream numbers(line);
    if (Vec3 p; numbers >> p.x >> p.y >> p.z)
    {
      p.z = std::isnan(height) ? p.z : height;
      scan.cloud.points.push_back(p);
    }
    else if (const std::size_t z = line.find(" z "); z != std::string::npos)
    {
      height = std::stod(line.substr(z + 3));
    }
  }
  return scan;
}

} // namespace

std::vector<ScanSource> scanSources(const fs::path& shared, const fs::path& data)
{
  const fs::path bunny = shared / "data/02_range_scans/stanford_bunny";
  const fs::path meshes = shared / "data/05_meshes/cgal";
  const fs::path points = shared / "data/01_points";
  const fs::path made = shared / "data/synthetic";
  return {
    { "bunny", Shape{ 0, {} },
      "Vertices of the Stanford bunny's published mesh. Genus 0; open at five places of its "
      "underside, which closed surfaces cover. Truth: the mesh.",
      bunny / "reconstruction/bun_zipper.ply", verticesOf },
    { "raw bunny", Shape{ 0, {} },
      "Ten range scans of the same bunny in their published positions: overlapping layers, noise, "
      "a stray point. Truth: the published mesh, which was made from these scans.",
      bunny / "data/bun.conf", rawBunny },
    { "link", Shape{ 1, true },
      "The sample `data/multiview_scan.ply`: a machined part with an eye in twelve simulated "
      "range images with noise. Closed, genus 1. Truth: exact.",
      data / "multiview_scan.ply", withTruth(linkSurface) },
    { "anchor", Shape{ 4, true }, "Vertices of a machine part. Closed, genus 4. Truth: the mesh.",
      meshes / "anchor_dense.off", verticesOf },
    { "fandisk", Shape{ 0, true },
      "Vertices of the sharp-edged benchmark part. Closed, genus 0. Truth: the mesh.",
      meshes / "fandisk.off", verticesOf },
    { "coupling", Shape{ 9, true },
      "Vertices of a machine part, sparse on its flats. Closed, genus 9. Truth: the mesh.",
      meshes / "couplingdown.off", verticesOf },
    { "mechanical part", Shape{ 0, {} },
      "Vertices of a machine part with four holes in the data. Truth: the mesh, holes and all.",
      meshes / "mech-holes-shark.off", verticesOf },
    { "distributor cap", std::nullopt,
      "Laser scans by Hoppe, 1992. Open, with thin walls and uneven coverage. No truth.",
      points / "hoppe/distcap.pts", pointsOnly },
    { "mannequin", Shape{ 0, {} },
      "Vertices of a mannequin's head with horns. Genus 0, open at the neck. Truth: the mesh.",
      meshes / "mannequin-devil.off", verticesOf },
    { "kitten", Shape{ 1, true }, "Points with normals of a statue. Closed, genus 1. No truth.",
      points / "cgal/kitten.xyz", pointsWithNormals },
    { "noisy torus", Shape{ 1, true },
      "Torus of radii 1 and 0.35, noise of standard deviation 0.01 on the points. Closed, genus 1. "
      "Truth: exact.",
      made / "torus5k_noise.xyz", withTruth(torusSurface) },
    { "noisy sphere", Shape{ 0, true },
      "Sphere of radius 1, noise of standard deviation 0.01 on the points. Closed, genus 0. Truth: "
      "exact.",
      made / "sphere20k_noise.xyz", withTruth(sphereSurface) },
    { "plate with a hole", Shape{ 1, true },
      "The sample `data/plate_hole.xyz`, sharp edges. Closed, genus 1. Truth: exact.",
      data / "plate_hole.xyz", withTruth(plateSurface) },
    { "skull", std::nullopt,
      "Contours of a skull, 109 planes. Open at both ends, with inner walls. No truth.",
      shared / "data/07_contours/skull.pts", skull },
    { "monkey saddle", Shape{ 0, false },
      "The sample `data/monkey_saddle.xyz`: an open sheet, a disk (one boundary). Truth: exact.",
      data / "monkey_saddle.xyz", withTruth(saddleSurface) },
    { "helix", Shape{ 0, false },
      "The sample `data/helix.xyz`: an open sheet, a disk, sampled in bars. Truth: the helicoid.",
      data / "helix.xyz", withTruth(helixSurface) },
  };
}

} // namespace quality
