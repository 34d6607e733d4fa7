// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes every sample of this folder: scan_make_samples FOLDER
#include "data/samples.h"

#include <cstdio>
#include <fstream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: scan_make_samples FOLDER\n");
    return 2;
  }
  for (const samples::Sample& sample : samples::makeSamples())
  {
    const std::string path = std::string(argv[1]) + '/' + sample.name;
    std::ofstream file(path, std::ios::binary);
    file.write(sample.bytes.data(), static_cast<std::streamsize>(sample.bytes.size()));
    file.close();
    if (!file)
    {
      std::fprintf(stderr, "scan_make_samples: cannot write %s\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
