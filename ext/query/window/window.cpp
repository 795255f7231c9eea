#include "query/window/window.h"

#include <limits>
#include <utility>

#include "base/float_environment.h"
#include "query/require.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_axis(const WindowFaces& faces, int axis) {
  const auto j = static_cast<std::size_t>(axis);
  const std::string letter(1, "xyz"[axis]);
  require_lower_bound((letter + "0").c_str(), faces.lower[j]);
  require_upper_bound((letter + "1").c_str(), faces.upper[j]);
  require_order((letter + "0").c_str(), faces.lower[j], (letter + "1").c_str(), faces.upper[j]);
  require_finite(("wv" + letter).c_str(), faces.velocity[j]);
}

/// What the objects do not have must be left out.
void require_no_axis(const WindowQuestion& question, int axis) {
  const auto j = static_cast<std::size_t>(axis);
  const std::string letter(1, "xyz"[axis]);
  const WindowFaces& faces = question.faces;
  const std::string given = faces.lower[j] != -infinity  ? letter + "0"
                            : faces.upper[j] != infinity ? letter + "1"
                            : faces.velocity[j] != 0     ? "wv" + letter
                                                         : "";
  if (!given.empty()) reject_axis(question.objects, given);
}

void require_only_zone(const WindowQuestion& question) {
  if (question.objects.layout().axes < 2)
    throw Error("zone: " + question.objects.name + " has one axis: write x0 and x1 in place of zone");
  for (const int axis : {0, 1}) {
    const std::string letter(1, "xyz"[axis]);
    if (question.faces.has_lower(axis) || question.faces.has_upper(axis))
      throw Error("zone says where the window is in x and y: leave out " + letter +
                  (question.faces.has_lower(axis) ? "0" : "1") + ", or zone");
  }
}

/// Of what may touch the window: a zone lies within its box.
WindowFaces faces_around(const WindowQuestion& question) {
  WindowFaces faces = question.faces;
  if (!question.zone) return faces;
  const Extents<2> around = question.zone->outline().extents();
  for (const std::size_t j : {0, 1})
    faces.lower[j] = around.lower[static_cast<Eigen::Index>(j)],
    faces.upper[j] = around.upper[static_cast<Eigen::Index>(j)];
  return faces;
}

WindowQuestion checked(WindowQuestion question) {
  if (question.zone) require_only_zone(question);
  require_not_negative("h", question.h);
  require_finite("now", question.now);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis < question.objects.layout().axes)
      require_axis(question.faces, axis);
    else
      require_no_axis(question, axis);
  }
  return question;
}

}  // namespace

Window::Window(WindowQuestion question, Interrupt& interrupt)
    : question_(checked(std::move(question))),
      interrupt_(interrupt),
      window_(question_.faces, question_.objects.layout(), question_.now, question_.zone),
      candidates_(window_candidates(question_.objects, faces_around(question_), question_.zone != nullptr,
                                    {question_.now, question_.h}, interrupt)),
      contact_(make_window_contact(window_, candidates_->bodies(), {question_.now, question_.h})) {
  contact_->heed(interrupt);
}

std::span<const WindowRow> Window::next() {
  const FloatEnvironment environment;
  rows_.clear();
  while (rows_.empty() && candidates_->next(batch_)) {
    interrupt_.check();
    pairs_.clear(), hits_.clear(), times_.clear();
    for (const std::uint32_t row : batch_.doubtful) pairs_.push_back({0, row});
    take_inside();
    const WindowWants& wants = question_.wants;
    if (wants.begins || wants.ends)
      contact_->first_contacts(pairs_, wants.ends ? TimesWanted::both : TimesWanted::begins, hits_, times_);
    else
      contact_->decide(pairs_, hits_);
    times_.resize(hits_.size());
    for (std::size_t i = 0; i < hits_.size(); ++i) rows_.push_back({candidates_->id(hits_[i].b), times_[i]});
  }
  return rows_;
}

/// What is inside at `now` touches from then on; only an end needs to be computed.
void Window::take_inside() {
  const double now = question_.now, nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t row : batch_.inside)
    if (question_.wants.ends)
      pairs_.push_back({0, row});
    else
      rows_.push_back({candidates_->id(row), {.t = now, .t_end = nan, .dt = 0, .dt_end = nan}});
}

}  // namespace foresee
