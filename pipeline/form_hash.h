// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "pipeline/data_form.h"
#include "pipeline/hash.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace scan
{

/// Arrays are stored and hashed in chunks of so many bytes: whole tuples, about 256 KiB.
std::size_t chunkSize(const ArrayShape& shape);

/// Of an array: the hash of its chunks' hashes, one after the other.
Hash hashOf(std::span<const Hash> chunks);

/// The hashes of a form, which tell it from any other.
struct FormHashes
{
  std::map<std::string, std::vector<Hash>> chunks; ///< of each array
  std::map<std::string, Hash> arrays;
  std::string form; ///< of the kind, the facts, and the arrays by their roles, shapes and hashes
};

FormHashes hashesOf(const DataForm& form, Execution& execution);

/// The same of a form whose arrays have their hashes.
std::string hashOf(const StoredForm& form);

} // namespace scan
