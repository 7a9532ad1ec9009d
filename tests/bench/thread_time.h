// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <time.h>

namespace ew::test {

/// Processor time of this thread [ms]: what other programs on the machine take does not count.
inline double threadTimeMs() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

}  // namespace ew::test
