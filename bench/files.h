// Two database files in the system's temporary folder, ours and the rival's: of this process alone, and gone
// with the object.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "all_rooms.h"

namespace foresee::bench {

class TwoFiles {
 public:
  TwoFiles() { remove(); }
  ~TwoFiles() { remove(); }
  TwoFiles(const TwoFiles&) = delete;
  TwoFiles& operator=(const TwoFiles&) = delete;

  const std::string ours = path_of("ours"), theirs = path_of("rival");

 private:
  static std::string path_of(const std::string& whose) {
    return std::filesystem::temp_directory_path() /
           ("foresee-bench-" + std::to_string(getpid()) + "-" + whose + ".db");
  }
  void remove() const {
    for (const std::string& path : {ours, theirs}) std::filesystem::remove(path);
  }
};

}  // namespace foresee::bench
