// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/threemf.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/little_endian.h"
#include "readers/text_scanner.h"
#include "readers/threemf_part.h"

#include <cmath>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kStep = 1U << 16U;
constexpr int kDeepest = 100;

/// What an object takes with all its components; a double, since copies of copies grow fast.
struct Amount
{
  double points = 0.0;
  double triangles = 0.0;
  int depth = 0;           // of the components
  bool isComplete = false; // or still being counted

  bool isNothing() const { return this->points == 0.0; }
};

/// Fills a model from the parts of an archive.
class Loader
{
public:
  Loader(const Source& source, Execution& execution, double largest)
    : Input(source)
    , Run(execution)
    , Archive(source)
    , Budget(12 * source.bytes.size() + (std::size_t(64) << 20U))
    , Largest(std::max(static_cast<double>(this->Budget), largest))
  {
  }

  Model load()
  {
    const std::string root = this->rootName();
    ThreemfPart& part = this->part(root);
    if (part.items.empty())
    {
      for (const auto& [id, object] : part.objects)
      {
        if (!object.mesh.points.empty())
        {
          part.items.push_back({ {}, id, {} });
        }
      }
    }
    this->reserve(part, root);
    for (const ThreemfUse& item : part.items)
    {
      this->append(item, root, {});
    }
    this->Check.finish(this->Input, this->Result, CoordinateCheck::Place::unknown);
    this->Result.millimetresPerUnit = part.millimetresPerUnit;
    return std::move(this->Result);
  }

private:
  /// The part that the relationships of the archive name, or else the first that looks right.
  std::string rootName()
  {
    if (this->Archive.has("_rels/.rels"))
    {
      ZipStream text(this->Archive, "_rels/.rels", this->Unpacked);
      XmlScanner xml(text, this->Run);
      while (xml.next())
      {
        const std::string_view type =
          xml.isStart() ? xml.attribute("Type").value_or("") : std::string_view();
        if (type.ends_with("/3dmodel"))
        {
          const std::string_view target = xml.attribute("Target").value_or("");
          return std::string(target.substr(target.starts_with('/') ? 1 : 0));
        }
      }
    }
    std::string name = this->Archive.firstThatEndsWith(".model");
    if (name.empty())
    {
      this->Input.fail("the archive has no 3D model; it is not a 3MF file");
    }
    return name;
  }

  ThreemfPart& part(const std::string& name)
  {
    const auto found = this->Parts.find(name);
    if (found != this->Parts.end())
    {
      return found->second;
    }
    ZipStream text(this->Archive, name, this->Unpacked);
    XmlScanner xml(text, this->Run);
    return this->Parts[name] = parseThreemfPart(xml, this->Budget);
  }

  const std::string& partOf(const ThreemfUse& use, const std::string& current) const
  {
    return use.part.empty() ? current : use.part;
  }

  ThreemfObject& objectOf(const ThreemfUse& use, const std::string& current)
  {
    const std::string& name = this->partOf(use, current);
    ThreemfPart& part = this->part(name);
    const auto found = part.objects.find(use.object);
    if (found == part.objects.end())
    {
      this->Input.fail("the part " + scan::quoted(name) + " has no object " +
        std::to_string(use.object) + "; the file is incomplete");
    }
    return found->second;
  }

  /// What a use takes. Each object is counted once, and loses the components that have no points,
  /// so that the number of uses is bounded by the number of points.
  Amount count(const ThreemfUse& use, const std::string& current, int depth)
  {
    ThreemfObject& object = this->objectOf(use, current);
    const auto [entry, isNew] = this->Amounts.try_emplace(&object);
    Amount& amount = entry->second; // stays where it is
    if (!isNew && amount.isComplete)
    {
      return amount;
    }
    if (!isNew || depth > kDeepest)
    {
      this->failAsNested(use.object);
    }
    amount.points = static_cast<double>(object.mesh.points.size());
    amount.triangles = static_cast<double>(object.mesh.triangles.size());
    std::erase_if(object.components,
      [&](const ThreemfUse& component)
      {
        const Amount inner = this->count(component, this->partOf(use, current), depth + 1);
        amount.points += inner.points;
        amount.triangles += inner.triangles;
        amount.depth = std::max(amount.depth, inner.depth + 1);
        return inner.isNothing();
      });
    if (amount.depth > kDeepest) // of objects that were counted one by one
    {
      this->failAsNested(use.object);
    }
    amount.isComplete = true;
    return amount;
  }

