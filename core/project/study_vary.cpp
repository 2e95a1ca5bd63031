// The changes that a study makes: values of an axis, set-ups and input quantities with one of them.
#include <cmath>

#include "core/project/kind_lookup.h"
#include "core/project/study_target.h"
#include "core/propagation/reverse_budget.h"

namespace covaria {

namespace {

// The number that the axis makes of one given in `unit`.
double varied_number(const StudyAxis& axis, double value, double base, const Unit& unit) {
    switch (axis.change) {
        case StudyChange::factor:
            return base * value;
        case StudyChange::added:
            return base + unit.interval_from_si(axis.unit.interval_to_si(value));
        case StudyChange::value:
            break;
    }
    return unit == axis.unit ? value : unit.from_si(axis.unit.to_si(value));
}

void vary_cell(const StudyTarget& target, const StudyAxis& axis, double value, SetupCell& cell) {
    const double* base = std::get_if<double>(&cell);
    if (!base && axis.change != StudyChange::value) return;
    double number = varied_number(axis, value, base ? *base : 0.0, target.unit);
    if (target.whole) number = std::round(number);
    cell = number;
}

void vary_table(const StudyTarget& target, const StudyAxis& axis, double value, const Setup& base,
                Setup& varied) {
    const auto& from = std::get<SetupTable>(base.values.at(target.key));
    auto& to = std::get<SetupTable>(varied.values.at(target.key));
    const bool all = target.kind == StudyTarget::Kind::column;
    for (std::size_t row = all ? 0 : target.row; row < (all ? from.rows.size() : target.row + 1); ++row) {
        auto& cells = to.rows[row];
        if (cells.size() <= target.column) cells.resize(target.column + 1);
        cells[target.column] =
            target.column < from.rows[row].size() ? from.rows[row][target.column] : SetupCell{};
        vary_cell(target, axis, value, cells[target.column]);
    }
}

}  // namespace

std::vector<double> axis_values(const StudyAxis& axis, bool whole_numbers) {
    std::vector<double> values;
    for (std::size_t i = 0; i < axis.values; ++i) {
        const double t =
            axis.values > 1 ? static_cast<double>(i) / static_cast<double>(axis.values - 1) : 0.0;
        double value = axis.spacing == StudySpacing::logarithmic
                           ? axis.from * std::pow(axis.to / axis.from, t)
                           : axis.from + t * (axis.to - axis.from);
        if (i + 1 == axis.values && axis.values > 1) value = axis.to;
        values.push_back(whole_numbers && axis.change == StudyChange::value ? std::round(value) : value);
    }
    return values;
}

void vary_setup(const StudyTarget& target, const StudyAxis& axis, double value, const Setup& base,
                Setup& varied) {
    if (target.kind == StudyTarget::Kind::cell || target.kind == StudyTarget::Kind::column)
        return vary_table(target, axis, value, base, varied);
    if (target.kind == StudyTarget::Kind::pose) {
        auto& pose = std::get<PoseValue>(varied.values.at(target.key));
        double& number = target.column < 3 ? pose.position[target.column] : pose.angles[target.column - 3];
        number = varied_number(axis, value, target.current, target.unit);
        return;
    }
    if (axis.change == StudyChange::value) {
        varied.values[target.key] = Quantity{value, axis.unit};
        return;
    }
    const double number = varied_number(axis, value, target.current, target.unit);
    varied.values[target.key] = Quantity{target.whole ? std::round(number) : number, target.unit};
}

void vary_inputs(const StudyTarget& target, const StudyAxis& axis, double value, InputSet& inputs) {
    if (target.kind == StudyTarget::Kind::component) {
        scale_component(inputs, target.index, value);
        return;
    }
    InputQuantity& quantity = inputs.quantities[target.index];
    if (target.kind == StudyTarget::Kind::components) {
        for (Share& share : quantity.shares) scale_share(inputs, quantity, share, value);
        return;
    }
    const double before = estimate_of(inputs, target.index);
    const double after =
        target.unit.to_si(varied_number(axis, value, target.unit.from_si(before), target.unit));
    quantity.offset += after - before;
}

}  // namespace covaria
