#include "gusset_arrays.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <numeric>

namespace gusset_vtk {

namespace {

using gusset::Domain;
using gusset::Rule;

/// The elements of one piece that have values: tuples `first` and on, or those that are listed.
struct Source {
    vtkDataSetAttributes *values;
    /// The number of tuples that an array must have. Arrays of broken data sets with other numbers do not belong to
    /// these elements.
    vtkIdType total;
    vtkIdType first;
    vtkIdType count;
    const std::vector<vtkIdType> *listed;

    vtkIdType tuple(vtkIdType element) const {
        return listed == nullptr || listed->empty() ? first + element : (*listed)[static_cast<std::size_t>(element)];
    }
};

/// The attributes that an array is: normals can be the scalars, too.
using Attributes = std::array<bool, vtkDataSetAttributes::NUM_ATTRIBUTES>;

Attributes attributes_of(vtkDataSetAttributes *values, vtkAbstractArray *array) {
    Attributes found{};
    for (std::size_t type = 0; type < found.size(); ++type) {
        found[type] = values->GetAbstractAttribute(static_cast<int>(type)) == array;
    }
    return found;
}

/// The array of a piece that matches an array of another piece: by name, or without a name by its first attribute.
vtkAbstractArray *same(const Source &source, vtkAbstractArray *array, const Attributes &attributes) {
    vtkAbstractArray *found = nullptr;
    const auto attribute = std::find(attributes.begin(), attributes.end(), true);
    if (array->GetName() != nullptr) {
        found = source.values->GetAbstractArray(array->GetName());
    } else if (attribute != attributes.end()) {
        found = source.values->GetAbstractAttribute(static_cast<int>(attribute - attributes.begin()));
    }
    const bool fits = found != nullptr && found->GetDataType() == array->GetDataType() &&
                      found->GetNumberOfComponents() == array->GetNumberOfComponents() && found->GetNumberOfTuples() == source.total;
    return fits ? found : nullptr;
}

/// How the values of several sources become one.
Rule rule_of(vtkAbstractArray *array, const Attributes &is) {
    const int type = array->GetDataType();
    const std::string name = array->GetName() != nullptr ? array->GetName() : "";
    const bool floats = type == VTK_FLOAT || type == VTK_DOUBLE;
    // Ghost flags are bits, and ids name things: neither has a mean.
    if (is[vtkDataSetAttributes::GLOBALIDS] || is[vtkDataSetAttributes::PEDIGREEIDS] ||
        name == vtkDataSetAttributes::GhostArrayName() || array->GetNumberOfComponents() > 4096) {
        return Rule::nearest;
    }
    if (floats && array->GetNumberOfComponents() == 3 && (is[vtkDataSetAttributes::NORMALS] || name == "Normals")) {
        return Rule::normal;
    }
    return floats || type == VTK_UNSIGNED_CHAR ? Rule::linear : Rule::nearest;
}

uint32_t value_type(int type) {
    return type == VTK_FLOAT ? GUSSET_VALUE_F32 : type == VTK_DOUBLE ? GUSSET_VALUE_F64 : GUSSET_VALUE_U8;
}

/// The arrays of one domain, carried from all pieces to a result.
class Carrier {
public:
    Carrier(const gusset::Origins &origins, Domain domain, std::vector<Source> sources, const Run &run)
        : origins_(origins), domain_(domain), sources_(std::move(sources)), run_(run) {}

    /// `copied`: the piece and the tuple of each tuple before the elements of the result.
    void carry(vtkDataSetAttributes *output, const std::vector<std::pair<std::size_t, vtkIdType>> &copied);

private:
    using Arrays = std::vector<vtkAbstractArray *>;

    void mix(vtkAbstractArray *made, vtkIdType first, Rule rule, const Arrays &arrays) const;
    void pick(vtkAbstractArray *made, vtkIdType first, const Arrays &arrays);

    const gusset::Origins &origins_;
    Domain domain_;
    std::vector<Source> sources_;
    const Run &run_;
    /// 1 and the number through all pieces of the source that counts most, or 0 for none; empty until it is asked for.
    std::vector<uint32_t> nearest_;
};

void Carrier::mix(vtkAbstractArray *made, vtkIdType first, Rule rule, const Arrays &arrays) const {
    auto channel = gusset::detail::sized<gusset_channel>();
    channel.domain = static_cast<uint32_t>(domain_);
    channel.value_type = value_type(made->GetDataType());
    channel.components = static_cast<uint32_t>(made->GetNumberOfComponents());
    channel.rule = static_cast<uint32_t>(rule);
    std::vector<gusset_channel_values> inputs;
    std::vector<vtkSmartPointer<vtkAbstractArray>> copies;
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const Source &source = sources_[i];
        vtkAbstractArray *array = arrays[i];
        vtkIdType from = source.first;
        if (source.count == 0) {
            inputs.push_back({nullptr, 0, 0});
            continue;
        }
        if (source.tuple(0) != from || (source.listed != nullptr && !source.listed->empty()) || !array->HasStandardMemoryLayout()) {
            copies.push_back(vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(array->GetDataType())));
            copies.back()->SetNumberOfComponents(array->GetNumberOfComponents());
            copies.back()->SetNumberOfTuples(source.count);
            for (vtkIdType k = 0; k < source.count; ++k) {
                copies.back()->SetTuple(k, source.tuple(k), array);
            }
            array = copies.back();
            from = 0;
        }
        const void *values = array->GetVoidPointer(from * array->GetNumberOfComponents());
        inputs.push_back({values, static_cast<std::size_t>(source.count), 0});
    }
    const std::size_t count = origins_.size(domain_);
    if (count > 0) {
        run_.context().call(gusset_attributes_apply, origins_.get(), &channel, inputs.data(), inputs.size(),
                            made->GetVoidPointer(first * made->GetNumberOfComponents()), count, std::size_t{0});
    }
}

