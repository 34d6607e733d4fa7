// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/form_hash.h"

#include "pipeline/json_text.h"

#include <algorithm>

namespace scan
{

std::size_t chunkSize(const ArrayShape& shape)
{
  constexpr std::size_t kChunk = std::size_t{ 1 } << 18U;
  const std::size_t tuple = widthOf(shape.type) * static_cast<std::size_t>(shape.components);
  return std::max<std::size_t>(kChunk / tuple, 1) * tuple;
}

Hash hashOf(std::span<const Hash> chunks)
{
  return hashOf(std::span<const char>(
    reinterpret_cast<const char*>(chunks.data()), chunks.size() * sizeof(Hash)));
}

FormHashes hashesOf(const DataForm& form, Execution& execution)
{
  FormHashes hashes;
  StoredForm stored{ form.kind, form.facts, {} };
  for (const auto& [role, array] : form.arrays)
  {
    const std::span<const char> bytes = array.bytes;
    const std::size_t size = chunkSize(array.shape);
    std::vector<Hash>& chunks = hashes.chunks[role];
    chunks.resize((bytes.size() + size - 1) / size);
    execution.parallelFor(chunks.size(), 8,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          chunks[i] = hashOf(bytes.subspan(i * size, std::min(size, bytes.size() - i * size)));
        }
      });
    hashes.arrays[role] = hashOf(chunks);
    stored.arrays[role] = { array.shape, hashes.arrays[role], 0 };
  }
  hashes.form = hashOf(stored);
  return hashes;
}

std::string hashOf(const StoredForm& form)
{
  std::string text = form.kind + "\n" + jsonOf(form.facts) + "\n";
  for (const auto& [role, array] : form.arrays)
  {
    text += role + " " + array.shape.type + " " + std::to_string(array.shape.components) + " " +
      std::to_string(array.shape.tuples) + " " + textOf(array.hash) + "\n";
  }
  return textOf(hashOf(std::span<const char>(text)));
}

} // namespace scan
