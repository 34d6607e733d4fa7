// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/writers/iges_structure.h"

#include <algorithm>
#include <cstdlib>

namespace scan::test
{
namespace
{

/// A right-justified number; blanks are 0.
std::size_t numberIn(const std::string& line, std::size_t begin, std::size_t size)
{
  return std::strtoul(line.substr(begin, size).c_str(), nullptr, 10);
}

std::size_t field(const std::string& line, std::size_t number)
{
  return numberIn(line, 8 * (number - 1), 8);
}

} // namespace

IgesStructure::IgesStructure(std::string_view bytes)
{
  this->splitLines(bytes);
  this->require(this->Directory.size() % 2 == 0, "half a directory entry");
  std::size_t used = 0;
  for (std::size_t i = 0; i < this->Directory.size() / 2 && this->Fault.empty(); ++i)
  {
    this->require(field(this->Directory[2 * i], 2) == used + 1, "parameters begin elsewhere");
    this->readEntity(i);
    used += field(this->Directory[2 * i + 1], 4);
  }
  this->require(used == this->Parameters.size(), "parameters of no entity");
  this->checkEnd();
}

std::size_t IgesStructure::count(int type, int form) const
{
  return static_cast<std::size_t>(std::ranges::count_if(this->Entities,
    [=](const Entity& entity) { return entity.type == type && entity.form == form; }));
}

void IgesStructure::splitLines(std::string_view bytes)
{
  const std::string_view letters = "SGDPT";
  std::vector<std::string>* const sections[] = { &this->Start, &this->Global, &this->Directory,
    &this->Parameters, &this->End };
  std::size_t section = 0;
  this->require(bytes.size() % 81 == 0, "a line without 80 columns");
  for (std::size_t at = 0; at < bytes.size() && this->Fault.empty(); at += 81)
  {
    const std::string line(bytes.substr(at, 80));
    this->require(bytes[at + 80] == '\n', "a line without 80 columns");
    const std::size_t letter = letters.find(line[72]);
    this->require(letter != std::string_view::npos && letter >= section, "sections out of order");
    section = std::min(letter, std::size_t{ 4 });
    sections[section]->push_back(line);
    this->require(numberIn(line, 73, 7) == sections[section]->size(), "wrong number: " + line);
  }
}

void IgesStructure::readEntity(std::size_t number)
{
  const std::string& first = this->Directory[2 * number];
  const std::string& second = this->Directory[2 * number + 1];
  Entity entity;
  entity.type = static_cast<int>(field(first, 1));
  entity.form = static_cast<int>(field(second, 5));
  this->require(field(first, 1) == field(second, 1), "two types: " + first);
  this->readParameters(field(first, 2) - 1, field(second, 4), 2 * number + 1, entity);
  this->require(
    !entity.parameters.empty() && entity.parameters.front() == std::to_string(entity.type),
    "parameters of another type: " + first);
  this->Entities.push_back(std::move(entity));
}

void IgesStructure::readParameters(
  std::size_t first, std::size_t count, std::size_t entry, Entity& entity)
{
  this->require(first + count <= this->Parameters.size(), "parameters beyond the section");
  for (std::size_t i = first; i < first + count && this->Fault.empty(); ++i)
  {
    const std::string& line = this->Parameters[i];
    this->require(numberIn(line, 64, 8) == entry, "points back to another entity: " + line);
    const std::string text = line.substr(0, line.find_last_not_of(' ', 63) + 1);
    this->require(text.ends_with(i + 1 == first + count ? ';' : ','), "broken number: " + line);
    std::size_t begin = 0;
    while (begin < text.size() && this->Fault.empty())
    {
      const std::size_t end = text.find_first_of(",;", begin);
      entity.parameters.push_back(text.substr(begin, end - begin));
      this->require(
        entity.parameters.back().find_first_not_of("0123456789.+-E") == std::string::npos,
        "no number: " + line);
      begin = end + 1;
    }
  }
}

void IgesStructure::checkEnd()
{
  this->require(this->Start.size() > 0 && this->End.size() == 1, "no start or no end");
  if (this->Fault.empty())
  {
    const std::string& end = this->End.front();
    const std::vector<std::string>* const sections[] = { &this->Start, &this->Global,
      &this->Directory, &this->Parameters };
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->require(end[8 * i] == "SGDP"[i] && numberIn(end, 8 * i + 1, 7) == sections[i]->size(),
        "wrong counts: " + end);
    }
  }
}

void IgesStructure::require(bool isRight, const std::string& fault)
{
  if (!isRight && this->Fault.empty())
  {
    this->Fault = fault;
  }
}

} // namespace scan::test
