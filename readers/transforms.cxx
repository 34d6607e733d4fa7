// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/transforms.h"

#include "readers/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace scan
{
namespace
{

constexpr double kMostScans = 1e6;

/// The words and numbers of a list.
class TransformReader
{
public:
  explicit TransformReader(const Source& source)
    : Text(source)
    , At(skipByteOrderMark(source))
  {
  }

  std::vector<ScanTransform> read()
  {
    const char* const start = this->skipGap();
    double count = 0.0;
    const bool isCounted = this->takeNumber(count); // as MeshLab's lists are
    if (isCounted && !(count >= 1.0 && count <= kMostScans && count == std::trunc(count)))
    {
      this->Text.failAtLine(start,
        "expected the name of a scan, or the number of scans, found " +
          quoted(word(start, this->Text.end())));
    }
    while (this->skipGap() != this->Text.end())
    {
      const char* const line = this->At;
      const std::string name = isCounted ? this->takeLine() : this->takeName();
      if (name == "camera") // Stanford's lists
      {
        this->At = nextLine(this->At, this->Text.end());
      }
      else if (name == "bmesh" || name == "mesh")
      {
        this->skipGap();
        this->readScan(line, this->takeName(), true);
      }
      else
      {
        this->readScan(line, name, false);
      }
      if (isCounted && static_cast<double>(this->Found.size()) == count)
      {
        break;
      }
    }
    if (isCounted)
    {
      this->finishCounted(count);
    }
    if (this->Found.empty())
    {
      this->Text.fail("no scan found; a list has lines with a name and 16, 12 or 7 numbers");
    }
    return std::move(this->Found);
  }

private:
  /// Moves to the next character that is neither space nor in a comment.
  const char* skipGap()
  {
    const char* const end = this->Text.end();
    this->At = skipSpace(this->At, end);
    while (this->At != end && *this->At == '#')
    {
      this->At = skipSpace(nextLine(this->At, end), end);
    }
    return this->At;
  }

  bool takeNumber(double& value)
  {
    const char* const stop = parseNumber(this->At, this->Text.end(), value);
    if (stop == nullptr || (stop != this->Text.end() && !isBlank(*stop) && !isLineEnd(*stop)))
    {
      return false;
    }
    this->At = stop;
    return true;
  }

  /// A name of a counted list has a line of its own, and stands there without quotes.
  std::string takeLine()
  {
    const char* const end = this->Text.end();
    const char* const stop = findLineEnd(this->At, end);
    std::string_view name(this->At, static_cast<std::size_t>(stop - this->At));
    name = name.substr(0, name.find_last_not_of(" \t") + 1);
    this->At = stop;
    const bool isQuoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
    return std::string(isQuoted ? name.substr(1, name.size() - 2) : name);
  }

  std::string takeName()
  {
    const char* const end = this->Text.end();
    if (this->At != end && *this->At == '"')
    {
      const char* const stop = std::find(this->At + 1, findLineEnd(this->At, end), '"');
      if (stop == end || *stop != '"')
      {
        this->Text.failAtLine(this->At, "a name without its closing quote");
      }
      std::string name(this->At + 1, stop);
      this->At = stop + 1;
      return name;
    }
    double ignored = 0.0;
    const char* const start = this->At;
    if (this->takeNumber(ignored))
    {
      this->Text.failAtLine(start,
        "expected the name of a scan, found the number " + quoted(word(start, end)) +
          "; there are 16, 12 or 7 numbers for each");
    }
    const std::string_view name = word(this->At, end);
    this->At += name.size();
    return std::string(name);
  }

  void readScan(const char* line, const std::string& name, bool isStanford)
  {
    std::vector<double> numbers;
    for (double number = 0.0;
         numbers.size() < 16 && this->skipGap() != this->Text.end() && this->takeNumber(number);)
    {
      if (!std::isfinite(number))
      {
        this->Text.failAtLine(this->At, "a number that is not finite");
      }
      numbers.push_back(number);
    }
    const bool isKnown =
      numbers.size() == 7 || (!isStanford && (numbers.size() == 12 || numbers.size() == 16));
    if (!isKnown || name.empty())
    {
      this->Text.failAtLine(line,
        "expected 16, 12 or 7 numbers behind the name of a scan, found " +
          std::to_string(numbers.size()) + " behind " + scan::quoted(name));
    }
    if (std::ranges::find(this->Found, name, &ScanTransform::name) != this->Found.end())
    {
      this->Text.failAtLine(line, scan::quoted(name) + " stands here for the second time");
    }
    const Affine place = numbers.size() == 7 ? this->quaternion(line, numbers, isStanford)
                                             : this->matrix(line, numbers);
    this->Found.push_back({ name, place });
  }

  Affine quaternion(const char* line, const std::vector<double>& n, bool isInverse) const
  {
    if (!std::isnormal(n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6]))
    {
      this->Text.failAtLine(line, "the quaternion has no length");
    }
    Affine place = rotationBy(n[3], n[4], n[5], isInverse ? -n[6] : n[6]);
    place.origin = { n[0], n[1], n[2] };
    return place;
  }

  Affine matrix(const char* line, const std::vector<double>& n) const
  {
    if (n.size() == 16 && !(n[12] == 0.0 && n[13] == 0.0 && n[14] == 0.0 && n[15] == 1.0))
    {
      this->Text.failAtLine(line,
        "the last row of the matrix must be 0 0 0 1, with the translation in the last column");
    }
    const Affine place{ { n[0], n[4], n[8] }, { n[1], n[5], n[9] }, { n[2], n[6], n[10] },
      { n[3], n[7], n[11] } };
    const double volume = dot(place.x, cross(place.y, place.z));
    if (!std::isnormal(volume))
    {
      this->Text.failAtLine(line, "the matrix flattens the scan");
    }
    return place;
  }

  void finishCounted(double count)
  {
    double zero = 0.0;
    if (static_cast<double>(this->Found.size()) != count)
    {
      this->Text.fail("the list announces " + std::to_string(static_cast<std::uint64_t>(count)) +
        " scans, but has " + std::to_string(this->Found.size()));
    }
    if (this->skipGap() != this->Text.end() &&
      !(this->takeNumber(zero) && zero == 0.0 && this->skipGap() == this->Text.end()))
    {
      this->Text.failAtLine(this->At, "expected the end of the list");
    }
  }

  const Source& Text;
  const char* At;
  std::vector<ScanTransform> Found;
};

} // namespace

std::vector<ScanTransform> parseTransforms(std::span<const char> bytes, std::string_view name)
{
  const Source source{ name, bytes };
  return TransformReader(source).read();
}

const ScanTransform* findTransform(
  const std::vector<ScanTransform>& transforms, const std::string& path)
{
  const std::filesystem::path file(path);
  for (const std::string& name : { path, file.filename().string(),
         (file.parent_path() / file.stem()).string(), file.stem().string() })
  {
    const auto found = std::ranges::find(transforms, name, &ScanTransform::name);
    if (found != transforms.end())
    {
      return &*found;
    }
  }
  return nullptr;
}

} // namespace scan
