// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanVtpReader.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "readers/coordinate_check.h"
#include "readers/isolated_run.h"
#include "readers/vtp.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <string>

vtkStandardNewMacro(vtkScanVtpReader);

namespace
{

/// Keeps the first error of all VTK objects.
class FirstError : public vtkOutputWindow
{
public:
  static FirstError* New();
  vtkTypeMacro(FirstError, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (this->Text.empty())
    {
      this->Text = text;
    }
  }

  /// Without the source file, the class and further lines.
  std::string Words() const
  {
    const std::size_t name = this->Text.find("): ");
    const std::size_t start = name == std::string::npos ? 0 : name + 3;
    const std::size_t end = this->Text.find_first_of("\r\n", start);
    return this->Text.substr(start, end - start);
  }

  bool IsEmpty() const { return this->Text.empty(); }

private:
  std::string Text;
};
vtkStandardNewMacro(FirstError);

void forwardProgress(vtkAlgorithm& reader, const scan::ReportFraction& report)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(const_cast<scan::ReportFraction*>(&report));
  command->SetCallback([](vtkObject*, unsigned long, void* to, void* fraction)
    { (*static_cast<scan::ReportFraction*>(to))(*static_cast<double*>(fraction)); });
  reader.AddObserver(vtkCommand::ProgressEvent, command);
}

vtkSmartPointer<vtkPolyData> readXml(const scan::Source& source, const scan::ReportFraction& report)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  forwardProgress(*reader, report);
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::string(source.begin(), source.end()));
  reader->Update();
  return reader->GetOutput();
}

void check(scan::Model& model, const scan::Source& source)
{
  if (model.points.empty())
  {
    source.fail("no points found; give a file of PolyData with points");
  }
  scan::CoordinateCheck coordinates;
  for (const scan::Vec3& point : model.points)
  {
    coordinates.see(point);
  }
  coordinates.finish(source, model, scan::CoordinateCheck::Place::unknown);
}

scan::Model modelIn(const scan::Source& source, const scan::ReportFraction& report)
{
  vtkNew<FirstError> error;
  vtkOutputWindow::SetInstance(error);
  vtkObject::GlobalWarningDisplayOn();
  const vtkSmartPointer<vtkPolyData> data = readXml(source, report);
  if (!error->IsEmpty())
  {
    source.fail(error->Words());
  }
  if (!data->GetPolys()->IsValid() || !data->GetStrips()->IsValid() || !data->GetLines()->IsValid())
  {
    source.fail("the offsets of the cells are malformed; write the file again");
  }
  try
  {
    scan::Model model = scan::bridge::modelOf(*data);
    check(model, source);
    return model;
  }
  catch (const scan::Error& wrong)
  {
    if (wrong.code() == scan::ErrorCode::badInput)
    {
      source.fail(wrong.what());
    }
    throw;
  }
}

} // namespace

scan::Model vtkScanVtpReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  const scan::Source source{ name, bytes };
  if (!scan::looksLikeVtp(bytes))
  {
    source.fail("not XML PolyData of VTK: its first element is not VTKFile of that type");
  }
  scan::checkVtp(source);
  return scan::runIsolated([&](const scan::ReportFraction& report)
    { return modelIn(source, report); },
    std::string(name) + ": VTK cannot read the content; write the file again", execution);
}
