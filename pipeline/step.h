// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/result.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace scan
{

/// Number of a step in its history: 1, 2, 3, ... in the order in which they were done; 0 is none.
/// The number of a deleted step is not given again.
using StepId = std::int64_t;

/// Parameters by their names, as parseValue() takes them.
using ParameterTexts = std::map<std::string, std::string>;

/// A file that a step has read.
struct ReadFile
{
  std::string path;  ///< as it was given
  std::string place; ///< the absolute path
  std::string format;
  std::int64_t bytes = 0;
  std::string modified; ///< 2026-01-31T23:59:59Z
  std::string hash;     ///< XXH3 of 128 bits

  friend bool operator==(const ReadFile&, const ReadFile&) = default;
};

/// A finished step of a history: what was done and what came out. Nobody changes it any more, but
/// its name.
struct Step
{
  StepId id = 0;
  StepId parent = 0;         ///< 0: starts from files
  std::string verb;          ///< of an operation, or "open"
  ParameterTexts parameters; ///< all of them, the seed too
  std::string name;          ///< that the user gave it; empty for none
  std::string inputHash;     ///< resultHash of the parent
  std::string resultHash;    ///< of the stored form of the result, see ProjectFile
  double seconds = 0.0;
  std::int64_t peakBytes = 0; ///< peak resident memory of the program so far
  Results results;            ///< counts and measures
  std::string note;
  std::string program;  ///< version that did it
  std::string finished; ///< when: 2026-01-31T23:59:59Z
  std::vector<ReadFile> files;
};

} // namespace scan
