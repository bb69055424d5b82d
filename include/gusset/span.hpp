/// @file
/// Runs of elements in memory that belongs to someone else. Include gusset.hpp, not this.
#ifndef GUSSET_SPAN_HPP
#define GUSSET_SPAN_HPP

#include <gusset/choices.hpp>
#include <gusset/error.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace gusset {

/// A run of elements in memory that belongs to someone else. The pointer of an empty span is null.
template <class T>
class Span {
public:
    /// No elements.
    Span() = default;
    /// `size` elements from `data` on.
    Span(T *data, std::size_t size) : data_(size != 0 ? data : nullptr), size_(size) {}
    /// From any container that keeps its elements side by side.
    template <class Container, class = std::enable_if_t<std::is_convertible_v<
                                   decltype(std::data(std::declval<Container &>())), T *>>>
    Span(Container &&container) : Span(std::data(container), std::size(container)) {}

    /// The first element.
    T *data() const noexcept { return data_; }
    /// The number of elements.
    std::size_t size() const noexcept { return size_; }
    /// True if the range is empty.
    bool empty() const noexcept { return size_ == 0; }
    /// As in the standard library.
    T &operator[](std::size_t i) const { return data_[i]; }
    /// The first element.
    T *begin() const noexcept { return data_; }
    /// The end of the range.
    T *end() const noexcept { return data_ + size_; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/// A run of C structures, each read as a Wrapper that is made of it, by value. Elements outlive the
/// run; its iterators live as long as the memory.
template <class Wrapper, class Data>
class Values {
public:
    /// The type of the elements.
    using value_type = Wrapper;
    /// The type of iterators.
    class iterator {
        struct Arrow {
            Wrapper value;
            const Wrapper *operator->() const noexcept { return &value; }
        };

    public:
        /// As the standard library requires of iterators.
        using iterator_category = std::input_iterator_tag;
        /// The type of the elements.
        using value_type = Wrapper;
        /// As the standard library requires of iterators.
        using difference_type = std::ptrdiff_t;
        /// As the standard library requires of iterators.
        using pointer = Arrow;
        /// As the standard library requires of iterators.
        using reference = Wrapper;
        /// No place.
        iterator() = default;
        /// The place of a structure.
        explicit iterator(const Data *at) : at_(at) {}
        /// As in the standard library.
        Wrapper operator*() const { return Wrapper(*at_); }
        /// As in the standard library.
        Arrow operator->() const { return {Wrapper(*at_)}; }
        /// As in the standard library.
        iterator &operator++() {
            ++at_;
            return *this;
        }
        /// As in the standard library.
        iterator operator++(int) {
            iterator old = *this;
            ++at_;
            return old;
        }
        /// As in the standard library.
        friend bool operator==(const iterator &a, const iterator &b) { return a.at_ == b.at_; }
        /// As in the standard library.
        friend bool operator!=(const iterator &a, const iterator &b) { return a.at_ != b.at_; }

    private:
        const Data *at_ = nullptr;
    };

    /// No elements.
    Values() = default;
    /// `size` elements from `data` on.
    Values(const Data *data, std::size_t size) : data_(data, size) {}

    /// The structures themselves.
    const Data *data() const noexcept { return data_.data(); }
    /// The number of elements.
    std::size_t size() const noexcept { return data_.size(); }
    /// True if the range is empty.
    bool empty() const noexcept { return data_.empty(); }
    /// Element `i` < size().
    Wrapper operator[](std::size_t i) const { return Wrapper(data_[i]); }
    /// The first element.
    iterator begin() const { return iterator(data_.begin()); }
    /// The end of the range.
    iterator end() const { return iterator(data_.end()); }

private:
    Span<const Data> data_;
};

/// Vertex, face or half-edge indices in memory that belongs to someone else. Any container of 32-bit integers that keeps
/// its elements side by side becomes one without a copy: std::vector<uint32_t>, std::vector<int>, std::span, a C array.
class Indices : public Span<const uint32_t> {
public:
    using Span::Span;
    /// Signed indices. Throws an Error for the first negative one.
    template <class Container, std::enable_if_t<std::is_convertible_v<decltype(std::data(std::declval<Container &>())),
                                                                      const int32_t *>, int> = 0>
    Indices(Container &&container)
        : Span(reinterpret_cast<const uint32_t *>(std::data(container)), std::size(container)) {
        require_signs(GUSSET_ELEMENT_NONE, "index");
    }

protected:
    /// Throws an Error if an index is negative as a signed number. `name`: the element that has the index.
    void require_signs(gusset_element element, const char *name) const {
        for (std::size_t k = 0; k < size(); ++k) {
            const auto value = static_cast<int32_t>((*this)[k]);
            if (value < 0) {
                detail::refuse(GUSSET_ERROR_INDEX_OUT_OF_RANGE,
                               std::string(name) + ' ' + std::to_string(k) + " is negative: " + std::to_string(value), k, element, value);
            }
        }
    }
};
/// x, y, z.
using Point3 = std::array<double, 3>;
/// Points side by side.
using Points = Span<const Point3>;

namespace detail {
template <class T>
struct IsSpan : std::false_type {};
template <class T>
struct IsSpan<Span<T>> : std::true_type {};
template <class T>
inline constexpr bool is_span = IsSpan<std::remove_cv_t<T>>::value;

/// The type of a row's elements; void if it has none.
template <class Row, class = void>
struct ElementOf {
    using Type = void;
};
template <class Row>
struct ElementOf<Row, std::void_t<decltype(std::declval<const Row &>()[0])>> {
    using Type = std::decay_t<decltype(std::declval<const Row &>()[0])>;
};
template <class T>
inline constexpr std::size_t size_of = sizeof(T);
template <>
inline constexpr std::size_t size_of<void> = 0;
/// Whether a row has its elements in itself, unlike a std::vector.
template <class Row>
inline constexpr bool holds_elements = std::is_trivially_destructible_v<Row> && !is_span<Row> && !std::is_pointer_v<Row>;

/// The type of the elements of a container; void if it does not keep them side by side.
template <class Container, class = void>
struct ValueOf {
    using Type = void;
};
template <class Container>
struct ValueOf<Container, std::void_t<decltype(std::data(std::declval<const Container &>()))>> {
    using Type = std::remove_cv_t<std::remove_reference_t<decltype(*std::data(std::declval<const Container &>()))>>;
};
/// Whether a container is a matrix of Eigen's.
template <class Container, class = void>
struct IsMatrix : std::false_type {};
template <class Container>
struct IsMatrix<Container, std::void_t<decltype(Container::RowsAtCompileTime)>> : std::true_type {};
/// The elements of a container that a view can borrow.
template <class Container>
struct Elements {
    using Type = typename ValueOf<Container>::Type;
    static_assert(!IsMatrix<Container>::value, "matrices of Eigen: include gusset/eigen.hpp and use gusset::eigen::Input");
    static_assert(IsMatrix<Container>::value || !std::is_void_v<Type>,
                  "a view borrows a container whose elements are side by side, such as std::vector, std::array, std::span or a C array");
};

/// The type of the coordinates of a host's point. They must be its first bytes, which excludes points that own
/// memory, such as std::vector<double>.
template <class Point>
struct PointTraits {
    using Scalar = typename ElementOf<Point>::Type;
    static_assert(std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>,
                  "points of float or double, each with an operator[], such as std::array<double, 3>");
    static_assert(holds_elements<Point>, "points that hold their coordinates, such as std::array<double, 3>, unlike std::vector");
};
/// The same for points in space.
template <class Point>
struct PointTraits3 : PointTraits<Point> {
    static_assert(sizeof(Point) >= 3 * size_of<typename PointTraits<Point>::Scalar>, "three coordinates in each point");
};

/// Elements of a list of indices: 32-bit integers, or rows of them.
template <class Element>
struct IndexTraits {
    using Number = std::conditional_t<std::is_arithmetic_v<Element>, Element, typename ElementOf<Element>::Type>;
    static_assert(std::is_integral_v<Number> && size_of<Number> == 4,
                  "indices are 32-bit integers, such as uint32_t or int: copy others into a std::vector<uint32_t>");
    static_assert(holds_elements<Element>, "rows that hold their indices, such as std::array<int, 3>: copy a std::vector of std::vector "
                                           "into offsets and corners for MeshView::polygons");
    /// The number of indices in an element.
    static constexpr std::size_t count = sizeof(Element) / 4;
};

/// Whether an argument is a container that is gone with the expression.
template <class Argument>
inline constexpr bool is_temporary =
    !std::is_lvalue_reference_v<Argument> && !std::is_trivially_destructible_v<std::remove_reference_t<Argument>>;

/// A C structure that says how large it is, and whose other fields are 0.
template <class T>
T sized() {
    T made{};
    made.struct_size = sizeof made;
    return made;
}

/// The first element; NULL if there is none.
template <class T>
const T *first(const std::vector<T> &list) {
    return list.empty() ? nullptr : list.data();
}

inline Indices indices(const gusset_indices &lent) { return {lent.data, lent.count}; }
/// The pairs of faces that a view has, if they were looked for.
template <class View> std::optional<Indices> intersections(const View &view) {
    if (view.intersections_known == 0) {
        return std::nullopt;
    }
    return indices(view.intersections);
}
inline Points points(const double *data, std::size_t count) {
    static_assert(sizeof(Point3) == 3 * sizeof(double), "packed");
    return {reinterpret_cast<const Point3 *>(data), count};
}
inline const double *numbers(const Point3 *points) { return reinterpret_cast<const double *>(points); }
inline double *numbers(Point3 *points) { return reinterpret_cast<double *>(points); }

/// A stride of numbers in bytes; one that is too large stays too large.
template <class T>
std::size_t stride_in_bytes(std::size_t stride) {
    return stride > std::numeric_limits<std::size_t>::max() / sizeof(T) ? std::numeric_limits<std::size_t>::max()
                                                                        : stride * sizeof(T);
}

/// Elements of a range by their number, for ranges whose operator[] makes its elements.
template <class Range>
class Iterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = typename Range::value_type;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = value_type;
    Iterator() = default;
    Iterator(const Range *range, std::size_t i) : range_(range), i_(i) {}
    value_type operator*() const { return (*range_)[i_]; }
    Iterator &operator++() {
        ++i_;
        return *this;
    }
    Iterator operator++(int) {
        Iterator old = *this;
        ++i_;
        return old;
    }
    friend bool operator==(const Iterator &a, const Iterator &b) { return a.i_ == b.i_; }
    friend bool operator!=(const Iterator &a, const Iterator &b) { return a.i_ != b.i_; }

private:
    const Range *range_ = nullptr;
    std::size_t i_ = 0;
};
} // namespace detail

} // namespace gusset

#endif // GUSSET_SPAN_HPP
