// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "writers/output_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace scan
{

/// The status of an entity that means nothing without the one that names it.
inline constexpr std::string_view kIgesPart = "00010000";

/// An entity's type and form, and its status: whether it stands alone.
struct IgesKind
{
  std::uint64_t type = 0;
  std::uint64_t form = 0;
  std::string_view status = "00000000"; ///< eight digits
};

/// What the start and the global section say.
struct IgesHeader
{
  std::string_view description; ///< ASCII, at most 72 characters
  std::uint64_t unitFlag = 2;
  std::string_view unitName = "MM";
  double resolution = 1e-6; ///< smallest distance that means something, in units
  double largest = 0.0;     ///< coordinate, its absolute value
};

/// Takes the entities of an IGES file one after another, each between begin() and end(). Entities
/// that others name come first.
class IgesSink
{
public:
  /// A file has a section that lists the entities before the one with what they hold, so it takes
  /// all of them twice.
  enum class Section
  {
    directory,
    parameters
  };

  IgesSink(Section section, std::uint64_t entities, OutputFile& file, Execution& execution);

  void begin(const IgesKind& kind);
  IgesSink& integer(std::uint64_t value);
  IgesSink& real(double value);
  IgesSink& point(const Vec3& point);
  /// The number under which others name the entity.
  std::uint64_t end();

  std::uint64_t directoryLines() const { return 2 * this->Entities; }
  std::uint64_t parameterLines() const { return this->Lines; }

private:
  static constexpr std::size_t kWidth = 64;

  void put(std::string_view parameter);
  void endLine();
  void writeDirectoryEntry();

  Section Current;
  std::uint64_t Expected;
  OutputFile& File;
  Execution& Run;
  IgesKind Kind;
  std::uint64_t Entities = 0;
  std::uint64_t Lines = 0;
  std::uint64_t FirstLine = 0; // of this entity
  std::array<char, kWidth> Text = {};
  std::size_t Column = 0;
};

/// Writes a whole file. Strings and numbers never break across lines.
///
/// Throws Error limit when a section needs more than 9,999,999 lines. Phase "write".
/// @param entities how many `put` puts
/// @param put puts all entities into the sink; called twice
void writeIgesFile(const IgesHeader& header, std::uint64_t entities,
  const std::function<void(IgesSink&)>& put, OutputFile& file, Execution& execution);

} // namespace scan
