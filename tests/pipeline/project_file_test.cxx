// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/project_file.h"

#include "filters/base/error.h"
#include "tests/pipeline/document_fixtures.h"
#include "tests/pipeline/integrity.h"

#include <sqlite3.h>

#include <fstream>
#include <iterator>
#include <random>

using namespace scan;

namespace
{

std::string contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void write(const std::string& path, const std::string& content)
{
  std::ofstream(path, std::ios::binary) << content;
}

std::string errorOf(const std::function<void()>& body)
{
  try
  {
    body();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

/// Runs SQL with the library itself.
void runSql(const std::string& path, const std::string& sql)
{
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
    << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

/// The plate story in a project; per step the hash of its dump.
std::vector<Hash> makePlateProject(const std::string& path)
{
  Document document = Document::create(path);
  openPlate(document);
  expectOk(apply(document, "repair-angles"));
  std::vector<Hash> dumps = { Hash() };
  for (const Step& step : document.steps())
  {
    dumps.push_back(dumpOf(document, step.id));
  }
  return dumps;
}

/// Every result that the project gives is right. Returns how many there are.
std::size_t expectRight(const std::string& path, const std::vector<Hash>& dumps)
{
  Document document = Document::open(path);
  std::size_t count = 0;
  for (const Step& step : document.steps())
  {
    if (document.project()->hasResult(step.id))
    {
      EXPECT_EQ(dumpOf(document, step.id), dumps.at(static_cast<std::size_t>(step.id)));
      ++count;
    }
  }
  return count;
}

} // namespace

TEST(ProjectFile, IsReadOnlyForTheSecondProgram)
{
  const std::string path = testFolder() + "/a.wrp";
  Document first = Document::create(path);
  openPlate(first);
  Document second = Document::open(path);
  EXPECT_NE(second.project()->whyReadOnly(), "");
  EXPECT_EQ(dumpOf(second, 3), dumpOf(first, 3));
  const StepResult refused = apply(second, "flatten");
  EXPECT_EQ(refused.outcome.state, vtkScanOutcome::State::failed);
  EXPECT_NE(refused.outcome.message.find("another program has it open"), std::string::npos)
    << refused.outcome.message;
  EXPECT_THROW(second.goTo(1), Error);
  EXPECT_THROW(second.setName(1, "a"), Error);
  EXPECT_THROW(second.removeBranch(3), Error);
  EXPECT_NE(
    errorOf([&] { ProjectFile::create(path); }).find("cannot be replaced"), std::string::npos);
  expectOk(apply(first, "flatten")); // the first one goes on
  EXPECT_EQ(Document::open(path).steps().size(), 4U);
}

TEST(ProjectFile, RefusesWhatIsNoProject)
{
  const std::string folder = testFolder();
  runSql(folder + "/other.db", "CREATE TABLE a (b)");
  EXPECT_NE(errorOf([&] { ProjectFile(folder + "/other.db"); }).find("no Scanwrap project"),
    std::string::npos);
  write(folder + "/text.wrp", std::string(10000, 'x'));
  EXPECT_NE(errorOf([&] { ProjectFile(folder + "/text.wrp"); }).find("no Scanwrap project"),
    std::string::npos);
  EXPECT_NE(errorOf([&] { ProjectFile(folder + "/missing.wrp"); }), "");
}

TEST(ProjectFile, RefusesNewerSchemas)
{
  const std::string path = testFolder() + "/a.wrp";
  makePlateProject(path);
  runSql(path, "PRAGMA user_version = 999");
  EXPECT_NE(errorOf([&] { ProjectFile project(path); }).find("newer Scanwrap"), std::string::npos);
}

TEST(ProjectFile, BringsOlderSchemasUpToItsOwn)
{
  const std::string path = testFolder() + "/a.wrp";
  const std::vector<Hash> dumps = makePlateProject(path);
  runSql(path,
    "DROP TABLE kept_text; CREATE TABLE template (name TEXT PRIMARY KEY, text TEXT NOT NULL) "
    "WITHOUT ROWID; INSERT INTO template VALUES ('old', 'scanwrap template 1'); "
    "PRAGMA user_version = 1");
  {
    std::filesystem::permissions(path, std::filesystem::perms::owner_read);
    const ProjectFile first(path); // root may write all the same
    EXPECT_EQ(first.texts("view").size(), 0U);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }
  ProjectFile(path).keepText("view", "side", "left");
  const ProjectFile project(path);
  EXPECT_EQ(project.texts("template").at("old"), "scanwrap template 1");
  EXPECT_EQ(project.texts("view").at("side"), "left");
  EXPECT_EQ(integrityOf(path), "ok");
  EXPECT_EQ(expectRight(path, dumps), 4U);
}

TEST(ProjectFile, HoldsWhatItsDocumentationSays)
{
  const std::string path = testFolder() + "/a.wrp";
  makePlateProject(path);
  EXPECT_EQ(integrityOf(path), "ok");
  EXPECT_TRUE(ProjectFile::looksLike(contentOf(path)));
  runSql(path, "SELECT step, name, rule FROM region");
}

namespace
{

/// The files that a program leaves when it is killed in the middle of a write to the database.
void leaveUnfinishedWrite(const std::string& path)
{
  const std::string copy = path + ".copy";
  constexpr auto kAnyhow = std::filesystem::copy_options::overwrite_existing;
  std::filesystem::copy_file(path, copy, kAnyhow);
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(copy.c_str(), &handle), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(handle,
              "PRAGMA cache_size = 1; BEGIN; UPDATE step SET note = hex(zeroblob(9000)); "
              "UPDATE chunk SET code = zeroblob(100000)",
              nullptr, nullptr, nullptr),
    SQLITE_OK);
  std::filesystem::copy_file(copy, path, kAnyhow);
  std::filesystem::copy_file(copy + "-journal", path + "-journal", kAnyhow);
  sqlite3_close(handle);
}

} // namespace

TEST(ProjectFile, TakesBackAnUnfinishedWrite)
{
  const std::string path = testFolder() + "/a.wrp";
  const std::vector<Hash> dumps = makePlateProject(path);
  leaveUnfinishedWrite(path);
  EXPECT_EQ(expectRight(path, dumps), 4U);
  EXPECT_FALSE(std::filesystem::exists(path + "-journal"));
}

TEST(ProjectFile, LeavesNothingOfTheUnfinishedWriteOfAnother)
{
  const std::string path = testFolder() + "/a.wrp";
  const std::vector<Hash> dumps = makePlateProject(path);
  leaveUnfinishedWrite(path);
  ProjectFile::create(path);
  EXPECT_EQ(integrityOf(path), "ok");
  EXPECT_TRUE(ProjectFile(path).steps().empty());

  // also where the project itself was removed
  std::filesystem::remove(path);
  makePlateProject(path);
  leaveUnfinishedWrite(path);
  std::filesystem::remove(path);
  EXPECT_EQ(makePlateProject(path), dumps);
  EXPECT_EQ(expectRight(path, dumps), 4U);

  leaveUnfinishedWrite(path);
  const std::string other = path + ".other.wrp";
  makePlateProject(other);
  ProjectFile::copy(other, path);
  EXPECT_EQ(integrityOf(path), "ok");
  EXPECT_EQ(expectRight(path, dumps), 4U);
}

TEST(ProjectFile, APushAddsLittle)
{
  const std::string path = testFolder() + "/a.wrp";
  Document document = Document::create(path);
  expectOk(import(document, { sampleFile("multiview_scan.ply") }));
  expectOk(apply(document, "wrap", { { "mode", "classic" } }));
  const auto before = std::filesystem::file_size(path);
  expectOk(apply(document, "push", { { "at", "0,0,0" } }));
  EXPECT_LT(std::filesystem::file_size(path) - before, 200000U);
  EXPECT_GT(before, 2000000U);
}

TEST(ProjectFile, FindsDamage)
{
  const std::string path = testFolder() + "/a.wrp";
  makePlateProject(path);
  Execution execution;
  EXPECT_TRUE(ProjectFile(path).findDamage(execution).empty());
  // a bit in the state that the push left
  runSql(path,
    "UPDATE chunk SET code = substr(code, 1, 9) || x'00' || substr(code, 11) WHERE id = "
    "(SELECT chunk FROM array_chunk JOIN result_array USING (array) JOIN step USING (result) "
    " WHERE role = 'wrap.delta' AND step.id = 3)");
  EXPECT_EQ(ProjectFile(path).findDamage(execution), (std::vector<StepId>{ 3 }));
  EXPECT_NE(
    errorOf([&] { Document::open(path).result(3, {}); }).find("--salvage"), std::string::npos);
}

TEST(ProjectFile, FindsChangedSteps)
{
  const std::string path = testFolder() + "/a.wrp";
  makePlateProject(path);
  runSql(path, "UPDATE step SET parameters = replace(parameters, '0,0,0', '0,0,1')");
  EXPECT_NE(errorOf([&] { Document::open(path); }).find("step 3 is damaged"), std::string::npos);
}

TEST(ProjectFile, ATruncatedFileIsSalvagedOrRefused)
{
  const std::string folder = testFolder();
  const std::string whole = folder + "/whole.wrp";
  const std::vector<Hash> dumps = makePlateProject(whole);
  const std::string content = contentOf(whole);
  Execution execution;
  std::size_t salvaged = 0;
  for (std::size_t part = 0; part < 40; ++part)
  {
    const std::size_t size = content.size() * part / 40 + part;
    const std::string path = folder + "/cut.wrp";
    const std::string saved = folder + "/saved.wrp";
    write(path, content.substr(0, size));
    std::filesystem::remove(saved);
    EXPECT_NE(errorOf([&] { expectRight(path, dumps); }), "") << size;
    const std::string refused = errorOf([&] { ProjectFile::salvage(path, saved, execution); });
    if (refused.empty())
    {
      ++salvaged;
      EXPECT_EQ(integrityOf(saved), "ok");
      expectRight(saved, dumps);
    }
  }
  EXPECT_GT(salvaged, 5U);
}

TEST(ProjectFile, AScribbledFileIsSalvagedOrRefused)
{
  const std::string folder = testFolder();
  const std::string whole = folder + "/whole.wrp";
  const std::vector<Hash> dumps = makePlateProject(whole);
  const std::string content = contentOf(whole);
  Execution execution;
  std::size_t savedResults = 0;
  for (unsigned seed = 1; seed <= 120; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::string scribbled = content;
    const std::size_t length = seed % 2 == 0 ? 1 + random() % 40 : 1 + random() % 40000;
    const std::size_t begin = random() % scribbled.size();
    for (std::size_t i = begin; i < std::min(begin + length, scribbled.size()); ++i)
    {
      scribbled[i] = static_cast<char>(random());
    }
    const std::string path = folder + "/scribbled.wrp";
    const std::string saved = folder + "/saved.wrp";
    write(path, scribbled);
    std::filesystem::remove(saved);
    errorOf([&] { expectRight(path, dumps); }); // right as far as it is read
    if (errorOf([&] { ProjectFile::salvage(path, saved, execution); }).empty())
    {
      savedResults += expectRight(saved, dumps);
    }
  }
  EXPECT_GT(savedResults, 120U);
}

namespace
{

/// A file system whose disk is full after some writes: a VFS between SQLite and the true one.
/// https://www.sqlite.org/vfs.html
class FullDisk
{
public:
  explicit FullDisk(int writes)
  {
    left = writes;
    inner = sqlite3_vfs_find(nullptr);
    outer = *inner;
    outer.zName = "full";
    outer.szOsFile = static_cast<int>(sizeof(File)) + inner->szOsFile;
    outer.xOpen = open;
    sqlite3_vfs_register(&outer, 1);
  }
  ~FullDisk() { sqlite3_vfs_unregister(&outer); }
  FullDisk(const FullDisk&) = delete;
  void operator=(const FullDisk&) = delete;

  static int writesLeft() { return left; }

private:
  struct File
  {
    sqlite3_file base;
    sqlite3_io_methods methods;
    const sqlite3_io_methods* true_;
    sqlite3_file* file() { return reinterpret_cast<sqlite3_file*>(this + 1); }
  };

  static sqlite3_file* behind(sqlite3_file* file) { return reinterpret_cast<File*>(file)->file(); }

  static int writeLess(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset)
  {
    if (--left < 0)
    {
      const int half = size / 2; // what still fitted
      behind(file)->pMethods->xWrite(behind(file), bytes, half, offset);
      return SQLITE_FULL;
    }
    return behind(file)->pMethods->xWrite(behind(file), bytes, size, offset);
  }

  static int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* outFlags)
  {
    auto* const mine = reinterpret_cast<File*>(file);
    const int code = inner->xOpen(inner, name, mine->file(), flags, outFlags);
    mine->base.pMethods = nullptr;
    if (code != SQLITE_OK || mine->file()->pMethods == nullptr)
    {
      return code;
    }
    sqlite3_io_methods& methods = mine->methods;
    methods = {};
    methods.iVersion = 1;
    methods.xClose = [](sqlite3_file* f) { return behind(f)->pMethods->xClose(behind(f)); };
    methods.xRead = [](sqlite3_file* f, void* to, int size, sqlite3_int64 at)
    { return behind(f)->pMethods->xRead(behind(f), to, size, at); };
    methods.xWrite = writeLess;
    methods.xTruncate = [](sqlite3_file* f, sqlite3_int64 size)
    { return behind(f)->pMethods->xTruncate(behind(f), size); };
    methods.xSync = [](sqlite3_file* f, int how)
    { return behind(f)->pMethods->xSync(behind(f), how); };
    methods.xFileSize = [](sqlite3_file* f, sqlite3_int64* size)
    { return behind(f)->pMethods->xFileSize(behind(f), size); };
    methods.xLock = [](sqlite3_file* f, int how)
    { return behind(f)->pMethods->xLock(behind(f), how); };
    methods.xUnlock = [](sqlite3_file* f, int how)
    { return behind(f)->pMethods->xUnlock(behind(f), how); };
    methods.xCheckReservedLock = [](sqlite3_file* f, int* isHeld)
    { return behind(f)->pMethods->xCheckReservedLock(behind(f), isHeld); };
    methods.xFileControl = [](sqlite3_file* f, int what, void* argument)
    { return behind(f)->pMethods->xFileControl(behind(f), what, argument); };
    methods.xSectorSize = [](sqlite3_file* f)
    { return behind(f)->pMethods->xSectorSize(behind(f)); };
    methods.xDeviceCharacteristics = [](sqlite3_file* f)
    { return behind(f)->pMethods->xDeviceCharacteristics(behind(f)); };
    mine->base.pMethods = &methods;
    return SQLITE_OK;
  }

  static inline sqlite3_vfs* inner = nullptr;
  static inline sqlite3_vfs outer = {};
  static inline int left = 0;
};

/// Does the plate story until a step fails; how many were told to be done.
StepId doPlateStory(const std::string& path)
{
  Document document = Document::create(path);
  StepId done = 0;
  const auto isDone = [&](const StepResult& step)
  {
    if (step.outcome.state != vtkScanOutcome::State::ok)
    {
      EXPECT_NE(step.outcome.message.find("disk is full"), std::string::npos)
        << step.outcome.message;
      return false;
    }
    done = document.current();
    return true;
  };
  isDone(import(document, { sampleFile("plate_hole.xyz") })) &&
    isDone(apply(document, "wrap", { { "mode", "classic" } })) &&
    isDone(apply(document, "push", { { "at", "0,0,0" }, { "deep", "true" } })) &&
    isDone(apply(document, "repair-angles"));
  return done;
}

} // namespace

TEST(ProjectFile, AFullDiskCostsTheRunningStepOnly)
{
  const std::string folder = testFolder();
  const std::vector<Hash> dumps = makePlateProject(folder + "/whole.wrp");
  constexpr int kMany = 1000000;
  int writes = 0;
  {
    const FullDisk disk(kMany);
    doPlateStory(folder + "/count.wrp");
    writes = kMany - FullDisk::writesLeft();
  }
  ASSERT_GT(writes, 100);
  std::mt19937 random(3);
  std::set<StepId> lengths;
  for (int run = 0; run < 60; ++run)
  {
    const std::string path = folder + "/full.wrp";
    std::filesystem::remove(path);
    const int limit = static_cast<int>(random() % static_cast<unsigned>(writes));
    SCOPED_TRACE("full after write " + std::to_string(limit) + " of " + std::to_string(writes));
    StepId done = 0;
    {
      const FullDisk disk(limit);
      done = doPlateStory(path);
    }
    lengths.insert(done);
    EXPECT_EQ(integrityOf(path), "ok");
    Document document = Document::open(path);
    EXPECT_EQ(static_cast<StepId>(document.steps().size()), done);
    EXPECT_EQ(expectRight(path, dumps), static_cast<std::size_t>(done));
  }
  EXPECT_GE(lengths.size(), 3U);
}
