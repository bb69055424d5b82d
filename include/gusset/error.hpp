/// @file
/// The exception of the library and of its wrapper. Include gusset.hpp, not this.
#ifndef GUSSET_ERROR_HPP
#define GUSSET_ERROR_HPP

#include <gusset.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace gusset {

/// The failure of a call, or a mistake that the wrapper finds before it. what() is a sentence.
class Error : public std::runtime_error {
public:
    /// A sentence for people, and the report for programs.
    Error(const std::string &sentence, const gusset_error_report &report) : std::runtime_error(sentence), report_(report) {}
    /// GUSSET_ERROR_...
    int32_t status() const noexcept { return report_.status; }
    /// The element that the error is about, and its value.
    const gusset_error_report &report() const noexcept { return report_; }

private:
    gusset_error_report report_;
};

namespace detail {
/// Throws an Error for a mistake that the wrapper finds.
[[noreturn]] inline void refuse(gusset_status status, const std::string &sentence, std::uint64_t index = 0,
                                gusset_element element = GUSSET_ELEMENT_NONE, double value = 0) {
    gusset_error_report report{};
    report.struct_size = sizeof report;
    report.status = status;
    report.element = element;
    report.index = index;
    report.value = value;
    throw Error(sentence, report);
}
/// Throws an Error unless `index` is less than `count`. `name`: what there are `count` of.
inline void require_element(std::size_t index, std::size_t count, const char *name) {
    if (index >= count) {
        refuse(GUSSET_ERROR_NO_SUCH_ELEMENT,
               std::string(name) + ' ' + std::to_string(index) + " does not exist (there are " + std::to_string(count) + ')', index);
    }
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_ERROR_HPP
