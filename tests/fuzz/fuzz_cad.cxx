// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzers of the readers of CAD files, SCAN_FUZZED being parseStep or parseIges. OpenCASCADE works
// in a process of its own and is not instrumented: what it does there, it ends in a usable model or
// in one line of an Error here.
#include "readers/cad.h"
#include "tests/fuzz/outcome.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::span<const char> bytes(reinterpret_cast<const char*>(data), size);
  scan::Execution execution(1);
  scan::looksLikeStep(bytes);
  scan::looksLikeIges(bytes);
  scan::test::requireModelOrError(
    [&] { return scan::SCAN_FUZZED(bytes, "file", scan::CadOptions(), execution); });
  return 0;
}
