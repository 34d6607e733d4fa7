// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ply.h"

#include "filters/base/error.h"
#include "filters/geometry/polygon.h"
#include "readers/coordinate_check.h"
#include "readers/ply_body.h"
#include "readers/ply_header.h"
#include "readers/ply_vertices.h"

#include <algorithm>

namespace scan
{
namespace
{

constexpr std::uint64_t kStep = 1U << 16U;

/// Fills a model from the values of a PLY file.
template <class Body>
class PlyLoader
{
public:
  PlyLoader(
    const Source& source, const PlyHeader& header, bool joinsRangeGrid, Execution& execution)
    : Input(source)
    , Header(header)
    , JoinsRangeGrid(joinsRangeGrid)
    , Run(execution)
    , Values(source, header.size)
  {
  }

  Model load()
  {
    for (const PlyElement& element : this->Header.elements)
    {
      this->VertexCount = element.name == "vertex" ? element.count : this->VertexCount;
    }
    this->Input.checkPointCount(this->VertexCount);
    this->checkCounts();
    for (const PlyElement& element : this->Header.elements)
    {
      if (element.name == "vertex")
      {
        this->loadVertices(element);
      }
      else if (element.name == "face" || element.name == "tristrips")
      {
        this->loadFaces(element);
      }
      else if (element.name == "range_grid" && this->JoinsRangeGrid)
      {
        this->loadRangeGrid(element);
      }
      else
      {
        this->forEach(element, [&] { this->skipAll(element); });
      }
    }
    appendPolygons(this->Mesh.triangles, this->Mesh.points, this->Waiting);
    this->Check.finish(this->Input, this->Mesh,
      this->Header.encoding == PlyEncoding::ascii ? CoordinateCheck::Place::line
                                                  : CoordinateCheck::Place::byte);
    return std::move(this->Mesh);
  }

private:
  /// No storage is reserved for elements that cannot be in the file.
  void checkCounts() const
  {
    std::uint64_t left = this->Values.left(PlyType::uint8);
    for (const PlyElement& element : this->Header.elements)
    {
      const std::uint64_t least = this->Values.leastSize(element);
      if (least > 0 && element.count > left / least)
      {
        this->Values.fail("the header announces " + std::to_string(element.count) + " of '" +
          element.name + "', more than the file can hold; it is truncated");
      }
      left -= element.count * least;
    }
  }

  template <class Read>
  void forEach(const PlyElement& element, const Read& read)
  {
    if (element.properties.empty())
    {
      return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i)
    {
      if (i % kStep == 0)
      {
        this->Run.step("read",
          static_cast<std::size_t>(this->Values.position() - this->Input.begin()),
          this->Input.bytes.size());
      }
      read();
    }
  }

  void skip(const PlyProperty& property)
  {
    this->Values.skip(property.type, property.isList ? this->listLength(property) : 1);
  }

  void skipAll(const PlyElement& element)
  {
    for (const PlyProperty& property : element.properties)
    {
      this->skip(property);
    }
  }

  std::uint64_t listLength(const PlyProperty& list)
  {
    const std::int64_t length = this->Values.integer(list.countType);
    if (length < 0 || static_cast<std::uint64_t>(length) > this->Values.left(list.type))
    {
      this->Values.fail("a list of " + std::to_string(length) +
        " values does not fit the file; it is truncated or malformed");
    }
    return static_cast<std::uint64_t>(length);
  }

  void loadVertices(const PlyElement& element)
  {
    PlyVertices vertices(this->Input, element, this->Mesh);
    PlyVertices::Values values = {};
    this->forEach(element,
      [&]
      {
        const char* const at = this->Values.position();
        this->readVertex(element, vertices, values);
        vertices.add(values);
        this->Check.see(this->Mesh.points.back(), at);
      });
    vertices.finish();
  }

