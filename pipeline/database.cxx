// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/database.h"

#include "filters/base/error.h"

#include <sqlite3.h>

#include <memory>
#include <utility>

namespace scan
{

namespace
{

constexpr int kPatience = 10000; // milliseconds

[[noreturn]] void refuse(sqlite3* handle, int code, const std::string& file)
{
  const std::string why = handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
  switch (code & 0xff)
  {
    case SQLITE_NOTADB:
      throw Error(ErrorCode::parse, file + ": is no Scanwrap project, or its beginning is damaged");
    case SQLITE_CORRUPT:
    case SQLITE_FORMAT:
    case SQLITE_ERROR: // a table or a column is missing
      throw Error(ErrorCode::parse,
        file + ": the project is damaged (" + why +
          "); save what is whole with: history --salvage=NEW.wrp");
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw Error(ErrorCode::io, file + ": another program is writing to it; try again later");
    case SQLITE_FULL:
      throw Error(ErrorCode::io,
        file + ": the disk is full; the steps before this one are safe, free space and go on");
    default:
      throw Error(ErrorCode::io, file + ": " + why);
  }
}

} // namespace

Statement::Statement(sqlite3* database, const std::string& file, std::string_view sql)
  : Handle(database)
  , File(file)
{
  const int code = sqlite3_prepare_v2(
    database, sql.data(), static_cast<int>(sql.size()), &this->Compiled, nullptr);
  if (code != SQLITE_OK)
  {
    refuse(database, code, file);
  }
}

Statement::Statement(Statement&& other) noexcept
  : Handle(other.Handle)
  , Compiled(std::exchange(other.Compiled, nullptr))
  , File(std::move(other.File))
{
}

Statement::~Statement()
{
  sqlite3_finalize(this->Compiled);
}

bool Statement::next()
{
  const int code = sqlite3_step(this->Compiled);
  if (code != SQLITE_ROW && code != SQLITE_DONE)
  {
    sqlite3_reset(this->Compiled);
    refuse(this->Handle, code, this->File);
  }
  return code == SQLITE_ROW;
}

void Statement::run()
{
  this->next();
  this->reset();
}

bool Statement::isNull(int column) const
{
  return sqlite3_column_type(this->Compiled, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const
{
  return sqlite3_column_int64(this->Compiled, column);
}

double Statement::real(int column) const
{
  return sqlite3_column_double(this->Compiled, column);
}

std::string Statement::text(int column) const
{
  const std::span<const char> characters = this->bytes(column);
  return { characters.data(), characters.size() };
}

std::span<const char> Statement::bytes(int column) const
{
  const auto* const first = static_cast<const char*>(sqlite3_column_blob(this->Compiled, column));
  return { first, static_cast<std::size_t>(sqlite3_column_bytes(this->Compiled, column)) };
}

void Statement::reset()
{
  sqlite3_reset(this->Compiled); // repeats the error of the last step, which was reported
}

void Statement::bind(int place, std::int64_t value)
{
  sqlite3_bind_int64(this->Compiled, place, value);
}

void Statement::bind(int place, double value)
{
  sqlite3_bind_double(this->Compiled, place, value);
}

void Statement::bind(int place, std::string_view text)
{
  sqlite3_bind_text64(this->Compiled, place, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
}

void Statement::bind(int place, std::span<const char> bytes)
{
  sqlite3_bind_blob64(this->Compiled, place, bytes.data(), bytes.size(), SQLITE_STATIC);
}

void Statement::bind(int place, std::nullopt_t)
{
  sqlite3_bind_null(this->Compiled, place);
}

Database::Database(std::string file, Access access)
  : File(std::move(file))
{
  const int flags = (access == Access::readWrite ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY) |
    SQLITE_OPEN_NOMUTEX;
  // ./ : a name is never taken for a URI or for the options ":memory:" and ""
  const std::string path = this->File.starts_with('/') ? this->File : "./" + this->File;
  const int code = sqlite3_open_v2(path.c_str(), &this->Handle, flags, nullptr);
  if (code != SQLITE_OK)
  {
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> closing(this->Handle, &sqlite3_close);
    refuse(this->Handle, code, this->File);
  }
  sqlite3_extended_result_codes(this->Handle, 1);
  sqlite3_busy_timeout(this->Handle, kPatience);
  // a file from elsewhere may hold anything
  const int isWhole = access == Access::damaged ? 0 : 1;
  sqlite3_db_config(this->Handle, SQLITE_DBCONFIG_DEFENSIVE, isWhole, nullptr);
  // without it SQLite reads nothing of a truncated file
  sqlite3_db_config(this->Handle, SQLITE_DBCONFIG_WRITABLE_SCHEMA, 1 - isWhole, nullptr);
  sqlite3_db_config(this->Handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(this->Handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
}

Database::Database(Database&& other) noexcept
  : File(std::move(other.File))
  , Handle(std::exchange(other.Handle, nullptr))
{
}

Database::~Database()
{
  sqlite3_close_v2(this->Handle);
}

void Database::execute(const std::string& sql)
{
  const int code = sqlite3_exec(this->Handle, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK)
  {
    refuse(this->Handle, code, this->File);
  }
}

Statement Database::prepare(std::string_view sql) const
{
  return { this->Handle, this->File, sql };
}

std::int64_t Database::lastRow() const
{
  return sqlite3_last_insert_rowid(this->Handle);
}

std::string Database::imageOf(const std::string& sql)
{
  sqlite3* handle = nullptr;
  const int code = sqlite3_open(":memory:", &handle);
  const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> memory(handle, &sqlite3_close);
  if (code != SQLITE_OK ||
    sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
  {
    refuse(handle, code, "a new project");
  }
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> image(
    sqlite3_serialize(handle, "main", &size, 0), &sqlite3_free);
  if (!image)
  {
    throw std::bad_alloc();
  }
  return { reinterpret_cast<const char*>(image.get()), static_cast<std::size_t>(size) };
}

Transaction::Transaction(Database& database)
  : Target(database)
{
  database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction()
{
  if (this->IsOpen)
  {
    try
    {
      this->Target.execute("ROLLBACK");
    }
    catch (const std::exception&)
    {
      // SQLite has rolled back itself after a full disk
    }
  }
}

void Transaction::commit()
{
  this->Target.execute("COMMIT");
  this->IsOpen = false;
}

} // namespace scan
