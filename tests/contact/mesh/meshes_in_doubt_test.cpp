// Meshes that slide in one slanted plane: doubles decide no pair of triangles that meet in it, so the exact
// stage decides, some pieces at a time.
#include <gtest/gtest.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <ctime>

#include "contact/mesh/meshes_by_hand.h"
#include "sanitized.h"

namespace foresee {
namespace {

using namespace testing_by_hand;
using testing::sanitized;

/// Squares of two triangles each, in the plane z = 3 x + 5 y.
MeshObject slanted(int columns, int rows) {
  const Mesh level = surface_of(terrain(columns, rows, 1, [] { return 0.0; }));
  return resting(mapped(level, [](const SpaceCorner& c) {
    return SpaceCorner{c.x, c.y, 3 * c.x + 5 * c.y};
  }));
}

MeshObject sliding(MeshObject object, const Corner& place, const Corner& velocity) {
  return moving(std::move(object), {place.x, place.y, 3 * place.x + 5 * place.y},
                {velocity.x, velocity.y, 3 * velocity.x + 5 * velocity.y});
}

/// Reads the heap size and the clock at each poll.
class Watching final : public Interrupt {
 public:
  void check() override {
    ++checks_;
    const double now = cpu_seconds();
    longest_ = std::max(longest_, now - last_), last_ = now;
    peak_ = std::max(peak_, heap());
  }
  double longest() const { return longest_; }
  std::size_t peak() const { return peak_ - std::min(peak_, first_); }
  int checks() const { return checks_; }

 private:
  static double cpu_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  static std::size_t heap() {
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return 0;
#endif
  }

  std::size_t first_ = heap(), peak_ = first_;
  double last_ = cpu_seconds(), longest_ = 0;
  int checks_ = 0;
};

/// b comes from the left at speed 1, starts to slide over a at 0.5, and is past it after the lengths of
/// both.
void expect_slide(const MeshObject& a, double length_a, MeshObject b, double length_b, Watching& watching) {
  b.row.t = -1;  // reported at another time, so that no axis is steady
  b = sliding(std::move(b), {-1.5 - length_b, 0.25}, {1, 0});
  const MeshScene scene{a, std::move(b), {.horizon = {.now = 0, .h = 1000}}};
  expect_contact(mesh_contact(scene, watching), 0.5, 0.5 + length_a + length_b);
}

TEST(MeshesInDoubt, AreDecidedSomePiecesAtATime) {
  const int n = sanitized ? 3 : 6;
  Watching watching;
  expect_slide(slanted(n, n), n, slanted(n, n), n, watching);
  EXPECT_GT(watching.checks(), 10);
  if (sanitized) return;
  EXPECT_LT(watching.peak(), 12'000'000u) << "bytes of the heap";
  EXPECT_LT(watching.longest(), 0.2) << "seconds without a poll of the interrupt";
}

// A chain of more intervals than are kept: the time is cut.
TEST(MeshesInDoubt, AreDecidedOneIntervalAfterAnother) {
  const int n = sanitized ? 20 : 200;
  Watching watching;
  expect_slide(slanted(n, 1), n, slanted(1, 1), 1, watching);
  if (sanitized) return;
  EXPECT_LT(watching.peak(), 12'000'000u) << "bytes of the heap";
}

}  // namespace
}  // namespace foresee
