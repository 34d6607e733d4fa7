// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/record.h"

#include <vtkDataObject.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace scan
{

namespace
{

using Json = nlohmann::ordered_json;

struct ToJson
{
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const Length& length) const { return length.text(); }
  Json operator()(const PointList& points) const
  {
    Json list = Json::array();
    for (const Vec3& p : points)
    {
      list.push_back({ p.x, p.y, p.z });
    }
    return list;
  }
  template <class T>
  Json operator()(const T& value) const
  {
    return value;
  }
};

template <class Pairs>
Json objectOf(const Pairs& pairs)
{
  Json object = Json::object();
  for (const auto& [name, value] : pairs)
  {
    object[name] = std::visit(ToJson{}, value);
  }
  return object;
}

std::string_view nameOf(vtkScanOutcome::State state)
{
  switch (state)
  {
    case vtkScanOutcome::State::ok:
      return "ok";
    case vtkScanOutcome::State::failed:
      return "failed";
    case vtkScanOutcome::State::cancelled:
      return "cancelled";
  }
  return {};
}

} // namespace

void Record::add(std::string verb, ParameterValues parameters, const StepResult& result)
{
  this->Steps.push_back({ std::move(verb), std::move(parameters), result });
  this->Steps.back().result.output = nullptr;
}

std::string Record::json(int exitStatus, const std::string& failure) const
{
  Json record;
  record["program"] = "scanwrap";
  record["version"] = SCAN_VERSION;
  record["status"] = exitStatus;
  record["message"] = failure;
  record["steps"] = Json::array();
  for (const Step& step : this->Steps)
  {
    Json entry;
    entry["verb"] = step.verb;
    entry["parameters"] = objectOf(step.parameters);
    entry["state"] = nameOf(step.result.outcome.state);
    entry["seconds"] = step.result.seconds;
    entry["peak-bytes"] = step.result.peakBytes;
    entry["results"] = objectOf(step.result.results);
    entry["note"] = step.result.note;
    record["steps"].push_back(std::move(entry));
  }
  // names of files need not be UTF-8
  return record.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace scan
