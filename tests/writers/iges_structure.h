// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scan::test
{

/// The entities of an IGES file as its two sections give them, and whether they agree.
class IgesStructure
{
public:
  struct Entity
  {
    int type = 0;
    int form = 0;
    std::vector<std::string> parameters; ///< begins with the type
  };

  explicit IgesStructure(std::string_view bytes);

  /// The first thing wrong: columns, numbers of lines, pointers, numbers broken across lines.
  const std::string& fault() const { return this->Fault; }
  const std::vector<Entity>& entities() const { return this->Entities; }
  /// By the number of its entry.
  const Entity& entity(std::size_t entry) const { return this->Entities.at(entry / 2); }
  std::size_t count(int type, int form) const;

private:
  void splitLines(std::string_view bytes);
  void readEntity(std::size_t number);
  void readParameters(std::size_t first, std::size_t count, std::size_t entry, Entity& entity);
  void checkEnd();
  void require(bool isRight, const std::string& fault);

  std::string Fault;
  std::vector<std::string> Start, Global, Directory, Parameters, End;
  std::vector<Entity> Entities;
};

} // namespace scan::test
