#include "query/tile/ownership.h"

namespace foresee {
namespace {

class OwnedCandidates final : public Candidates {
 public:
  OwnedCandidates(std::unique_ptr<Candidates> all, std::shared_ptr<const Ownership> ownership)
      : all_(std::move(all)),
        ownership_(std::move(ownership)),
        a_(ownership_->a.data()),
        b_(ownership_->b.empty() ? a_ : ownership_->b.data()) {}

  /// Without a branch on ownership, which would be mispredicted.
  bool next(std::vector<Pair>& out) override {
    std::size_t kept = out.size();
    const std::size_t before = kept;
    if (!all_->next(out)) return false;
    for (std::size_t i = before; i < out.size(); ++i) {
      const Pair pair = out[i];
      out[kept] = pair;
      kept += (a_[pair.a] | b_[pair.b]) == Tile::owned;
    }
    out.resize(kept);
    return true;
  }

  bool touching() const override { return all_->touching(); }
  std::string describe() const override { return all_->describe(); }

 private:
  std::unique_ptr<Candidates> all_;
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
  return std::make_unique<OwnedCandidates>(std::move(all), std::move(ownership));
}

std::unique_ptr<DividedCandidates> owned_candidates(std::unique_ptr<DividedCandidates> all,
                                                    std::shared_ptr<const Ownership> ownership) {
  return std::make_unique<OwnedParts>(std::move(all), std::move(ownership));
}

}  // namespace foresee
