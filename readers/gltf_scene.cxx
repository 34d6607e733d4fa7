// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf_scene.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace scan
{
namespace
{

using Json = GltfDocument::Json;

/// Walks through the nodes of a document.
class Walk
{
public:
  Walk(const GltfDocument& document, Execution& execution)
    : Document(document)
    , Run(execution)
  {
  }

  /// Goes through the nodes, parents first, in the order of the file.
  std::vector<GltfPlacement> find() const
  {
    std::vector<GltfPlacement> found;
    if (this->Document.size("nodes") == 0)
    {
      for (std::size_t mesh = 0; mesh < this->Document.size("meshes"); ++mesh)
      {
        found.push_back({ mesh, {} });
      }
      return found;
    }
    struct Visit
    {
      std::size_t node;
      Affine parent;
    };
    std::vector<Visit> stack;
    for (const std::size_t root : this->roots())
    {
      stack.push_back({ root, {} });
    }
    std::reverse(stack.begin(), stack.end());
    std::vector<bool> isSeen(this->Document.size("nodes"));
    while (!stack.empty())
    {
      this->Run.step("read", 1, 2);
      const Visit visit = stack.back();
      stack.pop_back();
      const Json& node = this->Document.entry("nodes", visit.node);
      if (isSeen[visit.node])
      {
        this->Document.source().fail("node " + std::to_string(visit.node) +
          " is in the scene twice or contains itself; the file is malformed");
      }
      isSeen[visit.node] = true;
      const Affine place = visit.parent * this->transformOf(node, visit.node);
      if (const std::optional<std::size_t> mesh = this->Document.number(node, "mesh"))
      {
        found.push_back({ *mesh, place });
      }
      const Json& children = this->Document.array(node, "children");
      for (std::size_t i = children.size(); i-- > 0;)
      {
        stack.push_back({ this->Document.indexIn(children, i), place });
      }
    }
    return found;
  }

private:
  std::vector<std::size_t> roots() const
  {
    std::vector<std::size_t> roots;
    if (this->Document.size("scenes") > 0)
    {
      const std::size_t scene = this->Document.number(this->Document.root(), "scene").value_or(0);
      const Json& nodes = this->Document.array(this->Document.entry("scenes", scene), "nodes");
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        roots.push_back(this->Document.indexIn(nodes, i));
      }
      return roots;
    }
    std::vector<bool> isChild(this->Document.size("nodes"));
    for (std::size_t node = 0; node < isChild.size(); ++node)
    {
      const Json& children = this->Document.array(this->Document.entry("nodes", node), "children");
      for (std::size_t i = 0; i < children.size(); ++i)
      {
        const std::size_t child = this->Document.indexIn(children, i);
        isChild[std::min(child, isChild.size() - 1)] = true; // a wrong one is found later
      }
    }
    for (std::size_t node = 0; node < isChild.size(); ++node)
    {
      if (!isChild[node])
      {
        roots.push_back(node);
      }
    }
    return roots;
  }

  /// The numbers of an array of a node; the given ones when it has none.
  template <std::size_t N>
  std::array<double, N> numbers(
    const Json& node, std::size_t index, const char* key, std::array<double, N> numbers) const
  {
    const Json& array = this->Document.array(node, key);
    bool isGood = array.empty() || array.size() == N;
    for (std::size_t i = 0; isGood && i < array.size(); ++i)
    {
      isGood = array[i].is_number();
      numbers[i] = isGood ? array[i].get<double>() : 0.0;
    }
    if (!isGood)
    {
      this->Document.source().fail("the " + std::string(key) + " of node " + std::to_string(index) +
        " is not " + std::to_string(N) + " numbers");
    }
    return numbers;
  }

  Affine transformOf(const Json& node, std::size_t index) const
  {
    if (node.contains("matrix"))
    {
      const auto m = this->numbers<16>(
        node, index, "matrix", { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
      return { { m[0], m[1], m[2] }, { m[4], m[5], m[6] }, { m[8], m[9], m[10] },
        { m[12], m[13], m[14] } };
    }
    const auto t = this->numbers<3>(node, index, "translation", { 0, 0, 0 });
    const auto r = this->numbers<4>(node, index, "rotation", { 0, 0, 0, 1 });
    const auto s = this->numbers<3>(node, index, "scale", { 1, 1, 1 });
    const Affine rotation = rotationBy(r[0], r[1], r[2], r[3]);
    return { rotation.x * s[0], rotation.y * s[1], rotation.z * s[2], { t[0], t[1], t[2] } };
  }

  const GltfDocument& Document;
  Execution& Run;
};

} // namespace

std::vector<GltfPlacement> gltfScene(const GltfDocument& document, Execution& execution)
{
  return Walk(document, execution).find();
}

} // namespace scan
