// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/stl.h"
#include "tests/readers/parsing.h"
#include "tests/readers/temporary_folder.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace scan::test
{

/// What a shell command prints, with its complaints; "status N" at the end when it fails.
inline std::string outputOf(const std::string& command)
{
  std::FILE* const pipe = ::popen(("( " + command + " ) 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> block = {};
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe))
  {
    output.append(block.data(), n);
  }
  const int status = ::pclose(pipe);
  return status == 0 ? output : output + "\nstatus " + std::to_string(status);
}

/// Whether a command can be run; a test that needs it skips otherwise.
inline bool isInstalled(const std::string& command)
{
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

inline bool hasAssimp()
{
  return isInstalled("command -v assimp");
}

/// The triangles that assimp reads from a file, with the points that they use.
inline TriMesh readWithAssimp(const std::string& path)
{
  const std::string stl = path + ".assimp.stl";
  const std::string output = outputOf("assimp export " + path + " " + stl + " -fstlb");
  if (output.find("wrote output file") == std::string::npos)
  {
    throw Error(ErrorCode::io, output);
  }
  return parse(parseStl, contentOf(stl));
}

/// Undoes what assimp does to 3DS and DXF, where it makes y the axis that points up.
inline void turnBackFromAssimp(TriMesh& mesh)
{
  for (Vec3& p : mesh.points)
  {
    p = { p.x, -p.z, p.y };
  }
}

} // namespace scan::test
