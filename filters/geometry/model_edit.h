// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/surface_change.h"
#include "filters/geometry/wrap_editor.h"
#include "filters/geometry/wrap_model.h"

#include <memory>
#include <span>
#include <unordered_set>

namespace scan
{

/// What an edit did. The Euler characteristic of the complex changes by that of `change`.
struct EditReport
{
  WrapChange change;
  SurfaceChange surface;
};

/// The next state of a model in the making. The model stays as it is until finish(), and all its
/// earlier states for good. Takes a copy of the state.
class ModelEdit
{
public:
  explicit ModelEdit(WrapModel& model)
    : Model(model)
    , Next(std::make_shared<WrapComplex>(*model.current))
    , Editor(*Next, *model.lines)
  {
  }

  const WrapComplex& kept() const { return *this->Next; }

  WrapEditor& editor() { return this->Editor; }

  /// Removes tetrahedra with their free facets; facets shared with a kept tetrahedron become
  /// boundary. Leaves no sheets.
  void removeWhole(std::span<const Index> tets);

  /// Makes the new state the current one, and tells what changed. The edit may have been anything:
  /// the new state is not taken to follow the flow.
  EditReport finish(Execution& execution);

  /// Makes the new state the current one. It follows the flow if the earlier one did: for edits
  /// that collapse all they can.
  void makeCurrent() { this->Model.current = this->Next; }

private:
  WrapModel& Model;
  std::shared_ptr<WrapComplex> Next;
  WrapEditor Editor;
};

/// The triangles that an operation may work on: all of them when none are given.
class Region
{
public:
  Region(const DelaunayComplex& complex, std::span<const Facet> triangles)
    : Complex(complex)
  {
    for (const Facet triangle : triangles)
    {
      this->Names.insert(complex.canonical(triangle));
    }
  }

  bool isEverything() const { return this->Names.empty(); }
  bool contains(Facet triangle) const
  {
    return this->isEverything() || this->Names.contains(this->Complex.canonical(triangle));
  }

private:
  const DelaunayComplex& Complex;
  std::unordered_set<Facet> Names;
};

} // namespace scan
