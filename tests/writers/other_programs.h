// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <cstddef>
#include <string>
#include <vector>

/// What programs that are not ours read from a file.
namespace scan::test
{

/// What a shell command prints, with its complaints; "status N" at the end when it fails.
std::string outputOf(const std::string& command);

/// Whether a command can be run; a test that needs it skips otherwise.
bool isInstalled(const std::string& command);

// ---- assimp

bool hasAssimp();

/// The triangles, with the points that they use, as float32. Throws Error io with what assimp says.
TriMesh readWithAssimp(const std::string& path);

/// Undoes what assimp does to 3DS and DXF, where it makes y the axis that points up.
void turnBackFromAssimp(TriMesh& mesh);

// ---- lib3ds

struct Lib3dsPart
{
  std::string name;
  std::size_t points = 0;
  std::size_t faces = 0;
};

struct Lib3dsResult
{
  std::vector<Lib3dsPart> parts;
  TriMesh mesh; ///< of all parts
};

bool hasLib3ds();

/// What lib3ds finds, as its dump prints it: six digits behind the point.
Lib3dsResult readWithLib3ds(const std::string& path);

// ---- ezdxf

struct EzdxfResult
{
  int complaints = 0;
  int meshes = 0;
  TriMesh mesh;                          ///< triangles with corners of their own, then the points
  std::vector<std::vector<Vec3>> curves; ///< closed ones end with their first point
};

bool hasEzdxf();

EzdxfResult readWithEzdxf(const std::string& path);

// ---- Coin, and the Open Inventor of SGI

bool hasCoin();

/// What Coin draws, colours rounded; curves of two points.
Model readWithCoin(const std::string& path);

bool hasSgiInventor();

/// Points and triangles, six digits.
Model readWithSgiInventor(const std::string& path);

// ---- admesh

bool hasAdmesh();

/// What admesh says of an STL file, after joining equal points.
struct AdmeshResult
{
  std::size_t facets = 0;
  std::size_t degenerate = 0;
  std::size_t open = 0;      ///< facets with a side that has no neighbour
  std::size_t backwards = 0; ///< edges and facets that disagree with others
  std::size_t wrongNormals = 0;
  std::size_t parts = 0;
  double volume = 0.0;
  Vec3 low; ///< of the bounding box, six digits
  Vec3 high;
};

AdmeshResult readWithAdmesh(const std::string& path);

} // namespace scan::test
