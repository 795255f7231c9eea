#include "query/tile/tile.h"

namespace foresee {
namespace {

/// Whether the tile owns a pair.
class IsOwned {
 public:
  explicit IsOwned(std::shared_ptr<const Ownership> ownership)
      : ownership_(std::move(ownership)),
        a_(ownership_->a.data()),
        b_(ownership_->b.empty() ? a_ : ownership_->b.data()) {}

  bool operator()(const Pair& pair) const { return (a_[pair.a] | b_[pair.b]) == Tile::owned; }

 private:
  std::shared_ptr<const Ownership> ownership_;
  const TileMarks *a_, *b_;
};

class OwnedParts final : public DividedCandidates {
 public:
  OwnedParts(std::unique_ptr<DividedCandidates> all, std::shared_ptr<const Ownership> ownership)
      : all_(std::move(all)), ownership_(std::move(ownership)) {}

  std::size_t parts() const override { return all_->parts(); }
  std::unique_ptr<Candidates> part(std::size_t i, Interrupt& interrupt) override {
    return owned_candidates(all_->part(i, interrupt), ownership_);
  }

 private:
  std::unique_ptr<DividedCandidates> all_;
  std::shared_ptr<const Ownership> ownership_;
};

}  // namespace

std::unique_ptr<Candidates> owned_candidates(std::unique_ptr<Candidates> all,
                                             std::shared_ptr<const Ownership> ownership) {
  return std::make_unique<FilteredCandidates<IsOwned>>(std::move(all), IsOwned(std::move(ownership)));
}

std::unique_ptr<DividedCandidates> owned_candidates(std::unique_ptr<DividedCandidates> all,
                                                    std::shared_ptr<const Ownership> ownership) {
  return std::make_unique<OwnedParts>(std::move(all), std::move(ownership));
}

}  // namespace foresee
