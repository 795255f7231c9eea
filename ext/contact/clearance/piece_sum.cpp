#include "contact/clearance/piece_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

Corner rotated(const Corner& corner, const SineCosine<double>& by) {
  return {corner.x * by.cosine + corner.y * by.sine, corner.y * by.cosine - corner.x * by.sine};
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

PieceSum::PieceSum(const ConvexPiece& own, const ConvexPiece& other, const SineCosine<double>& pose_of_other)
    : given_(own.corners.begin(), own.corners.end()), own_(given_) {
  for (const Corner& corner : other.corners) kept_corners_.push_back(rotated(corner, pose_of_other));
  other_ = {kept_corners_, kept_corners_.data(), nullptr};
  own_reach_ = reach_of(given_), size_ = own_reach_ + reach_of(kept_corners_), is_turned_ = true;
}

void PieceSum::turn(const SineCosine<double>& at) {
  pose_ = at;
  for (std::size_t i = 0; i < given_.size(); ++i) own_[i] = rotated(given_[i], at);
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

/// The sides of a piece, or of its reflection for the sign -1.
std::vector<PieceSum::Side> PieceSum::sides_of(const ConvexPiece& piece, double sign) {
  std::vector<Side> sides;
  const auto count = static_cast<std::size_t>(piece.edges());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = i + 1 < count ? i + 1 : 0;
    const double x = sign * (piece.along[next].x - piece.along[i].x),
                 y = sign * (piece.along[next].y - piece.along[i].y), run = length_of(x, y);
    const Corner &from = piece.corners[i], &to = piece.corners[next];
    sides.push_back({y / run, -x / run, length_of(to.x - from.x, to.y - from.y), run});
  }
  return sides;
}

void PieceSum::make_sides() const {
  if (!own_sides_.empty() || !other_sides_.empty()) return;
  own_sides_ = sides_of({given_, given_.data(), nullptr}, 1), other_sides_ = sides_of(other_, -1);
  turned_sides_ = own_sides_, first_other_ = first_of(other_sides_);
}

/// The first side counterclockwise from the lowest corner.
std::size_t PieceSum::first_of(const std::vector<Side>& sides) {
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i - 1].is_late() && !sides[i].is_late()) return i;
  return 0;
}

/// As make_ring(), but merged by rounded directions: a ring for guesses.
void PieceSum::make_turned_ring() const {
  is_turned_ = false;
  make_sides();
  point_ = {own_[0].x - other_.corners[0].x, own_[0].y - other_.corners[0].y};
  const std::size_t own_count = own_sides_.size(), other_count = other_sides_.size();
  for (std::size_t i = 0; i < own_count; ++i) {
    const Side& side = own_sides_[i];
    turned_sides_[i].normal_x = side.normal_x * pose_.cosine + side.normal_y * pose_.sine;
    turned_sides_[i].normal_y = side.normal_y * pose_.cosine - side.normal_x * pose_.sine;
  }
  const auto is_before = [](const Side& a, const Side& b) {
    return a.is_late() == b.is_late() ? a.normal_x * b.normal_y - a.normal_y * b.normal_x >= 0 : b.is_late();
  };
  std::size_t own = first_of(turned_sides_), other = first_other_;
  ring_.resize(own_count + other_count);
  Edge* edge = ring_.data();
  for (std::size_t own_left = own_count, other_left = other_count; own_left + other_left > 0; ++edge) {
    const bool of_own =
        other_left == 0 || (own_left > 0 && is_before(turned_sides_[own], other_sides_[other]));
    const Side& side = of_own ? turned_sides_[own] : other_sides_[other];
    const Corner &p = own_[own], &q = other_.corners[other];
    *edge = {p.x - q.x, p.y - q.y, side.normal_x, side.normal_y, side.length, side.run};
    if (of_own)
      own = own + 1 < own_count ? own + 1 : 0, --own_left;
    else
      other = other + 1 < other_count ? other + 1 : 0, --other_left;
  }
}

/// A vector that is rotated by up to a half width in both directions.
struct PieceSum::Arc {
  Arc(double x, double y, const SineCosine<double>& half) : x(x), y(y), length(length_of(x, y)), half(half) {}

  /// The farthest of them along n, of this length.
  double farthest(double nx, double ny, double n) const {
    const double along = nx * x + ny * y, across = nx * y - ny * x, all = n * length;
    return along >= half.cosine * all ? all : half.cosine * along + half.sine * std::abs(across);
  }

  double x, y, length;
  SineCosine<double> half;
};

