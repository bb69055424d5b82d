// The clocks of `make check-cancel`.
#ifndef CANCEL_INSTANT_HPP
#define CANCEL_INSTANT_HPP

#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
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

/// Memory of this program in bytes.
inline double held() {
    double pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Time in which the system reclaims this many bytes: the least of several measurements with one block. Nobody
/// who frees memory can be faster.
inline Milliseconds to_take_back(double bytes) {
    constexpr std::size_t block = std::size_t{1} << 28;
    static const Milliseconds of_block = [] {
        Milliseconds least{1e9};
        for (int k = 0; k < 5; ++k) {
            auto *start = static_cast<volatile char *>(
                mmap(nullptr, block, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
            if (start == MAP_FAILED) {
                return Milliseconds{0};
            }
            for (std::size_t at = 0; at < block; at += 4096) {
                start[at] = 1;
            }
            const Instant before = Instant::now();
            munmap(const_cast<char *>(start), block);
            least = std::min(least, between(before, Instant::now()));
        }
        return least;
    }();
    return of_block * (std::max(bytes, 0.0) / static_cast<double>(block));
}

/// The longest time between two progress calls, minus the time to reclaim memory, with the stages before and after.
struct Silence {
    Instant start, last;
    Milliseconds longest{0};
    std::string stage = "start", after, before;
    /// The part of the work that was done before it.
    double done = 0, fraction = 0;

    void begin() {
        to_take_back(0);
        start = last = looked = Instant::now();
        memory = held();
    }

    void heard(const char *next, double reached = 1) {
        const Instant now = Instant::now();
        Milliseconds time = between(last, now);
        // A look takes longer than most calls.
        if (time > longest || now.wall - looked.wall > Milliseconds{5}) {
            const double left = held();
            time -= to_take_back(memory - left);
            memory = left;
            looked = now;
        }
        if (time > longest) {
            longest = time;
            after = stage;
            before = next;
            done = fraction;
        }
        fraction = reached;
        last = Instant::now();
        stage = next;
    }

private:
    /// At the last look.
    Instant looked;
    double memory = 0;
};

} // namespace cancel

#endif // CANCEL_INSTANT_HPP
