// The changes that an analysis makes to its model's inputs, as project files have them: links, edits,
// correlations.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/project.h"

namespace covaria {

const JsonFields<InputLink>& link_fields();
const JsonFields<OutputReference>& output_reference_fields();
const JsonFields<InputEdit>& input_edit_fields();
const JsonFields<ComponentEdit>& component_fields();
const JsonFields<CorrelationEdit>& correlation_fields();
const JsonFields<QuantityNotes>& quantity_notes_fields();

}  // namespace covaria