  [[noreturn]] void failAsNested(std::uint32_t object) const
  {
    this->Input.fail("object " + std::to_string(object) +
      " contains itself, or components nest deeper than 100 levels");
  }

  void reserve(const ThreemfPart& part, const std::string& name)
  {
    Amount all;
    for (const ThreemfUse& item : part.items)
    {
      const Amount amount = this->count(item, name, 0);
      all.points += amount.points;
      all.triangles += amount.triangles;
    }
    if (all.isNothing())
    {
      this->Input.fail("no mesh found; export a model with triangles");
    }
    if (all.points * double(sizeof(Vec3)) + all.triangles * double(sizeof(Triangle)) >
      this->Largest)
    {
      this->Input.fail("the file builds its objects so often that they take more than " +
        std::to_string(static_cast<std::size_t>(this->Largest) >> 20U) +
        " MB; save it with fewer copies");
    }
    this->Input.checkPointCount(static_cast<std::uint64_t>(all.points));
    this->Total = static_cast<std::size_t>(all.points + all.triangles);
    this->Result.points.reserve(static_cast<std::size_t>(all.points));
    this->Result.triangles.reserve(static_cast<std::size_t>(all.triangles));
  }

  void report()
  {
    if (this->Done++ % kStep == 0)
    {
      this->Run.step("read", this->Done, this->Total);
    }
  }

  void append(const ThreemfUse& use, const std::string& current, const Affine& outer)
  {
    const ThreemfObject& object = this->objectOf(use, current);
    const Affine place = outer * use.place;
    const auto first = static_cast<Index>(this->Result.points.size());
    for (const Vec3& point : object.mesh.points)
    {
      this->report();
      this->Result.points.push_back(place.point(point));
      this->Check.see(this->Result.points.back());
    }
    const bool isMirrored = place.isMirror();
    for (const auto& [a, b, c] : object.mesh.triangles)
    {
      this->report();
      this->Result.triangles.push_back(isMirrored ? Triangle{ first + b, first + a, first + c }
                                                  : Triangle{ first + a, first + b, first + c });
    }
    for (const ThreemfUse& component : object.components)
    {
      this->append(component, this->partOf(use, current), place);
    }
  }

  const Source& Input;
  Execution& Run;
  ZipArchive Archive;
  std::uint64_t Unpacked = 0;
  std::size_t Budget; // bytes that what the parts say may take
  double Largest;     // bytes that the model may take
  std::map<std::string, ThreemfPart> Parts;
  std::map<const ThreemfObject*, Amount> Amounts;
  Model Result;
  CoordinateCheck Check;
  std::size_t Total = 0;
  std::size_t Done = 0;
};

} // namespace

Model parseThreemf(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseThreemfUpTo(1e9, bytes, name, execution);
}

Model parseThreemfUpTo(
  double largest, std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source{ name, bytes };
  return Loader(source, execution, largest).load();
}

bool looksLikeThreemf(std::span<const char> head)
{
  constexpr std::size_t kHeaderSize = 30;
  const std::string_view text(head.data(), head.size());
  if (text.size() < kHeaderSize || !text.starts_with("PK\3\4"))
  {
    return false;
  }
  const std::size_t size = loadLittle<std::uint16_t>(head.data() + 26);
  const std::string_view name = text.substr(kHeaderSize, size);
  return name == "[Content_Types].xml" || name.starts_with("_rels/") || name.starts_with("3D/") ||
    name.starts_with("Metadata/");
}

} // namespace scan
