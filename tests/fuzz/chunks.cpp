// Hostile chunks of plans with valid checksums: the bytes of a sound chunk are changed, cut and extended, and the
// checksum is recomputed. The result must be a message, or legs in order and the same plan in both ways of reading. A
// crash or a hang is a failure.
#include <cmath>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "format/chunk_blob.h"
#include "format/crc32c.h"
#include "motion/plan/plan_legs.h"
#include "wkt.h"

namespace foresee::testing {
namespace {

constexpr std::int64_t row = 7;

double fuzz_number(FuzzBytes& bytes) {
  return std::strtod(fuzz_coordinate(bytes).c_str(), nullptr);
}

std::array<double, 3> fuzz_vector(FuzzBytes& bytes, int axes) {
  std::array<double, 3> vector{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(axes); ++j) vector[j] = fuzz_number(bytes);
  return vector;
}

Plan fuzz_plan(FuzzBytes& bytes) {
  Plan plan{.kind = PlanKind(bytes.in_range(0, 2)), .axes = bytes.in_range(1, 3)};
  double t = bytes.in_range(-9, 9);
  for (int n = bytes.in_range(1, 20); n > 0; --n) {
    if (plan.kind == PlanKind::knots) {
      if (plan.knots.size() >= plan.part_starts.back() + 2 && n > 1 && bytes.in_range(0, 5) == 0)
        plan.part_starts.push_back(plan.knots.size());
      plan.knots.push_back({t, fuzz_vector(bytes, plan.axes)});
    } else {
      plan.legs.push_back({t, t + 1, fuzz_vector(bytes, plan.axes), fuzz_vector(bytes, plan.axes), {}});
      if (plan.kind == PlanKind::accelerated) plan.legs.back().a = fuzz_vector(bytes, plan.axes);
    }
    t += bytes.in_range(1, 3);
  }
  if (bytes.flag() && plan.kind == PlanKind::knots) plan.knots.push_back({no_end, plan.knots.back().x});
  return plan;
}

void change(std::vector<std::byte>& blob, FuzzBytes& bytes) {
  for (int n = bytes.in_range(0, 4); n > 0; --n) {
    const std::size_t last = bytes.flag() ? std::min<std::size_t>(blob.size() - 1, 31) : blob.size() - 1;
    blob[bytes.in_range<std::size_t>(0, last)] = std::byte(bytes.any<std::uint8_t>());
  }
  if (bytes.in_range(0, 7) == 0) blob.resize(bytes.in_range<std::size_t>(4, blob.size() + 40));
  std::uint32_t checksum = crc32c(blob.data(), blob.size() - 4);
  checksum = crc32c(&row, sizeof row, checksum);
  std::memcpy(blob.data() + blob.size() - 4, &checksum, sizeof checksum);
}

void require_ordered(const std::vector<Leg>& legs) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    require(std::isfinite(legs[i].t) && legs[i].t <= legs[i].until, "a leg has no life", "");
    if (i > 0) require(legs[i - 1].until <= legs[i].t, "legs overlap", "");
    for (std::size_t j = 0; j < 3; ++j)
      require(std::isfinite(legs[i].x[j]) && std::isfinite(legs[i].v[j]) && std::isfinite(legs[i].a[j]),
              "a number is not finite", "");
  }
}

void run(FuzzBytes& bytes) {
  const Plan plan = fuzz_plan(bytes);
  Layout layout{
      .axes = plan.axes, .law = Law::accelerated, .has_t = true, .has_until = true, .has_plan = true};
  std::vector<std::byte> blob;
  try {
    check_plan(plan);
    blob = ChunkWriter(plan, 42).blob(0, row);
  } catch (const Error&) {
    return;  // times of a plan without end, or no velocity
  }
  change(blob, bytes);
  const FloatEnvironment environment;
  StoredChunk chunk;
  if (open_chunk(layout, blob, row, chunk)) return;
  std::vector<Leg> legs;
  Plan read{.part_starts = {0}};
  const char* const of_legs = append_legs(chunk, legs);
  if (chunk.is_first) {
    const char* const of_plan = append_to_plan(chunk, read);
    require((of_legs == nullptr) == (of_plan == nullptr), "the two ways of reading disagree", "");
  }
  if (of_legs) return;
  require(legs.size() == chunk.legs, "the number of legs is not right", "");
  require_ordered(legs);
  if (!chunk.is_first) return;
  if (read.kind == PlanKind::knots && read.part_starts.back() == read.knots.size())
    read.part_starts.pop_back();
  check_plan(read);
  require(legs_of(read) == legs, "the plan has other legs", "");
}

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  foresee::testing::run(bytes);
  return 0;
}
