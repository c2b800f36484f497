#pragma once

#include <sys/resource.h>

namespace bioprint::bench {

/// What this process has taken of the processor so far [s]: what others do on the machine does not count.
inline double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

}  // namespace bioprint::bench
