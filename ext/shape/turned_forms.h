// Rotated forms of many rows, cached by form and heading and shared by rows, as contact reads them.
//
// Common to outlines (outline/turned_outlines.h) and meshes (mesh/turned_meshes.h).
//
//   TurnedForms<SharedOutline> forms;
//   forms.assign(ships, source, interrupt);               // looks up the form number of every row
//   ScratchPieces<ConvexPieces> own;
//   if (const ConvexPieces* hull = forms.pieces(row, own)) …   // turned by the row's heading
//
// Rows of the same form and heading share its pieces. Pieces are made on the first read of a row with that
// heading, and kept until the cache reaches its budget. Beyond the budget each caller makes its own pieces,
// and discards them with its next read. Thread-safe. Cost: a look-up per row; on demand a rotation and the
// pieces, as a rule once.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "shape/bodies.h"
#include "shape/scratch_pieces.h"
#include "shape/shared_form.h"

namespace foresee {

template <class KindOfForm>
class TurnedForms {
 public:
  using Pieces = typename KindOfForm::Pieces;

  /// In bytes: enough for all headings of a hundred thousand hulls, or forty of the largest mesh.
  static constexpr std::size_t usual_budget = std::size_t{256} << 20;

  explicit TurnedForms(std::size_t budget = usual_budget) : budget_(budget) {}
  TurnedForms(const TurnedForms&) = delete;
  TurnedForms& operator=(const TurnedForms&) = delete;

  /// Replaces the rows. Not thread-safe. Requires: the layout has such forms; the rows live as long as this
  /// and do not change.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt);

  /// The pieces of the row's rotated form; they live as long as this, or in `own`. Null: the row has no form.
  /// Throws Error if the rotated form is not valid: no accepted row has such a heading.
  const Pieces* pieces(std::size_t row, ScratchPieces<Pieces>& own) const;

  /// In bytes, partly an estimate; it grows as rows are read.
  std::size_t memory() const;

 private:
  using Turned = std::atomic<const Pieces*>;

  /// The key of the cache: a form and its heading.
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
  /// Caches the pieces; null if the budget does not allow it.
  const Pieces* keep(const Pose& pose, std::unique_ptr<const Pieces>& made) const;
  const Pieces* made_for(std::size_t row, const Pose& pose, ScratchPieces<Pieces>& own) const;
  double heading(std::size_t row) const { return value_or(bodies_.row(row), bodies_.at.heading, 0); }

  Bodies bodies_;
  std::unordered_map<std::int64_t, std::shared_ptr<const KindOfForm>> known_;
  std::vector<const KindOfForm*> forms_;      ///< per row; null: no form
  mutable std::unique_ptr<Turned[]> turned_;  ///< per row: its cached pieces; null: not known
  std::size_t budget_;
  mutable std::mutex mutex_;  ///< protects the members below
  mutable std::unordered_map<Pose, std::unique_ptr<const Pieces>, PoseHash> kept_;
  mutable std::size_t kept_bytes_ = 0;
};

}  // namespace foresee
