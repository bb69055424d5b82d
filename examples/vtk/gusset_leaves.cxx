#include "gusset_leaves.hpp"

#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSet.h>
#include <vtkSmartPointer.h>

namespace gusset_vtk {

namespace {

std::string name_of(vtkDataObjectTree *tree, vtkDataObjectTreeIterator *at) {
    const unsigned index = at->GetCurrentFlatIndex();
    // In a partitioned data set, index 0 is the whole.
    const bool flat = vtkPartitionedDataSet::SafeDownCast(tree) != nullptr;
    std::string name = flat ? "partition " + std::to_string(index - 1) : "block " + std::to_string(index);
    if (at->HasCurrentMetaData() && at->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME())) {
        name += std::string(" (") + at->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) + ")";
    }
    return name;
}

/// Calls `each(data, name, iterator)` for each data set of a tree.
template <class Each>
void for_each_data_set(vtkDataObjectTree *tree, Each &&each) {
    const auto at = vtk::TakeSmartPointer(tree->NewTreeIterator());
    at->VisitOnlyLeavesOn();
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem()) {
        each(at->GetCurrentDataObject(), name_of(tree, at), at.Get());
    }
}

void warn_of(vtkDataObject *data, const std::string &name, const char *fate, const Run &run) {
    vtkWarningWithObjectMacro(run.filter(), << name << ", a " << data->GetClassName() << " and no vtkPolyData, " << fate);
}

} // namespace

std::vector<Leaf> leaves(vtkDataObject *input, const Run &run) {
    std::vector<Leaf> found;
    if (auto *whole = vtkPolyData::SafeDownCast(input)) {
        found.push_back({whole, {}});
    } else if (auto *tree = vtkDataObjectTree::SafeDownCast(input)) {
        for_each_data_set(tree, [&](vtkDataObject *data, const std::string &name, vtkDataObjectTreeIterator *) {
            if (auto *leaf = vtkPolyData::SafeDownCast(data)) {
                found.push_back({leaf, name});
            } else {
                warn_of(data, name, "is left out", run);
            }
        });
    }
    return found;
}

void each_leaf(vtkDataObject *input, vtkDataObject *output, Run &run,
               const std::function<void(vtkPolyData *from, vtkPolyData *to)> &work) {
    const auto one = [&](vtkPolyData *from, vtkPolyData *to) {
        if (from->GetNumberOfPolys() + from->GetNumberOfStrips() == 0) {
            to->ShallowCopy(from);
        } else {
            to->GetFieldData()->PassData(from->GetFieldData());
            work(from, to);
        }
    };
    if (auto *whole = vtkPolyData::SafeDownCast(input)) {
        run.section(0.0, 1.0);
        one(whole, vtkPolyData::SafeDownCast(output));
        return;
    }
    auto *tree = vtkDataObjectTree::SafeDownCast(input);
    auto *made = vtkDataObjectTree::SafeDownCast(output);
    if (tree == nullptr || made == nullptr) {
        throw std::invalid_argument("the input is neither a vtkPolyData nor a tree of such");
    }
    made->CopyStructure(tree);
    double count = 0.0;
    for_each_data_set(tree, [&](vtkDataObject *, const std::string &, vtkDataObjectTreeIterator *) { count += 1.0; });
    double done = 0.0;
    for_each_data_set(tree, [&](vtkDataObject *data, const std::string &name, vtkDataObjectTreeIterator *at) {
        run.section(done / count, (done + 1.0) / count);
        done += 1.0;
        const auto to = vtk::TakeSmartPointer(data->NewInstance());
        if (auto *from = vtkPolyData::SafeDownCast(data)) {
            run.where = name + ": ";
            one(from, vtkPolyData::SafeDownCast(to));
        } else {
            warn_of(data, name, "passes as it is", run);
            to->ShallowCopy(data);
        }
        made->SetDataSet(at, to);
    });
    run.where.clear();
}

} // namespace gusset_vtk
