// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/format_registry.h"

#include "readers/autodesk_3ds.h"
#include "readers/cad.h"
#include "readers/cyberware_header.h"
#include "readers/digibotics.h"
#include "readers/gltf.h"
#include "readers/las.h"
#include "readers/legacy_vtk.h"
#include "readers/obj.h"
#include "readers/off.h"
#include "readers/pcd.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/pts.h"
#include "readers/ptx.h"
#include "readers/stl.h"
#include "readers/threemf.h"
#include "readers/vtkScanAutodesk3dsReader.h"
#include "readers/vtkScanCadReader.h"
#include "readers/vtkScanCyberwareReader.h"
#include "readers/vtkScanDigiboticsReader.h"
#include "readers/vtkScanGltfReader.h"
#include "readers/vtkScanLasReader.h"
#include "readers/vtkScanLegacyVtkReader.h"
#include "readers/vtkScanObjReader.h"
#include "readers/vtkScanOffReader.h"
#include "readers/vtkScanPcdReader.h"
#include "readers/vtkScanPlyReader.h"
#include "readers/vtkScanPointsReader.h"
#include "readers/vtkScanPtsReader.h"
#include "readers/vtkScanPtxReader.h"
#include "readers/vtkScanStlReader.h"
#include "readers/vtkScanThreemfReader.h"
#include "readers/vtkScanVtpReader.h"
#include "readers/vtp.h"
#include "writers/vtkScanAutodesk3dsWriter.h"
#include "writers/vtkScanDxfWriter.h"
#include "writers/vtkScanGlbWriter.h"
#include "writers/vtkScanIgesWriter.h"
#include "writers/vtkScanInventorWriter.h"
#include "writers/vtkScanObjWriter.h"
#include "writers/vtkScanOffWriter.h"
#include "writers/vtkScanPlyWriter.h"
#include "writers/vtkScanPngWriter.h"
#include "writers/vtkScanStlWriter.h"
#include "writers/vtkScanThreemfWriter.h"
#include "writers/vtkScanVrmlWriter.h"
#include "writers/vtkScanVtpWriter.h"
#include "writers/vtkScanXyzWriter.h"

