// Statements of metrologists about a quantity (certificate, limits, resolution, MPE ...), turned
// into a component of uncertainty (JCGM 100 4.3, JCGM 101 6.4).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/unit.h"
#include "core/quantity/distribution.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// A statement with its figures, SI (intervals).
struct Statement {
    std::string kind;  ///< key of `statement_kinds()`
    std::optional<double> a = {}, b = {};
    std::optional<double> degrees_of_freedom = {};
    std::optional<double> relative_uncertainty_of_u = {};  ///< du/u: nu = (du/u)^-2 / 2 (JCGM 100 G.3)
    std::optional<double> estimate = {};                   ///< estimate of the quantity
    Unit unit = {};  ///< unit of the quantity: in degC there is no part of its estimate
};

struct StatementKind {
    std::string_view key;
    std::string_view title;
    std::string_view a;  ///< meaning of the figure a; empty: not used
    std::string_view b;
    bool a_has_unit = true;
    bool b_has_unit = true;
    bool b_optional = false;
    bool a_optional = false;
};
/// All kinds of statements about figures; those about observations are not among them.
const std::vector<StatementKind>& statement_kinds();
const StatementKind* find_statement(std::string_view key);

/// Whether a figure is a part of the estimate: stated in % or ppm of a quantity that has a unit. For a ratio
/// it is absolute, as every figure in a unit of the quantity's own dimension.
bool is_part_of_estimate(const Unit& stated, const Unit& of_quantity);

/// A figure of a statement in SI: of limits a value on the scale, else an interval. A part of the estimate is
/// one of `estimate` (SI). Errors: a unit of another dimension, a part of an estimate that is not there.
Result<double> figure_in_si(double figure, const Unit& stated, const Unit& of_quantity, bool on_scale,
                            std::optional<double> estimate);

struct StatedComponent {
    Distribution distribution;  ///< distribution of the deviation from the estimate: its mean is zero
    double degrees_of_freedom = infinity;
    EvaluationType type = EvaluationType::type_b;
    std::optional<double> estimate = {};  ///< what the statement itself gives (limits, counts, events)
    std::string words = {};               ///< "certificate, U with k": where the figure comes from
};

/// Errors: a figure that is missing, superfluous or out of range; the message names the figure.
Result<StatedComponent> stated_component(const Statement& statement);

}  // namespace covaria
