// Contact over two axes: a file of its own, as it takes long to compile.
#include "contact/set_contact.h"

namespace foresee {

template class SetContact<2, 1>;
template class SetContact<2, 2>;

}  // namespace foresee
