// The clocks of `make check-cancel`.
#ifndef CANCEL_INSTANT_HPP
#define CANCEL_INSTANT_HPP

#include <time.h>

#include <algorithm>
#include <chrono>

namespace cancel {

using Milliseconds = std::chrono::duration<double, std::milli>;

/// By the clock on the wall, and by the time that all threads of this program have worked.
struct Instant {
    Milliseconds wall, work;

    static Instant now() { return {read(CLOCK_MONOTONIC), read(CLOCK_PROCESS_CPUTIME_ID)}; }

private:
    static Milliseconds read(clockid_t clock) {
        timespec time{};
        clock_gettime(clock, &time);
        return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    }
};

/// Other programs at work lengthen the one, threads of our own the other. A machine of our own, on which neither is so,
/// would need no more than the lesser.
inline Milliseconds between(const Instant &from, const Instant &to) {
    return std::min(to.wall - from.wall, to.work - from.work);
}

} // namespace cancel

#endif // CANCEL_INSTANT_HPP
