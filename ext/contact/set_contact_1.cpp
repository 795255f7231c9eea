// Contact over one axis: a file of its own, as it takes long to compile.
#include "contact/set_contact.h"

namespace foresee {

template class SetContact<1, 1>;
template class SetContact<1, 2>;

}  // namespace foresee
