// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "readers/gltf_accessor.h"
#include "readers/source.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scan
{

/// The JSON and the buffers of a glTF file. All functions throw Error parse for what is missing,
/// of the wrong type or beyond its bounds.
class GltfDocument
{
public:
  using Json = nlohmann::json;

  /// The bytes of a buffer in a file of its own, valid as long as the document.
  using ReadBuffer = std::function<std::span<const char>(const std::string& uri)>;

  /// Refuses JSON that nests deeply or that would take many times the memory of the file.
  /// @param readBuffer without it, buffers in files of their own are refused
  GltfDocument(const Source& source, const ReadBuffer& readBuffer, Execution& execution);

  const Source& source() const { return this->Input; }

  /// The number of entries of an array of the document, 0 without the array.
  std::size_t size(const char* array) const;

  /// An entry of an array of the document, an object.
  const Json& entry(const char* array, std::size_t index) const;

  /// An index or size; nothing when the object does not have it.
  std::optional<std::size_t> number(const Json& object, const char* key) const;

  /// The array under a key of an object; an empty one without the key.
  const Json& array(const Json& object, const char* key) const;

  /// An element of an array that is an index.
  std::size_t indexIn(const Json& array, std::size_t element) const;

  const Json& root() const { return this->Root; }

  GltfAccessor accessor(std::size_t index);

  /// The size of the file and of the buffers in files of their own that were used.
  std::size_t bytes() const { return this->Input.bytes.size() + this->OtherBytes; }

private:
  std::span<const char> findJson();
  void checkVersion() const;
  void checkExtensions() const;
  std::span<const char> buffer(std::size_t index);
  std::span<const char> bufferAt(const std::string& uri, std::size_t index);
  std::vector<char> decode(std::string_view text, std::size_t index) const;

  const Source& Input;
  Json Root;
  bool IsBinary = false;
  const ReadBuffer& Read;
  std::span<const char> Binary;               // the BIN chunk
  std::vector<std::vector<char>> Decoded;     // of embedded buffers
  std::vector<std::span<const char>> Buffers; // with a URI, once they were used
  std::size_t OtherBytes = 0;
};

} // namespace scan
