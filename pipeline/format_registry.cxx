// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/format_registry.h"

#include "filters/base/error.h"
#include "pipeline/file_head.h"
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/stl.h"
#include "readers/vtkScanObjReader.h"
#include "readers/vtkScanPlyReader.h"
#include "readers/vtkScanPointsReader.h"
#include "readers/vtkScanStlReader.h"
#include "writers/vtkScanObjWriter.h"
#include "writers/vtkScanPlyWriter.h"
#include "writers/vtkScanPngWriter.h"
#include "writers/vtkScanStlWriter.h"

#include <algorithm>
#include <filesystem>
#include <type_traits>

namespace scan
{

namespace
{

template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeReader(const std::string& path, ReadAs as)
{
  using Content = vtkScanReader::Content;
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->SetReadAs(as == ReadAs::points ? Content::points
      : as == ReadAs::mesh               ? Content::mesh
                                         : Content::automatic);
  return reader;
}

template <class Writer>
vtkSmartPointer<vtkAlgorithm> makeWriter(const std::string& path, Encoding encoding)
{
  const auto writer = vtkSmartPointer<Writer>::New();
  writer->SetFileName(path.c_str());
  if constexpr (std::is_base_of_v<vtkScanWriter, Writer>)
  {
    writer->SetEncoding(encoding);
  }
  return writer;
}

std::string extensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  extension.erase(0, 1);
  std::ranges::transform(extension, extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

bool hasExtension(const Format& format, const std::string& extension)
{
  return std::ranges::find(format.extensions, extension) != format.extensions.end();
}

const Format* readableByExtension(const std::string& extension)
{
  const auto found = std::ranges::find_if(formats(),
    [&](const Format& format)
    { return format.makeReader != nullptr && hasExtension(format, extension); });
  return found != formats().end() ? &*found : nullptr;
}

template <class Predicate>
std::string extensionsOf(Predicate isWanted)
{
  std::string text;
  for (const Format& format : formats())
  {
    if (isWanted(format))
    {
      for (const std::string& extension : format.extensions)
      {
        text += (text.empty() ? "" : ", ") + extension;
      }
    }
  }
  return text;
}

} // namespace

const std::vector<Format>& formats()
{
  static const std::vector<Format> kFormats{
    { .name = "PLY",
      .extensions = { "ply" },
      .looksLike = looksLikePly,
      .makeReader = makeReader<vtkScanPlyReader>,
      .makeWriter = makeWriter<vtkScanPlyWriter> },
    { .name = "STL",
      .extensions = { "stl" },
      .looksLike = looksLikeStl,
      .makeReader = makeReader<vtkScanStlReader>,
      .makeWriter = makeWriter<vtkScanStlWriter> },
    { .name = "OBJ",
      .extensions = { "obj" },
      .looksLike = looksLikeObj,
      .makeReader = makeReader<vtkScanObjReader>,
      .makeWriter = makeWriter<vtkScanObjWriter> },
    { .name = "points as text",
      .extensions = { "xyz", "txt", "asc", "pts", "csv" },
      .looksLike = looksLikePointsText,
      .makeReader = makeReader<vtkScanPointsReader> },
    { .name = "PNG picture",
      .extensions = { "png" },
      .isPicture = true,
      .makeWriter = makeWriter<vtkScanPngWriter> },
  };
  return kFormats;
}

const Format& formatToRead(const std::string& path, const CancelToken& token)
{
  const std::vector<char> head = path == "-" ? headOfStandardInput(token) : headOfFile(path);
  const std::string name = path == "-" ? "standard input" : path;
  if (head.empty())
  {
    throw Error(ErrorCode::parse, name + ": the file is empty; give a file with points");
  }
  const std::string extension = extensionOf(path);
  const Format* found = nullptr;
  for (const Format& format : formats())
  {
    if (format.looksLike != nullptr && format.looksLike(head) &&
      (found == nullptr || hasExtension(format, extension)))
    {
      found = &format;
    }
  }
  if (found == nullptr)
  {
    // the parser of the promised format says best what is wrong
    found = readableByExtension(extension);
  }
  if (found == nullptr)
  {
    throw Error(ErrorCode::parse,
      name + ": the content is of no known format; known are " + readableExtensions());
  }
  return *found;
}

const Format& formatToWrite(const std::string& path)
{
  const std::string extension = path == "-" ? "ply" : extensionOf(path);
  for (const Format& format : formats())
  {
    if (format.makeWriter != nullptr && hasExtension(format, extension))
    {
      return format;
    }
  }
  throw Error(ErrorCode::badParameter,
    path + ": no format for this name; end it with one of " + writableExtensions());
}

std::string readableExtensions()
{
  return extensionsOf([](const Format& format) { return format.makeReader != nullptr; });
}

std::string writableExtensions()
{
  return extensionsOf([](const Format& format) { return format.makeWriter != nullptr; });
}

} // namespace scan
