// What everything in gusset.hpp stands on: errors, spans, the context, views of meshes. Include gusset.hpp, not this.
#ifndef GUSSET_BASE_HPP
#define GUSSET_BASE_HPP

#include <gusset.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gusset {

/// What went wrong. what() is a sentence.
class Error : public std::runtime_error {
public:
    /// A sentence for people, and the report for programs.
    Error(const char *sentence, const gusset_error_report &report) : std::runtime_error(sentence), report_(report) {}
    /// GUSSET_ERROR_...
    int32_t status() const noexcept { return report_.status; }
    /// Which element, and its value.
    const gusset_error_report &report() const noexcept { return report_; }

private:
    gusset_error_report report_;
};

/// A run of elements in somebody else's memory.
template <class T>
class Span {
public:
    /// No elements.
    Span() = default;
    /// `size` elements from `data` on.
    Span(T *data, std::size_t size) : data_(data), size_(size) {}
    /// From any container that keeps its elements side by side.
    template <class Container, class = std::enable_if_t<std::is_convertible_v<
                                   decltype(std::data(std::declval<Container &>())), T *>>>
    Span(Container &&container) : data_(std::data(container)), size_(std::size(container)) {}

    T *data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    bool empty() const noexcept { return size_ == 0; }
    T &operator[](std::size_t i) const { return data_[i]; }
    T *begin() const noexcept { return data_; }
    T *end() const noexcept { return data_ + size_; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/// Vertex, face or half-edge indices.
using Indices = Span<const uint32_t>;
/// x, y, z.
using Point3 = std::array<double, 3>;

namespace detail {
template <class T>
struct IsSpan : std::false_type {};
template <class T>
struct IsSpan<Span<T>> : std::true_type {};
template <class T>
inline constexpr bool is_span = IsSpan<std::remove_cv_t<T>>::value;
inline Indices indices(const gusset_indices &lent) { return {lent.data, lent.count}; }
inline void check(gusset_status status) {
    if (status != GUSSET_OK) {
        gusset_error_report report{};
        report.struct_size = sizeof report;
        report.status = status;
        throw Error(gusset_status_text(status), report);
    }
}
} // namespace detail

/// Threads, progress, log and cancel for the calls that it is given to.
class Context {
public:
    /// Receives the part done (0 to 1) and the name of the stage; returns false to cancel the call. May throw.
    using Progress = std::function<bool(double fraction, const char *stage)>;
    /// Receives remarks that are no failures. May throw.
    using Log = std::function<void(const char *message)>;

    Context() : host_(std::make_unique<Host>()) {
        gusset_context *created = nullptr;
        detail::check(gusset_context_create(&created));
        context_.reset(created);
    }

    /// 0: as many threads as the machine has; 1: the calling thread only. Results do not depend on it.
    void set_threads(uint32_t threads) {
        const InUse in_use(host_.get());
        detail::check(gusset_context_set_threads(get(), threads));
    }
    /// Like every other use of a context while it runs a call, refused with GUSSET_ERROR_CONTEXT_BUSY and without effect.
    void set_progress(Progress progress) {
        const InUse in_use(host_.get());
        host_->progress = std::move(progress);
        install();
    }
    /// Sets the function that remarks go to, or none if empty; it may throw.
    void set_log(Log log) {
        const InUse in_use(host_.get());
        host_->log = std::move(log);
        install();
    }

    /// Cancels the running call and all later ones until reset(). From any thread.
    void cancel() const noexcept { gusset_context_cancel(get()); }
    void reset() const noexcept { gusset_context_reset(get()); }
    /// How much of the running call is done, 0 to 1. From any thread.
    double progress() const noexcept { return gusset_context_get_progress(get()); }

    gusset_context *get() const noexcept { return context_.get(); }

    /// Makes a call of the C interface, `function(gusset_context *)`, and throws what it has to say.
    template <class Function>
    void call(Function &&function) const {
        const InUse in_use(host_.get());
        host_->thrown = nullptr;
        const gusset_status status = function(get());
        if (host_->thrown) {
            std::rethrow_exception(std::exchange(host_->thrown, nullptr));
        }
        if (status == GUSSET_OK) {
            return;
        }
        gusset_error_report report{};
        report.struct_size = sizeof report;
        if (gusset_context_get_report(get(), &report) != GUSSET_OK) {
            detail::check(status);
        }
        throw Error(gusset_context_get_message(get()), report);
    }

private:
    struct Host {
        Progress progress;
        Log log;
        std::exception_ptr thrown;
        std::atomic_flag busy = ATOMIC_FLAG_INIT;
    };
    /// Holds the host's side of the context for one call; refuses a second one, on another thread or in a callback, and a
    /// context that was moved from.
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
    struct Destroy {
        void operator()(gusset_context *context) const noexcept { gusset_context_destroy(context); }
    };

    static int on_progress(void *user, double fraction, const char *stage) noexcept {
        Host &host = *static_cast<Host *>(user);
        if (host.thrown) {
            return 1;
        }
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
        // Progress is listened to for the log's sake too: that is how a log callback that throws stops the call.
        const bool listens = host_->progress || host_->log;
        detail::check(gusset_context_set_progress(get(), listens ? on_progress : nullptr, host_.get()));
        detail::check(gusset_context_set_log(get(), host_->log ? on_log : nullptr, host_.get()));
    }

    std::unique_ptr<Host> host_;
    std::unique_ptr<gusset_context, Destroy> context_;
};

/// A polygon mesh in memory: yours on the way in, a result's on the way out. It owns nothing.
class MeshView {
public:
    /// A view as the C interface has it.
    explicit MeshView(const gusset_mesh_view &view) : view_(view) {}

    /// Faces of `face_size` corners each. `points`: any container or array that keeps its elements side by side; their first
    /// bytes are three floats or doubles, p[0] to p[2]. The view borrows: points and indices must outlive it.
    template <class Points>
    static MeshView uniform(const Points &points, Indices corners, uint32_t face_size) {
        gusset_mesh_view view = with_points(std::data(points), std::size(points));
        view.face_corners = corners.data();
        view.face_count = face_size == 0 ? 0 : corners.size() / face_size;
        view.face_size = face_size;
        if (face_size != 0 && corners.size() % face_size != 0) {
            throw std::invalid_argument("gusset: the number of corners is no multiple of face_size");
        }
        return MeshView(view);
    }
    /// Triangles, three corners each.
    template <class Points>
    static MeshView triangles(const Points &points, Indices corners) {
        return uniform(points, corners, 3);
    }

    /// Face f has the corners offsets[f] to offsets[f + 1] - 1.
    template <class Points>
    static MeshView polygons(const Points &points, Indices offsets, Indices corners) {
        if (offsets.empty() || offsets[offsets.size() - 1] != corners.size()) {
            throw std::invalid_argument("gusset: the last offset is not the number of corners");
        }
        gusset_mesh_view view = with_points(std::data(points), std::size(points));
        view.face_offsets = offsets.data();
        view.face_corners = corners.data();
        view.face_count = offsets.size() - 1;
        return MeshView(view);
    }

    const gusset_mesh_view &get() const noexcept { return view_; }
    /// How many vertices.
    std::size_t vertex_count() const noexcept { return view_.vertex_count; }
    /// How many faces.
    std::size_t face_count() const noexcept { return view_.face_count; }

    /// Position `v` < vertex_count().
    std::array<double, 3> position(std::size_t v) const {
        const bool wide = view_.scalar == GUSSET_F64;
        const std::size_t stride = view_.position_stride != 0 ? view_.position_stride : (wide ? 24 : 12);
        const char *at = static_cast<const char *>(view_.positions) + v * stride;
        std::array<double, 3> wide_point;
        if (wide) {
            std::memcpy(wide_point.data(), at, 24);
            return wide_point;
        }
        std::array<float, 3> point;
        std::memcpy(point.data(), at, 12);
        return {point[0], point[1], point[2]};
    }

    /// The vertices of face `f` < face_count().
    Indices face(std::size_t f) const {
        const auto *corners = static_cast<const uint32_t *>(view_.face_corners);
        if (view_.face_offsets == nullptr) {
            return {corners + f * view_.face_size, view_.face_size};
        }
        const auto *offsets = static_cast<const uint32_t *>(view_.face_offsets);
        return {corners + offsets[f], offsets[f + 1] - offsets[f]};
    }

private:
    template <class Point>
    static gusset_mesh_view with_points(const Point *points, std::size_t count) {
        using Scalar = std::decay_t<decltype(std::declval<const Point &>()[0])>;
        static_assert(std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>, "points of float or double");
        static_assert(sizeof(Point) >= 3 * sizeof(Scalar), "three coordinates");
        gusset_mesh_view view{};
        view.struct_size = sizeof view;
        view.positions = points;
        view.position_stride = sizeof(Point);
        view.vertex_count = count;
        view.scalar = std::is_same_v<Scalar, float> ? GUSSET_F32 : GUSSET_F64;
        return view;
    }

    gusset_mesh_view view_;
};

/// Where new vertices lie; see the constants.
enum class Fairing : uint32_t { none = GUSSET_FAIRING_NONE, thin_plate = GUSSET_FAIRING_THIN_PLATE };

} // namespace gusset

#endif // GUSSET_BASE_HPP
