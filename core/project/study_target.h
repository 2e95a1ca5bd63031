// The number that an axis of a study varies: found in the project, and changed in set-ups and input
// quantities.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/model/output_quantity.h"
#include "core/project/project.h"
#include "core/quantity/input_quantity.h"
#include "core/text/typeset_message.h"

namespace covaria {

struct StudyTarget {
    enum class Kind { field, pose, cell, column, estimate, components, component };
    static constexpr std::size_t analysis = std::numeric_limits<std::size_t>::max();

    Kind kind = Kind::field;
    std::size_t asset = analysis;     ///< index of the asset in Project::assets
    std::size_t upstream = analysis;  ///< index in Project::analyses of another one that this one takes from
    std::string key = {};             ///< key of the field, symbol of the quantity, or id of the component
    std::size_t row = 0;
    std::size_t column = 0;  ///< column of the table's schema, or coordinate 0 ... 5 of a pose
    std::size_t index = 0;   ///< index of the quantity or component
    bool whole = false;      ///< whether it is a whole number
    bool measured = false;   ///< whether it was read, observed or calibrated, so that nobody can choose it
    Unit unit = {};          ///< unit in which the project gives the number
    /// The unit on whose scale the number is: `unit`, or the one which another cell of its row or a field
    /// gives it; no multiple is taken of a number in degC.
    Unit scale = {};
    TypesetMessage title = {};  ///< title of the target: "Targets, B: x"
    double current = 0.0;       ///< present value in `unit`; of a column, its first number

    bool in_setup() const { return kind <= Kind::column; }
    bool is_of_analysis_itself() const { return asset == analysis && upstream == analysis; }
};

/// The set-up that a target varies, in a project whose analysis at `own` has the study.
Setup& varied_setup(const StudyTarget& target, std::size_t own, Project& project);
const Setup& varied_setup(const StudyTarget& target, std::size_t own, const Project& project);

/// The title of a target with what is done to it: "Targets, B: x, factor".
TypesetMessage changed_title(const StudyTarget& target, StudyChange change);

/// The number that an axis varies. Error (path "/asset" or "/target") when there is no such number. `inputs`
/// are those of the analysis, edits applied; null when they are not known.
Result<StudyTarget> find_study_target(const Project& project, const AnalysisEntry& analysis,
                                      const InputSet* inputs, const StudyAxis& axis);

/// The words for a row of a table: the name or reference that stands first in it, else its number ("row 3").
Message row_words(const SetupTable& table, std::size_t row);

/// Writes the varied number(s) into `varied`, which is the set-up `base` otherwise. `value` is in the axis'
/// unit.
void vary_setup(const StudyTarget& target, const StudyAxis& axis, double value, const Setup& base,
                Setup& varied);
void vary_inputs(const StudyTarget& target, const StudyAxis& axis, double value, InputSet& inputs);

/// A number that can be varied: a name in the words of the schemas, and an axis with target, unit and a range
/// about the present value filled in.
struct StudyTargetChoice {
    StudyTarget target;
    StudyAxis axis;
};
std::vector<StudyTargetChoice> study_targets(const Project& project, const AnalysisEntry& analysis,
                                             const InputSet* inputs);

/// Reports problems of the studies of one analysis, with paths relative to it ("/studies/0/axes/1/target").
/// `outputs` and `inputs` are null when the model could not be made.
void check_studies(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems);
/// Reports problems of an axis, and of an output that is looked at.
void check_study_axis(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                      const StudyAxis& axis, const std::string& path, Problems& problems);
void check_study_output(const std::vector<OutputQuantity>* outputs, const StudyOutput& wanted,
                        const std::string& path, Problems& problems);

}  // namespace covaria
