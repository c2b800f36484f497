#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

/// Work on the items of a chunk by several threads; results stay in their order.
namespace bioprint {

/// Calls `work(i)` for i from 0 to count − 1 on up to `jobs` threads; the first exception is thrown again
/// here.
template <class Work>
void for_each_index(std::size_t count, unsigned jobs, const Work& work) {
    // Items a thread takes at a time: of many, far above the cost of taking them; of few, which may be long, one.
    const std::size_t batch = std::clamp<std::size_t>(count / (8 * std::max<std::size_t>(jobs, 1)), 1, 16);
    const auto threads = static_cast<unsigned>(std::min<std::size_t>(jobs, (count + batch - 1) / batch));
    if (threads <= 1) {
        for (std::size_t i = 0; i < count; ++i) work(i);
        return;
    }
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_lock;
    const auto run = [&] {
        try {
            for (std::size_t begin = next.fetch_add(batch); begin < count; begin = next.fetch_add(batch)) {
                for (std::size_t i = begin; i < std::min(count, begin + batch); ++i) work(i);
            }
        } catch (...) {
            const std::lock_guard lock(failure_lock);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> pool;
    try {
        for (unsigned t = 1; t < threads; ++t) pool.emplace_back(run);
    } catch (const std::system_error&) {
        // The system grants no more threads: those that run do the work.
    }
    run();
    for (std::thread& thread : pool) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace bioprint
