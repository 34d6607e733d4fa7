// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/las.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/las_unit.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

namespace scan
{
namespace
{

constexpr std::uint64_t kStep = 1U << 16U;
constexpr std::string_view kSignature = "LASF";
constexpr std::size_t kFirstExtendedFormat = 6;

/// What is known about a point format.
struct PointFormat
{
  std::size_t size;  // the least bytes of a record
  std::size_t color; // the byte of red; 0 when there is none
};

constexpr std::array<PointFormat, 11> kFormats = { { { 20, 0 }, { 28, 0 }, { 26, 20 }, { 34, 28 },
  { 57, 0 }, { 63, 28 }, { 30, 0 }, { 36, 30 }, { 38, 30 }, { 59, 0 }, { 67, 30 } } };
constexpr std::size_t kCoordinatesSize = 12;

/// Reads a LAS file, little-endian throughout, into a model.
class LasReader
{
public:
  LasReader(const Source& source, Execution& execution)
    : Input(source)
    , Run(execution)
  {
  }

  Model read()
  {
    this->readHeader();
    this->readRecords();
    this->readPoints();
    if (this->Result.points.empty())
    {
      this->Input.fail(this->Count == 0 ? "the LAS file has no points"
                                        : "all points of the LAS file are withheld");
    }
    if (const std::uint64_t withheld = this->Count - this->Result.points.size(); withheld > 0)
    {
      this->Result.addNote("withheld points left out: " + std::to_string(withheld));
    }
    this->readColors();
    this->Check.finish(this->Input, this->Result, CoordinateCheck::Place::byte);
    return std::move(this->Result);
  }

private:
  template <class T>
  T get(std::uint64_t offset) const
  {
    T value;
    std::memcpy(&value, this->Input.begin() + offset, sizeof(T));
    return value;
  }

  [[noreturn]] void fail(std::uint64_t offset, const std::string& what) const
  {
    this->Input.failAtByte(this->Input.begin() + offset, what);
  }

  void readHeader()
  {
    const std::size_t size = this->Input.bytes.size();
    constexpr std::size_t kVersionEnd = 26;
    if (size < kVersionEnd || !looksLikeLas(this->Input.bytes))
    {
      this->Input.fail("this is no LAS file; one starts with LASF");
    }
    const auto major = this->get<std::uint8_t>(24);
    this->Minor = this->get<std::uint8_t>(25);
    if (major != 1 || this->Minor > 4)
    {
      this->fail(24,
        "version " + std::to_string(major) + "." + std::to_string(this->Minor) +
          " of LAS is not known; export the points as LAS 1.4");
    }
    const std::size_t least = this->Minor == 4 ? 375 : this->Minor == 3 ? 235 : 227;
    if (size < least)
    {
      this->Input.fail("the file ends in the header; it is truncated");
    }
    this->HeaderSize = this->get<std::uint16_t>(94);
    this->Start = this->get<std::uint32_t>(96);
    if (this->HeaderSize < least || this->Start < this->HeaderSize || this->Start > size)
    {
      this->fail(94, "the header's size or the place of the points is impossible");
    }
    this->readPointFormat();
    this->Count = this->get<std::uint32_t>(107);
    if (this->Minor == 4 && this->get<std::uint64_t>(247) != 0)
    {
      this->Count = this->get<std::uint64_t>(247);
    }
    const std::uint64_t room = (size - this->Start) / this->RecordSize;
    if (this->Count > room)
    {
      this->Input.fail("the header announces " + std::to_string(this->Count) +
        " points, but the file holds " + std::to_string(room) + "; it is truncated");
    }
    this->Input.checkPointCount(this->Count);
    this->readScale();
  }

  void readPointFormat()
  {
    const auto format = this->get<std::uint8_t>(104);
    if ((format & 0xc0U) != 0)
    {
      this->Input.fail("this LAS file is compressed (LAZ), which is not read; decompress it to LAS "
                       "first, for example with laszip or pdal translate");
    }
    this->Format = format;
    this->RecordSize = this->get<std::uint16_t>(105);
    const bool isKnown = this->Format < kFormats.size();
    if (this->RecordSize < (isKnown ? kFormats[this->Format].size : kCoordinatesSize))
    {
      this->fail(105,
        "records of " + std::to_string(this->RecordSize) +
          " bytes are too short for points of format " + std::to_string(format));
    }
    this->ColorOffset = isKnown ? kFormats[this->Format].color : 0;
  }

  void readScale()
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Scale[axis] = this->get<double>(131 + 8 * axis);
      this->Offset[axis] = this->get<double>(155 + 8 * axis);
      if (!std::isfinite(this->Scale[axis]) || this->Scale[axis] == 0.0 ||
        !std::isfinite(this->Offset[axis]))
      {
        this->fail(131, "the scale or the offset of the coordinates is impossible");
      }
    }
  }

