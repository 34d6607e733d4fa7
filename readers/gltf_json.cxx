// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf_json.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>

namespace scan
{
namespace
{

using Json = nlohmann::json;

constexpr std::size_t kStepBytes = std::size_t(1) << 20U;
constexpr int kDeepest = 100;

/// The characters of the JSON, with reports on the way.
class Characters
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Characters(const char* at, const Source& source, Execution& execution)
    : At(at)
    , Input(&source)
    , Run(&execution)
  {
  }

  reference operator*() const { return *this->At; }
  Characters& operator++()
  {
    ++this->At;
    const auto done = static_cast<std::size_t>(this->At - this->Input->begin());
    if (done % kStepBytes == 0)
    {
      this->Run->step("read", done, 2 * this->Input->bytes.size());
    }
    return *this;
  }
  Characters operator++(int)
  {
    const Characters before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Characters& a, const Characters& b) { return a.At == b.At; }
  friend bool operator!=(const Characters& a, const Characters& b) { return a.At != b.At; }

private:
  const char* At;
  const Source* Input;
  Execution* Run;
};

/// Goes through JSON before it becomes a tree in memory, which takes many times the memory of its
/// text when it has many small values.
class Inspector : public nlohmann::json_sax<Json>
{
public:
  explicit Inspector(const Source& source)
    : Input(source)
    , Allowed(6 * source.bytes.size() + (std::size_t(24) << 20U))
  {
  }

  /// Where the JSON is malformed; nothing when it is not.
  std::optional<std::size_t> errorAt() const { return this->ErrorAt; }

  bool null() override { return this->take(kNumber); }
  bool boolean(bool) override { return this->take(kNumber); }
  bool number_integer(number_integer_t) override { return this->take(kNumber); }
  bool number_unsigned(number_unsigned_t) override { return this->take(kNumber); }
  bool number_float(number_float_t, const string_t&) override { return this->take(kNumber); }
  bool string(string_t&) override { return this->take(kText); }
  bool binary(binary_t&) override { return this->take(kText); }
  bool key(string_t&) override { return this->take(kKey); }
  bool start_object(std::size_t) override { return this->open(kObject); }
  bool start_array(std::size_t) override { return this->open(kArray); }
  bool end_object() override { return this->close(); }
  bool end_array() override { return this->close(); }
  bool parse_error(
    std::size_t position, const std::string&, const nlohmann::detail::exception&) override
  {
    this->ErrorAt = position;
    return false;
  }

private:
  /// About the bytes that values take; arrays grow in steps, and every allocation has its cost.
  enum Cost : std::size_t
  {
    kNumber = 48,
    kText = 96,
    kKey = 112,
    kObject = 96,
    kArray = 72
  };

  bool take(Cost cost)
  {
    this->Memory += cost;
    if (this->Memory > this->Allowed)
    {
      this->Input.fail("its JSON holds too many small values; it is no model");
    }
    return true;
  }

  bool open(Cost cost)
  {
    if (++this->Depth > kDeepest)
    {
      this->Input.fail("its JSON nests deeper than 100 levels; it is no model");
    }
    return this->take(cost);
  }

  bool close()
  {
    --this->Depth;
    return true;
  }

  const Source& Input;
  std::size_t Allowed;
  std::size_t Memory = 0;
  int Depth = 0;
  std::optional<std::size_t> ErrorAt;
};

} // namespace

nlohmann::json parseGltfJson(const Source& source, std::span<const char> text, Execution& execution)
{
  while (!text.empty() && text.back() == '\0') // padding of some writers
  {
    text = text.first(text.size() - 1);
  }
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  Inspector inspector(source);
  const Characters first(begin, source, execution);
  const Characters last(end, source, execution);
  Json::sax_parse(first, last, &inspector);
  if (inspector.errorAt())
  {
    const std::size_t at = std::max<std::size_t>(*inspector.errorAt(), 1) - 1;
    source.failAtByte(
      begin + std::min(text.size(), at), "malformed JSON; the file is damaged or truncated");
  }
  return Json::parse(first, last);
}

} // namespace scan