  void readVertex(
    const PlyElement& element, const PlyVertices& vertices, PlyVertices::Values& values)
  {
    if constexpr (Body::kHasRecords) // fast: nothing is looked at that is not wanted
    {
      const std::size_t size = vertices.recordSize();
      if (size > 0 && this->Values.hasBytes(size))
      {
        for (const auto& [place, offset, type] : vertices.fields())
        {
          values[place] = this->Values.realAt(offset, type);
        }
        this->Values.advance(size);
        return;
      }
    }
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const std::size_t place = vertices.places()[p];
      if (place != PlyVertices::ignored)
      {
        values[place] = this->Values.real(element.properties[p].type);
      }
      else
      {
        this->skip(element.properties[p]);
      }
    }
  }

  void loadFaces(const PlyElement& element)
  {
    const std::size_t named = element.find("vertex_indices");
    const std::size_t corners =
      named < element.properties.size() ? named : element.find("vertex_index");
    if (corners == element.properties.size() || !element.properties[corners].isList)
    {
      this->forEach(element, [&] { this->skipAll(element); });
      return;
    }
    const bool isStrips = element.name == "tristrips";
    this->Mesh.triangles.reserve(element.count);
    this->forEach(element,
      [&]
      {
        for (std::size_t p = 0; p < element.properties.size(); ++p)
        {
          if (p != corners)
          {
            this->skip(element.properties[p]);
          }
          else if (isStrips)
          {
            this->loadStrips(element.properties[p]);
          }
          else
          {
            this->loadPolygon(element.properties[p]);
          }
        }
      });
  }

  /// Doubling the room would take much memory for a large file: it ends where the file must.
  /// @param next triangles that need it
  /// @param most triangles that can follow them
  void makeRoom(std::uint64_t next, std::uint64_t most)
  {
    std::vector<Triangle>& all = this->Mesh.triangles;
    if (all.size() + next > all.capacity())
    {
      const std::uint64_t bound = all.size() + next + most;
      const std::uint64_t wanted = std::max(2 * all.size() + 64, all.size() + next);
      all.reserve(4 * all.size() < bound ? std::min(wanted, bound) : bound);
    }
  }

  void addTriangle(const Triangle& triangle, std::uint64_t most)
  {
    this->makeRoom(1, most);
    this->Mesh.triangles.push_back(triangle);
  }

  void loadPolygon(const PlyProperty& list)
  {
    if constexpr (Body::kHasRecords) // fast: the usual triangle, checked as a whole
    {
      constexpr std::uint64_t kNegative = std::uint64_t(1) << 31U; // and above, if signed
      Triangle corners = {};
      if (this->Values.peekTriangle(list, corners) &&
        std::max({ corners[0], corners[1], corners[2] }) < std::min(this->VertexCount, kNegative))
      {
        this->Values.advance(Body::kTriangleSize);
        this->Mesh.triangles.push_back(corners);
        return;
      }
    }
    const std::uint64_t length = this->listLength(list);
    this->Polygon.clear();
    for (std::uint64_t i = 0; i < length; ++i)
    {
      this->Polygon.push_back(this->vertexIndex(this->Values.integer(list.type)));
    }
    if (length > 3 && this->Mesh.points.size() < this->VertexCount) // faces ahead of the vertices
    {
      std::vector<Index>& corners = this->Waiting.corners;
      corners.insert(corners.end(), this->Polygon.begin(), this->Polygon.end());
      this->Waiting.endLine();
      return;
    }
    this->makeRoom(length, this->Values.left(list.type));
    appendPolygon(this->Mesh.triangles, this->Mesh.points, this->Polygon);
  }

  void loadStrips(const PlyProperty& list)
  {
    const std::uint64_t length = this->listLength(list);
    Triangle last = {};
    std::uint64_t used = 0; // corners of the current strip
    for (std::uint64_t i = 0; i < length; ++i)
    {
      const std::int64_t value = this->Values.integer(list.type);
      if (value == -1)
      {
        used = 0;
        continue;
      }
      last = { last[1], last[2], this->vertexIndex(value) };
      if (++used >= 3)
      {
        this->addTriangle(used % 2 == 1 ? last : Triangle{ last[1], last[0], last[2] },
          this->Values.left(list.type));
      }
    }
  }

