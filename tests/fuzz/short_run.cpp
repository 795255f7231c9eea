// A fuzzer's short run as a test: the same inputs on every machine, whatever the compiler.
//
//   short_run_nodes 0 1000 regressions/nodes_*     # these files, then inputs 0 to 999
//   short_run_nodes 737 738                        # only the input that it named last before it failed
//
// libFuzzer's own run depends on addresses, so it differs each time: it is for long runs.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t max_bytes = 400;

std::vector<std::uint8_t> random_input(std::uint64_t number) {
  std::mt19937_64 random(number);
  std::vector<std::uint8_t> bytes(1 + random() % max_bytes);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: %s FIRST END [FILE…]\n", arguments[0]);
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // so that the last name is that of the input that failed
  for (int i = 3; i < count; ++i) {
    std::ifstream file(arguments[i], std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    std::printf("%s\n", arguments[i]);
    if (bytes.empty()) return 1;
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  const std::uint64_t end = std::strtoull(arguments[2], nullptr, 10);
  for (std::uint64_t input = std::strtoull(arguments[1], nullptr, 10); input < end; ++input) {
    const std::vector<std::uint8_t> bytes = random_input(input);
    std::printf("%llu ", static_cast<unsigned long long>(input));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("\n");
}
