// Database files in the system's temporary folder: private to this process, and deleted with the object.
//
//   TwoFiles files;                          // ours and the rival's
//   ScratchFile file("watched");
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace foresee::bench {

class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name)
      : path(std::filesystem::temp_directory_path() /
             ("foresee-bench-" + std::to_string(getpid()) + "-" + name + ".db")) {
    std::filesystem::remove(path);
  }
  ~ScratchFile() { std::filesystem::remove(path); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string path;
};

class TwoFiles {
  ScratchFile our_file_{"ours"}, their_file_{"rival"};

 public:
  const std::string ours = our_file_.path, theirs = their_file_.path;
};

}  // namespace foresee::bench