void Carrier::pick(vtkAbstractArray *made, vtkIdType first, const Arrays &arrays) {
    const gusset::Indices starts = origins_.starts(domain_);
    const std::size_t count = origins_.size(domain_);
    if (nearest_.empty()) {
        std::vector<uint32_t> numbers(starts[starts.size() - 1]);
        std::iota(numbers.begin(), numbers.end(), 1U);
        std::vector<gusset::Span<const uint32_t>> inputs;
        for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
            inputs.emplace_back(numbers.data() + starts[i], starts[i + 1] - starts[i]);
        }
        nearest_ = origins_.apply<uint32_t>(domain_, Rule::nearest, inputs, run_.context());
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (nearest_[k] != 0) {
            const uint32_t number = nearest_[k] - 1;
            const auto i = static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), number) - starts.begin()) - 1;
            made->SetTuple(first + static_cast<vtkIdType>(k), sources_[i].tuple(number - starts[i]), arrays[i]);
        }
    }
}

void Carrier::carry(vtkDataSetAttributes *output, const std::vector<std::pair<std::size_t, vtkIdType>> &copied) {
    // Pieces without elements do not affect the choice of arrays.
    const auto has_elements = [](const Source &source) { return source.total > 0; };
    const auto base = std::find_if(sources_.begin(), sources_.end(), has_elements);
    if (base == sources_.end()) {
        return;
    }
    const auto first = static_cast<vtkIdType>(copied.size());
    for (int a = 0; a < base->values->GetNumberOfArrays(); ++a) {
        vtkAbstractArray *array = base->values->GetAbstractArray(a);
        const Attributes attributes = attributes_of(base->values, array);
        Attributes active = attributes;
        active[vtkDataSetAttributes::GLOBALIDS] = false;
        Arrays arrays;
        bool everywhere = true;
        for (const Source &source : sources_) {
            const bool own = &source == &*base && array->GetNumberOfTuples() == source.total;
            vtkAbstractArray *found = own ? array : same(source, array, attributes);
            arrays.push_back(found);
            if (has_elements(source)) {
                everywhere = everywhere && found != nullptr;
                const Attributes there = attributes_of(source.values, found);
                std::transform(active.begin(), active.end(), there.begin(), active.begin(), std::logical_and<bool>());
            }
        }
        const std::string name = array->GetName() != nullptr ? array->GetName() : "without a name";
        if (!everywhere) {
            vtkWarningWithObjectMacro(run_.filter(), << run_.where << "the array " << name << " is left behind: not all pieces have it for "
                                                     << "all elements, of one type and number of components");
            continue;
        }
        const auto made = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(array->GetDataType()));
        made->SetName(array->GetName());
        made->SetNumberOfComponents(array->GetNumberOfComponents());
        made->CopyComponentNames(array);
        if (array->HasInformation()) {
            made->CopyInformation(array->GetInformation()); // units, say
        }
        made->SetNumberOfTuples(first + static_cast<vtkIdType>(origins_.size(domain_)));
        if (auto *numbers = vtkDataArray::SafeDownCast(made)) {
            numbers->Fill(0.0);
            numbers->SetLookupTable(vtkDataArray::SafeDownCast(array)->GetLookupTable());
        }
        for (std::size_t k = 0; k < copied.size(); ++k) {
            made->SetTuple(static_cast<vtkIdType>(k), copied[k].second, arrays[copied[k].first]);
        }
        const Rule rule = rule_of(array, attributes);
        if (rule == Rule::nearest) {
            pick(made, first, arrays);
        } else {
            try {
                mix(made, first, rule, arrays);
            } catch (const gusset::Error &error) {
                if (error.status() != GUSSET_ERROR_NOT_FINITE) {
                    throw;
                }
                vtkWarningWithObjectMacro(run_.filter(), << run_.where << "the array " << name
                                                         << " is not mixed, but copied from the nearest: " << error.what());
                pick(made, first, arrays);
            }
        }
        const int index = output->AddArray(made);
        for (std::size_t type = 0; type < active.size(); ++type) {
            if (active[type]) {
                output->SetActiveAttribute(index, static_cast<int>(type));
            }
        }
    }
}

} // namespace

void carry_points(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run) {
    std::vector<Source> sources;
    for (const Piece &piece : pieces) {
        sources.push_back({piece.data()->GetPointData(), piece.data()->GetNumberOfPoints(), 0, piece.data()->GetNumberOfPoints(), nullptr});
    }
    Carrier(origins, Domain::vertices, std::move(sources), run).carry(output->GetPointData(), {});
}

void carry_cells(vtkPolyData *output, const gusset::Origins &origins, const std::vector<Piece> &pieces, const Run &run) {
    std::vector<Source> sources;
    for (const Piece &piece : pieces) {
        sources.push_back({piece.data()->GetCellData(), piece.data()->GetNumberOfCells(), piece.loose_count(),
                           static_cast<vtkIdType>(piece.face_count()), &piece.cells()});
    }
    // VTK numbers the vertices of all pieces first, then the lines.
    std::vector<std::pair<std::size_t, vtkIdType>> copied;
    for (const bool lines : {false, true}) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const vtkIdType vertices = pieces[i].data()->GetNumberOfVerts();
            const vtkIdType end = lines ? pieces[i].loose_count() : vertices;
            for (vtkIdType cell = lines ? vertices : 0; cell < end; ++cell) {
                copied.emplace_back(i, cell);
            }
        }
    }
    Carrier(origins, Domain::faces, std::move(sources), run).carry(output->GetCellData(), copied);
}

} // namespace gusset_vtk
