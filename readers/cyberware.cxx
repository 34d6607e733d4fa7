// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cyberware.h"

#include "filters/base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace scan
{
namespace
{

constexpr std::int64_t kVoid = -32768;
constexpr double kMicro = 1e6; // microradians of a radian
constexpr double kMilli = 1e3; // micrometres of a millimetre
constexpr std::int64_t kLongitudesPerStep = 64;

/// Turns the samples into points, one longitude after the other.
class RangeMap
{
public:
  RangeMap(const Source& source, const CyberwareOptions& options, Execution& execution)
    : Header(parseCyberwareHeader(source))
    , Input(source)
    , Options(options)
    , Run(execution)
  {
  }

  CyberwareScan read()
  {
    this->checkSize();
    this->reserve();
    const CyberwareHeader& header = this->Header;
    this->Scan.model.millimetresPerUnit = 1.0;
    this->Scan.latitudes = static_cast<std::uint32_t>(header.latitudes);
    this->Scan.longitudes = static_cast<std::uint32_t>(header.longitudes);
    Column first;
    Column last;
    for (std::int64_t lg = header.firstLongitude; lg <= header.lastLongitude; ++lg)
    {
      this->report(lg);
      Column column = this->readLongitude(lg);
      if (this->Options.mesh && lg > header.firstLongitude)
      {
        this->join(last, column);
      }
      else if (this->Options.mesh)
      {
        first = column;
      }
      last = std::move(column);
    }
    if (this->Options.mesh && this->isClosed())
    {
      this->join(last, first);
    }
    if (this->Negative > 0)
    {
      this->Scan.model.addNote(
        "samples with a radius below zero left out: " + std::to_string(this->Negative));
    }
    if (header.space == CyberwareSpace::bilateral)
    {
      this->Scan.model.addNote("the two halves of the map lie over each other");
    }
    return std::move(this->Scan);
  }

private:
  /// The points of a longitude, by their latitude in the window; kNone where it is void.
  using Column = std::vector<Index>;

  void checkSize() const
  {
    const auto wanted =
      2 * static_cast<std::size_t>(this->Header.latitudes * this->Header.longitudes);
    const std::size_t found = this->Input.bytes.size() - this->Header.size;
    if (found < wanted)
    {
      this->Input.fail("the header announces " + std::to_string(this->Header.longitudes) + " x " +
        std::to_string(this->Header.latitudes) + " samples of two bytes, but only " +
        std::to_string(found) + " of " + std::to_string(wanted) +
        " bytes follow; the file is truncated");
    }
  }

  void reserve()
  {
    const CyberwareHeader& header = this->Header;
    std::size_t count = 0;
    for (std::int64_t lg = header.firstLongitude; lg <= header.lastLongitude; ++lg)
    {
      this->report(lg);
      for (std::int64_t lt = header.firstLatitude; lt <= header.lastLatitude; ++lt)
      {
        const std::int64_t value = this->sample(lg, lt);
        count += this->isValid(value) ? 1 : 0;
        this->Negative += value != kVoid && !this->isValid(value) ? 1 : 0;
      }
    }
    if (count == 0)
    {
      this->Input.fail("no sample of the map is valid; scan again, or widen the window that LTMIN, "
                       "LTMAX, LGMIN and LGMAX give");
    }
    this->Scan.model.points.reserve(count);
    this->Scan.cells.reserve(count);
    // two triangles for each point but the last of its longitude
    this->Scan.model.triangles.reserve(this->Options.mesh ? 2 * count : 0);
  }

  void report(std::int64_t lg)
  {
    if (lg % kLongitudesPerStep == 0)
    {
      this->Run.step(
        "read", static_cast<std::size_t>(lg), static_cast<std::size_t>(this->Header.longitudes));
    }
  }

  std::int64_t sample(std::int64_t lg, std::int64_t lt) const
  {
    const char* const at =
      this->Input.begin() + this->Header.size + 2 * (lg * this->Header.latitudes + lt);
    const char high = this->Header.isBigEndian ? at[0] : at[1];
    const char low = this->Header.isBigEndian ? at[1] : at[0];
    return static_cast<signed char>(high) * 256 + static_cast<unsigned char>(low);
  }

  bool isValid(std::int64_t value) const
  {
    return this->isCylindrical() ? value >= 0 : value != kVoid;
  }

  bool isCylindrical() const { return this->Header.space == CyberwareSpace::cylindrical; }

  Column readLongitude(std::int64_t lg)
  {
    const CyberwareHeader& header = this->Header;
    const double angle =
      this->isCylindrical() ? static_cast<double>(lg * header.longitudeStep) / kMicro : 0.0;
    const double along = header.isRightHanded ? -std::sin(angle) : std::sin(angle);
    const double across = -std::cos(angle);
    const std::int64_t middle = header.longitudes / 2;
    const double column = static_cast<double>((lg - middle) * header.longitudeStep) / kMilli;
    Column points(static_cast<std::size_t>(header.lastLatitude - header.firstLatitude + 1), kNone);
    for (std::int64_t lt = header.firstLatitude; lt <= header.lastLatitude; ++lt)
    {
      const std::int64_t value = this->sample(lg, lt);
      if (!this->isValid(value))
      {
        continue;
      }
      const double range = static_cast<double>(value * (std::int64_t(1) << header.shift)) / kMilli;
      const double height = this->height(lt);
      std::vector<Vec3>& all = this->Scan.model.points;
      points[static_cast<std::size_t>(lt - header.firstLatitude)] = static_cast<Index>(all.size());
      all.push_back(this->isCylindrical() ? Vec3{ range * along, height, range * across }
                                          : Vec3{ column, height, range });
      this->Scan.cells.push_back(static_cast<std::uint32_t>(lg * header.latitudes + lt));
    }
    return points;
  }

  double height(std::int64_t lt) const
  {
    const std::int64_t half = this->Header.latitudes / 2;
    const std::int64_t steps = this->Header.space == CyberwareSpace::bilateral
      ? lt % half - this->Header.latitudes
      : lt - half;
    return static_cast<double>(steps * this->Header.latitudeStep) / kMilli;
  }

  /// Triangles between two neighbouring longitudes.
  void join(const Column& left, const Column& right)
  {
    // angles run clockwise about y unless right-handed, columns of a plane map run along x
    const bool runsClockwise = this->isCylindrical() && !this->Header.isRightHanded;
    const bool isFlipped = runsClockwise == this->Header.isInsideOut;
    for (std::size_t i = 0; i + 1 < left.size(); ++i)
    {
      const bool isSeam = this->Header.space == CyberwareSpace::bilateral &&
        this->Header.firstLatitude + static_cast<std::int64_t>(i) + 1 == this->Header.latitudes / 2;
      const bool isWhole =
        left[i] != kNone && left[i + 1] != kNone && right[i] != kNone && right[i + 1] != kNone;
      if (isWhole && !isSeam)
      {
        this->addTriangle({ left[i], right[i + 1], right[i] }, isFlipped);
        this->addTriangle({ left[i], left[i + 1], right[i + 1] }, isFlipped);
      }
    }
  }

  void addTriangle(const Triangle& t, bool isFlipped)
  {
    this->Scan.model.triangles.push_back(isFlipped ? Triangle{ t[0], t[2], t[1] } : t);
  }

  /// Whether the last longitude has the first as its neighbour.
  bool isClosed() const
  {
    const CyberwareHeader& header = this->Header;
    const auto step = static_cast<double>(header.longitudeStep);
    const double rest =
      static_cast<double>(header.longitudes) * step - 2.0 * std::numbers::pi * kMicro;
    return this->isCylindrical() && header.longitudes >= 3 && header.firstLongitude == 0 &&
      header.lastLongitude == header.longitudes - 1 && 2.0 * std::abs(rest) <= step;
  }

  const CyberwareHeader Header;
  const Source& Input;
  const CyberwareOptions Options;
  Execution& Run;
  CyberwareScan Scan;
  std::size_t Negative = 0; // radii below zero
};

/// The pixel of `pixels` that lies where `cell` does among `cells`.
std::size_t nearest(std::size_t cell, std::size_t cells, std::size_t pixels)
{
  return (2 * cell + 1) * pixels / (2 * cells);
}

} // namespace

CyberwareScan parseCyberwareScan(std::span<const char> bytes, std::string_view name,
  const CyberwareOptions& options, Execution& execution)
{
  const Source source{ name, bytes };
  return RangeMap(source, options, execution).read();
}

Model parseCyberware(std::span<const char> bytes, std::string_view name,
  const CyberwareOptions& options, Execution& execution)
{
  return parseCyberwareScan(bytes, name, options, execution).model;
}

Model parseCyberware(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseCyberware(bytes, name, CyberwareOptions(), execution);
}

void addCyberwareColors(CyberwareScan& scan, const SgiImage& image)
{
  if (image.width == 0 || image.height == 0 || image.pixels.size() != image.width * image.height)
  {
    throw Error(ErrorCode::badInput, "the image with the colours has no pixels; save it anew");
  }
  const bool isUpright = scan.longitudes > scan.latitudes
    ? image.width > image.height
    : scan.longitudes < scan.latitudes && image.width < image.height;
  scan.model.colors.clear();
  scan.model.colors.reserve(scan.cells.size());
  for (const std::uint32_t cell : scan.cells)
  {
    const std::size_t lg = cell / scan.latitudes;
    const std::size_t lt = cell % scan.latitudes;
    const std::size_t x = isUpright ? nearest(lg, scan.longitudes, image.width)
                                    : nearest(lt, scan.latitudes, image.width);
    const std::size_t y = isUpright ? nearest(lt, scan.latitudes, image.height)
                                    : nearest(lg, scan.longitudes, image.height);
    scan.model.colors.push_back(image.pixels[y * image.width + x]);
  }
}

} // namespace scan
