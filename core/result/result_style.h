// Style in which the results of a project are stated: units and digits. No number depends on it.
#pragma once

#include <optional>

#include "core/model/output_quantity.h"
#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"

namespace covaria {

/// A unit of that dimension was chosen.
bool has_unit(const DisplayUnits& units, const Dimension& dimension);
bool same_units(const DisplayUnits& a, const DisplayUnits& b);
/// `units`, and those that are preferred of other dimensions.
DisplayUnits with_preferred(const DisplayUnits& units, const DisplayUnits& preferred);

struct ResultStyle {
    DisplayUnits units = {};         ///< units of outputs by dimension; others as the model gives them
    std::optional<int> digits = {};  ///< significant ones of uncertainties; empty: two
    bool operator==(const ResultStyle& other) const {
        return same_units(units, other.units) && digits == other.digits;
    }
};

/// Gives an output the unit of the style.
void take_style(OutputQuantity& output, const ResultStyle& style);
/// Takes the style for the outputs of a result, whose numbers stay.
void take_style(UncertaintyResult& result, const ResultStyle& style);

}  // namespace covaria
