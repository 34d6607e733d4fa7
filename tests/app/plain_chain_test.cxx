// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapFilter.h"
#include "readers/vtkScanPlyReader.h"
#include "tests/readers/temporary_folder.h"
#include "writers/vtkScanStlWriter.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cstdlib>

TEST(PlainChain, WritesTheBytesOfTheCommandLine)
{
  const scan::test::TemporaryFolder folder;
  const std::string input = SCAN_DATA_DIR "/multiview_scan.ply";

  vtkNew<vtkScanPlyReader> reader;
  reader->SetFileName(input.c_str());
  vtkNew<vtkScanWrapFilter> wrap;
  wrap->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkScanStlWriter> writer;
  writer->SetInputConnection(wrap->GetOutputPort());
  writer->SetFileName(folder.file("chain.stl").c_str());
  ASSERT_EQ(writer->Write(), 1);

  const std::string command =
    SCAN_PROGRAM " '" + input + "' wrap -o '" + folder.file("program.stl") + "'";
  // nothing else runs in this program
  ASSERT_EQ(std::system(command.c_str()), 0); // NOLINT(concurrency-mt-unsafe)

  const std::string chain = scan::test::contentOf(folder.file("chain.stl"));
  EXPECT_GT(chain.size(), 1000000U);
  EXPECT_TRUE(chain == scan::test::contentOf(folder.file("program.stl")));
}
