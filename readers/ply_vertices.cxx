// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ply_vertices.h"

#include <algorithm>

namespace scan
{

PlyVertices::PlyVertices(const Source& source, const PlyElement& element, Model& model)
  : Result(model)
  , Before(model.points.size())
  , Places(element.properties.size(), ignored)
{
  if (!this->findGroup(element, { "x", "y", "z" }, coordinate))
  {
    source.fail("the element 'vertex' lacks one of the properties x, y, z");
  }
  this->HasNormals = this->findGroup(element, { "nx", "ny", "nz" }, normal);
  this->HasColors = this->findColors(element);
  this->layOut(element);
  const std::size_t total = this->Before + element.count;
  model.points.reserve(total);
  if (this->HasNormals)
  {
    model.normals.reserve(total);
    model.normals.resize(this->Before);
  }
  if (this->HasRealColors)
  {
    this->Channels.reserve(element.count);
  }
  else if (this->HasWideColors)
  {
    this->Wide.reserve(element.count);
  }
  else if (this->HasColors)
  {
    model.colors.reserve(total);
    model.colors.resize(this->Before, kNoColor);
  }
}

bool PlyVertices::findGroup(
  const PlyElement& element, const std::array<const char*, 3>& names, Place place)
{
  std::array<std::size_t, 3> found = {};
  for (std::size_t i = 0; i < 3; ++i)
  {
    found[i] = element.find(names[i]);
    if (found[i] == element.properties.size() || element.properties[found[i]].isList)
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->Places[found[i]] = static_cast<std::uint8_t>(place + i);
  }
  return true;
}

bool PlyVertices::findColors(const PlyElement& element)
{
  const bool hasColors = this->findGroup(element, { "red", "green", "blue" }, color) ||
    this->findGroup(element, { "diffuse_red", "diffuse_green", "diffuse_blue" }, color);
  this->HasWideColors = hasColors;
  for (std::size_t i = 0; i < this->Places.size(); ++i)
  {
    const PlyType type = element.properties[i].type;
    const bool isColor = this->Places[i] >= color && this->Places[i] < ignored;
    this->HasRealColors =
      this->HasRealColors || (isColor && (type == PlyType::float32 || type == PlyType::float64));
    this->HasWideColors = this->HasWideColors && (!isColor || type == PlyType::uint16);
  }
  return hasColors;
}

void PlyVertices::layOut(const PlyElement& element)
{
  std::size_t offset = 0;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
  {
    const PlyProperty& property = element.properties[i];
    if (this->Places[i] != ignored)
    {
      this->Fields.push_back({ this->Places[i], offset, property.type });
    }
    offset += plySize(property.type);
  }
  this->RecordSize = element.hasList() ? 0 : offset;
}

void PlyVertices::finish()
{
  Model& model = this->Result;
  if (this->HasRealColors)
  {
    const std::vector<Color> found = this->Channels.take(model.points.size() - this->Before);
    if (!found.empty())
    {
      model.colors.resize(this->Before, kNoColor);
      model.colors.insert(model.colors.end(), found.begin(), found.end());
    }
  }
  if (!this->Wide.empty())
  {
    std::uint16_t largest = 0;
    for (const auto& [red, green, blue] : this->Wide)
    {
      largest = std::max({ largest, red, green, blue });
    }
    const unsigned shift = largest > 255 ? 8 : 0;
    model.colors.resize(this->Before, kNoColor);
    for (const auto& wide : this->Wide)
    {
      const auto channel = [&](std::size_t i)
      { return static_cast<std::uint8_t>(wide[i] >> shift); };
      model.colors.push_back({ channel(0), channel(1), channel(2) });
    }
  }
  if (!model.colors.empty())
  {
    model.colors.resize(model.points.size(), kNoColor);
  }
  if (!model.normals.empty())
  {
    model.normals.resize(model.points.size());
  }
}

} // namespace scan
