// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/json_text.h"

#include "filters/base/error.h"

#include <nlohmann/json.hpp>

namespace scan
{

namespace
{

using Json = nlohmann::ordered_json;

std::string textOf(const Json& json)
{
  // names of files need not be UTF-8
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json parse(const std::string& text)
{
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    throw Error(ErrorCode::parse, "a step of the project is damaged");
  }
  return json;
}

ResultValue valueOf(const Json& json)
{
  return json.is_boolean()     ? ResultValue(json.get<bool>())
    : json.is_number_integer() ? ResultValue(json.get<std::int64_t>())
    : json.is_number()         ? ResultValue(json.get<double>())
    : json.is_string()         ? ResultValue(json.get<std::string>())
                               : ResultValue();
}

struct ToJson
{
  Json operator()(std::monostate) const { return nullptr; }
  template <class T>
  Json operator()(const T& value) const
  {
    return value;
  }
};

} // namespace

std::string jsonOf(const Results& results)
{
  Json json = Json::object();
  for (const auto& [name, value] : results)
  {
    json[name] = std::visit(ToJson{}, value);
  }
  return textOf(json);
}

Results parseResults(const std::string& text)
{
  Results results;
  const Json json = parse(text); // items() does not keep it
  for (const auto& [name, value] : json.items())
  {
    results.emplace_back(name, valueOf(value));
  }
  return results;
}

std::string jsonOf(const std::map<std::string, std::string>& texts)
{
  Json json = Json::object();
  for (const auto& [name, text] : texts)
  {
    json[name] = text;
  }
  return textOf(json);
}

std::map<std::string, std::string> parseTexts(const std::string& text)
{
  std::map<std::string, std::string> texts;
  const Json json = parse(text); // items() does not keep it
  for (const auto& [name, value] : json.items())
  {
    texts[name] = value.is_string() ? value.get<std::string>() : std::string();
  }
  return texts;
}

} // namespace scan
