// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/suggestion.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace scan
{

namespace
{

/// Levenshtein distance, one row at a time.
std::size_t distance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ replaced, row[j] + 1, diagonal + 1 });
    }
  }
  return row.back();
}

} // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates)
{
  std::size_t least = std::max<std::size_t>(1, std::min<std::size_t>(2, word.size() / 2)) + 1;
  std::string best;
  for (const std::string& candidate : candidates)
  {
    const std::size_t errors = distance(word, candidate);
    if (errors < least)
    {
      least = errors;
      best = candidate;
    }
  }
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

} // namespace scan
