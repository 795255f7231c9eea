// Our table and a rival's, loaded with the objects of a feed.
#pragma once

#include "files.h"
#include "reports/table.h"

namespace foresee::bench {

struct TwoTables {
  TwoTables(const Feed& feed, Medium medium, Table::Kind rival_kind)
      : scene(feed.objects().name),
        ours(Table::foresee, feed.objects(), medium, files.ours),
        rival(rival_kind, feed.objects(), medium, files.theirs) {
    const Writes all = writes_of(feed.objects());
    ours.insert_all(all);
    rival.insert_all(all);
  }

  /// Throws Error unless both hold the same rows.
  void require_same_rows() {
    if (!same_rows(ours, rival)) throw Error(scene + ": the two tables hold other rows");
  }

  const std::string scene;
  const TwoFiles files;
  Table ours, rival;
};

}  // namespace foresee::bench
