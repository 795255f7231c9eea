#include "sqlite/table/layout_rules.h"

#include "base/error.h"

namespace foresee {
namespace {

/// The declared words, indexed by quantity and axis.
class WordTable {
 public:
  explicit WordTable(const std::vector<DeclaredWord>& words) {
    for (const DeclaredWord& declared : words) {
      slot(declared.word.quantity, declared.word.axis) = &declared;
      in_degrees_ |= geo_column(declared.word.name) != GeoColumn::none;
      if (declared.word.name == zone_column) axes_ = 2;  // its corners place it
    }
    while (axes_ < 3 && has(Quantity::centre, axes_)) ++axes_;
  }

  Layout layout() const {
    require_axes();
    require_known_axes();
    require_rules_of_plans();
    Layout layout{.axes = axes_, .law = law(), .shape = shape()};
    layout.has_plan = has(Quantity::plan);
    layout.has_t = layout.has_plan || has(Quantity::reference_time);
    layout.has_until = layout.has_plan || has(Quantity::until);
    layout.has_radius = is_stored_apart(layout.shape) && has(Quantity::radius);
    layout.has_heading = has(Quantity::heading);
    layout.has_category = has(Quantity::category);
    layout.has_mask = has(Quantity::mask);
    add_growth(layout);
    return layout;
  }

 private:
  const DeclaredWord*& slot(Quantity quantity, int axis) { return slots_[static_cast<int>(quantity)][axis]; }
  const DeclaredWord* at(Quantity quantity, int axis) const {
    return slots_[static_cast<int>(quantity)][axis];
  }
  bool has(Quantity quantity, int axis) const { return at(quantity, axis) != nullptr; }
  bool has(Quantity quantity) const { return first(quantity) != nullptr; }

  /// The declared word of this quantity along the lowest axis, or null.
  const DeclaredWord* first(Quantity quantity) const {
    for (int axis = 0; axis < 3; ++axis)
      if (has(quantity, axis)) return at(quantity, axis);
    return nullptr;
  }

  [[noreturn]] static void refuse(const DeclaredWord* declared, const std::string& why) {
    throw Error("\"" + declared->argument + "\": " + why);
  }

  /// "vx, vy" for two axes; with `missing_only`, only those that are not declared.
  std::string list(Quantity quantity, bool missing_only = false) const {
    std::string names;
    for (int axis = 0; axis < axes_; ++axis) {
      if (missing_only && has(quantity, axis)) continue;
      if (!names.empty()) names += ", ";
      names += word_for(quantity, axis, in_degrees_);
    }
    return names;
  }

  void require_axes() const {
    for (int axis = axes_ + 1; axis < 3; ++axis)
      if (has(Quantity::centre, axis))
        refuse(at(Quantity::centre, axis), "there is no " + std::string(word_for(Quantity::centre, axes_)) +
                                               "; axes are declared in the order x, y, z");
    if (axes_ > 0) return;
    const std::string why =
        "no position is declared; add x (and y, z for two or three axes), as in moving_objects(id, x, y, vx, "
        "vy)";
    if (const DeclaredWord* plan = first(Quantity::plan)) refuse(plan, why);
    throw Error(why);
  }

  void require_known_axes() const {
    for (Quantity quantity :
         {Quantity::velocity, Quantity::acceleration, Quantity::force, Quantity::half_extent})
      for (int axis = axes_; axis < 3; ++axis)
        if (const DeclaredWord* declared = at(quantity, axis)) {
          const std::string centre(word_for(Quantity::centre, axis));
          refuse(declared, "there is no axis " + centre + "; add " + centre + " or leave " +
                               std::string(declared->word.name) + " out");
        }
  }

  void require_rules_of_plans() const {
    if (!has(Quantity::plan)) return;
    for (const Quantity quantity : {Quantity::force, Quantity::mass})
      if (const DeclaredWord* declared = first(quantity))
        refuse(declared, "a plan has accelerations, not forces; declare " + list(Quantity::acceleration) +
                             ", or leave plan out");
    if (const DeclaredWord* growth = first(Quantity::growth))
      refuse(growth, "a plan does not grow; leave one out");
  }

  /// Whether the quantity is declared. Throws Error if some of its axes are missing.
  bool complete(Quantity quantity, const char* what) const {
    const DeclaredWord* declared = first(quantity);
    if (declared == nullptr) return false;
    const std::string missing = list(quantity, true);
    if (!missing.empty())
      refuse(declared, std::string(what) + " is declared for all axes or none; add " + missing);
    return true;
  }

