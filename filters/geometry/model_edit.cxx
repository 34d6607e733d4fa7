// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/model_edit.h"

namespace scan
{

void ModelEdit::removeWhole(std::span<const Index> tets)
{
  this->Next->setFollowsFlow(false);
  for (const Index tet : tets)
  {
    this->Editor.removeTet(tet);
  }
  for (const Index tet : tets)
  {
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      if (this->Next->isSheet(facet))
      {
        this->Editor.removeSheet(facet);
      }
    }
  }
}

EditReport ModelEdit::finish(Execution& execution)
{
  this->Next->setFollowsFlow(false);
  EditReport report{ .change = this->Editor.change(),
    .surface = compareSurfaces(*this->Model.current, *this->Next, execution) };
  this->makeCurrent();
  return report;
}

} // namespace scan
