#include "lattice/huge_buffer.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace bioprint {

HugeBuffer::HugeBuffer(std::size_t bytes) : data_(nullptr) {
    constexpr std::size_t page = std::size_t{2} << 20U;
    const std::size_t rounded = (bytes + page) / page * page;
    data_ = std::aligned_alloc(page, rounded);
    if (data_ == nullptr) {
        throw std::bad_alloc();
    }
#ifdef __linux__
    // A refusal only costs speed.
    (void)madvise(data_, rounded, MADV_HUGEPAGE);
#endif
    std::memset(data_, 0, rounded);
}

HugeBuffer::~HugeBuffer() {
    std::free(data_);
}

}  // namespace bioprint
