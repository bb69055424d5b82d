// A run as its user follows and steers it: a bar of progress, Ctrl-C, and a cancel after a while.
#pragma once

#include <gusset_plugin.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

/// Until it is finished Ctrl-C cancels the run, and a second one ends the program. There may be one at a time.
class Steering {
public:
    using Clock = std::chrono::steady_clock;

    /// bar: progress goes to the standard error. cancel_after: seconds from now.
    Steering(uint32_t threads, bool origins, bool bar, std::optional<double> cancel_after);
    ~Steering();
    Steering(const Steering &) = delete;
    Steering &operator=(const Steering &) = delete;

    /// For the run.
    const gusset_host *host() const { return &callbacks; }
    /// The run is over: ends the bar, and Ctrl-C means what it did before.
    void finish();
    /// From the request of cancel_after to `now` in milliseconds, if it came before that.
    std::optional<double> since_request(Clock::time_point now);

private:
    static int32_t progress(void *user, double fraction, const char *stage) noexcept;
    static void log(void *user, const char *message) noexcept;
    void show(double fraction, const std::string &stage);

    gusset_host callbacks{};
    const bool bar;
    const bool terminal;
    std::string shown;

    std::mutex guard;
    std::condition_variable over;
    bool finished = false;
    std::optional<Clock::time_point> requested;
    std::thread watch;
};
