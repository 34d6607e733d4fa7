// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanGltfReader.h"

#include "readers/gltf.h"
#include "readers/mapped_file.h"
#include "readers/text_scanner.h"

#include <vtkObjectFactory.h>

#include <charconv>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkScanGltfReader);

namespace
{

/// The text of a URI without its escapes: "%20" becomes a blank.
std::string unescaped(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    unsigned char code = 0;
    const char* const digits = uri.data() + i + 1;
    const bool isEscape = uri[i] == '%' && i + 2 < uri.size() &&
      std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    text += isEscape ? static_cast<char>(code) : uri[i];
    i += isEscape ? 2 : 0;
  }
  return text;
}

} // namespace

scan::Model vtkScanGltfReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  std::vector<std::unique_ptr<scan::MappedFile>> buffers;
  const auto readBuffer = [&](const std::string& uri)
  {
    const std::filesystem::path path = unescaped(uri);
    if (path.empty() || path.is_absolute() || uri.find("://") != std::string::npos)
    {
      scan::Source{ name, bytes }.fail("a buffer is at " + scan::quoted(uri) +
        ", which is no file beside this one; save as .glb or with embedded buffers");
    }
    const auto folder = std::filesystem::path(this->FileName).parent_path();
    buffers.push_back(std::make_unique<scan::MappedFile>(folder / path));
    return buffers.back()->bytes();
  };
  return scan::parseGltfScene(bytes, name, { .readBuffer = readBuffer }, execution);
}
