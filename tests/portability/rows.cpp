// Every row of many seeded joins as bit patterns, for tests/portability.sh: two builds agree if their outputs
// do.
//
// Scenes of every layout and kind go through the join by two methods. Some objects of each layout go through
// the avoidance of all others. The hard families of the report on accuracy, of outlines and of meshes go
// through contact one pair at a time. The bits of the inputs are printed too, so that a difference there is
// not attributed to the library; those of turned outlines are already computed by it.
#include <bit>
#include <cinttypes>
#include <cstdio>

#include "accuracy/families.h"
#include "contact/mesh/mesh_scenes.h"
#include "contact/outline/outline_scenes.h"
#include "query/avoid/avoid_cases.h"

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

std::uint64_t mixed(const std::string& text) {
  std::uint64_t sum = 0;
  for (const char byte : text) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x9e3779b97f4a7c15u;
  return sum;
}

/// Scenes of each family, as text and as the first contact.
template <class Family, class Pairings, class FirstContact>
void print_pairs(std::span<const Family> families, const Pairings& pairings, std::uint64_t seeds,
                 FirstContact first_contact) {
  for (const Family& family : families)
    for (const auto pairing : pairings)
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const auto scene = draw_scene(family, pairing, seed);
        std::printf("%s %d, inputs %016" PRIx64, family.name, static_cast<int>(pairing),
                    mixed(described(scene)));
        if (const auto times = first_contact(scene))
          for (const double value : {times->t, times->t_end, times->dt, times->dt_end}) print_bits(value);
        std::printf("\n");
      }
}

void print_outlines() {
  using enum testing_by_hand::OutlinePairing;
  const auto first_contact = [](const auto& scene) { return testing_by_hand::outline_contact(scene); };
  print_pairs(testing_by_hand::outline_families(), std::array{outlines, outline_and_point, outline_and_box},
              8, first_contact);
}

void print_meshes() {
  using enum testing_by_hand::MeshPairing;
  const auto first_contact = [](const auto& scene) { return testing_by_hand::mesh_contact(scene); };
  print_pairs(testing_by_hand::mesh_families(),
              std::array{meshes, mesh_and_point, mesh_and_box, mesh_and_ball}, 1, first_contact);
}

/// Avoidance by the first objects of a scene.
void print_manoeuvres(const SceneSpec& spec) {
  const RandomScene scene = random_scene(spec);
  for (std::size_t i = 0; i < 2; ++i) {
    const AvoidQuestion question = avoid_question(scene, i, as_scene(scene));
    for (const AvoidRow& row : rows_of(question)) {
      std::printf("%s %d", std::string(name_of(row.manoeuvre)).c_str(), row.clear);
      for (const double value : {row.k_from, row.k_to, row.k}) print_bits(value);
      for (const double value : row.record) print_bits(value);
      for (const auto& end : {row.below, row.above})
        if (end) std::printf(" %" PRId64, end->id), print_bits(end->t);
      std::printf("\n");
    }
  }
}

}  // namespace
}  // namespace foresee::testing

int main() {
  using namespace foresee;
  using namespace foresee::testing;
  std::uint64_t seed = 1;
  for (const Layout& layout : all_layouts())
    for (SceneKind kind : all_scene_kinds)
      print_scene({.layout = layout, .kind = kind, .count = 14, .seed = seed++});
  for (const Layout& layout : all_layouts())
    print_manoeuvres({.layout = layout, .count = 14, .seed = seed++});
  for (const std::string& name : foresee::bench::family_names()) print_family(name, 100);
  print_outlines();
  print_meshes();
}
