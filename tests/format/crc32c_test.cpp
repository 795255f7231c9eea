#include "format/crc32c.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace foresee {
namespace {

TEST(Crc32c, GivesThePublishedValues) {  // RFC 3720, B.4
  EXPECT_EQ(crc32c("123456789", 9), 0xE3069283u);
  EXPECT_EQ(crc32c(std::vector<unsigned char>(32, 0).data(), 32), 0x8A9136AAu);
  EXPECT_EQ(crc32c(std::vector<unsigned char>(32, 255).data(), 32), 0x62A8AB43u);
}

TEST(Crc32c, AgreesWithThePortableOneAtEveryLength) {
  std::mt19937 random(7);
  std::vector<unsigned char> bytes(5000);
  for (auto& byte : bytes) byte = static_cast<unsigned char>(random());
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 50)
    for (std::size_t start : {0, 1, 7}) {
      if (start > size) continue;
      ASSERT_EQ(crc32c(&bytes[start], size - start), crc32c_portable(&bytes[start], size - start)) << size;
    }
}

TEST(Crc32c, GoesOnWhereItStopped) {
  const std::vector<unsigned char> bytes(2000, 0xa5);
  const std::uint32_t whole = crc32c(bytes.data(), bytes.size());
  for (std::size_t cut : {0, 1, 777, 1024, 2000})
    EXPECT_EQ(crc32c(bytes.data() + cut, bytes.size() - cut, crc32c(bytes.data(), cut)), whole);
}

}  // namespace
}  // namespace foresee
