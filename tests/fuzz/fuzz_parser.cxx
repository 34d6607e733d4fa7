// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target for the parser that SCAN_FUZZED names: whatever the bytes, it ends in a usable
// model or in one line of an Error, and takes no more memory than it may.
#include "tests/fuzz/outcome.h"
#include "tests/fuzz/parser_table.h"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

namespace
{

using scan::test::FuzzedParser;

constexpr const FuzzedParser& kParser =
  *std::find_if(std::begin(scan::test::kFuzzedParsers), std::end(scan::test::kFuzzedParsers),
    [](const FuzzedParser& parser) { return parser.name == SCAN_FUZZED; });

// bytes allocated since the start of the run; the fuzzer has one thread
std::ptrdiff_t allocated = 0;
std::ptrdiff_t mostAllocated = 0;

void seeAllocation(const volatile void*, std::size_t size)
{
  allocated += static_cast<std::ptrdiff_t>(size);
  mostAllocated = std::max(mostAllocated, allocated);
}

void seeRelease(const volatile void* memory)
{
  allocated -=
    static_cast<std::ptrdiff_t>(__sanitizer_get_allocated_size(const_cast<const void*>(memory)));
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  __sanitizer_install_malloc_and_free_hooks(seeAllocation, seeRelease);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::span<const char> bytes(reinterpret_cast<const char*>(data), size);
  scan::Execution execution(1);
  kParser.looksLike(bytes);
  allocated = mostAllocated = 0;
  scan::test::requireModelOrError([&] { return kParser.parse(bytes, "file", execution); });
  scan::test::require(
    mostAllocated <= static_cast<std::ptrdiff_t>(kParser.memoryPerByte * size + kParser.freeMemory),
    std::to_string(mostAllocated) + " bytes of memory for a file of " + std::to_string(size));
  return 0;
}
