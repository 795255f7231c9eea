#include "storage/crc32c.h"

#include <array>
#include <cstring>

#if defined(__SSE4_2__)
#include <nmmintrin.h>
#elif defined(__ARM_FEATURE_CRC32)
#include <arm_acle.h>
#endif

namespace foresee {
namespace {

constexpr std::uint32_t polynomial = 0x82F63B78;  // reflected

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

// tables[k][b]: the checksum of byte b followed by k zero bytes.
constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ polynomial : crc >> 1;
    tables[0][byte] = crc;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte)
      tables[k][byte] = tables[k - 1][byte] >> 8 ^ tables[0][tables[k - 1][byte] & 255];
  return tables;
}

constexpr Tables tables = make_tables();

struct PortableSteps {
  static std::uint32_t eight(std::uint32_t crc, std::uint64_t word) {
    word ^= crc;
    crc = 0;
    for (std::size_t k = 0; k < 8; ++k) crc ^= tables[7 - k][word >> 8 * k & 255];
    return crc;
  }
  static std::uint32_t one(std::uint32_t crc, std::uint8_t byte) {
    return crc >> 8 ^ tables[0][(crc ^ byte) & 255];
  }
};

#if defined(__SSE4_2__)
struct Steps {
  static std::uint32_t eight(std::uint32_t crc, std::uint64_t word) {
    return static_cast<std::uint32_t>(_mm_crc32_u64(crc, word));
  }
  static std::uint32_t one(std::uint32_t crc, std::uint8_t byte) { return _mm_crc32_u8(crc, byte); }
};
#elif defined(__ARM_FEATURE_CRC32)
struct Steps {
  static std::uint32_t eight(std::uint32_t crc, std::uint64_t word) { return __crc32cd(crc, word); }
  static std::uint32_t one(std::uint32_t crc, std::uint8_t byte) { return __crc32cb(crc, byte); }
};
#else
using Steps = PortableSteps;
#endif

template <class Steps>
std::uint32_t run(const void* bytes, std::size_t size, std::uint32_t before) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  std::uint32_t crc = ~before;
  for (; size >= 8; size -= 8, at += 8) {
    std::uint64_t word;
    std::memcpy(&word, at, 8);
    crc = Steps::eight(crc, word);
  }
  for (; size > 0; --size, ++at) crc = Steps::one(crc, *at);
  return ~crc;
}

}  // namespace

std::uint32_t crc32c(const void* bytes, std::size_t size, std::uint32_t before) {
  return run<Steps>(bytes, size, before);
}

std::uint32_t crc32c_portable(const void* bytes, std::size_t size, std::uint32_t before) {
  return run<PortableSteps>(bytes, size, before);
}

}  // namespace foresee
