// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/affine.h"
#include "readers/transforms.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace scan
{

/// What came out of a file. Nobody changes the data.
struct InputModel
{
  vtkSmartPointer<vtkPolyData> data;
  std::string name; ///< of the file
  std::string note; ///< one line on what was done to it; empty for nothing
};

/// A list that places scans, see readers/transforms.h.
class TransformList
{
public:
  /// Throws Error io or parse.
  explicit TransformList(const std::string& path);

  /// Where the list puts a file. Throws Error badInput when it says nothing about it.
  const Affine& placeOf(const std::string& file) const;

private:
  std::string Path;
  std::vector<ScanTransform> Transforms;
};

/// The model with a unit for its coordinates, which stay as they are. A model that has one keeps
/// it, and the note says so when it is another one.
InputModel withUnit(InputModel model, double millimetres);

/// The model in another place: its points and normals moved, triangles and strips turned over by a
/// mirror. The place is in the unit of the model.
InputModel placed(InputModel model, const Affine& place);

/// One model with the points and cells of all parts, in their order. Points stay double. Units are
/// converted to that of the first part. Where only some parts have colours or normals, the others
/// are white and have normals of length 0; other point arrays are kept when every part has them.
/// The parts keep their names, see arrays::kScanFileNames. A single part is returned as it is.
///
/// @throws Error{badInput} when only some of the parts have a unit; Error{limit} for more points
///   than Index can count
InputModel mergeModels(const std::vector<InputModel>& parts);

/// The model with the points and cells of one more file behind its own, as mergeModels() merges. A
/// part without a unit is taken to be in that of the model. Scan-point ids and the files they come
/// from go on behind those of the model; what a model of a single file comes from is called
/// "model", and points that were added since are a file of their own, "added points".
///
/// @throws Error{badInput} when only the part has a unit; Error{limit} as mergeModels()
InputModel appendModel(const InputModel& model, InputModel part);

} // namespace scan