  /// Finds the unit in the variable length records. Real files get their number and sizes wrong,
  /// which is no reason to refuse the points.
  void readRecords()
  {
    constexpr std::size_t kRecordHeader = 54;
    const auto count = this->get<std::uint32_t>(100);
    std::uint64_t at = this->HeaderSize;
    for (std::uint32_t i = 0; i < count && at + kRecordHeader <= this->Start; ++i)
    {
      const std::string_view user(this->Input.begin() + at + 2, 16);
      const auto id = this->get<std::uint16_t>(at + 18);
      const std::uint64_t size = this->get<std::uint16_t>(at + 20);
      at += kRecordHeader;
      if (size > this->Start - at)
      {
        return;
      }
      const char* const data = this->Input.begin() + at;
      const bool isProjection = user.starts_with("LASF_Projection");
      double& unit = this->Result.millimetresPerUnit;
      if (isProjection && id == 34735)
      {
        unit = unit != 0.0 ? unit : geoKeyUnit({ data, size });
      }
      else if (isProjection && id == 2112)
      {
        unit = unit != 0.0 ? unit : wellKnownTextUnit({ data, size });
      }
      at += size;
    }
  }

  bool isWithheld(std::uint64_t record) const
  {
    if (this->Format >= kFormats.size() || this->Minor == 0) // 1.0 has no such mark
    {
      return false;
    }
    const unsigned mark = this->Format < kFirstExtendedFormat ? 0x80U : 0x04U;
    return (this->get<std::uint8_t>(record + 15) & mark) != 0;
  }

  /// Calls use(record) for the place of each record that counts.
  template <class Use>
  void forEachRecord(std::size_t done, const Use& use)
  {
    const std::uint64_t work = this->ColorOffset != 0 ? 2 * this->Count : this->Count;
    for (std::uint64_t i = 0; i < this->Count; ++i)
    {
      if (i % kStep == 0)
      {
        this->Run.step("read", done + i, work);
      }
      const std::uint64_t record = this->Start + i * this->RecordSize;
      if (!this->isWithheld(record))
      {
        use(record);
      }
    }
  }

  void readPoints()
  {
    this->Result.points.reserve(this->Count);
    this->forEachRecord(0,
      [&](std::uint64_t record)
      {
        std::array<std::int32_t, 3> raw = {};
        std::memcpy(raw.data(), this->Input.begin() + record, kCoordinatesSize);
        this->Result.points.push_back({ raw[0] * this->Scale[0] + this->Offset[0],
          raw[1] * this->Scale[1] + this->Offset[1], raw[2] * this->Scale[2] + this->Offset[2] });
        this->Check.see(this->Result.points.back(), this->Input.begin() + record);
      });
  }

  void readColors()
  {
    if (this->ColorOffset == 0)
    {
      return;
    }
    // both readings, until the range of the whole file is known
    std::vector<Color>& upper = this->Result.colors;
    std::vector<Color> lower;
    upper.reserve(this->Result.points.size());
    lower.reserve(this->Result.points.size());
    unsigned used = 0;
    this->forEachRecord(this->Count,
      [&](std::uint64_t record)
      {
        std::array<std::uint16_t, 3> raw = {};
        std::memcpy(raw.data(), this->Input.begin() + record + this->ColorOffset, sizeof(raw));
        const auto low = [](unsigned value) { return static_cast<std::uint8_t>(value & 0xffU); };
        upper.push_back({ low(raw[0] >> 8U), low(raw[1] >> 8U), low(raw[2] >> 8U) });
        lower.push_back({ low(raw[0]), low(raw[1]), low(raw[2]) });
        used |= static_cast<unsigned>(raw[0] | raw[1] | raw[2]);
      });
    if (used == 0)
    {
      upper.clear();
    }
    else if (used < 256)
    {
      upper.swap(lower);
    }
  }

  const Source& Input;
  Execution& Run;
  unsigned Minor = 0; // of the version
  std::size_t HeaderSize = 0;
  std::uint64_t Start = 0; // of the points
  std::size_t Format = 0;
  std::size_t RecordSize = 0;
  std::size_t ColorOffset = 0; // in a record; 0 when it has no colour
  std::uint64_t Count = 0;
  std::array<double, 3> Scale = {};
  std::array<double, 3> Offset = {};
  Model Result;
  CoordinateCheck Check;
};

} // namespace

Model parseLas(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  return LasReader(source, execution).read();
}

bool looksLikeLas(std::span<const char> head)
{
  return std::string_view(head.data(), head.size()).starts_with(kSignature);
}

} // namespace scan
