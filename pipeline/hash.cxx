// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hash.h"

#include "readers/mapped_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <iterator>

namespace scan
{

Hash hashOf(std::span<const char> bytes)
{
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  Hash hash;
  std::ranges::copy(canonical.digest, hash.bytes.begin());
  return hash;
}

std::string textOf(const Hash& hash)
{
  std::string text;
  for (const char byte : hash.bytes)
  {
    fmt::format_to(std::back_inserter(text), "{:02x}", static_cast<unsigned char>(byte));
  }
  return text;
}

Hash hashOfFile(const std::string& path)
{
  return hashOf(MappedFile(path).bytes());
}

} // namespace scan
