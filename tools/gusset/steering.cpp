#include "steering.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>

namespace {
// The one thing that a signal handler, the watching thread and the callback share.
std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch it");

extern "C" void interrupted(int) { stop = true; }

void on_interrupt(void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(SIGINT, &action, nullptr);
}
} // namespace

Steering::Steering(uint32_t threads, bool origins, bool bar_, std::optional<double> cancel_after)
    : bar(bar_), terminal(isatty(STDERR_FILENO) != 0) {
    callbacks.struct_size = sizeof callbacks;
    callbacks.user = this;
    callbacks.progress = progress;
    callbacks.log = log;
    callbacks.threads = threads;
    callbacks.origins = origins ? 1 : 0;
    stop = false;
    on_interrupt(interrupted, static_cast<int>(SA_RESETHAND));
    if (cancel_after) {
        watch = std::thread([this, wait = std::chrono::duration<double>(*cancel_after)] {
            std::unique_lock lock(guard);
            if (!over.wait_for(lock, wait, [this] { return finished; })) {
                requested = Clock::now();
                stop = true;
            }
        });
    }
}

Steering::~Steering() { finish(); }

void Steering::finish() {
    {
        const std::lock_guard lock(guard);
        finished = true;
    }
    over.notify_all();
    if (watch.joinable()) {
        watch.join();
    }
    on_interrupt(SIG_DFL, 0);
    if (terminal && !shown.empty()) {
        std::cerr << '\n';
        shown.clear();
    }
}

std::optional<double> Steering::since_request(Clock::time_point now) {
    const std::lock_guard lock(guard);
    if (!requested || *requested > now) {
        return std::nullopt;
    }
    return std::chrono::duration<double, std::milli>(now - *requested).count();
}

// What calls back is C: nothing may be thrown through it.
int32_t Steering::progress(void *user, double fraction, const char *stage) noexcept {
    try {
        auto &self = *static_cast<Steering *>(user);
        if (self.bar) {
            self.show(fraction, stage);
        }
    } catch (...) {
        // A bar is not worth a run.
    }
    return stop ? 1 : 0;
}

void Steering::log(void *user, const char *message) noexcept {
    try {
        // Not into the bar.
        const auto &self = *static_cast<Steering *>(user);
        std::cerr << (self.terminal && !self.shown.empty() ? "\n" : "") << message << '\n';
    } catch (...) {
        // Nor is a remark.
    }
}

void Steering::show(double fraction, const std::string &stage) {
    constexpr std::size_t width = 30;
    // Whatever a plugin says, NaN too.
    const double done = fraction > 0 ? std::min(fraction, 1.0) : 0.0;
    const auto part = [done](std::size_t whole) {
        return static_cast<std::size_t>(std::floor(done * static_cast<double>(whole)));
    };
    std::string line = '[' + std::string(part(width), '#') + std::string(width - part(width), '.') + "] " +
                       std::to_string(part(100)) + " % " + stage;
    // Callbacks come far more often than a terminal can show.
    if (line == shown) {
        return;
    }
    if (terminal) {
        std::cerr << '\r' << line << std::string(line.size() < shown.size() ? shown.size() - line.size() : 0, ' ')
                  << std::flush;
    } else {
        std::cerr << line << '\n';
    }
    shown = std::move(line);
}
