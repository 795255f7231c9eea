#include "format/crc32c.h"

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

using LookUpTables = std::array<std::array<std::uint32_t, 256>, 8>;

// tables[k][b]: the checksum of byte b followed by k zero bytes.
constexpr LookUpTables make_tables() {
  LookUpTables tables{};
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

constexpr LookUpTables tables = make_tables();

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

std::uint64_t word_at(const unsigned char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

// Returns the checksum register after these bytes; `crc` is the register before them.
template <class Steps>
std::uint32_t serial_crc(std::uint32_t crc, const unsigned char* bytes, std::size_t size) {
  for (; size >= 8; size -= 8, bytes += 8) crc = Steps::eight(crc, word_at(bytes));
  for (; size > 0; --size, ++bytes) crc = Steps::one(crc, *bytes);
  return crc;
}

// The CRC instruction has a latency of three cycles and a throughput of one per cycle, so three blocks are
// computed in parallel. A table then shifts the register of each block past the blocks behind it.
constexpr std::size_t block = 256;

// The register after `block` zero bytes, as a table: it is linear in each of the register's four bytes.
constexpr std::array<std::array<std::uint32_t, 256>, 4> make_block_shift() {
  std::array<std::array<std::uint32_t, 256>, 4> shift{};
  for (std::size_t place = 0; place < 4; ++place)
    for (std::uint32_t bit = 1; bit < 256; bit *= 2) {
      std::uint32_t crc = bit << 8 * place;
      for (std::size_t i = 0; i < block; ++i) crc = crc >> 8 ^ tables[0][crc & 255];
      for (std::uint32_t lower = 0; lower < bit; ++lower)
        shift[place][bit + lower] = shift[place][lower] ^ crc;
    }
  return shift;
}

constexpr auto block_shift = make_block_shift();

std::uint32_t shift_past_block(std::uint32_t crc) {
  return block_shift[0][crc & 255] ^ block_shift[1][crc >> 8 & 255] ^ block_shift[2][crc >> 16 & 255] ^
         block_shift[3][crc >> 24];
}

std::uint32_t interleaved_crc(std::uint32_t crc, const unsigned char* bytes, std::size_t size) {
  for (; size >= 3 * block; size -= 3 * block, bytes += 3 * block) {
    std::uint32_t second = 0, third = 0;
    for (std::size_t i = 0; i < block; i += 8) {
      crc = Steps::eight(crc, word_at(bytes + i));
      second = Steps::eight(second, word_at(bytes + block + i));
      third = Steps::eight(third, word_at(bytes + 2 * block + i));
    }
    crc = shift_past_block(shift_past_block(crc) ^ second) ^ third;
  }
  return serial_crc<Steps>(crc, bytes, size);
}

}  // namespace

std::uint32_t crc32c(const void* bytes, std::size_t size, std::uint32_t before) {
  return ~interleaved_crc(~before, static_cast<const unsigned char*>(bytes), size);
}

std::uint32_t crc32c_portable(const void* bytes, std::size_t size, std::uint32_t before) {
  return ~serial_crc<PortableSteps>(~before, static_cast<const unsigned char*>(bytes), size);
}

}  // namespace foresee
