// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "readers/color_channels.h"
#include "readers/ply_header.h"
#include "readers/point_attributes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scan
{

/// Takes the values of an element "vertex" into a model, one vertex after the other.
class PlyVertices
{
public:
  /// What values mean, and the place that they have in Values.
  enum Place : std::uint8_t
  {
    coordinate = 0, ///< three of each
    normal = 3,
    color = 6,
    ignored = 9
  };

  using Values = std::array<double, ignored>;

  /// A property that is not ignored.
  struct Field
  {
    std::size_t place = 0;
    std::size_t offset = 0; ///< bytes ahead of it in a binary record
    PlyType type = PlyType::float32;
  };

  /// Throws Error parse when the element lacks x, y or z.
  PlyVertices(const Source& source, const PlyElement& element, Model& model);

  /// The places of the element's properties; lists are ignored.
  const std::vector<std::uint8_t>& places() const { return this->Places; }

  const std::vector<Field>& fields() const { return this->Fields; }

  /// Bytes of a binary record, 0 when there are lists in it.
  std::size_t recordSize() const { return this->RecordSize; }

  void add(const Values& values)
  {
    this->Result.points.push_back({ values[0], values[1], values[2] });
    if (this->HasNormals)
    {
      this->Result.normals.push_back(
        unitOrZero({ values[normal], values[normal + 1], values[normal + 2] }));
    }
    if (this->HasColors)
    {
      this->addColor(values[color], values[color + 1], values[color + 2]);
    }
  }

  /// After the last vertex: every point of the model gets a normal and a colour if any has one.
  void finish();

private:
  bool findGroup(const PlyElement& element, const std::array<const char*, 3>& names, Place place);
  bool findColors(const PlyElement& element);
  void layOut(const PlyElement& element);

  void addColor(double red, double green, double blue)
  {
    if (this->HasRealColors)
    {
      this->Channels.add(red, green, blue);
      return;
    }
    if (this->HasWideColors)
    {
      const auto wide = [](double channel) { return static_cast<std::uint16_t>(channel); };
      this->Wide.push_back({ wide(red), wide(green), wide(blue) });
      return;
    }
    const bool isColor = isChannel(red) && isChannel(green) && isChannel(blue);
    this->Result.colors.push_back(
      isColor ? Color{ toChannel(red), toChannel(green), toChannel(blue) } : kNoColor);
  }

  Model& Result;
  std::size_t Before; // points ahead of this element
  std::vector<std::uint8_t> Places;
  std::vector<Field> Fields;
  std::size_t RecordSize = 0;
  bool HasNormals = false;
  bool HasColors = false;
  bool HasRealColors = false; // not in bytes or other integers
  bool HasWideColors = false; // in integers of 16 bits, of which some files use the lower 8 only
  ColorChannels Channels;
  std::vector<std::array<std::uint16_t, 3>> Wide;
};

} // namespace scan
