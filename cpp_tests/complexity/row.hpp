// Rows of the table of complexity: an input of each size, and the call that is measured on it.
#ifndef COMPLEXITY_ROW_HPP
#define COMPLEXITY_ROW_HPP

#include <gusset.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace complexity {

/// The call on an input that is made beforehand. The returned object is kept until it is measured.
using Call = std::function<std::shared_ptr<void>(const gusset::Context &)>;

/// One line of the table. The header states the exponents; a factor log n counts as no more of an exponent.
struct Row {
    /// The function of the header, without its prefix, and the family of inputs.
    const char *function, *family;
    /// The least size, of three: n, 2 n, 4 n.
    std::size_t size;
    /// The size at which `make check-cancel` listens for how long the call is silent.
    std::size_t large;
    /// Work and memory are O(n^work) and O(n^memory).
    double work, memory;
    /// Bytes at the peak for each unit of n that docs/guides/guarantees.md states, or 0.
    double bytes;
    std::function<Call(std::size_t)> prepare;
    /// It takes seconds: skipped unless the program is called with --all.
    bool slow = false;
    /// For how many milliseconds the call may be silent, as docs/guides/guarantees.md states.
    double silence = 100;
};

/// A call that makes a handle, which is kept.
template <class Function>
Call making(Function function) {
    return [function](const gusset::Context &context) -> std::shared_ptr<void> {
        return std::make_shared<decltype(function(context))>(function(context));
    };
}

std::vector<Row> mesh_rows();
std::vector<Row> curve_rows();
std::vector<Row> net_rows();
std::vector<Row> surface_rows();
/// Peak memory of operations without a known hostile input.
std::vector<Row> operation_rows();

} // namespace complexity

#endif // COMPLEXITY_ROW_HPP