/// A piece in a place. `pose`: of the normals of its sides.
struct PieceSum::Placed {
  std::span<const Corner> corners;
  const std::vector<Side>& sides;
  SineCosine<double> pose;
  Corner place;

  Corner corner(std::size_t i) const { return {corners[i].x + place.x, corners[i].y + place.y}; }
  Corner normal(std::size_t i) const {
    const Side& side = sides[i];
    return {side.normal_x * pose.cosine + side.normal_y * pose.sine,
            side.normal_y * pose.cosine - side.normal_x * pose.sine};
  }
  /// How far an arc reaches beyond a side.
  double over(std::size_t i, const Arc& arc) const {
    const Corner n = normal(i), from = corner(i);
    return arc.farthest(n.x, n.y, 1) - (n.x * from.x + n.y * from.y);
  }
};

/// `side`: where the last corner was rejected, and its neighbours mostly are. `left`: the tests of sides that remain.
bool PieceSum::is_inside(const Arc& arc, const Placed& piece, double radius, double slack, std::size_t& side,
                         std::size_t& left) {
  const double near = radius + slack;
  const std::size_t sides = piece.sides.size();
  if (left < sides) return false;
  std::size_t beyond = 0, edge = 0;  // the edges that it crosses
  for (std::size_t tested = 0, i = side; tested < sides; ++tested, i = i + 1 < sides ? i + 1 : 0) {
    --left;
    const double over = piece.over(i, arc);
    if (over > near) return side = i, false;
    if (over > slack) ++beyond, edge = i;
  }
  if (!piece.sides.empty() && beyond == 0) return true;
  if (!(radius > 0)) return false;
  if (beyond == 1) {
    const Corner n = piece.normal(edge), from = piece.corner(edge);
    const double start = n.x * from.y - n.y * from.x;
    if (arc.farthest(n.y, -n.x, 1) <= -start &&
        arc.farthest(-n.y, n.x, 1) <= start + piece.sides[edge].length)
      return true;
  }
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const Corner c = piece.corner(i);
    const double square = c.x * c.x + c.y * c.y;
    if (square + arc.length * arc.length + 2 * arc.farthest(-c.x, -c.y, std::sqrt(square)) <= near * near)
      return true;
  }
  return false;
}

bool PieceSum::has_corner_inside(const Corner& other_place, const Corner& own_place,
                                 const SineCosine<double>& half, double radius, double slack) const {
  make_sides();
  const Placed own{own_, own_sides_, pose_, own_place},
      other{other_.corners, other_sides_, {0, -1}, other_place};
  // Linear in the corners, as all of this class: of many corners and many sides not all are tested.
  std::size_t left = 32 * (own_.size() + other_.corners.size());
  const auto has_inside = [&](const Placed& from, const Placed& in) {
    std::size_t side = 0;
    for (std::size_t i = 0; i < from.corners.size(); ++i)
      if (is_inside({from.corner(i).x, from.corner(i).y, half}, in, radius, slack, side, left)) return true;
    return false;
  };
  return has_inside(own, other) || has_inside(other, own);
}

double PieceSum::support(double x, double y, const SineCosine<double>& pose) const {
  return farthest_along(given_, x * pose.cosine - y * pose.sine, x * pose.sine + y * pose.cosine) +
         farthest_along(other_.corners, -x, -y) + size_ * (pad_of_sum * (std::abs(x) + std::abs(y)));
}

double PieceSum::support(double x, double y) const {
  return farthest_along(own_, x, y) + farthest_along(other_.corners, -x, -y) +
         size_ * (pad_of_sum * (std::abs(x) + std::abs(y)));
}

Corner PieceSum::farthest(double x, double y) const {
  const Corner &own = farthest_corner(own_, x, y), &other = farthest_corner(other_.corners, -x, -y);
  return {own.x - other.x, own.y - other.y};
}

PieceSum::CornerPair PieceSum::farthest_pair(double x, double y, const SineCosine<double>& pose) const {
  return {farthest_corner(given_, x * pose.cosine - y * pose.sine, x * pose.sine + y * pose.cosine),
          farthest_corner(other_.corners, -x, -y)};
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
  const auto projects_onto = [&](const Edge& edge) {
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
  if (nearest_edge && (within <= 0 || projects_onto(*nearest_edge))) {
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
    if (ahead > 0 && projects_onto(edge)) {
      normal_x = edge.normal_x, normal_y = edge.normal_y;
      return ahead;
    }
  }
  const double distance = length_of(to_x, to_y);
  normal_x = distance > 0 ? to_x / distance : 0, normal_y = distance > 0 ? to_y / distance : 1;
  return distance;
}

}  // namespace foresee
