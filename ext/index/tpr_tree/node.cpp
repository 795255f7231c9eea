#include "index/tpr_tree/node.h"

namespace foresee {

template <int D>
Entry<D> summary(const Node& node, const LeafReader<D>& reader, double epoch) {
  Entry<D> all;
  for (std::size_t slot = 0; slot < node.size(); ++slot) {
    if (node.is_leaf()) {
      all.include(entry_of(Mover<D>(reader, reader.record(node, slot)), epoch));
    } else {
      all.include(entry_at<D>(node, slot, epoch));
    }
  }
  return all;
}

template Entry<1> summary(const Node&, const LeafReader<1>&, double);
template Entry<2> summary(const Node&, const LeafReader<2>&, double);
template Entry<3> summary(const Node&, const LeafReader<3>&, double);

}  // namespace foresee
