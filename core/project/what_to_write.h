// Advice on the text that a project file should have in place of a value of another kind, as far as that can
// be seen.
#pragma once

#include "core/project/object_reader.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// Advice for a cell of a column in this unit: "write 1.5" for the text '1,5'.
Message cell_to_write(const Json& given, FieldKind kind, const Unit& unit);
/// Advice for a number field: "write {"value": 1.5, "unit": "mm"}" for the text '1,5 mm'.
Message number_to_write(const Json& given, const Unit& unit);

}  // namespace covaria
