// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf_document.h"

#include "readers/gltf_json.h"
#include "readers/little_endian.h"
#include "readers/text_scanner.h"

#include <algorithm>

namespace scan
{
namespace
{

using Json = GltfDocument::Json;

/// Required extensions without any influence on points and triangles, or that are understood.
bool isHarmless(const std::string& extension)
{
  for (const char* const start :
    { "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_mesh_quantization" })
  {
    if (extension.starts_with(start))
    {
      return true;
    }
  }
  return false;
}

/// The six bits of a character of base64, or 64.
unsigned sixBits(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<unsigned>(c - 'A')
    : c >= 'a' && c <= 'z'    ? static_cast<unsigned>(c - 'a') + 26
    : isDigit(c)              ? static_cast<unsigned>(c - '0') + 52
    : c == '+'                ? 62
    : c == '/'                ? 63
                              : 64;
}

} // namespace

GltfDocument::GltfDocument(const Source& source, const ReadBuffer& readBuffer, Execution& execution)
  : Input(source)
  , Read(readBuffer)
{
  this->Root = parseGltfJson(this->Input, this->findJson(), execution);
  if (!this->Root.is_object())
  {
    this->Input.fail("not a glTF file: its JSON is not an object");
  }
  this->checkVersion();
  this->checkExtensions();
  this->Decoded.resize(this->size("buffers"));
  this->Buffers.resize(this->Decoded.size());
}

std::span<const char> GltfDocument::findJson()
{
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  const char* const begin = this->Input.begin();
  const std::size_t size = this->Input.bytes.size();
  if (size < 4 || std::string_view(begin, 4) != "glTF")
  {
    return this->Input.bytes;
  }
  this->IsBinary = true;
  const std::size_t announced =
    size < kHeader ? kHeader : std::size_t{ loadLittle<std::uint32_t>(begin + 8) };
  if (announced > size || announced < kHeader + kChunkHeader)
  {
    this->Input.fail("the header announces " + std::to_string(announced) +
      " bytes, but the file has " + std::to_string(size) + "; it is truncated or malformed");
  }
  if (const auto version = loadLittle<std::uint32_t>(begin + 4); version != 2)
  {
    this->Input.fail("GLB of version " + std::to_string(version) + "; only version 2 is read");
  }
  std::span<const char> json;
  const char* const end = begin + announced;
  for (const char* at = begin + kHeader; end - at >= std::ptrdiff_t(kChunkHeader);)
  {
    const std::size_t length = loadLittle<std::uint32_t>(at);
    const std::string_view type(at + 4, 4);
    if (length > static_cast<std::size_t>(end - at) - kChunkHeader)
    {
      this->Input.failAtByte(at, "a chunk is longer than the rest of the file; it is truncated");
    }
    const std::span<const char> chunk(at + kChunkHeader, length);
    if (json.data() == nullptr && type != "JSON")
    {
      this->Input.failAtByte(at, "expected the JSON chunk of a GLB file");
    }
    json = json.data() == nullptr ? chunk : json;
    this->Binary =
      this->Binary.data() == nullptr && type == std::string_view("BIN\0", 4) ? chunk : this->Binary;
    at += kChunkHeader + length;
  }
  return json;
}

void GltfDocument::checkVersion() const
{
  const auto asset = this->Root.find("asset");
  if (asset == this->Root.end() || !asset->is_object() || !asset->contains("version") ||
    !(*asset)["version"].is_string())
  {
    this->Input.fail("not a glTF file: its JSON does not say asset.version");
  }
  const auto& version = (*asset)["version"].get_ref<const std::string&>();
  if (!version.starts_with("2."))
  {
    this->Input.fail("glTF of version " + scan::quoted(version) + "; only version 2 is read");
  }
}

void GltfDocument::checkExtensions() const
{
  for (const Json& extension : this->array(this->Root, "extensionsRequired"))
  {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
    if (!isHarmless(name))
    {
      this->Input.fail("the file needs the extension " + scan::quoted(name) +
        ", which is not read; export it without compression");
    }
  }
}

std::size_t GltfDocument::size(const char* array) const
{
  return this->array(this->Root, array).size();
}

const Json& GltfDocument::entry(const char* array, std::size_t index) const
{
  const Json& entries = this->array(this->Root, array);
  if (index >= entries.size() || !entries[index].is_object())
  {
    this->Input.fail("something refers to entry " + std::to_string(index) + " of '" + array +
      "', but there are " + std::to_string(entries.size()) + ", counted from 0");
  }
  return entries[index];
}

std::optional<std::size_t> GltfDocument::number(const Json& object, const char* key) const
{
  const auto found = object.find(key);
  if (found == object.end())
  {
    return std::nullopt;
  }
  if (!found->is_number_unsigned())
  {
    this->Input.fail(std::string("a '") + key + "' is not a number counted from 0");
  }
  return found->get<std::size_t>();
}

const Json& GltfDocument::array(const Json& object, const char* key) const
{
  static const Json kEmpty = Json::array();
  const auto found = object.find(key);
  if (found != object.end() && !found->is_array())
  {
    this->Input.fail(std::string("'") + key + "' is not an array");
  }
  return found != object.end() ? *found : kEmpty;
}

std::size_t GltfDocument::indexIn(const Json& array, std::size_t element) const
{
  if (!array[element].is_number_unsigned())
  {
    this->Input.fail("a list of nodes has an entry that is not a number counted from 0");
  }
  return array[element].get<std::size_t>();
}

GltfAccessor GltfDocument::accessor(std::size_t index)
{
  const Json& json = this->entry("accessors", index);
  const std::string where = "accessor " + std::to_string(index);
  if (json.contains("sparse"))
  {
    this->Input.fail(where + " is sparse, which is not read; export without sparse accessors");
  }
  const std::optional<std::size_t> viewIndex = this->number(json, "bufferView");
  if (!viewIndex)
  {
    this->Input.fail(where + " has no data; the file is compressed or incomplete");
  }
  const Json& view = this->entry("bufferViews", *viewIndex);
  const std::span<const char> bytes = this->buffer(this->number(view, "buffer").value_or(0));
  const std::size_t viewOffset = this->number(view, "byteOffset").value_or(0);
  const std::size_t viewLength = this->number(view, "byteLength").value_or(0);
  if (viewOffset > bytes.size() || viewLength > bytes.size() - viewOffset)
  {
    this->Input.fail("buffer view " + std::to_string(*viewIndex) +
      " reaches beyond its buffer; the file is truncated or malformed");
  }

  GltfAccessor accessor;
  accessor.index = index;
  const std::size_t type = this->number(json, "componentType").value_or(0);
  const auto shape = json.find("type");
  accessor.components =
    shape != json.end() && shape->is_string() ? gltfComponentsOf(shape->get<std::string>()) : 0;
  const std::size_t size = gltfSizeOf(type) * static_cast<std::size_t>(accessor.components);
  if (size == 0)
  {
    this->Input.fail(where + " has a type that glTF does not know, or that no mesh uses");
  }
  accessor.componentType = static_cast<int>(type);
  const auto normalized = json.find("normalized");
  accessor.isNormalized = normalized != json.end() && *normalized == true;
  accessor.count = this->number(json, "count").value_or(0);
  accessor.stride = this->number(view, "byteStride").value_or(size);
  const std::size_t offset = this->number(json, "byteOffset").value_or(0);
  if (accessor.count == 0 || accessor.stride < size || offset > viewLength ||
    size > viewLength - offset ||
    (viewLength - offset - size) / accessor.stride < accessor.count - 1)
  {
    this->Input.fail(where + " announces " + std::to_string(accessor.count) +
      " elements, which its buffer view does not hold; the file is malformed");
  }
  accessor.data = bytes.data() + viewOffset + offset;
  return accessor;
}

std::span<const char> GltfDocument::buffer(std::size_t index)
{
  const Json& json = this->entry("buffers", index);
  const std::size_t length = this->number(json, "byteLength").value_or(0);
  const auto uri = json.find("uri");
  std::span<const char> bytes;
  if (index == 0 && this->IsBinary)
  {
    bytes = this->Binary;
  }
  if (uri != json.end())
  {
    if (!uri->is_string())
    {
      this->Input.fail("the 'uri' of a buffer is not text");
    }
    if (this->Buffers[index].empty())
    {
      this->Buffers[index] = this->bufferAt(uri->get_ref<const std::string&>(), index);
    }
    bytes = this->Buffers[index];
  }
  if (length == 0 || length > bytes.size())
  {
    this->Input.fail("buffer " + std::to_string(index) + " announces " + std::to_string(length) +
      " bytes, but has " + std::to_string(bytes.size()) + "; the file is truncated or malformed");
  }
  return bytes.first(length);
}

std::span<const char> GltfDocument::bufferAt(const std::string& uri, std::size_t index)
{
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = uri.substr(0, 256).find(kMark);
  if (uri.starts_with("data:") && mark != std::string::npos)
  {
    this->Decoded[index] = this->decode(std::string_view(uri).substr(mark + kMark.size()), index);
    return this->Decoded[index];
  }
  if (this->Read == nullptr || uri.starts_with("data:"))
  {
    this->Input.fail("buffer " + std::to_string(index) + " is " + scan::quoted(uri) +
      ", which is not read; save as .glb or with embedded buffers");
  }
  const std::span<const char> bytes = this->Read(uri);
  this->OtherBytes += bytes.size();
  return bytes;
}

std::vector<char> GltfDocument::decode(std::string_view text, std::size_t index) const
{
  text = text.substr(0, std::min(text.size(), text.find_last_not_of('=') + 1));
  std::vector<char> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  unsigned pending = 0;
  unsigned bits = 0;
  for (const char c : text)
  {
    const unsigned six = sixBits(c);
    if (six > 63)
    {
      this->Input.fail("buffer " + std::to_string(index) + " has malformed base64 data");
    }
    pending = (pending << 6U | six) & 0xffffU;
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes.push_back(static_cast<char>(pending >> bits & 0xffU));
    }
  }
  return bytes;
}

} // namespace scan
