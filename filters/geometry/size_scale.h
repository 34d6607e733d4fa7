// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/blocks.h"
#include "filters/geometry/wrap_editor.h"

#include <vector>

namespace scan
{

class ScanComplex;

/// All wraps between the Wrap complex (size infinite) and nothing (size 0), sorted once: at size R
/// everything is removed that one reaches from outside through doors wider than R, and every sheet
/// block wider than R. From one size to another the cost follows what changes.
class SizeScale
{
public:
  SizeScale(const ScanComplex& scan, const Blocks& blocks, Execution& execution);

  /// Turns the wrap of size `from` into that of size `to`.
  /// @param complex that the editor edits
  void resize(WrapEditor& editor, const WrapComplex& complex, double from, double to,
    Execution& execution) const;

private:
  struct Entry
  {
    double radius;
    Index name;
  };

  void open(WrapEditor& editor, const WrapComplex& complex, double from, double to,
    Execution& execution) const;

  CriticalChoice choiceOf(
    const CollapseGraph& graph, const WrapComplex& complex, double from, double to) const;

  const ScanComplex& Scan;
  const Blocks& TheBlocks;
  std::vector<Entry> Openings;  ///< of volume blocks, from wide to narrow
  std::vector<Entry> Triangles; ///< critical triangles, from wide to narrow
};

} // namespace scan
