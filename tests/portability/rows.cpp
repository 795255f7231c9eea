// Every row of many seeded joins as bit patterns, for tests/portability.sh: two builds agree if their outputs
// do.
//
// Scenes of every layout and kind go through the join by two methods; the hard families of the report on
// accuracy go through contact pair by pair. The inputs' bits are printed too, so that a difference there is
// not blamed on the library.
#include <bit>
#include <cinttypes>
#include <cstdio>

#include "accuracy/families.h"
#include "all_rooms.h"
#include "query/join_cases.h"

namespace foresee::testing {
namespace {

std::uint64_t mixed(const std::vector<double>& numbers) {
  std::uint64_t sum = 0;
  for (double number : numbers) sum = (sum ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
  return sum;
}

void print_bits(double value) {
  std::printf(" %016" PRIx64, std::bit_cast<std::uint64_t>(value));
}

void print_scene(const SceneSpec& spec) {
  const RandomScene random = random_scene(spec);
  std::printf("%s, %s, inputs %016" PRIx64 "\n", name_of(spec.layout).c_str(), name_of(spec.kind).c_str(),
              mixed(random.records));
  JoinQuestion question{.a = scene_of(random), .now = random.now, .h = random.h, .within = random.within};
  for (JoinMethod method : {JoinMethod::scan, JoinMethod::grid}) {
    question.method = method;
    for (const JoinRow& row : rows_of(question)) {
      std::printf("%" PRId64 " %" PRId64, row.a, row.b);
      const ContactTimes& c = row.contact;
      for (double value : {c.t, c.t_end, c.dt, c.dt_end, row.approach.t, row.approach.dt, row.approach.d})
        print_bits(value);
      std::printf("\n");
    }
  }
}

void print_family(const std::string& name, std::size_t count) {
  const bench::Family family = bench::make_family(name, count, 11);
  std::printf("%s, inputs %016" PRIx64 " %016" PRIx64 "\n", name.c_str(), mixed(family.rows_a),
              mixed(family.rows_b));
  std::vector<Pair> pairs, hits;
  for (std::uint32_t i = 0; i < count; ++i) pairs.push_back({i, i});
  const auto contact = make_contact(family.a(), family.b(), {.horizon = family.horizon}, "a", "b");
  std::vector<ContactTimes> times;
  contact->first_contacts(pairs, TimesWanted::both, hits, times);
  std::vector<ClosestApproach> approaches(hits.size());
  contact->closest_approach(hits, approaches);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    std::printf("%u", hits[i].a);
    for (double value : {times[i].t, times[i].t_end, times[i].dt, times[i].dt_end, approaches[i].t,
                         approaches[i].dt, approaches[i].d})
      print_bits(value);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace foresee::testing

int main() {
  using namespace foresee::testing;
  std::uint64_t seed = 1;
  for (const Layout& layout : all_layouts())
    for (SceneKind kind : all_scene_kinds)
      print_scene({.layout = layout, .kind = kind, .count = 14, .seed = seed++});
  for (const std::string& name : foresee::bench::family_names()) print_family(name, 100);
}