namespace scan
{
namespace
{

/// For readers without settings of their own.
template <class Reader>
void configure(Reader&, const ReadOptions&)
{
}

template <>
void configure(vtkScanCadReader& reader, const ReadOptions& options)
{
  const Length& tolerance = options.tolerance;
  if (tolerance.unit() == Length::Unit::diagonalPercent)
  {
    reader.SetRelativeTolerance(tolerance.value() / 100.0);
  }
  else
  {
    reader.SetTolerance(tolerance.resolve({ .millimetresPerUnit = 1.0 }));
  }
}

template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeReader(const std::string& path, const ReadOptions& options)
{
  using Content = vtkScanReader::Content;
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->SetReadAs(options.as == ReadAs::points ? Content::points
      : options.as == ReadAs::mesh               ? Content::mesh
                                                 : Content::automatic);
  configure(*reader, options);
  return reader;
}

/// For writers without settings of their own.
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

bool isChosen(const ParameterValues& values, std::string_view name, std::string_view choice)
{
  return std::get<std::string>(values.find(name)->second) == choice;
}

template <>
void configure(vtkScanDxfWriter& writer, const ParameterValues& values)
{
  writer.SetFaces(isChosen(values, "faces", "polyface") ? DxfFaces::polyface : DxfFaces::face3d);
}

template <>
void configure(vtkScanIgesWriter& writer, const ParameterValues& values)
{
  writer.SetEntities(isChosen(values, "entities", "solid") ? IgesEntities::solid
      : isChosen(values, "entities", "nurbs")              ? IgesEntities::nurbs
      : isChosen(values, "entities", "wireframe")          ? IgesEntities::wireframe
      : isChosen(values, "entities", "points")             ? IgesEntities::points
                                                           : IgesEntities::faces);
}

template <>
void configure(vtkScanVrmlWriter& writer, const ParameterValues& values)
{
  writer.SetVersion1(isChosen(values, "version", "1.0"));
}

template <class Writer>
vtkSmartPointer<vtkAlgorithm> makeWriter(const std::string& path, const ParameterValues& values)
{
  const auto writer = vtkSmartPointer<Writer>::New();
  writer->SetFileName(path.c_str());
  if constexpr (requires { writer->SetConsistent(true); })
  {
    const auto consistent = values.find("consistent");
    writer->SetConsistent(consistent == values.end() || std::get<bool>(consistent->second));
  }
  configure(*writer, values);
  return writer;
}

Parameter consistentParameter()
{
  return { .name = "consistent",
    .defaultValue = true,
    .help = "surfaces are mended: manifold, no triangles without area, outwards; "
            "false writes them as they are" };
}

Parameter encodingParameter()
{
  return { .name = "encoding",
    .defaultValue = "binary",
    .help = "binary is smaller and faster, ascii can be read by people",
    .choices = { "binary", "ascii" } };
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table
const std::vector<Format>& formats()
{
  static const std::vector<Format> kFormats{
    { .name = "PLY",
      .extensions = { "ply" },
      .reads = { .points = true, .triangles = true, .colors = true, .normals = true },
      .writes = { .points = true, .triangles = true, .colors = true, .normals = true },
      .writeParameters = { encodingParameter(), consistentParameter() },
      .looksLike = looksLikePly,
      .makeReader = makeReader<vtkScanPlyReader>,
      .makeWriter = makeWriter<vtkScanPlyWriter> },
    { .name = "STL",
      .extensions = { "stl" },
      .reads = { .triangles = true },
      .writes = { .triangles = true, .limits = "binary: 7 digits" },
      .writeParameters = { encodingParameter(), consistentParameter() },
      .looksLike = looksLikeStl,
      .makeReader = makeReader<vtkScanStlReader>,
      .makeWriter = makeWriter<vtkScanStlWriter> },
    { .name = "OBJ",
      .extensions = { "obj" },
      .reads = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true },
      .writes = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeObj,
      .makeReader = makeReader<vtkScanObjReader>,
      .makeWriter = makeWriter<vtkScanObjWriter> },
    { .name = "OFF",
      .extensions = { "off" },
      .reads = { .points = true, .triangles = true, .colors = true, .normals = true },
      .writes = { .points = true, .triangles = true, .colors = true },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeOff,
      .makeReader = makeReader<vtkScanOffReader>,
      .makeWriter = makeWriter<vtkScanOffWriter> },
    { .name = "3D Studio",
      .extensions = { "3ds" },
      .reads = { .points = true, .triangles = true },
      .writes = { .triangles = true, .limits = "7 digits; parts of 65,535 points or triangles" },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeAutodesk3ds,
      .makeReader = makeReader<vtkScanAutodesk3dsReader>,
      .makeWriter = makeWriter<vtkScanAutodesk3dsWriter> },
    { .name = "DXF",
      .extensions = { "dxf" },
      .writes = { .points = true,
        .triangles = true,
        .curves = true,
        .limits = "polyface: parts of 32,767 points or triangles" },
      .writeParameters = { { .name = "faces",
                             .defaultValue = "3dface",
                             .help = "triangles one by one, which every program reads, or meshes "
                                     "with shared points",
                             .choices = { "3dface", "polyface" } },
        consistentParameter() },
      .makeWriter = makeWriter<vtkScanDxfWriter> },
    { .name = "Open Inventor",
      .extensions = { "iv" },
      .writes = { .points = true, .triangles = true, .curves = true, .colors = true },
      .writeParameters = { consistentParameter() },
      .makeWriter = makeWriter<vtkScanInventorWriter> },
    { .name = "VRML",
      .extensions = { "wrl", "vrml" },
      .writes = { .points = true, .triangles = true, .curves = true, .colors = true },
      .writeParameters = { { .name = "version",
                             .defaultValue = "97",
                             .help = "VRML97, also named 2.0, or the older 1.0",
                             .choices = { "97", "1.0" } },
        consistentParameter() },
      .makeWriter = makeWriter<vtkScanVrmlWriter> },
    { .name = "IGES",
      .extensions = { "igs", "iges" },
      .reads = { .triangles = true, .unit = "millimetre" },
      .writes = { .points = true,
        .triangles = true,
        .curves = true,
        .unit = "in the file",
        .limits = "9,999,999 lines: 1.5 million triangles, 800,000 as a solid" },
      .writeParameters = { { .name = "entities",
                             .defaultValue = "faces",
                             .help = "planes one by one, one solid of a closed surface, patches, "
                                     "polylines, points",
                             .choices = { "faces", "solid", "nurbs", "wireframe", "points" } },
        consistentParameter() },
      .looksLike = looksLikeIges,
      .makeReader = makeReader<vtkScanCadReader>,
      .makeWriter = makeWriter<vtkScanIgesWriter> },
    { .name = "glTF",
      .extensions = { "glb", "gltf" },
      .writeExtensions = { "glb" },
      .reads = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true,
        .unit = "metre" },
      .writes = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true,
        .unit = "metre",
        .limits = "written as glb: 7 digits around the centre, 4 GB" },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeGltf,
      .makeReader = makeReader<vtkScanGltfReader>,
      .makeWriter = makeWriter<vtkScanGlbWriter> },
    { .name = "3MF",
      .extensions = { "3mf" },
      .reads = { .triangles = true, .unit = "in the file" },
      .writes = { .triangles = true, .unit = "in the file" },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeThreemf,
      .makeReader = makeReader<vtkScanThreemfReader>,
      .makeWriter = makeWriter<vtkScanThreemfWriter> },
    { .name = "STEP",
      .extensions = { "stp", "step" },
      .reads = { .triangles = true, .unit = "millimetre" },
      .looksLike = looksLikeStep,
      .makeReader = makeReader<vtkScanCadReader> },
    { .name = "VTK XML PolyData",
      .extensions = { "vtp" },
      .reads = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true,
        .unit = "in the file" },
      .writes = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true,
        .unit = "in the file" },
      .writeParameters = { consistentParameter() },
      .looksLike = looksLikeVtp,
      .makeReader = makeReader<vtkScanVtpReader>,
      .makeWriter = makeWriter<vtkScanVtpWriter> },
    { .name = "legacy VTK",
      .extensions = { "vtk" },
      .reads = { .points = true,
        .triangles = true,
        .curves = true,
        .colors = true,
        .normals = true,
        .unit = "in the file" },
      .looksLike = looksLikeLegacyVtk,
      .makeReader = makeReader<vtkScanLegacyVtkReader> },
    { .name = "LAS",
      .extensions = { "las" },
      .reads = { .points = true,
        .colors = true,
        .unit = "in the file",
        .limits = "not compressed" },
      .looksLike = looksLikeLas,
      .makeReader = makeReader<vtkScanLasReader> },
    { .name = "PCD",
      .extensions = { "pcd" },
      .reads = { .points = true, .colors = true, .normals = true },
      .looksLike = looksLikePcd,
      .makeReader = makeReader<vtkScanPcdReader> },
    { .name = "Cyberware range map",
      .extensions = { "cy", "echo" },
      .reads = { .points = true,
        .triangles = true,
        .colors = true,
        .unit = "millimetre",
        .limits = "triangles with --as=mesh" },
      .looksLike = looksLikeCyberware,
      .makeReader = makeReader<vtkScanCyberwareReader> },
    { .name = "PTX",
      .extensions = { "ptx" },
      .reads = { .points = true, .colors = true, .unit = "metre" },
      .looksLike = looksLikePtx,
      .makeReader = makeReader<vtkScanPtxReader> },
    { .name = "PTS",
      .extensions = { "pts" },
      .reads = { .points = true, .colors = true },
      .looksLike = looksLikePts,
      .makeReader = makeReader<vtkScanPtsReader> },
    { .name = "Digibotics contours",
      .extensions = { "dbt", "dig" },
      .reads = { .points = true, .unit = "in the file", .limits = "text; not verified" },
      .looksLike = looksLikeDigibotics,
      .makeReader = makeReader<vtkScanDigiboticsReader> },
    { .name = "points as text",
      .extensions = { "xyz", "txt", "asc", "pts", "csv" },
      .writeExtensions = { "xyz", "txt", "asc" },
      .reads = { .points = true, .colors = true, .normals = true },
      .writes = { .points = true, .colors = true, .normals = true },
      .looksLike = looksLikePointsText,
      .isVague = true,
      .makeReader = makeReader<vtkScanPointsReader>,
      .makeWriter = makeWriter<vtkScanXyzWriter> },
    { .name = "PNG picture",
      .extensions = { "png" },
      .isPicture = true,
      .makeWriter = makeWriter<vtkScanPngWriter> },
  };
  return kFormats;
}

} // namespace scan
