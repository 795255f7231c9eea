#include "index/paper_grid/paper_candidates.h"

#include "index/paper_grid/paper_grid.h"
#include "index/paper_grid/paper_stages.h"

namespace foresee {
namespace {

template <int D>
class PaperCandidates final : public Candidates {
 public:
  PaperCandidates(const Bodies& a, const Bodies& b, bool between, const Horizon& horizon,
                  const Vec<D>& margin, Interrupt& interrupt)
      : grid_(make_paper_grid<D>(a, b, between, horizon, margin, interrupt)),
        stages_(make_paper_stages<D>(a, b, between, horizon, margin, interrupt)) {}

  bool next(std::vector<Pair>& out) override {
    batch_.clear();
    if (!grid_->next(batch_)) return false;
    stages_->prune(batch_);
    out.insert(out.end(), batch_.begin(), batch_.end());
    return true;
  }

 private:
  std::unique_ptr<PaperGrid<D>> grid_;
  std::unique_ptr<PaperStages> stages_;
  std::vector<Pair> batch_;
};

}  // namespace

template <int D>
std::unique_ptr<Candidates> make_paper_candidates(const Bodies& a, const Bodies& b, bool between,
                                                  const Horizon& horizon, const Vec<D>& margin,
                                                  Interrupt& interrupt) {
  return std::make_unique<PaperCandidates<D>>(a, b, between, horizon, margin, interrupt);
}

template std::unique_ptr<Candidates> make_paper_candidates(const Bodies&, const Bodies&, bool, const Horizon&,
                                                           const Vec<1>&, Interrupt&);
template std::unique_ptr<Candidates> make_paper_candidates(const Bodies&, const Bodies&, bool, const Horizon&,
                                                           const Vec<2>&, Interrupt&);
template std::unique_ptr<Candidates> make_paper_candidates(const Bodies&, const Bodies&, bool, const Horizon&,
                                                           const Vec<3>&, Interrupt&);

}  // namespace foresee
