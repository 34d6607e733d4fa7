// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/writers/lib3mf_reading.h"

#ifdef SCAN_HAS_LIB3MF
#include <Model/COM/NMR_DLLInterfaces.h>
#endif

namespace scan::test
{

#ifdef SCAN_HAS_LIB3MF

bool hasLib3mf()
{
  return true;
}

Lib3mfResult readWithLib3mf(const std::string& path, const std::string& rewritten)
{
  NMR::PLib3MFModel* model = nullptr;
  NMR::PLib3MFModelReader* reader = nullptr;
  NMR::lib3mf_createmodel(&model);
  NMR::lib3mf_model_queryreader(model, "3mf", &reader);
  Lib3mfResult result;
  result.isRead = NMR::lib3mf_reader_readfromfileutf8(reader, path.c_str()) == 0;
  DWORD count = 0;
  NMR::lib3mf_reader_getwarningcount(reader, &count);
  result.warnings = count;
  NMR::lib3mf_release(reader);
  NMR::PLib3MFModelResourceIterator* iterator = nullptr;
  NMR::lib3mf_model_getmeshobjects(model, &iterator);
  BOOL isThere = 0;
  NMR::lib3mf_resourceiterator_movenext(iterator, &isThere);
  if (isThere != 0)
  {
    NMR::PLib3MFModelResource* mesh = nullptr;
    BOOL isClosed = 0;
    NMR::lib3mf_resourceiterator_getcurrent(iterator, &mesh);
    NMR::lib3mf_meshobject_getvertexcount(mesh, &count);
    result.vertices = count;
    NMR::lib3mf_meshobject_gettrianglecount(mesh, &count);
    result.triangles = count;
    NMR::lib3mf_meshobject_ismanifoldandoriented(mesh, &isClosed);
    result.isClosed = isClosed != 0;
    NMR::lib3mf_release(mesh);
  }
  NMR::lib3mf_release(iterator);
  if (!rewritten.empty())
  {
    NMR::PLib3MFModelWriter* writer = nullptr;
    NMR::lib3mf_model_querywriter(model, "3mf", &writer);
    NMR::lib3mf_writer_writetofileutf8(writer, rewritten.c_str());
    NMR::lib3mf_release(writer);
  }
  NMR::lib3mf_release(model);
  return result;
}

#else

bool hasLib3mf()
{
  return false;
}

Lib3mfResult readWithLib3mf(const std::string&, const std::string&)
{
  return {};
}

#endif

} // namespace scan::test
