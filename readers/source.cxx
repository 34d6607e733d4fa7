// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/source.h"

#include "filters/base/error.h"
#include "filters/geometry/mesh.h"
#include "readers/text_scanner.h"

namespace scan
{

void Source::failAtLine(const char* at, const std::string& what) const
{
  this->fail("line " + std::to_string(lineNumber(this->begin(), at)) + ": " + what);
}

void Source::failAtByte(const char* at, const std::string& what) const
{
  this->fail("byte " + std::to_string(at - this->begin()) + ": " + what);
}

void Source::fail(const std::string& what) const
{
  throw Error(ErrorCode::parse, std::string(this->name) + ": " + what);
}

void Source::checkPointCount(std::uint64_t count) const
{
  if (count >= kNone)
  {
    throw Error(ErrorCode::limit,
      std::string(this->name) + ": more than 4294967294 points; split or thin the file");
  }
}

} // namespace scan
