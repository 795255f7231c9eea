// Common part of every benchmark's main(): reads the arguments, and turns an exception into a message.
//
//   int main_of(const Options& options) { if (options.has("--quick")) … }
//   int main(int count, char** arguments) { return run_program(count, arguments, main_of); }
#pragma once

#include <algorithm>
#include <cstdio>
#include <exception>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace foresee::bench {

/// --flags, names, and values that follow a flag.
class Options {
 public:
  Options(int count, char** arguments) : words_(arguments + 1, arguments + count) {}

  bool has(const std::string& flag) const {
    return std::find(words_.begin(), words_.end(), flag) != words_.end();
  }
  /// The word after `flag`, which then is not a name.
  std::optional<std::string> value(const std::string& flag) {
    const auto found = std::find(words_.begin(), words_.end(), flag);
    if (found == words_.end() || found + 1 == words_.end()) return std::nullopt;
    std::string value = found[1];
    words_.erase(found, found + 2);
    return value;
  }
  /// All words that are not flags, or `otherwise` without any.
  std::vector<std::string> names(std::vector<std::string> otherwise) const {
    std::vector<std::string> names;
    for (const std::string& word : words_)
      if (!word.starts_with("--")) names.push_back(word);
    return names.empty() ? otherwise : names;
  }

 private:
  std::vector<std::string> words_;
};

/// A mode: a measurement that a program runs if its flag is given.
struct Mode {
  const char* flag;
  void (*measure)(const Options&);
};
/// The requested modes, or all without any.
inline int run_modes(const Options& options, std::initializer_list<Mode> modes) {
  const bool all =
      std::none_of(modes.begin(), modes.end(), [&](const Mode& mode) { return options.has(mode.flag); });
  for (const Mode& mode : modes)
    if (all || options.has(mode.flag)) mode.measure(options);
  return 0;
}

template <class Main>
int run_program(int count, char** arguments, Main main_of) {
  try {
    return main_of(Options(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace foresee::bench
