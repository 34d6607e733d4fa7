// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/format_registry.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"
#include "pipeline/file_head.h"
#include "pipeline/unread_formats.h"
#include "readers/text_scanner.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace scan
{

namespace
{

std::string extensionOf(const std::string& path)
{
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : lowerCase(extension).substr(1);
}

bool hasExtension(const Format& format, const std::string& extension)
{
  return std::ranges::find(format.extensions, extension) != format.extensions.end();
}

std::vector<std::string> writeExtensionsOf(const Format& format)
{
  return format.makeWriter == nullptr ? std::vector<std::string>()
    : format.writeExtensions.empty()  ? format.extensions
                                      : format.writeExtensions;
}

const Format* readableByExtension(const std::string& extension)
{
  const auto found = std::ranges::find_if(formats(),
    [&](const Format& format)
    { return format.makeReader != nullptr && hasExtension(format, extension); });
  return found != formats().end() ? &*found : nullptr;
}

std::string listOf(const std::vector<std::string>& extensions)
{
  std::string text;
  for (const std::string& extension : extensions)
  {
    text += text.empty() ? "" : ", ";
    text += extension;
  }
  return text;
}

/// A line of the table of formats.
std::string tableRow(const Format& format)
{
  const auto held = [](bool isThere, const Abilities& can)
  {
    std::vector<std::string> kinds;
    for (const auto& [isHeld, kind] : { std::pair{ can.points, "points" },
           { can.triangles, "triangles" }, { can.curves, "curves" } })
    {
      if (isThere && isHeld)
      {
        kinds.emplace_back(kind);
      }
    }
    return isThere ? listOf(kinds) : std::string("no");
  };
  const auto ways = [](bool isRead, bool isWritten)
  {
    return std::string(isRead && isWritten ? "read, written"
        : isRead                           ? "read"
        : isWritten                        ? "written"
                                           : "no");
  };
  const Abilities& reads = format.reads;
  const Abilities& writes = format.writes;
  const std::string unit = reads.unit == writes.unit || writes.unit.empty() ? reads.unit
    : reads.unit.empty()                                                    ? writes.unit
                         : "read: " + reads.unit + ", written: " + writes.unit;
  return std::string("| ") + format.name + " | " + listOf(format.extensions) + " | " +
    held(format.makeReader != nullptr, reads) + " | " + held(format.makeWriter != nullptr, writes) +
    " | " + ways(reads.colors, writes.colors) + " | " + ways(reads.normals, writes.normals) +
    " | " + (unit.empty() ? "no" : unit) + " | " +
    (writes.limits.empty() ? reads.limits : writes.limits) + " |\n";
}

} // namespace

void checkReadOptions(const ReadOptions& options)
{
  const Length& tolerance = options.tolerance;
  if (tolerance.unit() == Length::Unit::spacing || !(tolerance.value() > 0.0))
  {
    throw Error(ErrorCode::badParameter,
      "--tolerance=" + tolerance.text() + ": expected a length above 0 such as 0.1mm or 0.1%");
  }
}

const Format& formatToRead(const std::string& path, const CancelToken& token)
{
  const std::vector<char> head = path == "-" ? headOfStandardInput(token) : headOfFile(path);
  const std::string name = path == "-" ? "standard input" : path;
  if (head.empty())
  {
    throw Error(ErrorCode::parse, name + ": the file is empty; give a file with points");
  }
  const std::string advice = adviceOnUnread(head);
  if (!advice.empty())
  {
    throw Error(ErrorCode::parse, name + ": " + advice);
  }
  const std::string extension = extensionOf(path);
  const Format* found = nullptr;
  const auto rank = [&](const Format& format)
  { return (format.isVague ? 0 : 2) + (hasExtension(format, extension) ? 1 : 0); };
  for (const Format& format : formats())
  {
    if (format.looksLike != nullptr && format.looksLike(head) &&
      (found == nullptr || rank(format) > rank(*found)))
    {
      found = &format;
    }
  }
  if (found == nullptr || (found->isVague && !hasExtension(*found, extension)))
  {
    // the parser of the promised format says best what is wrong
    const Format* const promised = readableByExtension(extension);
    found = promised != nullptr ? promised : found;
    const std::string unread = promised == nullptr ? adviceOnUnreadName(extension) : "";
    if (!unread.empty())
    {
      throw Error(ErrorCode::parse, name + ": " + unread);
    }
  }
  if (found == nullptr)
  {
    throw Error(ErrorCode::parse,
      name + ": the content is of no known format; known are " + readableExtensions());
  }
  return *found;
}

const Format* findFormatToWrite(const std::string& path)
{
  const std::string extension = path == "-" ? "ply" : extensionOf(path);
  const auto found = std::ranges::find_if(formats(),
    [&](const Format& format)
    {
      const std::vector<std::string> own = writeExtensionsOf(format);
      return std::ranges::find(own, extension) != own.end();
    });
  return found != formats().end() ? &*found : nullptr;
}

const Format& formatToWrite(const std::string& path)
{
  const Format* const format = findFormatToWrite(path);
  if (format == nullptr)
  {
    throw Error(ErrorCode::badParameter,
      path + ": no format for this name; end it with one of " + writableExtensions());
  }
  return *format;
}

std::string readableExtensions()
{
  std::vector<std::string> all;
  for (const Format& format : formats())
  {
    for (const std::string& extension : format.extensions)
    {
      if (format.makeReader != nullptr && std::ranges::find(all, extension) == all.end())
      {
        all.push_back(extension);
      }
    }
  }
  return listOf(all);
}

std::string writableExtensions()
{
  std::vector<std::string> all;
  for (const Format& format : formats())
  {
    const std::vector<std::string> own = writeExtensionsOf(format);
    all.insert(all.end(), own.begin(), own.end());
  }
  return listOf(all);
}

std::string lossesOf(const Format& format, vtkPolyData& model)
{
  if (format.isPicture)
  {
    return {};
  }
  vtkPointData& attributes = *model.GetPointData();
  const bool hasTriangles = model.GetNumberOfPolys() + model.GetNumberOfStrips() > 0;
  std::vector<std::string> lost;
  const auto check = [&](bool isThere, bool isHeld, const char* what)
  {
    if (isThere && !isHeld)
    {
      lost.emplace_back(what);
    }
  };
  check(hasTriangles, format.writes.triangles, "triangles");
  check(model.GetNumberOfLines() > 0, format.writes.curves, "curves");
  check(attributes.GetArray(arrays::kColors) != nullptr, format.writes.colors, "colours");
  check(attributes.GetNormals() != nullptr, format.writes.normals, "normals");
  return lost.empty() ? "" : "the format holds no " + listOf(lost) + "; they are left out";
}

std::string formatTable()
{
  std::string text = "| format | names | read | written | colours | normals | unit | limits |\n"
                     "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Format& format : formats())
  {
    text += format.isPicture ? "" : tableRow(format);
  }
  return text;
}

} // namespace scan
