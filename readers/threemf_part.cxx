// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/threemf_part.h"

#include "readers/text_scanner.h"

#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kDeepest = 100;

/// Where in the document an element is.
enum class Level
{
  document,
  model,
  resources,
  object,
  mesh,
  vertices,
  triangles,
  components,
  build,
  other // and everything inside
};

/// Fills a part from its tags.
class PartReader
{
public:
  PartReader(XmlScanner& xml, std::size_t& budget)
    : Xml(xml)
    , Budget(budget)
  {
  }

  ThreemfPart read()
  {
    while (this->Xml.next())
    {
      if (this->Xml.isStart())
      {
        const Level parent = this->Levels.empty() ? Level::document : this->Levels.back();
        this->Levels.push_back(this->start(parent));
      }
      else if (this->Levels.empty())
      {
        this->Xml.fail("an end tag without a start");
      }
      else
      {
        this->Levels.pop_back();
      }
      if (this->Levels.size() > kDeepest)
      {
        this->Xml.fail("elements nest deeper than 100 levels");
      }
    }
    if (!this->Levels.empty() || !this->HasModel)
    {
      this->Xml.fail(this->HasModel ? "the document ends too early; it is truncated"
                                    : "no element 'model' found");
    }
    return std::move(this->Part);
  }

private:
  // NOLINTNEXTLINE(readability-function-cognitive-complexity): a table
  Level start(Level parent)
  {
    const std::string_view name = this->Xml.name();
    switch (parent)
    {
      case Level::vertices:
        return name == "vertex" ? this->addVertex() : Level::other;
      case Level::triangles:
        return name == "triangle" ? this->addTriangle() : Level::other;
      case Level::document:
        return name == "model" ? this->startModel() : Level::other;
      case Level::model:
        return name == "resources" ? Level::resources
          : name == "build"        ? Level::build
                                   : Level::other;
      case Level::resources:
        return name == "object" ? this->startObject() : Level::other;
      case Level::object:
        return name == "mesh"    ? Level::mesh
          : name == "components" ? Level::components
                                 : Level::other;
      case Level::mesh:
        return name == "vertices" ? Level::vertices
          : name == "triangles"   ? Level::triangles
                                  : Level::other;
      case Level::components:
        return name == "component" ? this->addUse(this->Object->components) : Level::other;
      case Level::build:
        return name == "item" ? this->addUse(this->Part.items) : Level::other;
      case Level::other:
        break;
    }
    return Level::other;
  }

  void take(std::size_t bytes)
  {
    if (bytes > this->Budget)
    {
      this->Xml.fail("the model takes far more memory than a file of this size can need");
    }
    this->Budget -= bytes;
  }

  Level startModel()
  {
    static constexpr std::pair<std::string_view, double> kUnits[] = { { "micron", 0.001 },
      { "millimeter", 1.0 }, { "centimeter", 10.0 }, { "inch", 25.4 }, { "foot", 304.8 },
      { "meter", 1000.0 } };
    const std::string_view unit = this->Xml.attribute("unit").value_or("millimeter");
    bool isKnown = false;
    for (const auto& [name, millimetres] : kUnits)
    {
      if (name == unit)
      {
        isKnown = true;
        this->Part.millimetresPerUnit = millimetres;
      }
    }
    if (!isKnown)
    {
      this->Xml.fail("unknown unit " + scan::quoted(unit));
    }
    this->HasModel = true;
    return Level::model;
  }

  Level startObject()
  {
    this->take(sizeof(ThreemfObject) + 64);
    const std::uint32_t id = this->index("id");
    const auto [entry, isNew] = this->Part.objects.try_emplace(id);
    if (!isNew)
    {
      this->Xml.fail("object " + std::to_string(id) + " is there twice");
    }
    this->Object = &entry->second;
    return Level::object;
  }

  Level addVertex()
  {
    this->take(sizeof(Vec3));
    this->Object->mesh.points.push_back(
      { this->number("x"), this->number("y"), this->number("z") });
    if (this->Object->mesh.points.size() >= kNone)
    {
      this->Xml.fail("more than 4294967294 vertices");
    }
    return Level::other;
  }

  Level addTriangle()
  {
    this->take(sizeof(Triangle));
    this->Object->mesh.triangles.push_back(
      { this->corner("v1"), this->corner("v2"), this->corner("v3") });
    return Level::other;
  }

  Level addUse(std::vector<ThreemfUse>& uses)
  {
    ThreemfUse use;
    use.object = this->index("objectid");
    if (const auto part = this->Xml.prefixedAttribute("path"))
    {
      use.part = part->substr(part->starts_with('/') ? 1 : 0);
    }
    if (const auto transform = this->Xml.attribute("transform"))
    {
      use.place = this->transform(*transform);
    }
    this->take(sizeof(ThreemfUse) + use.part.size());
    uses.push_back(std::move(use));
    return Level::other;
  }

  std::string_view required(std::string_view name) const
  {
    const auto text = this->Xml.attribute(name);
    if (!text)
    {
      this->Xml.fail(
        "the tag " + scan::quoted(this->Xml.name()) + " lacks the attribute " + scan::quoted(name));
    }
    return *text;
  }

  /// A number and nothing but blanks around it.
  double number(std::string_view name) const
  {
    const std::string_view text = this->required(name);
    const char* const end = text.data() + text.size();
    double value = 0.0;
    const char* const stop = parseNumber(skipSpace(text.data(), end), end, value);
    if (stop == nullptr || skipSpace(stop, end) != end)
    {
      this->Xml.fail("expected a number, found " + scan::quoted(text));
    }
    return value;
  }

  std::uint32_t index(std::string_view name) const
  {
    const std::string_view text = this->required(name);
    const char* const end = text.data() + text.size();
    std::uint32_t value = 0;
    const auto [stop, error] = std::from_chars(skipSpace(text.data(), end), end, value);
    if (error != std::errc() || skipSpace(stop, end) != end)
    {
      this->Xml.fail("expected an index, found " + scan::quoted(text));
    }
    return value;
  }

  Index corner(std::string_view name) const
  {
    const std::uint32_t value = this->index(name);
    const std::size_t known = this->Object->mesh.points.size();
    if (value >= known)
    {
      this->Xml.fail("a triangle refers to vertex " + std::to_string(value) + ", but there are " +
        std::to_string(known) + ", counted from 0");
    }
    return value;
  }

  /// Twelve numbers: where the axes go, and the origin.
  Affine transform(std::string_view text) const
  {
    std::array<double, 12> m = {};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (double& value : m)
    {
      at = parseNumber(skipSpace(at, end), end, value);
      if (at == nullptr)
      {
        this->Xml.fail("expected a transform of 12 numbers, found " + scan::quoted(text));
      }
    }
    return { { m[0], m[1], m[2] }, { m[3], m[4], m[5] }, { m[6], m[7], m[8] },
      { m[9], m[10], m[11] } };
  }

  XmlScanner& Xml;
  std::size_t& Budget;
  ThreemfPart Part;
  ThreemfObject* Object = nullptr;
  std::vector<Level> Levels;
  bool HasModel = false;
};

} // namespace

ThreemfPart parseThreemfPart(XmlScanner& xml, std::size_t& budget)
{
  return PartReader(xml, budget).read();
}

} // namespace scan
