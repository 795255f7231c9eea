// The kernel for AVX2: four doubles at a time. Compiled with -mavx2; called where the CPU has it.
#include "contact/box_ends_kernel.h"

#if defined(__x86_64__)
FORESEE_BOX_KERNELS(box_kernel_avx2)
#endif
