// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pcd.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/lzf.h"
#include "readers/pcd_header.h"
#include "readers/pcd_values.h"
#include "readers/point_attributes.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <array>
#include <string>

namespace scan
{
namespace
{

constexpr std::uint64_t kStep = 1U << 16U;
constexpr std::uint64_t kMemoryPerByte = 20;
constexpr std::uint64_t kFreeMemory = std::uint64_t(64) << 20U;
constexpr std::size_t kNoField = ~std::size_t(0);

/// What values of a point mean: its coordinates, its normal, its colour.
constexpr std::array<const char*, 7> kRoles = { "x", "y", "z", "normal_x", "normal_y", "normal_z",
  "rgb" };
constexpr std::size_t kNormalX = 3;
constexpr std::size_t kColor = 6;

struct PointValues
{
  std::array<double, kColor> reals = {};
  std::uint32_t color = 0;
};

/// Fills a model from the body of a PCD file.
class PcdLoader
{
public:
  PcdLoader(const Source& source, const PcdHeader& header, Execution& execution)
    : Input(source)
    , Header(header)
    , Run(execution)
    , Left(static_cast<std::uint64_t>(source.end() - header.body))
  {
    this->findRoles();
  }

  Model load()
  {
    this->Input.checkPointCount(this->Header.points);
    switch (this->Header.encoding)
    {
      case PcdEncoding::ascii:
        this->loadText();
        break;
      case PcdEncoding::binary:
        this->loadRecords();
        break;
      case PcdEncoding::compressed:
        this->loadCompressed();
        break;
    }
    if (this->Result.points.empty())
    {
      this->Input.fail("no point with coordinates; there is nothing to load");
    }
    this->Check.finish(this->Input, this->Result,
      this->Header.encoding == PcdEncoding::ascii ? CoordinateCheck::Place::line
                                                  : CoordinateCheck::Place::byte);
    return std::move(this->Result);
  }

private:
  void findRoles()
  {
    const std::size_t none = this->Header.fields.size();
    for (std::size_t role = 0; role < kRoles.size(); ++role)
    {
      const std::size_t field = this->Header.find(kRoles[role]);
      this->Roles[role] = field != none ? field : kNoField;
    }
    if (this->Roles[0] == kNoField || this->Roles[1] == kNoField || this->Roles[2] == kNoField)
    {
      this->Input.fail("the PCD file lacks one of the fields x, y, z");
    }
    this->HasNormals = std::none_of(this->Roles.begin() + kNormalX, this->Roles.begin() + kColor,
      [](std::size_t field) { return field == kNoField; });
    std::size_t& color = this->Roles[kColor];
    if (color == kNoField && this->Header.find("rgba") != none)
    {
      color = this->Header.find("rgba");
    }
    this->HasColors = color != kNoField && this->Header.fields[color].size == 4;
  }

  /// The roles that points of this file have.
  template <class Use>
  void forEachRole(const Use& use) const
  {
    for (std::size_t role = 0; role < kRoles.size(); ++role)
    {
      if (role < kNormalX || (role == kColor ? this->HasColors : this->HasNormals))
      {
        use(role, this->Roles[role]);
      }
    }
  }

  void reserve()
  {
    this->Result.points.reserve(this->Header.points);
    this->Result.normals.reserve(this->HasNormals ? this->Header.points : 0);
    this->Result.colors.reserve(this->HasColors ? this->Header.points : 0);
  }

  void add(const PointValues& values, const char* at)
  {
    const auto& [x, y, z, normalX, normalY, normalZ] = values.reals;
    this->Result.points.push_back({ x, y, z });
    this->Check.see(this->Result.points.back(), at);
    if (this->HasNormals)
    {
      this->Result.normals.push_back(unitOrZero({ normalX, normalY, normalZ }));
    }
    if (this->HasColors)
    {
      const std::uint32_t color = values.color;
      this->Result.colors.push_back({ static_cast<std::uint8_t>(color >> 16U & 255U),
        static_cast<std::uint8_t>(color >> 8U & 255U), static_cast<std::uint8_t>(color & 255U) });
    }
  }

  void loadText()
  {
    const std::size_t columns = this->Header.pointColumns();
    if (this->Header.points > (this->Left + 1) / (2 * columns))
    {
      this->failAtEnd((this->Left + 1) / (2 * columns));
    }
    this->reserve();
    std::vector<std::size_t> columnRoles(columns, kNoField);
    this->forEachRole(
      [&](std::size_t role, std::size_t field) { columnRoles[this->columnOf(field)] = role; });
    const char* const end = this->Input.end();
    const char* at = skipSpace(this->Header.body, end);
    for (std::uint64_t i = 0; i < this->Header.points; ++i)
    {
      if (at == end)
      {
        this->failAtEnd(i);
      }
      if (i % kStep == 0)
      {
        this->Run.step(
          "read", static_cast<std::size_t>(at - this->Input.begin()), this->Input.bytes.size());
      }
      at = skipSpace(this->loadLine(at, columnRoles), end);
    }
    if (at != end)
    {
      this->Input.failAtLine(at,
        "more lines follow than the " + std::to_string(this->Header.points) +
          " points that the header announces");
    }
  }

