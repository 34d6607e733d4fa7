// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace scan
{

/// How a format that has both forms is written.
enum class Encoding
{
  binary,
  ascii
};

} // namespace scan
