// States of a project with some numbers changed, one after the other, by one thread.
#pragma once

#include <span>
#include <vector>

#include "core/made/made_project.h"
#include "core/project/study_target.h"

namespace covaria::detail {

/// Numbers to be changed, and the state that they are changed in; outlives those who change them.
struct ChangedNumbers {
    MadeProject::Pointer made;  ///< the analysis is the first of its project
    std::shared_ptr<const PreparedAnalysis> analysis;
    std::vector<StudyAxis> axes;
    std::vector<StudyTarget> targets;  ///< per axis

    bool reach_setup() const;  ///< false: the model stays and only its inputs change
};

/// A model with its inputs changed; the analysis keeps it alive.
struct ChangedModel {
    std::shared_ptr<const PreparedAnalysis> analysis;
    InputSet inputs;
    const MeasurementModel& model() const { return *analysis->model; }
};

/// Makes of each state what its changes reach, and takes the rest over from the unchanged project.
class ChangedProject {
public:
    explicit ChangedProject(const ChangedNumbers& numbers);

    /// Sets one value for each axis, in its unit.
    void set(std::span<const double> values);
    /// The state as it is now, for further changes; `set` begins from the unchanged values of its targets
    /// only.
    Project& project() { return project_; }
    /// Error: why there is no model here.
    Result<ChangedModel> make() const;
    /// After other changes of the project too, which needs only these of its assets (rising indices).
    Result<ChangedModel> make_with(const std::vector<std::size_t>& assets) const;

private:
    Result<ChangedModel> of_state(Project state) const;
    Result<ChangedModel> of_analysis(std::shared_ptr<const PreparedAnalysis> analysis) const;
    Result<InputSet> varied(InputSet inputs) const;

    const ChangedNumbers& numbers_;
    Project project_;
    std::vector<double> values_;
};

inline constexpr std::size_t no_output = static_cast<std::size_t>(-1);
/// Index of an output in a model, or no_output: mostly where it was in the unchanged one.
std::size_t find_output(const std::vector<OutputQuantity>& outputs, const StudyOutput& wanted,
                        std::size_t guess);
std::vector<double> estimates_of(const InputSet& inputs);

}  // namespace covaria::detail
