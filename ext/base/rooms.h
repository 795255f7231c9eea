// Whose names does a room know without saying whose? Those of the rooms to its right.
//
//   sqlite -> query -> index -> contact -> shape -> motion -> numbers -> base,     storage -> index,
//   sqlite -> geography -> base
//
//   namespace foresee::contact {
//   double rounded_square_root(const Dyadic& square);        // numbers::Dyadic
//   }
//
// The namespace of a file is its room. A name to the left is not found, and to spell it with its room would
// take an #include or a declaration that the guard of the rooms refuses. What storage may use of the index is
// told by the includes alone.
//
// Directives, which are bad manners elsewhere, open here our own namespaces to each other: in the order of
// the includes, at this one place, never std, Eigen or Boost. No two rooms define a type of one name in
// their headers (a test), so that numbers:: and motion:: before every other word would tell nothing.
//
// To know: a function hides those of its name to the right, unless an argument's type leads there;
// base::shown(x) says which is meant. And looking up by arguments follows no directives: a template called on
// a Dyadic finds the functions of numbers and those declared before it, not what is included later.
#pragma once

namespace foresee {

namespace base {}
namespace geography {
using namespace base;
}
namespace numbers {
using namespace base;
}
namespace motion {
using namespace numbers;
}
namespace shape {
using namespace motion;
}
namespace contact {
using namespace shape;
}
namespace index {
using namespace contact;
}
namespace query {
using namespace index;
}
namespace storage {
using namespace index;
}
namespace sqlite {
using namespace query;
using namespace storage;
using namespace geography;
}  // namespace sqlite

}  // namespace foresee
