/// @file
/// Handles, and the context of calls. Include gusset.hpp, not this.
#ifndef GUSSET_CONTEXT_HPP
#define GUSSET_CONTEXT_HPP

#include <gusset/span.hpp>

#include <atomic>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace gusset {

namespace detail {
/// The owner of a handle.
template <class T, void (*destroy)(T *)>
struct Destroyer {
    void operator()(T *handle) const noexcept { destroy(handle); }
};
template <class T, void (*destroy)(T *)>
using Handle = std::unique_ptr<T, Destroyer<T, destroy>>;

/// The type that the last parameter of a C function points to.
template <class... Parameters>
using Output = std::remove_pointer_t<std::tuple_element_t<sizeof...(Parameters) - 1, std::tuple<Parameters...>>>;
template <class T, class = void>
struct HasSize : std::false_type {};
template <class T>
struct HasSize<T, std::void_t<decltype(T::struct_size)>> : std::true_type {};
/// An output before the call: a sized structure, or 0.
template <class T>
T cleared() {
    if constexpr (HasSize<T>::value) {
        return sized<T>();
    } else {
        return T{};
    }
}

inline void check(gusset_status status) {
    if (status != GUSSET_OK) {
        auto report = sized<gusset_error_report>();
        report.status = status;
        throw Error(gusset_status_text(status), report);
    }
}

/// The one output of a function without a context: `function(arguments..., &output)`.
template <class... Parameters, class... Arguments>
Output<Parameters...> lent(gusset_status (*function)(Parameters...), Arguments... arguments) {
    auto output = cleared<Output<Parameters...>>();
    check(function(arguments..., &output));
    return output;
}

/// The output of a function that tells how much it would write: `function(out, capacity,
/// &written)`.
template <class T, class Function>
std::vector<T> filled(Function &&function) {
    std::size_t count = 0;
    function(static_cast<T *>(nullptr), std::size_t{0}, &count);
    std::vector<T> out(count);
    if (count != 0) {
        function(out.data(), count, &count);
    }
    return out;
}
} // namespace detail

/// The version of the library that is loaded; GUSSET_VERSION_STRING is the header's.
inline const char *version() noexcept { return gusset_version(); }
/// Its binary interface.
inline uint32_t abi() noexcept { return gusset_abi(); }

/// Threads, progress, log and cancel for the calls that it is given to.
class Context {
public:
    /// Receives the part done (0 to 1) and the name of the stage; returns false to cancel the call.
    /// May throw.
    using Progress = std::function<bool(double fraction, const char *stage)>;
    /// Receives remarks that are not failures. May throw.
    using Log = std::function<void(const char *message)>;

    /// See ::gusset_context_create.
    Context() : host_(std::make_unique<Host>()), context_(detail::lent(gusset_context_create)) {}

    /// 0: as many threads as the machine has; 1: the calling thread only. Results do not depend on
    /// it.
    void set_threads(uint32_t threads) {
        const InUse in_use(host_.get());
        detail::check(gusset_context_set_threads(get(), threads));
    }
    /// Sets the function that follows a call, or none if empty. While the context runs a call this
    /// is refused, as every other use of it is: GUSSET_ERROR_CONTEXT_BUSY, without effect.
    void set_progress(Progress progress) {
        const InUse in_use(host_.get());
        host_->progress = std::move(progress);
        install();
    }
    /// Sets the function that receives remarks, or none if empty.
    void set_log(Log log) {
        const InUse in_use(host_.get());
        host_->log = std::move(log);
        install();
    }

    /// Cancels the running call and all later ones until reset(). From any thread.
    void cancel() const noexcept { gusset_context_cancel(get()); }
    /// See ::gusset_context_reset.
    void reset() const noexcept { gusset_context_reset(get()); }
    /// The part of the running call that is done, 0 to 1. From any thread.
    double progress() const noexcept { return gusset_context_get_progress(get()); }

    /// The argument for the C interface, which this still owns.
    gusset_context *get() const noexcept { return context_.get(); }

    /// Makes a call of the C interface, `function(gusset_context *, arguments...)`; throws an Error
    /// if it fails, and whatever a callback has thrown.
    template <class Function, class... Arguments>
    void call(Function &&function, Arguments... arguments) const {
        const InUse in_use(host_.get());
        host_->thrown = nullptr;
        const gusset_status status = function(get(), arguments...);
        if (host_->thrown) {
            std::rethrow_exception(std::exchange(host_->thrown, nullptr));
        }
        if (status == GUSSET_OK) {
            return;
        }
        auto report = detail::sized<gusset_error_report>();
        if (gusset_context_get_report(get(), &report) != GUSSET_OK) {
            detail::check(status);
        }
        throw Error(gusset_context_get_message(get()), report);
    }
    /// Makes a call with one output: `function(gusset_context *, arguments..., &output)`. Returns
    /// the output: a report, a number, or a handle, which the caller owns. Not for arrays.
    template <class... Parameters, class... Arguments>
    detail::Output<Parameters...> result(gusset_status (*function)(Parameters...), Arguments... arguments) const {
        auto output = detail::cleared<detail::Output<Parameters...>>();
        call(function, arguments..., &output);
        return output;
    }

private:
    struct Host {
        Progress progress;
        Log log;
        std::exception_ptr thrown;
        std::atomic_flag busy = ATOMIC_FLAG_INIT;
    };
    /// Holds the host's side of the context for one call; refuses a second one, on another thread
    /// or in a callback, and a context that was moved from.
    class InUse {
    public:
        explicit InUse(Host *host) : host_(host) {
            if (host_ == nullptr) {
                detail::check(GUSSET_ERROR_NULL_ARGUMENT);
            }
            if (host_->busy.test_and_set()) {
                detail::check(GUSSET_ERROR_CONTEXT_BUSY);
            }
        }
        ~InUse() { host_->busy.clear(); }
        InUse(const InUse &) = delete;
        InUse &operator=(const InUse &) = delete;

    private:
        Host *host_;
    };

    static int on_progress(void *user, double fraction, const char *stage) noexcept {
        Host &host = *static_cast<Host *>(user);
        if (host.thrown) { return 1; }
        try {
            return host.progress && !host.progress(fraction, stage);
        } catch (...) {
            host.thrown = std::current_exception();
            return 1;
        }
    }
    static void on_log(void *user, const char *message) noexcept {
        Host &host = *static_cast<Host *>(user);
        try {
            if (host.log && !host.thrown) {
                host.log(message);
            }
        } catch (...) {
            host.thrown = std::current_exception();
        }
    }
    void install() {
        // A log callback that throws stops the call through the progress callback.
        const bool listens = host_->progress || host_->log;
        detail::check(gusset_context_set_progress(get(), listens ? on_progress : nullptr, host_.get()));
        detail::check(gusset_context_set_log(get(), host_->log ? on_log : nullptr, host_.get()));
    }

    std::unique_ptr<Host> host_;
    detail::Handle<gusset_context, gusset_context_destroy> context_;
};

} // namespace gusset

#endif // GUSSET_CONTEXT_HPP
