// make_contact() and make_window_contact(): select the class that decides contact by the rule of the distance
// (pair_rule.h), once per statement. The table of docs/explanation/semantics.md#contact lists the distances.
#include "base/error.h"
#include "contact/contact.h"
#include "contact/contact_factories.h"
#include "contact/minkowski/contact_set.h"
#include "contact/window_contact.h"
#include "shape/shared_form.h"

namespace foresee {
namespace {

/// Whether something is round: `within`, or a radius above 0 in a row, now or later. Balls of radius 0 are
/// points: if `within` is 0, the cheaper distance per axis gives the same answers.
bool is_round(const PairRule& rule, const Bodies& a, const Bodies& b) {
  const auto has_radius = [](const Bodies& bodies, int radius, int growth) {
    if (radius == Offsets::absent && growth == Offsets::absent) return false;
    for (std::size_t i = 0; i < bodies.count; ++i)
      if (value_or(bodies.row(i), radius, 0) > 0 || value_or(bodies.row(i), growth, 0) > 0) return true;
    return false;
  };
  const PairSize& radius = rule.radius;
  return radius.limit > 0 || has_radius(a, radius.a, radius.growth_a) ||
         has_radius(b, radius.b, radius.growth_b);
}

/// The forms of both tables for contact; null where `bounds_alone`, or boxes and points, stand for them.
template <class Pieces>
FormTables<Pieces> tables_of(const Bodies& a, const Bodies& b, const FormRows<Pieces>* Bodies::*forms,
                             bool bounds_alone) {
  const auto of = [&](const Bodies& bodies) -> const FormRows<Pieces>* {
    if (bounds_alone || !is_stored_apart(bodies.layout.shape)) return nullptr;
    if (!(bodies.*forms) && bodies.count > 0)
      throw Error(std::string("the ") + name_of_form(bodies.layout.shape) +
                  (bodies.layout.shape == Shape::mesh ? "es" : "s") + " of these rows are not loaded");
    return bodies.*forms;
  };
  return {of(a), of(b)};
}

}  // namespace

void Contact::all_contacts(std::span<const Pair>, std::vector<Pair>&, std::vector<ContactTimes>&) {
  throw Error("contacts = 'all' is not for outlines and meshes: leave it out");
}

std::unique_ptr<Contact> make_contact(const Bodies& a, const Bodies& b, const ContactQuestion& question,
                                      const std::string& name_a, const std::string& name_b) {
  require_distance(a.layout, b.layout, question.within_z, name_a, name_b);
  PairRule rule(a.layout, b.layout, question.within, question.within_z);
  if (rule.distance == Distance::euclidean && !is_round(rule, a, b) && rule.pieces == PieceKind::none)
    rule = rule.without_radius();
  const Setup setup{a, b, question.horizon, rule};
  const int degree = std::max(degree_of(a.layout.law), degree_of(b.layout.law));
  const bool boxes = question.rectangles_for_outlines;
  if (rule.pieces == PieceKind::planar)
    return make_outline_contact(setup, tables_of(a, b, &Bodies::outlines, boxes), degree);
  if (rule.pieces == PieceKind::spatial)
    return make_mesh_contact(setup, tables_of(a, b, &Bodies::meshes, boxes), degree);
  if (rule.distance == Distance::per_axis && !rule.grows) return make_box_contact(setup, degree);
  return make_set_contact(setup, contact_set(setup), degree);
}

MovingWindow::MovingWindow(const WindowFaces& faces, const Layout& objects, double now,
                           std::shared_ptr<const SharedOutline> zone)
    : faces_(faces) {
  const Layout layout{.axes = objects.axes, .law = Law::uniform, .shape = Shape::point, .has_t = true};
  bodies_ = Bodies(layout, row_.data(), 1);
  zone_.outline = std::move(zone);
  if (zone_.outline) bodies_.outlines = &zone_;
  const bool from_origin = zone_.outline || objects.shape == Shape::outline || objects.shape == Shape::mesh;
  row_[static_cast<std::size_t>(bodies_.at.t)] = now;
  for (int axis = 0; axis < objects.axes; ++axis) {
    row_[static_cast<std::size_t>(bodies_.at.x + axis)] = from_origin ? 0 : faces.reference(axis);
    row_[static_cast<std::size_t>(bodies_.at.v + axis)] = faces.velocity[static_cast<std::size_t>(axis)];
  }
}

std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon) {
  const WindowFaces& faces = window.faces();
  if (window.has_zone()) require_distance_from_zone(objects.layout, faces.has_lower(2) || faces.has_upper(2));
  const PairRule rule = PairRule::of_window(window.bodies().layout, objects.layout, window.has_zone());
  const Setup setup{window.bodies(), objects, horizon, rule, &faces};
  const int degree = degree_of(objects.layout.law);
  if (rule.pieces == PieceKind::spatial) return make_mesh_contact(setup, {nullptr, objects.meshes}, degree);
  if (rule.pieces == PieceKind::planar)
    return make_outline_contact(setup, {window.bodies().outlines, objects.outlines}, degree);
  return make_set_contact(setup, contact_set(setup), degree);
}

}  // namespace foresee
