#include "core/study/changed_project.h"

#include <algorithm>

namespace covaria::detail {

bool ChangedNumbers::reach_setup() const {
    return std::any_of(targets.begin(), targets.end(), [](const auto& target) { return target.in_setup(); });
}

ChangedProject::ChangedProject(const ChangedNumbers& numbers)
    : numbers_(numbers), project_(numbers.made->project()) {}

// The axes of one table or asset begin from the unchanged set-up, cell by cell.
void ChangedProject::set(std::span<const double> values) {
    values_.assign(values.begin(), values.end());
    for (std::size_t axis = 0; axis < values_.size(); ++axis) {
        const StudyTarget& target = numbers_.targets[axis];
        if (!target.in_setup()) continue;
        vary_setup(target, numbers_.axes[axis], values_[axis],
                   varied_setup(target, 0, numbers_.made->project()), varied_setup(target, 0, project_));
    }
}

Result<ChangedModel> ChangedProject::make() const {
    return numbers_.reach_setup() ? of_state(project_) : of_analysis(numbers_.analysis);
}

Result<ChangedModel> ChangedProject::make_with(const std::vector<std::size_t>& assets) const {
    Project state;
    state.directory = project_.directory;
    state.analyses = project_.analyses;
    for (const std::size_t asset : assets) state.assets.push_back(project_.assets[asset]);
    return of_state(std::move(state));
}

Result<ChangedModel> ChangedProject::of_state(Project state) const {
    const auto made = MadeProject::make(std::move(state), numbers_.made);
    auto analysis = made->analysis(project_.analyses.front().id);
    if (!analysis)
        return fail(ErrorCode::numeric, first_error(made->problems(), tell<"the model cannot be made">()));
    return of_analysis(std::move(analysis));
}

Result<ChangedModel> ChangedProject::of_analysis(std::shared_ptr<const PreparedAnalysis> analysis) const {
    auto inputs = varied(analysis->inputs);
    if (!inputs) return fail(inputs.error());
    return ChangedModel{std::move(analysis), *std::move(inputs)};
}

Result<InputSet> ChangedProject::varied(InputSet inputs) const {
    for (std::size_t axis = 0; axis < values_.size(); ++axis) {
        StudyTarget target = numbers_.targets[axis];
        if (target.in_setup()) continue;
        if (target.kind == StudyTarget::Kind::component) {
            const auto found = std::find_if(inputs.components.begin(), inputs.components.end(),
                                            [&](const auto& c) { return c.id == target.key; });
            target.index = static_cast<std::size_t>(found - inputs.components.begin());
            if (found == inputs.components.end())
                return fail(ErrorCode::numeric, tell<"there is no component '%1' here">(target.key));
        } else if ((target.index = inputs.find(target.key)) == InputSet::npos) {
            return fail(ErrorCode::numeric, tell<"there is no input quantity '%1' here">(target.key));
        }
        vary_inputs(target, numbers_.axes[axis], values_[axis], inputs);
    }
    return inputs;
}

std::size_t find_output(const std::vector<OutputQuantity>& outputs, const StudyOutput& wanted,
                        std::size_t guess) {
    const auto fits = [&](const OutputQuantity& output) {
        return output.symbol == wanted.symbol && output.group == wanted.group;
    };
    if (guess < outputs.size() && fits(outputs[guess])) return guess;
    const auto found = std::find_if(outputs.begin(), outputs.end(), fits);
    return found == outputs.end() ? no_output : static_cast<std::size_t>(found - outputs.begin());
}

std::vector<double> estimates_of(const InputSet& inputs) {
    std::vector<double> x;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    return x;
}

}  // namespace covaria::detail
