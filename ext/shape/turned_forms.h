// Rotated forms of many rows, cached by form and heading and shared by rows, as contact reads them.
//
//   RowForms forms;                                       // outlines or meshes, as the layout says
//   forms.assign(ships, source, interrupt);               // looks up the form number of every row
//   forms.attach_to(ships);                               // contact reads ships.outlines or ships.meshes
//
// Rows of the same form and heading share its pieces. Pieces are made on the first read of a row with that
// heading, and kept until the cache reaches its budget. Beyond the budget each caller makes its own pieces,
// and discards them with its next read. Thread-safe. Cost: a look-up per row. On demand it is a microsecond per
// heading and some 50 ns per corner of an outline, 200 ns per corner of a mesh, as a rule once.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "base/repeatable_choice.h"
#include "shape/bodies.h"
#include "shape/form_rows.h"
#include "shape/mesh/shared_mesh.h"
#include "shape/outline/shared_outline.h"
#include "shape/shared_form.h"

namespace foresee {

template <class KindOfForm>
class TurnedForms final : public FormRows<typename KindOfForm::Pieces> {
 public:
  using Pieces = typename KindOfForm::Pieces;

  /// In bytes: enough for all headings of a hundred thousand hulls, or forty of the largest mesh.
  static constexpr std::size_t usual_budget = std::size_t{256} << 20;

  explicit TurnedForms(std::size_t budget = usual_budget) : budget_(budget) {}
  TurnedForms(const Bodies& bodies, FormSource& source, Interrupt& interrupt) : TurnedForms() {
    assign(bodies, source, interrupt);
  }
  TurnedForms(const TurnedForms&) = delete;
  TurnedForms& operator=(const TurnedForms&) = delete;

  /// Replaces the rows. Not thread-safe. Requires: the layout has such forms; the rows live as long as this
  /// and do not change.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt);

  /// Throws Error if the rotated form is not valid: no accepted row has such a heading.
  const Pieces* pieces(std::size_t row, ScratchPieces<Pieces>& own) const override;

  /// In bytes, partly an estimate; it grows as rows are read.
  std::size_t memory() const;

 private:
  using Turned = std::atomic<const Pieces*>;

  /// A form and the heading by which it is rotated.
  struct Pose {
    const KindOfForm* form;
    double heading;

    friend bool operator==(const Pose&, const Pose&) = default;
  };
  struct PoseHash {
    std::size_t operator()(const Pose& pose) const {
      return std::hash<const KindOfForm*>()(pose.form) ^ by_golden_ratio * std::hash<double>()(pose.heading);
    }
  };

  /// From the cache, or made for this row.
  const Pieces* kept_or_made(std::size_t row, const Pose& pose, ScratchPieces<Pieces>& own) const;
  /// Caches the pieces; null if the budget does not allow it.
  const Pieces* keep(const Pose& pose, std::unique_ptr<const Pieces>& made) const;
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

using TurnedOutlines = TurnedForms<SharedOutline>;
using TurnedMeshes = TurnedForms<SharedMesh>;

/// The rotated forms of many rows, to be attached to bodies.
class RowForms {
 public:
  /// As TurnedForms::assign(). Requires: a layout whose shapes are stored separately.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    if (bodies.layout.shape == Shape::mesh)
      meshes_.assign(bodies, source, interrupt);
    else
      outlines_.assign(bodies, source, interrupt);
  }
  /// From now on contact reads the forms of these bodies here; this must outlive it.
  void attach_to(Bodies& bodies) const {
    if (bodies.layout.shape == Shape::mesh)
      bodies.meshes = &meshes_;
    else
      bodies.outlines = &outlines_;
  }
  std::size_t memory() const { return outlines_.memory() + meshes_.memory(); }

 private:
  TurnedOutlines outlines_;
  TurnedMeshes meshes_;
};

}  // namespace foresee
