// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cad.h"

#include "filters/base/error.h"
#include "readers/cad_tessellation.h"
#include "readers/coordinate_check.h"
#include "readers/isolated_run.h"
#include "readers/text_scanner.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <new>
#include <numbers>
#include <streambuf>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kIgesColumns = 72; // of data; the section and the number follow
constexpr double kRelativeGap = 1e-5;    // between loose faces that meet, of the diagonal

/// A progress bar of OpenCASCADE that reports every percent.
class FractionIndicator : public Message_ProgressIndicator
{
public:
  explicit FractionIndicator(const ReportFraction& report)
    : Report(report)
  {
  }

protected:
  void Show(const Message_ProgressScope&, Standard_Boolean) override
  {
    const double fraction = this->GetPosition();
    if (fraction >= this->Reported + 0.01)
    {
      this->Reported = fraction;
      this->Report(fraction);
    }
  }

private:
  const ReportFraction& Report;
  double Reported = 0.0;
};

/// Bytes in memory to read from.
class MemoryBuffer : public std::streambuf
{
public:
  explicit MemoryBuffer(std::span<const char> bytes)
  {
    char* const start = const_cast<char*>(bytes.data()); // a get area is never written
    this->setg(start, start, start + bytes.size());
  }
};

/// Bytes under a path, without a file.
class MemoryFile
{
public:
  explicit MemoryFile(std::span<const char> bytes)
    : Descriptor(::memfd_create("iges", MFD_CLOEXEC))
  {
    while (!bytes.empty())
    {
      const ssize_t put = ::write(this->Descriptor, bytes.data(), bytes.size());
      if (put <= 0)
      {
        throw std::bad_alloc();
      }
      bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(this->Descriptor); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(this->Descriptor); }

private:
  int Descriptor = -1;
};

constexpr const char* kCannotRead =
  "OpenCASCADE cannot read the content; export it again from the CAD program";

[[noreturn]] void failOnContent(const Source& source)
{
  source.fail(kCannotRead);
}

/// The shape of a file, once it is read into `reader`.
TopoDS_Shape transfer(XSControl_Reader& reader, const Message_ProgressRange& progress)
{
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.TransferRoots(progress);
  return reader.OneShape();
}

/// What a file holds.
struct CadContent
{
  TopoDS_Shape shape;
  double resolution = 0.0;        // in millimetres, where the file tells
  bool mayHaveLooseFaces = false; // that belong together, though the file does not say so
};

CadContent readStep(const Source& source, Message_ProgressScope& progress)
{
  STEPControl_Reader reader;
  MemoryBuffer buffer(source.bytes);
  std::istream stream(&buffer);
  if (reader.ReadStream("model", stream) != IFSelect_RetDone)
  {
    failOnContent(source);
  }
  progress.Next(2);
  return { transfer(reader, progress.Next(4)) };
}

CadContent readIges(const Source& source, Message_ProgressScope& progress)
{
  const MemoryFile file(source.bytes);
  IGESControl_Reader reader;
  if (reader.ReadFile(file.path().c_str()) != IFSelect_RetDone || reader.NbRootsForTransfer() == 0)
  {
    failOnContent(source);
  }
  progress.Next(2);
  const TopoDS_Shape shape = transfer(reader, progress.Next(4));
  const IGESData_GlobalSection& header = reader.IGESModel()->GlobalSection();
  return { shape, header.Resolution() * header.UnitValue(), true };
}

/// The faces of the shape; those that are in no shell sewn where they are closer than the
/// tolerance.
TopoDS_Shape sewLooseFaces(
  const TopoDS_Shape& shape, double tolerance, const Message_ProgressRange& progress)
{
  BRepBuilderAPI_Sewing sewing(tolerance);
  TopExp_Explorer loose(shape, TopAbs_FACE, TopAbs_SHELL);
  if (!loose.More())
  {
    return shape;
  }
  for (; loose.More(); loose.Next())
  {
    sewing.Add(loose.Current());
  }
  sewing.Perform(progress);
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, sewing.SewedShape());
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
  {
    builder.Add(all, solid.Current());
  }
  for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
  {
    builder.Add(all, shell.Current());
  }
  return all;
}

