// A project with a design in it.
#include <algorithm>
#include <cmath>

#include "core/design/design.h"
#include "core/project/component_edit.h"
#include "core/project/kind_lookup.h"
#include "core/study/varied_part.h"

namespace covaria {

namespace {

class TakeOver {
public:
    TakeOver(Project project, const PreparedDesign& design, const DesignResult& result)
        : project_(std::move(project)), design_(design), result_(result) {}

    Result<Project> take() {
        for (std::size_t i = 0; i < result_.values.size(); ++i)
            if (auto taken = take_value(i); !taken) return fail(taken.error());
        if (design_.table) take_rows();
        return std::move(project_);
    }

private:
    AnalysisEntry& entry() {
        return *std::find_if(project_.analyses.begin(), project_.analyses.end(),
                             [&](const AnalysisEntry& one) { return one.id == result_.analysis; });
    }

    Result<void> take_value(std::size_t i) {
        const StudyAxis& axis = design_.numbers.axes[i];
        const InputSet& inputs = design_.numbers.analysis->inputs;
        const auto target = find_study_target(project_, entry(), &inputs, axis);
        if (!target) return fail(target.error());
        const double value = result_.values[i].chosen;
        if (!target->in_setup()) return take_input(*target, axis, value);
        AnalysisEntry& analysis = entry();
        const auto own = static_cast<std::size_t>(&analysis - project_.analyses.data());
        Setup& setup = varied_setup(*target, own, project_);
        give_default(schema_of(*target, own, project_), target->key, setup);
        if (auto* table = std::get_if<SetupTable>(&setup.values.at(target->key))) embed(*table);
        const Setup base = setup;
        vary_setup(*target, axis, value, base, setup);
        return {};
    }

    /// Rows that were read from a file are the project's own from now on.
    static void embed(SetupTable& table) {
        table.csv_file.clear();
        table.csv_columns.clear();
    }

    InputEdit& edit_of(const std::string& symbol) {
        auto& edits = entry().inputs;
        const auto found = std::find_if(edits.begin(), edits.end(),
                                        [&](const InputEdit& edit) { return edit.symbol == symbol; });
        if (found != edits.end()) return *found;
        edits.push_back({.symbol = symbol});
        return edits.back();
    }

    Result<void> take_input(const StudyTarget& target, const StudyAxis& axis, double value) {
        InputSet inputs = design_.numbers.analysis->inputs;
        if (target.kind == StudyTarget::Kind::component) return take_component(target, value);
        if (target.kind == StudyTarget::Kind::components)
            return take_components(target.key, value, InputSet::npos);
        vary_inputs(target, axis, value, inputs);
        edit_of(target.key).estimate =
            axis.change == StudyChange::value
                ? Quantity{value, axis.unit}
                : Quantity{target.unit.from_si(estimate_of(inputs, target.index)), target.unit};
        return {};
    }

    Result<void> take_component(const StudyTarget& target, double factor) {
        for (const InputQuantity& quantity : design_.numbers.analysis->inputs.quantities)
            for (const Share& share : quantity.shares)
                if (share.component == target.index)
                    return take_components(quantity.symbol, factor, target.index);
        return {};
    }

    /// Scales the components of one quantity, all or the one of that index, as an edit of that quantity.
    Result<void> take_components(const std::string& symbol, double factor, std::size_t only) {
        const InputSet& inputs = design_.numbers.analysis->inputs;
        const InputQuantity& quantity = inputs.quantities[inputs.find(symbol)];
        std::vector<ComponentEdit> edits;
        for (const Share& share : quantity.shares) {
            const UncertaintyComponent& component = inputs.components[share.component];
            if (share.factor != 1.0 || !quantity.analysis.empty() || uses_of(share.component) != 1)
                return fail(ErrorCode::bad_input,
                            tell<"the component '%1' is not of one input quantity alone: change it where it "
                                 "comes from (%2)">(component.id, component.origin.empty()
                                                                      ? tell<"the set-up">()
                                                                      : Message(component.origin)));
            edits.push_back(to_edit(component));
            if (only != InputSet::npos && only != share.component) continue;
            const auto stated = distribution_of(edits.back());
            if (!stated) return fail(stated.error());
            const double mean = stated->mean();  // stays
            set_distribution(edits.back(), stated->scaled(factor).shifted(mean * (1.0 - factor)));
        }
        edit_of(symbol).components = std::move(edits);
        return {};
    }

    std::size_t uses_of(std::size_t component) const {
        std::size_t uses = 0;
        for (const InputQuantity& quantity : design_.numbers.analysis->inputs.quantities)
            for (const Share& share : quantity.shares) uses += share.component == component;
        return uses;
    }

    void take_rows() {
        const DesignTable& table = *design_.table;
        const std::string& asset = design_.design.choose->asset;
        Setup& setup =
            asset.empty()
                ? entry().setup
                : std::find_if(project_.assets.begin(), project_.assets.end(), [&](const AssetEntry& one) {
                      return one.id == asset;
                  })->setup;
        SetupTable all = table.rows;
        if (const auto found = setup.values.find(table.key); found != setup.values.end())
            if (const auto* now = std::get_if<SetupTable>(&found->second))  // which has the values taken over
                std::copy(now->rows.begin(), now->rows.end(), all.rows.begin());
        SetupTable kept = all;
        kept.rows.clear();
        for (const DesignRow& row : result_.rows) kept.rows.push_back(all.rows[row.row]);
        setup.values[table.key] = std::move(kept);
    }

    Project project_;
    const PreparedDesign& design_;
    const DesignResult& result_;
};

}  // namespace

Result<Project> take_over(const Project& project, const PreparedDesign& design, const DesignResult& result) {
    return TakeOver(project, design, result).take();
}

}  // namespace covaria
