# The 3-D lattice. Its row kernels are compiled once for each instruction set and chosen at run time, so that one
# build is fast on AVX2 and AVX-512 machines and correct on any.
find_package(OpenMP REQUIRED)
target_sources(bioprint_lattice PRIVATE
  d3q19.cpp
  d3q19_boundaries.cpp
  d3q19_kernel.cpp
  d3q19_kernel_baseline.cpp
  d3q19_state.cpp
  d3q19_window.cpp
  huge_buffer.cpp
  section.cpp)
target_link_libraries(bioprint_lattice PRIVATE OpenMP::OpenMP_CXX)
set_property(GLOBAL APPEND PROPERTY BIOPRINT_LINKED_PACKAGES OpenMP)

set(kernel_flags -fopenmp-simd -ffp-contract=fast -fno-math-errno -fno-trapping-math)
set_source_files_properties(d3q19_kernel_baseline.cpp PROPERTIES COMPILE_OPTIONS "${kernel_flags}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  target_sources(bioprint_lattice PRIVATE
    d3q19_kernel_avx2.cpp
    d3q19_kernel_avx512.cpp)
  set_source_files_properties(d3q19_kernel_avx2.cpp PROPERTIES
    COMPILE_OPTIONS "${kernel_flags};-mavx2;-mfma")
  set_source_files_properties(d3q19_kernel_avx512.cpp PROPERTIES
    COMPILE_OPTIONS "${kernel_flags};-mavx512f;-mavx512vl;-mavx512dq;-mavx512bw;-mfma;-mprefer-vector-width=512")
  set_source_files_properties(d3q19_kernel.cpp PROPERTIES COMPILE_DEFINITIONS BIOPRINT_X86_KERNELS)
endif()