/// The diagonal of the box around all faces; 0 without faces.
double diagonalOf(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
  {
    BRepBndLib::AddOptimal(at.Current(), box, Standard_False, Standard_False);
  }
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

using Read = CadContent (*)(const Source& source, Message_ProgressScope& progress);

TriMesh meshOf(
  const Source& source, const CadOptions& options, Read read, const ReportFraction& report)
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const Handle(FractionIndicator) indicator = new FractionIndicator(report);
  Message_ProgressScope progress(indicator->Start(), "", 20);
  const CadContent content = read(source, progress);
  const double diagonal = content.shape.IsNull() ? 0.0 : diagonalOf(content.shape);
  if (!(diagonal > 0.0 && diagonal < CoordinateCheck::kLargest))
  {
    source.fail("no surfaces found; export the model as surfaces or solids");
  }
  const double deflection =
    options.deflection > 0.0 ? options.deflection : options.relativeDeflection * diagonal;
  const Message_ProgressRange sewing = progress.Next(4);
  const double gap = std::max(content.resolution, kRelativeGap * diagonal);
  const TopoDS_Shape shape = content.mayHaveLooseFaces
    ? sewLooseFaces(content.shape, std::min(gap, 0.5 * deflection), sewing)
    : content.shape;
  return tessellate(shape, deflection, options.angle, source, progress.Next(10));
}

/// meshOf() with Errors in place of the exceptions of OpenCASCADE.
TriMesh guardedMeshOf(
  const Source& source, const CadOptions& options, Read read, const ReportFraction& report)
{
  try
  {
    return meshOf(source, options, read, report);
  }
  catch (const Standard_OutOfMemory&)
  {
    throw std::bad_alloc();
  }
  catch (const Standard_Failure&)
  {
    failOnContent(source);
  }
}

void check(const CadOptions& options)
{
  const bool isUsable = options.deflection >= 0.0 &&
    options.deflection < CoordinateCheck::kLargest && options.relativeDeflection > 0.0 &&
    options.relativeDeflection <= 1.0 && options.angle > 0.0 && options.angle <= std::numbers::pi;
  if (!isUsable)
  {
    throw Error(ErrorCode::badParameter,
      "the deflection must be 0 or more, or more than 0 and at most 1 of the diagonal; the angle "
      "more than 0 and at most pi");
  }
}

Model modelOf(const Source& source, const CadOptions& options, Read read, Execution& execution)
{
  check(options);
  const std::string whenItDies = std::string(source.name) + ": " + kCannotRead;
  Model model{ runIsolated([&](const ReportFraction& report)
    { return Model{ guardedMeshOf(source, options, read, report) }; },
    whenItDies, execution) };
  if (model.triangles.empty() || !std::ranges::all_of(model.points, CoordinateCheck::isUsable))
  {
    failOnContent(source);
  }
  model.millimetresPerUnit = 1.0;
  return model;
}

std::string_view textOf(std::span<const char> bytes)
{
  return { bytes.data(), bytes.size() };
}

/// The section that the line at the start of `text` belongs to; 0 for a short line.
char igesSection(std::string_view text)
{
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() > kIgesColumns ? line[kIgesColumns] : '\0';
}

void checkIgesEnd(const Source& source)
{
  std::string_view text = textOf(source.bytes);
  text = text.substr(0, text.find_last_not_of(std::string_view("\0 \t\r\n\x1a", 6)) + 1);
  const std::string_view last = text.substr(text.find_last_of("\r\n") + 1);
  if (igesSection(last) != 'T')
  {
    source.fail("the file ends early: its last line is not the one of section T; copy or export "
                "it again");
  }
}

} // namespace

Model parseStep(std::span<const char> bytes, std::string_view name, const CadOptions& options,
  Execution& execution)
{
  const Source source{ name, bytes };
  if (!looksLikeStep(bytes))
  {
    source.fail("not a STEP file: it does not start with ISO-10303-21;");
  }
  if (textOf(bytes).rfind("END-ISO-10303-21") == std::string_view::npos)
  {
    source.fail("the file ends early: END-ISO-10303-21; is missing; copy or export it again");
  }
  return modelOf(source, options, readStep, execution);
}

Model parseIges(std::span<const char> bytes, std::string_view name, const CadOptions& options,
  Execution& execution)
{
  const Source source{ name, bytes };
  if (!looksLikeIges(bytes))
  {
    source.fail("not an IGES file: columns 73 to 80 of the first line are not S and the number 1");
  }
  if (igesSection(textOf(bytes)) != 'S')
  {
    source.fail("compressed and binary IGES files cannot be read; export the fixed ASCII form");
  }
  checkIgesEnd(source);
  return modelOf(source, options, readIges, execution);
}

bool looksLikeStep(std::span<const char> head)
{
  const char* const end = head.data() + head.size();
  const std::string_view text = textOf({ skipSpace(head.data(), end), end });
  return text.starts_with("ISO-10303-21;");
}

bool looksLikeIges(std::span<const char> head)
{
  const std::string_view text = textOf(head);
  if (std::string_view("SCB").find(igesSection(text)) == std::string_view::npos)
  {
    return false;
  }
  const std::string_view number = text.substr(kIgesColumns + 1, 7);
  const std::size_t digit = number.find_first_not_of(" 0");
  return digit != std::string_view::npos && number[digit] == '1' &&
    number.find_first_not_of(" \r\n", digit + 1) == std::string_view::npos;
}

} // namespace scan
