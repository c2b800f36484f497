#define BIOPRINT_KERNEL_TABLE(real) avx2_kernels_##real
#include "lattice/d3q19_kernel_body.hpp"
