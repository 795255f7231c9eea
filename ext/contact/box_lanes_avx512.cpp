// The kernel for AVX-512: eight lanes at a time. Compiled with -mavx512f; called where the CPU has it.
#include "contact/box_ends_kernel.h"

#if defined(__x86_64__)
FORESEE_BOX_KERNELS(box_kernel_avx512)
#endif