  /// The cells are row after row; each lists no vertex, or its vertices with the best first.
  void loadRangeGrid(const PlyElement& element)
  {
    const std::uint64_t columns = this->Header.columns;
    const std::size_t list = element.find("vertex_indices");
    if (columns == 0 || element.count % columns != 0 ||
      element.count / columns != this->Header.rows || list == element.properties.size() ||
      !element.properties[list].isList)
    {
      this->Input.fail("the range_grid has " + std::to_string(element.count) +
        " cells, but obj_info num_cols and num_rows say " + std::to_string(columns) + " x " +
        std::to_string(this->Header.rows) + "; load the points without a mesh");
    }
    this->Mesh.triangles.reserve(
      this->Mesh.triangles.size() + 2 * std::min(element.count, this->VertexCount));
    std::vector<Index> below;
    std::vector<Index> row;
    this->forEach(element,
      [&]
      {
        row.push_back(kNone);
        for (std::size_t p = 0; p < element.properties.size(); ++p)
        {
          if (p == list)
          {
            row.back() = this->firstVertex(element.properties[p]);
          }
          else
          {
            this->skip(element.properties[p]);
          }
        }
        if (row.size() == columns)
        {
          this->joinRows(below, row);
          below.swap(row);
          row.clear();
        }
      });
  }

  /// The first vertex of a list, kNone when it is empty.
  Index firstVertex(const PlyProperty& list)
  {
    const std::uint64_t length = this->listLength(list);
    if (length == 0)
    {
      return kNone;
    }
    const Index first = this->vertexIndex(this->Values.integer(list.type));
    this->Values.skip(list.type, length - 1);
    return first;
  }

  void joinRows(const std::vector<Index>& below, const std::vector<Index>& above)
  {
    for (std::size_t i = 0; i + 1 < below.size(); ++i)
    {
      if (below[i] != kNone && below[i + 1] != kNone && above[i] != kNone && above[i + 1] != kNone)
      {
        // a cell takes two bytes
        const std::uint64_t most = this->Values.left(PlyType::uint8) + 2 * (below.size() - i);
        this->addTriangle({ below[i], below[i + 1], above[i + 1] }, most);
        this->addTriangle({ below[i], above[i + 1], above[i] }, most);
      }
    }
  }

  Index vertexIndex(std::int64_t value) const
  {
    if (value < 0 || static_cast<std::uint64_t>(value) >= this->VertexCount)
    {
      this->Values.fail("a face refers to vertex " + std::to_string(value) + ", but there are " +
        std::to_string(this->VertexCount) + ", counted from 0");
    }
    return static_cast<Index>(value);
  }

  const Source& Input;
  const PlyHeader& Header;
  const bool JoinsRangeGrid;
  Execution& Run;
  Body Values;
  std::uint64_t VertexCount = 0;
  Model Mesh;
  std::vector<Index> Polygon; // the corners of the last one
  Polylines Waiting;          // polygons ahead of their points
  CoordinateCheck Check;
};

Model parse(
  std::span<const char> bytes, std::string_view name, bool joinsRangeGrid, Execution& execution)
{
  const Source source{ name, bytes };
  const PlyHeader header = parsePlyHeader(source);
  switch (header.encoding)
  {
    case PlyEncoding::littleEndian:
      return PlyLoader<PlyBinaryBody<std::endian::little>>(
        source, header, joinsRangeGrid, execution)
        .load();
    case PlyEncoding::bigEndian:
      return PlyLoader<PlyBinaryBody<std::endian::big>>(source, header, joinsRangeGrid, execution)
        .load();
    case PlyEncoding::ascii:
      break;
  }
  return PlyLoader<PlyAsciiBody>(source, header, joinsRangeGrid, execution).load();
}

} // namespace

Model parsePly(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parse(bytes, name, false, execution);
}

Model parsePlyRangeGrid(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parse(bytes, name, true, execution);
}

bool looksLikePly(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const char* const start = skipUtf8Mark(head);
  const char* const stop = findLineEnd(start, end);
  return stop != end && word(start, end) == "ply" && skipBlanks(start + 3, end) == stop;
}

} // namespace scan
