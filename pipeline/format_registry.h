// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/base/length.h"
#include "pipeline/parameter.h"

#include <vtkSmartPointer.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

namespace scan
{

/// What to take from a file that may hold points and triangles.
enum class ReadAs
{
  automatic, ///< what the file holds
  points,    ///< the points only, as a scan
  mesh       ///< a file without triangles is an error
};

/// How to read files.
struct ReadOptions
{
  ReadAs as = ReadAs::automatic;
  /// Of the triangles of CAD surfaces: millimetres, another unit, or percent of the diagonal of the
  /// bounding box. A plain number is in millimetres.
  Length tolerance = Length(0.1, Length::Unit::diagonalPercent);
};

/// Throws Error badParameter for options that cannot be.
void checkReadOptions(const ReadOptions& options);

/// What comes in or out with a format.
struct Abilities
{
  bool points = false; ///< without triangles
  bool triangles = false;
  bool curves = false;     ///< lines through points
  bool colors = false;     ///< per point
  bool normals = false;    ///< per point
  std::string unit = {};   ///< "metre", or "in the file"; empty: the format has none
  std::string limits = {}; ///< in a few words; empty: those of the model
};

/// A file format: how to recognise, read and write it.
struct Format
{
  std::string name;
  std::vector<std::string> extensions;           ///< lower case, without the dot
  std::vector<std::string> writeExtensions = {}; ///< of these the ones to write; empty: all
  bool isPicture = false; ///< written from a vtkImageData, else from a vtkPolyData
  Abilities reads = {};
  Abilities writes = {};
  std::vector<Parameter> writeParameters = {};

  bool (*looksLike)(std::span<const char> head) = nullptr; ///< null where reading is not possible
  bool isVague = false; ///< other formats may look like this one, too: they come first

  /// A fresh reader; null where reading is not possible. The path "-" is standard input.
  vtkSmartPointer<vtkAlgorithm> (*makeReader)(
    const std::string& path, const ReadOptions& options) = nullptr;

  /// A fresh writer; null where writing is not possible. The path "-" is standard output.
  /// @param values of all writeParameters
  vtkSmartPointer<vtkAlgorithm> (*makeWriter)(
    const std::string& path, const ParameterValues& values) = nullptr;
};

/// Every format, the ones with the surest content check first.
const std::vector<Format>& formats();

/// The format of a file to read. Content decides; the extension decides between formats of equal
/// rank that the content allows, and names the parser that has to say what is wrong when it allows
/// none. Standard input, "-", is read to its end and stays readable.
/// @throws Error{io} for a file that is missing, a directory or unreadable; Error{parse} for an
///   empty file, for known formats that are not read and for unknown content; Cancelled while
///   waiting for standard input
const Format& formatToRead(const std::string& path, const CancelToken& token);

/// The same as formatToWrite(), or null.
const Format* findFormatToWrite(const std::string& path);

/// The format of a file to write, from its extension; "-" is written as PLY.
/// @throws Error{badParameter} naming the extensions that can be written
const Format& formatToWrite(const std::string& path);

/// What the model has and the format cannot hold, in one line; empty when it holds everything.
std::string lossesOf(const Format& format, vtkPolyData& model);

/// "stl, ply, obj": the extensions of the formats that can be read or written.
std::string readableExtensions();
std::string writableExtensions();

/// A table in Markdown of all formats and their abilities.
std::string formatTable();

} // namespace scan
