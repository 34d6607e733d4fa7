// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/scan_complex.h"
#include "pipeline/hash.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

class vtkPolyData;

namespace scan
{

/// What an array is, apart from its values.
struct ArrayShape
{
  std::string type; ///< "float64", "int32", "id", "text", ...
  int components = 1;
  std::int64_t tuples = 0; ///< of texts: bytes

  friend bool operator==(const ArrayShape&, const ArrayShape&) = default;
};

/// Bytes of one value of a type; 1 for texts. Throws Error parse for an unknown type.
std::size_t widthOf(const std::string& type);

/// Bytes of all values. Throws Error parse for a shape that cannot be.
std::size_t sizeOf(const ArrayShape& shape);

/// An array to be stored. The values are in the machine's order, little endian; texts end with a
/// zero byte each.
struct ArrayForm
{
  ArrayShape shape;
  std::span<const char> bytes;
  std::shared_ptr<const void> owner; ///< keeps the bytes
};

/// A data set as named arrays and a few facts: all that makes it again, byte for byte.
///
/// A polygonal model has "points", "verts", "lines", "polys" and "strips", the latter four as
/// NAME.offsets and NAME.connectivity, and "point-data:NAME", "cell-data:NAME", "field-data:NAME".
/// A wrap has "complex.points", "complex.scan-points", "complex.tetrahedra", "complex.mirror",
/// "wrap.start", "wrap.delta", "wrap.lines", "wrap.inside", "wrap.input-ids" instead of the
/// surface, which follows from them; no delta where the first and the current state are equal, see
/// wrap_delta.h. Arrays without values may be missing.
struct DataForm
{
  std::string kind; ///< "polydata" or "wrap"
  std::map<std::string, std::string> facts;
  std::map<std::string, ArrayForm> arrays;
};

/// The form shares the memory of the model, which nobody may change meanwhile.
DataForm formOf(vtkPolyData& model);

/// A form whose values are elsewhere.
struct StoredForm
{
  struct Array
  {
    ArrayShape shape;
    Hash hash; ///< of the values
    std::int64_t place = 0;
  };

  std::string kind;
  std::map<std::string, std::string> facts;
  std::map<std::string, Array> arrays;
};

/// Copies the values of an array, as many bytes as its shape says.
using ReadArray = std::function<void(const StoredForm::Array&, std::span<char>)>;

/// Complexes that are in memory now, by the hash of their arrays: wraps of one scan share theirs.
using LoadedComplexes = std::map<Hash, std::weak_ptr<const ScanComplex>>;

/// The complex that a wrap's form is about.
Hash complexOf(const StoredForm& form);

/// Makes the model again.
/// @throws Error parse when the form cannot be a model
vtkSmartPointer<vtkPolyData> modelOf(
  const StoredForm& form, const ReadArray& read, LoadedComplexes& complexes, Execution& execution);

} // namespace scan
