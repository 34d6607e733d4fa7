// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace scan
{

/// An SQL statement that can be run again and again; places are counted from 1, columns from 0.
class Statement
{
public:
  Statement(Statement&& other) noexcept;
  ~Statement();
  Statement(const Statement&) = delete;
  void operator=(const Statement&) = delete;

  /// Binds the values to the places in their order and starts again. Texts and bytes must live
  /// until the statement has run. std::nullopt is NULL.
  template <class... Values>
  Statement& with(const Values&... values)
  {
    this->reset();
    int place = 0;
    (this->bind(++place, values), ...);
    return *this;
  }

  /// Goes to the next row; false behind the last one.
  bool next();

  /// Runs a statement that gives no rows.
  void run();

  bool isNull(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::span<const char> bytes(int column) const; ///< until the next call

private:
  friend class Database;
  Statement(sqlite3* database, const std::string& file, std::string_view sql);

  void reset();
  void bind(int place, std::int64_t value);
  void bind(int place, double value);
  void bind(int place, std::string_view text);
  void bind(int place, std::span<const char> bytes);
  void bind(int place, std::nullopt_t);
  template <class Value>
  void bind(int place, const std::optional<Value>& value)
  {
    value ? this->bind(place, *value) : this->bind(place, std::nullopt);
  }

  sqlite3* Handle;
  sqlite3_stmt* Compiled = nullptr;
  std::string File;
};

/// An SQLite database in a file. Everything throws Error io (disk full, no permission, busy for
/// ten seconds) or Error parse (damaged, no database), naming the file.
/// https://www.sqlite.org/c3ref/intro.html
class Database
{
public:
  enum class Access
  {
    readOnly,
    readWrite,
    damaged ///< to read what can be read of a file that is shorter than it says, for example
  };

  /// The file must exist.
  Database(std::string file, Access access);
  Database(Database&& other) noexcept;
  ~Database();
  Database(const Database&) = delete;
  void operator=(const Database&) = delete;

  const std::string& file() const { return this->File; }

  /// Runs statements without values and without rows.
  void execute(const std::string& sql);
  Statement prepare(std::string_view sql) const;
  std::int64_t lastRow() const; ///< number of the row inserted last

  /// A database that holds what the statements make, as the bytes of a file.
  static std::string imageOf(const std::string& sql);

private:
  std::string File;
  sqlite3* Handle = nullptr;
};

/// All changes from its beginning to commit() are made, durably, or none.
class Transaction
{
public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  void operator=(const Transaction&) = delete;

  void commit();

private:
  Database& Target;
  bool IsOpen = true;
};

} // namespace scan
