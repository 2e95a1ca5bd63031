// What an axis of a study varies: found in the project, and changed in set-ups and input quantities.
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
    std::size_t asset = analysis;     ///< index in Project::assets
    std::size_t upstream = analysis;  ///< index in Project::analyses of another one that this one takes from
    std::string key = {};             ///< of the field; symbol of the quantity; id of the component
    std::size_t row = 0;
    std::size_t column = 0;  ///< of the table's schema; coordinate 0 ... 5 of a pose
    std::size_t index = 0;   ///< of the quantity or component
    bool whole = false;      ///< a whole number
    bool measured = false;   ///< read, observed or calibrated: nobody can choose it
    Unit unit = {};          ///< in which the project gives the number
    /// On whose scale the number is: `unit`, or that which another cell of its row or a field gives it; in
    /// degC no multiple is taken of it.
    Unit scale = {};
    TypesetMessage title = {};  ///< "Targets, B: x"
    double current = 0.0;       ///< in `unit`; of a column that of its first row with a number

    bool in_setup() const { return kind <= Kind::column; }
    bool is_of_analysis_itself() const { return asset == analysis && upstream == analysis; }
};

/// The set-up that a target varies, in a project whose analysis at `own` has the study.
Setup& varied_setup(const StudyTarget& target, std::size_t own, Project& project);
const Setup& varied_setup(const StudyTarget& target, std::size_t own, const Project& project);

/// The title of a target with what is done to it: "Targets, B: x, factor".
TypesetMessage changed_title(const StudyTarget& target, StudyChange change);

/// Error (path "/asset" or "/target") when there is no such number. `inputs`: of the analysis, edits applied;
/// null when they are not known.
Result<StudyTarget> find_study_target(const Project& project, const AnalysisEntry& analysis,
                                      const InputSet* inputs, const StudyAxis& axis);

/// What stands first in a row of a table: a name or a reference; else its number ("row 3").
Message row_words(const SetupTable& table, std::size_t row);

/// Writes the varied number(s) into `varied`, which is the set-up `base` otherwise. `value` in the axis'
/// unit.
void vary_setup(const StudyTarget& target, const StudyAxis& axis, double value, const Setup& base,
                Setup& varied);
void vary_inputs(const StudyTarget& target, const StudyAxis& axis, double value, InputSet& inputs);

/// Everything that can be varied: a name in the words of the schemas, and an axis with target, unit and a
/// range about the present value filled in.
struct StudyTargetChoice {
    StudyTarget target;
    StudyAxis axis;
};
std::vector<StudyTargetChoice> study_targets(const Project& project, const AnalysisEntry& analysis,
                                             const InputSet* inputs);

/// Problems of the studies of one analysis, paths relative to it ("/studies/0/axes/1/target"). `outputs` and
/// `inputs` are null when the model could not be made.
void check_studies(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                   const std::vector<OutputQuantity>* outputs, Problems& problems);
/// Of an axis, and of an output that is looked at.
void check_study_axis(const Project& project, const AnalysisEntry& analysis, const InputSet* inputs,
                      const StudyAxis& axis, const std::string& path, Problems& problems);
void check_study_output(const std::vector<OutputQuantity>* outputs, const StudyOutput& wanted,
                        const std::string& path, Problems& problems);

}  // namespace covaria
