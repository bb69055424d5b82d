// The clocks of `make check-cancel`.
#ifndef CANCEL_INSTANT_HPP
#define CANCEL_INSTANT_HPP

#include <time.h>

#include <algorithm>
#include <chrono>
#include <string>

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

/// The longest time between two progress calls, and the stages round it.
struct Silence {
    Instant start, last;
    Milliseconds longest{0};
    std::string stage = "start", after, before;
    /// The part of the work that was done before it.
    double done = 0, fraction = 0;

    void begin() { start = last = Instant::now(); }

    void heard(const char *next, double reached = 1) {
        const Instant now = Instant::now();
        if (between(last, now) > longest) {
            longest = between(last, now);
            after = stage;
            before = next;
            done = fraction;
        }
        fraction = reached;
        last = now;
        stage = next;
    }
};

} // namespace cancel

#endif // CANCEL_INSTANT_HPP
