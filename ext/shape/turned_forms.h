// What do the forms of many rows look like, as they lie? Asked by contact, for the rows that come near each
// other. Common to outlines (outline/turned_outlines.h) and meshes (mesh/turned_meshes.h).
//
//   TurnedForms<SharedOutline> forms;
//   forms.assign(ships, source, interrupt);               // looks every number up
//   ScratchPieces<ConvexPieces> own;
//   if (const ConvexPieces* hull = forms.pieces(row, own)) …   // turned by the row's heading
//
// Rows of one form and one heading share its pieces. Those of a heading are made when a row of it is first
// asked for, and kept as long as all that are kept take no more than a budget; beyond that each who asks
// makes its own, which it forgets when it asks for others. Several threads may ask. Cost: a look-up a row;
// later to turn and to make, once as a rule.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "shape/bodies.h"
#include "shape/form.h"
#include "shape/scratch_pieces.h"

namespace foresee {

template <class KindOfForm>
class TurnedForms {
 public:
  using Pieces = typename KindOfForm::Pieces;

  /// So many bytes: all headings of a hundred thousand hulls, or forty of the largest mesh.
  static constexpr std::size_t usual_budget = std::size_t{256} << 20;

  explicit TurnedForms(std::size_t budget = usual_budget) : budget_(budget) {}
  TurnedForms(const TurnedForms&) = delete;
  TurnedForms& operator=(const TurnedForms&) = delete;

  /// From now on these rows. Nobody asks meanwhile. Requires: the layout is one of such forms; the rows live
  /// as long as this and do not change.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt);

  /// Which live as long as this, or are in `own`; null: the row has no form. Throws Error where the form,
  /// turned, is none: no row that was accepted has such a heading.
  const Pieces* pieces(std::size_t row, ScratchPieces<Pieces>& own) const;

  /// Bytes, some of them an estimate: it grows as rows are asked for.
  std::size_t memory() const;

 private:
  using Turned = std::atomic<const Pieces*>;

  /// What is shared.
  struct Pose {
    const KindOfForm* form;
    double heading;

    friend bool operator==(const Pose&, const Pose&) = default;
  };
  struct PoseHash {
    std::size_t operator()(const Pose& pose) const {
      return std::hash<const void*>()(pose.form) ^ 0x9e3779b97f4a7c15U * std::hash<double>()(pose.heading);
    }
  };

  const Pieces* kept(const Pose& pose) const;
  /// Null: there is no room.
  const Pieces* keep(const Pose& pose, std::unique_ptr<const Pieces>& made) const;
  const Pieces* made_for(std::size_t row, const Pose& pose, ScratchPieces<Pieces>& own) const;
  double heading(std::size_t row) const { return value_or(bodies_.row(row), bodies_.at.heading, 0); }

  Bodies bodies_;
  std::unordered_map<std::int64_t, std::shared_ptr<const KindOfForm>> known_;
  std::vector<const KindOfForm*> forms_;      ///< one a row; null: none
  mutable std::unique_ptr<Turned[]> turned_;  ///< … and its pieces among those kept; null: not known
  std::size_t budget_;
  mutable std::mutex mutex_;  ///< of what follows
  mutable std::unordered_map<Pose, std::unique_ptr<const Pieces>, PoseHash> kept_;
  mutable std::size_t kept_bytes_ = 0;
};

}  // namespace foresee
