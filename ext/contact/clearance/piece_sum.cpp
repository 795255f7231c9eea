#include "contact/clearance/piece_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

/// Upper bound of the relative rounding errors of rotated corners and of a stored heading.
constexpr double pad_of_sum = 0x1p-45;

double length_of(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// The distance of the farthest corner, rounded up, also where squares underflow.
double reach_of(std::span<const Corner> corners) {
  double largest = 0, longest = 0;
  for (const Corner& corner : corners) largest = std::max({largest, std::abs(corner.x), std::abs(corner.y)});
  if (largest == 0) return 0;
  for (const Corner& corner : corners)
    longest = std::max(longest, length_of(corner.x / largest, corner.y / largest));
  return largest * longest * (1 + 0x1p-49) + std::numeric_limits<double>::denorm_min();
}

double farthest_along(std::span<const Corner> corners, double x, double y) {
  double support = -std::numeric_limits<double>::infinity();
  for (const Corner& corner : corners) support = std::max(support, x * corner.x + y * corner.y);
  return support;
}

const Corner& farthest_corner(std::span<const Corner> corners, double x, double y) {
  const Corner* found = corners.data();
  double support = -std::numeric_limits<double>::infinity();
  for (const Corner& corner : corners) {
    const double here = x * corner.x + y * corner.y;
    if (here > support) support = here, found = &corner;
  }
  return *found;
}

}  // namespace

PieceSum::PieceSum(const ConvexPiece& own, const ConvexPiece& other)
    : given_(own.corners.begin(), own.corners.end()), own_(given_), other_(other) {
  own_reach_ = reach_of(given_);
  size_ = own_reach_ + reach_of(other.corners);
  make_ring(own.along == own.corners.data() ? own_.data() : own.along);
}

PieceSum::PieceSum(const ConvexPiece& own, std::shared_ptr<const ObjectPieces> other)
    : PieceSum(own, other->piece(0)) {
  kept_ = std::move(other);
}

void PieceSum::turn(double degrees) {
  const SineCosine<double> at = quick_sine_cosine(degrees);
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const Corner& corner = given_[i];
    own_[i] = {corner.x * at.cosine + corner.y * at.sine, corner.y * at.cosine - corner.x * at.sine};
  }
  is_turned_ = true;
}

void PieceSum::make_ring(const Corner* along) const {
  is_turned_ = false;
  ring_.clear();
  const ConvexPiece own{own_, along, nullptr};
  point_ = {own_[0].x - other_.corners[0].x, own_[0].y - other_.corners[0].y};
  if (own.edges() + other_.edges() == 0) return;
  SumEdge edge;
  for (ConvexSum sum(own, other_); sum.next(edge);) {
    const double x = edge.p->x - edge.q->x, y = edge.p->y - edge.q->y;
    const double run_x = edge.to->x - edge.from->x, run_y = edge.to->y - edge.from->y;
    const double length = length_of(run_x, run_y);
    const double travelled = length_of(edge.p_end->x - edge.q_end->x - x, edge.p_end->y - edge.q_end->y - y);
    if (length > 0) ring_.push_back({x, y, run_y / length, -run_x / length, travelled, length});
  }
}

double PieceSum::support(double x, double y) const {
  return farthest_along(own_, x, y) + farthest_along(other_.corners, -x, -y) +
         size_ * (pad_of_sum * (std::abs(x) + std::abs(y)));
}

Corner PieceSum::farthest(double x, double y) const {
  const Corner &own = farthest_corner(own_, x, y), &other = farthest_corner(other_.corners, -x, -y);
  return {own.x - other.x, own.y - other.y};
}

std::pair<double, double> PieceSum::crossing(double x, double y, double vx, double vy, double begin,
                                             double end) const {
  for (const Edge& edge : ring()) {
    const double beyond = (x - edge.x) * edge.normal_x + (y - edge.y) * edge.normal_y;
    const double slope = vx * edge.normal_x + vy * edge.normal_y;
    if (slope < 0) begin = std::max(begin, beyond / -slope);
    if (slope > 0) end = std::min(end, -beyond / slope);
    if (slope == 0 && beyond > 0) return {0, -1};
  }
  return {begin, end};
}

double PieceSum::signed_distance(double x, double y, double& normal_x, double& normal_y) const {
  const auto beyond = [&](const Edge& edge) {
    return (x - edge.x) * edge.normal_x + (y - edge.y) * edge.normal_y;
  };
  const auto past = [&](const Edge& edge) {
    return (y - edge.y) * edge.normal_x - (x - edge.x) * edge.normal_y;
  };
  const auto is_beside = [&](const Edge& edge) {
    const double here = past(edge);
    return here >= 0 && here <= edge.length;
  };
  const std::vector<Edge>& edges = ring();
  const Edge* nearest_edge = nullptr;
  double within = -std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) {
    const double here = beyond(edge);
    if (here > within) within = here, nearest_edge = &edge;
  }
  // Not from the vector between the point and the edge, which may be very short.
  if (nearest_edge && (within <= 0 || is_beside(*nearest_edge))) {
    normal_x = nearest_edge->normal_x, normal_y = nearest_edge->normal_y;
    return within;
  }
  // The nearest is a corner, or one of several collinear edges.
  double square = nearest_edge ? std::numeric_limits<double>::infinity() : -1, to_x = x - point_.x,
         to_y = y - point_.y;
  for (const Edge& edge : edges) {
    const double from_x = x - edge.x, from_y = y - edge.y, ahead = beyond(edge);
    const double here = from_x * from_x + from_y * from_y;
    if (here < square) square = here, to_x = from_x, to_y = from_y;
    if (ahead > 0 && is_beside(edge)) {
      normal_x = edge.normal_x, normal_y = edge.normal_y;
      return ahead;
    }
  }
  const double distance = length_of(to_x, to_y);
  normal_x = distance > 0 ? to_x / distance : 0, normal_y = distance > 0 ? to_y / distance : 1;
  return distance;
}

}  // namespace foresee
