// Hostile plans as text and as blobs: numbers on a small grid and of any size, parts that overlap, and texts and
// blobs that are cut, doubled and corrupted. The result must be a message or a plan. A plan must read back the same,
// and its chunks must cover its legs in order. A crash or a hang is a failure.
#include <cstring>
#include <string>

#include "base/error.h"
#include "motion/plan/chunks.h"
#include "motion/plan/packed_legs.h"
#include "motion/plan/plan_legs.h"
#include "motion/plan/plan_text.h"
#include "wkt.h"

namespace foresee::testing {
namespace {

NeverInterrupt never;

std::string fuzz_part(FuzzBytes& bytes, int axes, int& t) {
  std::string text;
  for (int n = bytes.in_range(2, 20); n > 0; --n) {
    text += text.empty() ? "(" : ", ";
    for (int j = 0; j < axes; ++j) text += fuzz_coordinate(bytes) + ' ';
    t += bytes.in_range(0, 9) == 0 ? 0 : 1;
    text += bytes.in_range(0, 19) == 0 ? fuzz_coordinate(bytes) : std::to_string(t);
  }
  return text + ')';
}

std::string fuzz_text(FuzzBytes& bytes) {
  const int axes = bytes.in_range(2, 3);
  const std::string tag = axes == 3 ? " ZM" : " M";
  int t = bytes.in_range(-9, 9);
  if (bytes.flag()) return "LINESTRING" + tag + fuzz_part(bytes, axes, t);
  std::string text = "MULTILINESTRING" + tag + '(' + fuzz_part(bytes, axes, t);
  for (int n = bytes.in_range(0, 3); n > 0; --n) text += ", " + fuzz_part(bytes, axes, t);
  return text + ')';
}

void require_sound(const Plan& plan, const std::string& text) {
  const std::vector<Leg> legs = legs_of(plan);
  require(legs.size() == leg_count(plan), "the count of legs is not right", text);
  const Plan packed = decode_plan(encode_plan(plan, never), never);
  require(legs_of(packed) == legs, "the blob does not read back the same", text);
  std::size_t next = 0;
  for (const ChunkRange& range : cut_into_chunks(legs)) {
    require(range.first == next && range.count > 0, "a chunk is not the next one", text);
    next += range.count;
    const ChunkBox box = chunk_box(std::span(legs).subspan(range.first, range.count), plan.axes);
    for (const double half : box.half) require(half >= 0, "a box has no size", text);
  }
  require(next == legs.size(), "chunks leave legs out", text);
  const double middle = legs[legs.size() / 2].t;
  if (const auto part = cut_plan(plan, middle, no_end)) check_plan(*part);
}

void run_text(FuzzBytes& bytes) {
  std::string text = fuzz_text(bytes);
  if (bytes.in_range(0, 3) == 0) spoil(text, bytes);
  try {
    const Plan plan = read_plan(text, never);
    require(read_plan(write_plan(plan, never), never) == plan, "does not read back the same", text);
    require_sound(plan, text);
  } catch (const Error& error) {
    require(std::strlen(error.what()) < 400, "a long message", text);
  }
}

void run_blob(FuzzBytes& bytes) {
  std::vector<std::byte> blob{std::byte{'p'}, std::byte{'l'}, std::byte{1}};
  blob.push_back(std::byte(bytes.in_range(1, 3))), blob.push_back(std::byte(bytes.in_range(0, 2)));
  blob.resize(8);
  double t = bytes.in_range(-9, 9);
  const bool bounded = bytes.flag();
  for (int n = bytes.in_range(0, 60); n > 0; --n) {
    std::uint64_t bits = bytes.any<std::uint64_t>();
    if (bounded) bits = (bits & 0x800fffffffffffff) | 0x4000000000000000;
    double number;
    std::memcpy(&number, &bits, sizeof bits);
    if (bytes.in_range(0, 2) == 0) number = t += bytes.in_range(0, 3);
    const auto* first = reinterpret_cast<const std::byte*>(&number);
    blob.insert(blob.end(), first, first + sizeof number);
  }
  if (bytes.in_range(0, 5) == 0 && blob.size() > 9)
    blob[bytes.in_range<std::size_t>(0, 9)] = std::byte(bytes.any<std::uint8_t>());
  try {
    const Plan plan = decode_plan(blob, never);
    require(encode_plan(plan, never) == blob, "the blob is written otherwise", "");
    require_sound(plan, "");
  } catch (const Error& error) {
    require(std::strlen(error.what()) < 400, "a long message", "");
  }
}

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  if (bytes.flag())
    foresee::testing::run_text(bytes);
  else
    foresee::testing::run_blob(bytes);
  return 0;
}
