// The reference of a figure in % or ppm: a part of the value, or absolute.
#pragma once

#include <QString>
#include <vector>

#include "core/setup/setup_schema.h"

namespace covaria::ui {

/// `words` of a tooltip, below what a row of a table that states quantities says with such a figure: "5 % of
/// the value" or "5 % absolute, not a part of the value". `words` alone: it has none.
QString below_stated_part(const FieldSpec& table, const std::vector<SetupCell>& row, const QString& words);

}  // namespace covaria::ui
