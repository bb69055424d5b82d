// Shared by the filters: one execution, with threads, progress, abort and errors.
#ifndef GUSSET_VTK_RUN_HPP
#define GUSSET_VTK_RUN_HPP

#include <gusset.hpp>

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>

#include <algorithm>
#include <string>

namespace gusset_vtk {

/// Thrown between calls of the library once AbortExecute is set.
struct Aborted {};

/// One execution of a filter. Nothing of it is shared with other filters, so that they may run on threads of their own.
class Run {
public:
    Run(vtkAlgorithm *filter, int threads) : filter_(filter) {
        context_.set_threads(static_cast<uint32_t>(std::max(threads, 0)));
        // The library calls back on the thread of the call alone, where observers of progress expect to be.
        context_.set_progress([this](double fraction, const char *) {
            report(fraction);
            return filter_->GetAbortExecute() == 0;
        });
        context_.set_log([this](const char *message) { vtkWarningWithObjectMacro(filter_, << where << message); });
    }
    Run(const Run &) = delete;
    Run &operator=(const Run &) = delete;

    const gusset::Context &context() const { return context_; }
    vtkAlgorithm *filter() const { return filter_; }

    /// The calls that follow are the part from `low` to `high`, 0 to 1, of the whole.
    void section(double low, double high) {
        low_ = low, high_ = high;
        report(0.0);
        if (filter_->GetAbortExecute() != 0) {
            throw Aborted();
        }
    }

    /// The part of the input that messages are about, or empty.
    std::string where;

private:
    void report(double fraction) {
        // Each call counts from 0 to 1: the whole must not go back.
        done_ = std::max(done_, low_ + (high_ - low_) * fraction);
        filter_->UpdateProgress(done_);
    }

    vtkAlgorithm *filter_;
    gusset::Context context_;
    double low_ = 0.0, high_ = 1.0, done_ = 0.0;
};

/// Runs work that may throw, and returns the result of RequestData. The output of work that failed, or was aborted,
/// is empty.
template <class Work>
int guarded(Run &run, vtkDataObject *output, Work &&work) {
    try {
        work();
        return 1;
    } catch (const Aborted &) {
        output->Initialize();
        return 1;
    } catch (const std::exception &error) {
        output->Initialize();
        const auto *ours = dynamic_cast<const gusset::Error *>(&error);
        if (ours != nullptr && ours->status() == GUSSET_ERROR_CANCELLED) {
            return 1;
        }
        vtkErrorWithObjectMacro(run.filter(), << run.where << error.what());
        return 0;
    }
}

} // namespace gusset_vtk

#endif // GUSSET_VTK_RUN_HPP