  Law law() const {
    const DeclaredWord* force = first(Quantity::force);
    const DeclaredWord* mass = first(Quantity::mass);
    if (force != nullptr && has(Quantity::acceleration))
      refuse(force, "a table has either acceleration (" + list(Quantity::acceleration) +
                        ") or force and mass (" + list(Quantity::force) + ", m); leave one out");
    if (mass != nullptr && has(Quantity::acceleration))
      refuse(mass, "a mass goes with a force (" + list(Quantity::force) +
                       "), not with an acceleration; leave " + std::string(mass->word.name) + " out");
    const bool moves = complete(Quantity::velocity, "velocity");
    if (complete(Quantity::acceleration, "acceleration")) return Law::accelerated;
    if (complete(Quantity::force, "force")) {
      if (mass == nullptr) refuse(force, "a force needs a mass; add m");
      return Law::forced;
    }
    if (mass != nullptr)
      refuse(mass, "a mass needs a force; add " + list(Quantity::force) + " or leave " +
                       std::string(mass->word.name) + " out");
    return moves || has(Quantity::plan) ? Law::uniform : Law::rest;
  }

  void require_place_for_form(const DeclaredWord* form) const {
    if (axes_ == 1) refuse(form, "an outline needs two axes or three; add y, or write hx in place of shape");
    if (has(Quantity::half_extent, 0) || has(Quantity::half_extent, 1))
      refuse(form, "a table has either outlines (shape) or boxes (" + list(Quantity::half_extent) +
                       "); leave one out: a box is an outline of four corners");
  }

  Shape shape() const {
    if (const DeclaredWord* form = first(Quantity::form)) {
      require_place_for_form(form);
      return axes_ == 3 && !has(Quantity::half_extent, 2) ? Shape::mesh : Shape::outline;
    }
    if (const DeclaredWord* heading = first(Quantity::heading))
      refuse(heading, "a heading turns an outline; add shape or leave heading out");
    const bool flat = has(Quantity::half_extent, 0) || has(Quantity::half_extent, 1);
    const DeclaredWord* hz = at(Quantity::half_extent, 2);
    if (const DeclaredWord* radius = first(Quantity::radius)) {
      if (flat)
        refuse(radius, "a shape is either a box (" + list(Quantity::half_extent) + ") or round (r" +
                           (axes_ == 3 ? ", or r and hz for an upright cylinder" : "") + "); leave one out");
      return hz != nullptr ? Shape::cylinder : Shape::ball;
    }
    if (hz != nullptr && !flat)
      refuse(hz,
             "hz alone is no shape; add hx, hy for a box, r for an upright cylinder, or shape for a prism");
    return complete(Quantity::half_extent, "half extent") ? Shape::box : Shape::point;
  }

  /// A growing point becomes a disc or ball of initial radius 0; with growth_z, an upright cylinder.
  void add_growth(Layout& layout) const {
    const DeclaredWord *growth = at(Quantity::growth, 0), *growth_z = at(Quantity::growth, 2);
    if (growth == nullptr && growth_z == nullptr) return;
    const DeclaredWord* const declared = growth != nullptr ? growth : growth_z;
    if (layout.shape == Shape::mesh)
      refuse(declared,
             "no distance is defined to a mesh that grows; declare hz to make prisms, or leave shape out and "
             "declare r, a ball around each mesh");
    if (growth_z != nullptr && axes_ < 3) refuse(growth_z, "there is no axis z; add z or leave growth_z out");
    if (growth_z != nullptr && layout.shape == Shape::ball)
      refuse(growth_z,
             "a ball grows alike on all sides; add hz for an upright cylinder, or leave growth_z out");
    if (layout.shape == Shape::point) {
      if (growth == nullptr) refuse(growth_z, "a point that grows along z alone is no shape; add growth");
      layout.shape = growth_z != nullptr ? Shape::cylinder : Shape::ball;
      layout.starts_as_point = true;
    }
    layout.has_growth = growth != nullptr;
    layout.has_growth_z = growth_z != nullptr;
  }

  const DeclaredWord* slots_[quantity_count][3] = {};
  int axes_ = 0;
  bool in_degrees_ = false;
};

}  // namespace

Layout layout_of(const std::vector<DeclaredWord>& words) {
  return WordTable(words).layout();
}

int offset_of(const Offsets& at, const Word& word) {
  switch (word.quantity) {
    case Quantity::reference_time:
      return at.t;
    case Quantity::centre:
      return at.x + word.axis;
    case Quantity::velocity:
      return at.v + word.axis;
    case Quantity::acceleration:
      return at.a + word.axis;
    case Quantity::force:
      return at.force + word.axis;
    case Quantity::mass:
      return at.mass;
    case Quantity::half_extent:
      return at.half == Offsets::absent ? at.hz : at.half + word.axis;
    case Quantity::radius:
      return at.r;
    case Quantity::form:
      return at.outline;
    case Quantity::heading:
      return at.heading;
    case Quantity::growth:
      return word.axis == 2 ? at.growth_z : at.growth;
    case Quantity::category:
      return at.category;
    case Quantity::mask:
      return at.mask;
    case Quantity::plan:
      return at.plan;
    case Quantity::until:
      return at.until;
  }
  return Offsets::absent;
}

}  // namespace foresee
