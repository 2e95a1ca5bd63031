// Studies as project files have them.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/study.h"

namespace covaria {

const JsonFields<Study>& study_fields();
const JsonFields<StudyAxis>& axis_fields();
/// The fields of an axis that say which number it varies: asset, target, change, ends and unit.
const JsonFields<StudyAxis>& varied_number_fields();
const JsonFields<StudyOutput>& study_output_fields();

}  // namespace covaria
