#include "index/tpr_tree/node.h"

namespace foresee {

template <int D>
Entry<D> summary(const Node& node, const LeafReader<D>& reader, double epoch) {
  Entry<D> all;
  if (!node.is_leaf()) {
    for (std::size_t slot = 0; slot < node.size(); ++slot) all.include(entry_at<D>(node, slot, epoch));
  } else if (reader.is_plain()) {
    for (std::size_t slot = 0; slot < node.size(); ++slot)
      all.include(entry_of(Mover<D>::plain(reader, reader.record(node, slot)), epoch));
  } else {
    for (std::size_t slot = 0; slot < node.size(); ++slot)
      all.include(entry_of(Mover<D>(reader, reader.record(node, slot)), epoch));
  }
  return all;
}

template Entry<1> summary(const Node&, const LeafReader<1>&, double);
template Entry<2> summary(const Node&, const LeafReader<2>&, double);
template Entry<3> summary(const Node&, const LeafReader<3>&, double);

}  // namespace foresee
