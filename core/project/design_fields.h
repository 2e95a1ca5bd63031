// Designs as project files have them.
#pragma once

#include "core/project/design.h"
#include "core/project/json_fields.h"

namespace covaria {

const JsonFields<Design>& design_fields();
const JsonFields<DesignVariable>& variable_fields();
const JsonFields<DesignReduction>& reduction_fields();
/// The fields of a reduction's number.
const JsonFields<StudyAxis>& reduced_number_fields();
const JsonFields<DesignChoice>& choice_fields();
const JsonFields<DesignBox>& box_fields();

/// The figure that the search makes smallest, in words: "mean U/target"; relative to the present design where
/// no targets are given.
const char* objective_words(DesignObjective objective, bool targets);

}  // namespace covaria
