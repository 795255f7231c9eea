#if __has_include(<boost/math/tools/quartic_roots.hpp>)
#include <boost/math/tools/quartic_roots.hpp>
#define FORESEE_HAS_BOOST_QUARTIC 1
#endif

#include "accuracy/methods.h"

namespace foresee::bench {

Method boost_quartic(const Family& family) {
#ifdef FORESEE_HAS_BOOST_QUARTIC
  if (family.balls())
    return one_by_one("boost-quartic", "", [&family](std::size_t i) -> Answer {
      const Quartic<double> f(Seen<double>(family, i));
      if (f.c[0] <= 0) return {true, 0};
      for (double root : boost::math::tools::quartic_roots(f.c[4], f.c[3], f.c[2], f.c[1], f.c[0]))
        if (root >= 0 && root <= family.horizon.h) return {true, root};
      return {};
    });
#endif
  (void)family;
  return {};
}

}  // namespace foresee::bench
