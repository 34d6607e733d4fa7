// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/format_registry.h"

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

/// For writers without settings.
template <class Writer>
void configure(Writer&, const ParameterValues&)
{
}

void setEncoding(vtkScanWriter& writer, const ParameterValues& values)
{
  const bool isText = std::get<std::string>(values.at("encoding")) == "ascii";
  writer.SetEncoding(isText ? Encoding::ascii : Encoding::binary);
}

template <>
void configure(vtkScanPlyWriter& writer, const ParameterValues& values)
{
  setEncoding(writer, values);
}

template <>
void configure(vtkScanStlWriter& writer, const ParameterValues& values)
{
  setEncoding(writer, values);
}

template <class Writer>
vtkSmartPointer<vtkAlgorithm> makeWriter(const std::string& path, const ParameterValues& values)
{
  const auto writer = vtkSmartPointer<Writer>::New();
  writer->SetFileName(path.c_str());
  configure(*writer, values);
  return writer;
}

Parameter encodingParameter()
{
  return { .name = "encoding",
    .defaultValue = "binary",
    .help = "binary is smaller and faster, ascii can be read by people",
    .choices = { "binary", "ascii" } };
}

} // namespace

const std::vector<Format>& formats()
{
  static const std::vector<Format> kFormats{
    { .name = "PLY",
      .extensions = { "ply" },
      .reads = { .points = true, .triangles = true },
      .writes = { .points = true, .triangles = true },
      .writeParameters = { encodingParameter() },
      .looksLike = looksLikePly,
      .makeReader = makeReader<vtkScanPlyReader>,
      .makeWriter = makeWriter<vtkScanPlyWriter> },
    { .name = "STL",
      .extensions = { "stl" },
      .reads = { .triangles = true },
      .writes = { .triangles = true, .limits = "binary: 7 digits" },
      .writeParameters = { encodingParameter() },
      .looksLike = looksLikeStl,
      .makeReader = makeReader<vtkScanStlReader>,
      .makeWriter = makeWriter<vtkScanStlWriter> },
    { .name = "OBJ",
      .extensions = { "obj" },
      .reads = { .points = true, .triangles = true },
      .writes = { .points = true, .triangles = true },
      .looksLike = looksLikeObj,
      .makeReader = makeReader<vtkScanObjReader>,
      .makeWriter = makeWriter<vtkScanObjWriter> },
    { .name = "points as text",
      .extensions = { "xyz", "txt", "asc", "pts", "csv" },
      .reads = { .points = true },
      .looksLike = looksLikePointsText,
      .makeReader = makeReader<vtkScanPointsReader> },
    { .name = "PNG picture",
      .extensions = { "png" },
      .isPicture = true,
      .makeWriter = makeWriter<vtkScanPngWriter> },
  };
  return kFormats;
}

} // namespace scan
