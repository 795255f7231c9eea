// Laws of contact (contact/contact.h) for outlines and meshes alike: a scene that is exchanged, scaled or
// mirrored has the same answers, and greater distances are reached no later.
#include "contact/form_laws.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace foresee {
namespace {

using namespace testing_by_hand;

template <class Forms>
struct FormLaws : ::testing::Test {};

struct FormNames {
  template <class Forms>
  static std::string GetName(int) {
    return Forms::name;
  }
};
using AllForms = ::testing::Types<OutlineForms, MeshForms>;
TYPED_TEST_SUITE(FormLaws, AllForms, FormNames);

/// Law 1.
TYPED_TEST(FormLaws, ExchangingTheTwoChangesNothing) {
  for_each_scene<TypeParam>([](const auto& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, TypeParam::answer({scene.b, scene.a, scene.question}), "exchanged");
  });
}

/// Law 2.
TYPED_TEST(FormLaws, AMirrorChangesNothing) {
  for_each_scene<TypeParam>([](const auto& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, TypeParam::answer(TypeParam::mirrored(scene)), "mirrored in x");
  });
}

/// Law 4.
TYPED_TEST(FormLaws, LengthsInAnotherUnitChangeNothing) {
  for_each_scene<TypeParam>([](const auto& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, TypeParam::answer(TypeParam::scaled(scene, 0x1p20)), "scaled");
    // Where squares vanish, what is near is left to exact numbers. Of a subnormal number digits would, and a face might
    // lose its area.
    const auto would_vanish = [](double x) { return x != 0 && std::abs(x) < 0x1p-700; };
    if (std::any_of(std::begin(scene.b.row.x), std::end(scene.b.row.x), would_vanish)) return;
    const std::vector<double> corners = TypeParam::corner_numbers(scene);
    if (std::any_of(corners.begin(), corners.end(), would_vanish)) return;
    expect_same(answer, TypeParam::answer(TypeParam::scaled(scene, 0x1p-290)), "made small");
  });
}

/// Whether a product with a power of two is exact: the smallest numbers lose bits.
bool is_scalable(double number) {
  return number == 0 || std::abs(number) > 0x1p-980;
}

/// Law 5.
TYPED_TEST(FormLaws, TimeInAnotherUnitChangesNothing) {
  int skipped = 0;
  for_each_scene<TypeParam>([&skipped](const auto& scene, const std::optional<ContactTimes>& answer) {
    const auto all = [](const auto& numbers) {
      return std::all_of(std::begin(numbers), std::end(numbers), is_scalable);
    };
    if (!all(scene.a.row.v) || !all(scene.a.row.a) || !all(scene.b.row.v) || !all(scene.b.row.a) ||
        (answer && !(is_scalable(answer->dt) && is_scalable(answer->t))))
      return static_cast<void>(++skipped);
    for (const double unit : {0x1p12, 0x1p-12}) {
      auto other = scene;
      other.question.horizon.now *= unit, other.question.horizon.h *= unit;
      for (auto* o : {&other.a, &other.b}) {
        o->row.t *= unit, o->row.until *= unit;
        for (double& v : o->row.v) v /= unit;
        for (double& a : o->row.a) a /= unit * unit;
      }
      auto found = TypeParam::answer(other);
      if (found)
        for (double* time : {&found->t, &found->dt, &found->t_end, &found->dt_end}) *time /= unit;
      expect_same(answer, found, "in another unit of time");
    }
  });
  EXPECT_LT(skipped, scaled_count(TypeParam::seeds));
}

/// Law 11.
TYPED_TEST(FormLaws, AGreaterDistanceIsReachedNoLater) {
  for_each_scene<TypeParam>([](auto scene, const std::optional<ContactTimes>& answer) {
    if (!answer) return;
    scene.question.within += 0x1p-300;
    const auto grown = TypeParam::answer(scene);
    ASSERT_TRUE(grown.has_value());
    EXPECT_LE(grown->dt, answer->dt);
  });
}

}  // namespace
}  // namespace foresee
