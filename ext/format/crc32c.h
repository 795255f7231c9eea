// CRC-32C (Castagnoli), the checksum of every stored node: it detects any change within 32 adjacent bits,
// hence any changed byte.
//
//   crc32c("123456789", 9) == 0xE3069283
//   crc32c(b, 5, crc32c(a, 4))        // of a followed by b
//
// Cost: about six bytes per cycle with the CPU's instruction, about one without.
#pragma once

#include <cstddef>
#include <cstdint>

namespace foresee {

std::uint32_t crc32c(const void* bytes, std::size_t size, std::uint32_t before = 0);

/// crc32c() without the CPU's instruction, for other machines and as a reference in tests.
std::uint32_t crc32c_portable(const void* bytes, std::size_t size, std::uint32_t before = 0);

}  // namespace foresee
