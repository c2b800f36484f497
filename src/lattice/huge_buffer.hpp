#pragma once

#include <cstddef>

namespace bioprint {

/// Zeroed memory aligned to 2 MiB, in huge pages where the system grants them: the lattice walks 38 streams
/// at once, more than the first-level translation buffers hold in small pages.
class HugeBuffer {
  public:
    explicit HugeBuffer(std::size_t bytes);
    ~HugeBuffer();
    HugeBuffer(const HugeBuffer&) = delete;
    HugeBuffer& operator=(const HugeBuffer&) = delete;
    [[nodiscard]] void* data() const { return data_; }

  private:
    void* data_;
};

}  // namespace bioprint
