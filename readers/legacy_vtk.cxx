// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/legacy_vtk.h"

#include "filters/base/error.h"
#include "filters/geometry/polygon.h"
#include "readers/coordinate_check.h"
#include "readers/legacy_vtk_scanner.h"
#include "readers/point_attributes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace scan
{
namespace
{

constexpr std::string_view kSignature = "# vtk DataFile Version";

/// Reads the sections of a legacy VTK file into a model.
class LegacyVtkReader
{
public:
  LegacyVtkReader(const Source& source, Execution& execution)
    : Scan(source, execution)
  {
  }

  Model read()
  {
    this->Scan.readHead();
    for (std::string keyword = this->Scan.lowerWord(); !keyword.empty();
         keyword = this->Scan.lowerWord())
    {
      if (!this->readSection(keyword) && !this->readAttribute(keyword))
      {
        if (this->Place == Owner::none)
        {
          this->Scan.fail("expected a section of PolyData, found " + quoted(keyword));
        }
        this->Scan.skipToEnd();
      }
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  enum class Owner
  {
    none,
    points,
    cells
  };

  enum class Cells
  {
    vertices,
    lines,
    polygons,
    strips
  };

  bool readSection(const std::string& keyword)
  {
    if (keyword == "dataset")
    {
      if (const std::string kind = this->Scan.lowerWord(); kind != "polydata")
      {
        this->Scan.fail("the data set is " + quoted(kind) + "; only POLYDATA can be read");
      }
    }
    else if (keyword == "points")
    {
      this->readPoints();
    }
    else if (keyword == "vertices")
    {
      this->readCells(Cells::vertices);
    }
    else if (keyword == "lines")
    {
      this->readCells(Cells::lines);
    }
    else if (keyword == "polygons")
    {
      this->readCells(Cells::polygons);
    }
    else if (keyword == "triangle_strips")
    {
      this->readCells(Cells::strips);
    }
    else if (keyword == "metadata")
    {
      this->Scan.skipMetadata();
    }
    else if (keyword == "field")
    {
      this->readFields();
    }
    else if (keyword == "point_data" || keyword == "cell_data")
    {
      this->Place = keyword == "point_data" ? Owner::points : Owner::cells;
      this->Rows = this->Scan.readCount();
      if (this->Place == Owner::points && this->Rows != this->Result.points.size())
      {
        this->Scan.fail("data of " + std::to_string(this->Rows) + " points, but there are " +
          std::to_string(this->Result.points.size()));
      }
    }
    else
    {
      return false;
    }
    return true;
  }

  void readPoints()
  {
    const std::size_t count = this->Scan.readCount();
    const VtkNumberType type = this->Scan.readType();
    std::vector<Vec3>& points = this->Result.points;
    if (!points.empty())
    {
      this->Scan.fail("a second section of points");
    }
    this->Scan.text().checkPointCount(count);
    this->Scan.readVectors(count, type,
      [&](const Vec3& point, const char* at)
      {
        points.push_back(point);
        this->Check.see(point, at);
      });
  }

  std::vector<std::int64_t> readIds(std::size_t count, const VtkNumberType& type)
  {
    std::vector<std::int64_t> ids;
    this->Scan.readValues(count, 1, type,
      [&](double value, const char*)
      {
        const bool isId = value >= 0.0 && value < static_cast<double>(kNone) * 16.0;
        ids.push_back(isId ? static_cast<std::int64_t>(value) : -1);
      });
    return ids;
  }

  void readCells(Cells kind)
  {
    const std::size_t first = this->Scan.readCount();
    const std::size_t second = this->Scan.readCount();
    if (this->Scan.takeWord("offsets")) // version 5
    {
      const std::vector<std::int64_t> offsets = this->readIds(first, this->Scan.readType());
      if (!this->Scan.takeWord("connectivity"))
      {
        this->Scan.fail("expected CONNECTIVITY");
      }
      const std::vector<std::int64_t> ids = this->readIds(second, this->Scan.readType());
      for (std::size_t i = 1; i < offsets.size(); ++i)
      {
        const std::int64_t start = offsets[i - 1];
        if (start < 0 || offsets[i] < start || offsets[i] > static_cast<std::int64_t>(ids.size()))
        {
          this->failOnFace(i - 1);
        }
        this->addCell(kind, i - 1,
          std::span(ids).subspan(
            static_cast<std::size_t>(start), static_cast<std::size_t>(offsets[i] - start)));
      }
      return;
    }
    const std::vector<std::int64_t> numbers = this->readIds(second, *vtkNumberType("int"));
    std::size_t at = 0;
    for (std::size_t i = 0; i < first; ++i)
    {
      if (at >= numbers.size() || numbers[at] < 0 ||
        numbers[at] >= static_cast<std::int64_t>(numbers.size() - at))
      {
        this->failOnFace(i);
      }
      const auto size = static_cast<std::size_t>(numbers[at]);
      this->addCell(kind, i, std::span(numbers).subspan(at + 1, size));
      at += 1 + size;
    }
  }

  [[noreturn]] void failOnFace(std::size_t number) const
  {
    this->Scan.fail("cell " + std::to_string(number) + " is not within the list of its section");
  }

  void addCell(Cells kind, std::size_t number, std::span<const std::int64_t> ids)
  {
    if (kind == Cells::vertices)
    {
      return;
    }
    const auto count = static_cast<std::int64_t>(this->Result.points.size());
    this->Cell.clear();
    for (const std::int64_t id : ids)
    {
      if (id < 0 || id >= count)
      {
        this->Scan.fail("cell " + std::to_string(number) + " names point " +
          (id < 0 ? "-1" : std::to_string(id)) + ", but there are " + std::to_string(count) +
          ", counted from 0");
      }
      this->Cell.push_back(static_cast<Index>(id));
    }
    if (kind == Cells::lines)
    {
      std::vector<Index>& corners = this->Result.curves.corners;
      corners.insert(corners.end(), this->Cell.begin(), this->Cell.end());
      this->Result.curves.endLine();
    }
    else if (kind == Cells::polygons)
    {
      appendPolygon(this->Result.triangles, this->Result.points, this->Cell);
    }
    else
    {
      appendStrip(this->Result.triangles, this->Cell);
    }
  }

  void readFields()
  {
    this->Scan.nextWord(); // the name of the field
    for (std::size_t count = this->Scan.readCount(); count > 0; --count)
    {
      if (this->Scan.takeWord("metadata"))
      {
        this->Scan.skipMetadata();
      }
      const std::string_view name = this->Scan.nextWord();
      if (name.empty())
      {
        this->Scan.fail("the file ends early: a field is missing");
      }
      if (name == "NULL_ARRAY")
      {
        continue;
      }
      const std::size_t columns = this->Scan.readCount();
      const std::size_t rows = this->Scan.readCount();
      const std::string type = this->Scan.lowerWord();
      if (type == "string")
      {
        this->Scan.skipStrings(rows, columns);
        continue;
      }
      const std::optional<VtkNumberType> known = vtkNumberType(type);
      if (!known && this->Place != Owner::none)
      {
        this->Scan.skipToEnd();
        return;
      }
      if (!known)
      {
        this->Scan.fail("fields of type " + quoted(type) + " cannot be read");
      }
      const bool isUnit = this->Place == Owner::none && name == "MillimetresPerUnit";
      this->Scan.readValues(rows, columns, *known,
        [&](double value, const char*)
        {
          if (isUnit && value > 0.0 && std::isfinite(value))
          {
            this->Result.millimetresPerUnit = value;
          }
        });
    }
  }

  /// False for what is not known or not among the data of points and cells.
  bool readAttribute(const std::string& keyword)
  {
    if (this->Place == Owner::none)
    {
      return false;
    }
    if (keyword == "lookup_table")
    {
      this->Scan.nextWord();
      const std::size_t rows = this->Scan.readCount();
      this->skip(rows, 4, *vtkNumberType("unsigned_char"));
      return true;
    }
    static constexpr std::pair<std::string_view, std::size_t> kColumns[] = { { "scalars", 0 },
      { "color_scalars", 0 }, { "texture_coordinates", 0 }, { "normals", 3 }, { "vectors", 3 },
      { "tensors", 9 }, { "tensors6", 6 }, { "global_ids", 1 }, { "pedigree_ids", 1 } };
    const auto* const row =
      std::ranges::find(kColumns, keyword, &std::pair<std::string_view, std::size_t>::first);
    if (row == std::end(kColumns))
    {
      return false;
    }
    this->Scan.nextWord(); // the name
    if (keyword == "color_scalars")
    {
      this->readColors(this->Scan.readCount());
      return true;
    }
    const std::size_t columns =
      keyword == "texture_coordinates" ? this->Scan.readCount() : row->second;
    const std::optional<VtkNumberType> type = vtkNumberType(this->Scan.lowerWord());
    if (!type)
    {
      return false;
    }
    if (keyword == "normals" && this->Place == Owner::points)
    {
      this->readNormals(*type);
      return true;
    }
    this->skip(this->Rows, keyword == "scalars" ? this->scalarColumns() : columns, *type);
    return true;
  }

  /// The columns of SCALARS, and the line of their table.
  std::size_t scalarColumns()
  {
    const std::string columns = this->Scan.lowerWordOnLine();
    if (!this->Scan.takeWord("lookup_table"))
    {
      this->Scan.fail("expected LOOKUP_TABLE");
    }
    this->Scan.nextWord();
    return columns.size() == 1 && columns[0] >= '1' && columns[0] <= '4'
      ? static_cast<std::size_t>(columns[0] - '0')
      : 1;
  }

  void skip(std::size_t rows, std::size_t columns, const VtkNumberType& type)
  {
    this->Scan.readValues(rows, columns, type, [](double, const char*) {});
  }

  void readColors(std::size_t columns)
  {
    const bool isWanted = this->Place == Owner::points && columns >= 3;
    const double scale = this->Scan.isBinary() ? 1.0 : 255.0; // text has 0 to 1
    std::vector<Color>& colors = this->Result.colors;
    colors.resize(isWanted ? 0 : colors.size());
    Color color = {};
    std::size_t channel = 0;
    this->Scan.readValues(this->Rows, columns, *vtkNumberType("unsigned_char"),
      [&](double value, const char*)
      {
        if (channel < 3)
        {
          color[channel] = isChannel(scale * value) ? toChannel(scale * value) : 255;
        }
        channel = (channel + 1) % columns;
        if (channel == 0 && isWanted)
        {
          colors.push_back(color);
        }
      });
  }

  void readNormals(const VtkNumberType& type)
  {
    std::vector<Vec3>& normals = this->Result.normals;
    normals.clear();
    this->Scan.readVectors(this->Rows, type,
      [&](const Vec3& normal, const char*) { normals.push_back(unitOrZero(normal)); });
  }

  void finish()
  {
    const Source& text = this->Scan.text();
    const std::size_t count = this->Result.points.size();
    if (count == 0)
    {
      text.fail("no points found; a legacy VTK file of PolyData has a line 'POINTS n type'");
    }
    this->Check.finish(text, this->Result,
      this->Scan.isBinary() ? CoordinateCheck::Place::byte : CoordinateCheck::Place::line);
  }

  VtkScanner Scan;
  Model Result;
  std::vector<Index> Cell; // the points of the last one
  CoordinateCheck Check;
  Owner Place = Owner::none;
  std::size_t Rows = 0; // of the attributes
};

} // namespace

Model parseLegacyVtk(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  if (!looksLikeLegacyVtk(bytes))
  {
    source.fail("not a legacy VTK file: it does not start with '# vtk DataFile Version'");
  }
  return LegacyVtkReader(source, execution).read();
}

bool looksLikeLegacyVtk(std::span<const char> head)
{
  return std::string_view(head.data(), head.size()).starts_with(kSignature);
}

} // namespace scan