  const char* loadLine(const char* at, const std::vector<std::size_t>& columnRoles)
  {
    const char* const end = this->Input.end();
    const char* const line = at;
    PointValues values;
    for (const std::size_t role : columnRoles)
    {
      at = skipBlanks(at, end);
      double value = 0.0;
      const char* stop = at;
      if (role != kNoField)
      {
        stop = parseNumber(at, end, value);
      }
      else
      {
        stop = at + word(at, end).size();
      }
      if (stop == nullptr || stop == at || (stop != end && !isBlank(*stop) && !isLineEnd(*stop)))
      {
        this->Input.failAtLine(line,
          "expected " + std::to_string(columnRoles.size()) + " numbers for a point, found " +
            quoted(word(at, end)));
      }
      if (role == kColor)
      {
        values.color = colorBits(value, this->Header.fields[this->Roles[kColor]].type);
      }
      else if (role != kNoField)
      {
        values.reals[role] = value;
      }
      at = stop;
    }
    this->add(values, line);
    return nextLine(at, end);
  }

  /// The first of a field's columns in text.
  std::size_t columnOf(std::size_t field) const
  {
    std::size_t column = 0;
    for (std::size_t i = 0; i < field; ++i)
    {
      column += this->Header.fields[i].count;
    }
    return column;
  }

  /// Where a field starts in a binary point.
  std::size_t offsetOf(std::size_t field) const
  {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < field; ++i)
    {
      offset += this->Header.fields[i].size * this->Header.fields[i].count;
    }
    return offset;
  }

  void loadRecords()
  {
    const std::size_t size = this->Header.pointSize();
    if (this->Header.points > this->Left / size)
    {
      this->failAtEnd(this->Left / size);
    }
    this->forEachRole(
      [&](std::size_t role, std::size_t field)
      {
        this->Starts[role] = this->Header.body + this->offsetOf(field);
        this->Strides[role] = size;
      });
    this->loadColumns(false);
  }

  void loadCompressed()
  {
    constexpr std::size_t kSizes = 8; // packed and unpacked, in front of the data
    if (this->Left < kSizes)
    {
      this->Input.fail("the file ends in front of its compressed data; it is truncated");
    }
    std::uint32_t packed = 0;
    std::uint32_t unpacked = 0;
    std::memcpy(&packed, this->Header.body, sizeof(packed));
    std::memcpy(&unpacked, this->Header.body + sizeof(packed), sizeof(unpacked));
    const char* const data = this->Header.body + kSizes;
    if (packed > this->Left - kSizes)
    {
      this->Input.failAtByte(data, "the compressed data are cut off; the file is truncated");
    }
    if (this->Header.points * this->Header.pointSize() != unpacked)
    {
      this->Input.failAtByte(
        this->Header.body, "the size of the compressed data does not match the header");
    }
    this->checkMemory(unpacked);
    std::vector<char> raw(unpacked);
    if (!expandLzf({ data, packed }, raw, this->Run))
    {
      this->Input.failAtByte(data, "the compressed data are malformed");
    }
    this->forEachRole(
      [&](std::size_t role, std::size_t field)
      {
        // field by field: first all values of the first
        this->Starts[role] = raw.data() + this->offsetOf(field) * this->Header.points;
        this->Strides[role] = this->Header.fields[field].size * this->Header.fields[field].count;
      });
    this->loadColumns(true);
  }

  /// Compressed data that expand without bounds would take the machine's memory.
  void checkMemory(std::uint64_t unpacked) const
  {
    const std::uint64_t pointBytes =
      sizeof(Vec3) + (this->HasNormals ? sizeof(Vec3) : 0) + (this->HasColors ? sizeof(Color) : 0);
    if (unpacked + this->Header.points * pointBytes >
      kMemoryPerByte * this->Input.bytes.size() + kFreeMemory)
    {
      throw Error(ErrorCode::limit,
        std::string(this->Input.name) +
          ": the compressed data expand to more than 20 times the file; save it as binary");
    }
  }

  /// Reads the points that Starts and Strides tell.
  void loadColumns(bool isSecondHalf)
  {
    this->reserve();
    const std::uint64_t count = this->Header.points;
    const std::size_t size = this->Header.pointSize();
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (i % kStep == 0)
      {
        this->Run.step("read", isSecondHalf ? count + i : i, isSecondHalf ? 2 * count : count);
      }
      PointValues values;
      this->forEachRole(
        [&](std::size_t role, std::size_t field)
        {
          const char* const at = this->Starts[role] + i * this->Strides[role];
          if (role == kColor)
          {
            values.color = loadColor(at, this->Header.fields[field]);
          }
          else
          {
            values.reals[role] = loadReal(at, this->Header.fields[field]);
          }
        });
      this->add(values, this->Header.body + (isSecondHalf ? 0 : i * size));
    }
  }

  [[noreturn]] void failAtEnd(std::uint64_t found) const
  {
    this->Input.fail("the header announces " + std::to_string(this->Header.points) +
      " points, but the file holds at most " + std::to_string(found) + "; it is truncated");
  }

  const Source& Input;
  const PcdHeader& Header;
  Execution& Run;
  std::uint64_t Left;                                // bytes of the body
  std::array<std::size_t, kRoles.size()> Roles = {}; // their fields
  std::array<const char*, kRoles.size()> Starts = {};
  std::array<std::size_t, kRoles.size()> Strides = {};
  bool HasNormals = false;
  bool HasColors = false;
  Model Result;
  CoordinateCheck Check;
};

} // namespace

Model parsePcd(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  const PcdHeader header = parsePcdHeader(source);
  return PcdLoader(source, header, execution).load();
}

bool looksLikePcd(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const char* at = skipSpace(head.data(), end);
  while (at != end && *at == '#')
  {
    const std::string_view line(at, static_cast<std::size_t>(findLineEnd(at, end) - at));
    if (line.find(".PCD") != line.npos)
    {
      return true;
    }
    at = skipSpace(nextLine(at, end), end);
  }
  const std::string_view first = word(at, end);
  return first == "VERSION" || first == "FIELDS" || first == "COLUMNS";
}

} // namespace scan
