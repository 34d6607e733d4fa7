// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace scan
{

/// By how much the numbers of kept simplices changed.
struct WrapChange
{
  std::int64_t tetrahedra = 0;
  std::int64_t triangles = 0;
  std::int64_t edges = 0;

  WrapChange& operator+=(const WrapChange& other)
  {
    this->tetrahedra += other.tetrahedra;
    this->triangles += other.triangles;
    this->edges += other.edges;
    return *this;
  }

  std::int64_t eulerCharacteristic() const
  {
    return this->triangles - this->edges - this->tetrahedra;
  }
};

} // namespace scan
