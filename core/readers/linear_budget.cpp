#include "core/readers/linear_budget.h"

#include <algorithm>
#include <cmath>

#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr double rounding_of_contributions = 0.02;  // figures have two digits

/// Units that a coefficient may be in where the sheet does not say: one between units of a dimension, the
/// unit of the contributions or of the result per unit of the quantity.
std::vector<Unit> units_of_coefficient(const Unit& x, const Unit& y, const Unit& contribution) {
    std::vector<Unit> units;
    const auto add_unit = [&](const Unit& unit) {
        if (std::none_of(units.begin(), units.end(), [&](const Unit& u) {
                return u.dimension() == unit.dimension() && u.interval_to_si(1.0) == unit.interval_to_si(1.0);
            }))
            units.push_back(unit);
    };
    if (x.dimension() == y.dimension()) add_unit(Unit());
    for (const Unit& of : {contribution, y})
        if (const auto quotient = Unit::parse("(" + of.interval().text() + ")/(" + x.text() + ")"))
            add_unit(*quotient);
    return units;
}

}  // namespace

Result<Coefficient> coefficient_of(const BudgetCells& cells, int row) {
    const auto read = cells.figure(row, BudgetColumn::c);
    if (!read) return fail(read.error());
    if (!*read) return Coefficient{row};
    return Coefficient{row, (*read)->value, (*read)->unit, true};
}

Result<std::pair<std::string, double>> LinearModel::term_of(std::size_t index, const NotedQuantity& q,
                                                            const Unit& y, bool first,
                                                            Proposals& proposals) const {
    const auto unit = unit_of_coefficient(index, q, y);
    if (!unit) return fail(unit.error());
    say_what_differs(index, *unit, y, proposals);
    const double c = coefficients_[index].value;
    std::string sign = c < 0.0 ? "-" : "+";
    sign = first ? (c < 0.0 ? "-" : "") : " " + sign + " ";
    std::string factor = shortest_number(std::abs(c));
    const bool one = unit->dimension().is_one() && unit->interval_to_si(1.0) == 1.0;
    if (!one) factor += " [" + unit->text() + "]";
    factor = one && std::abs(c) == 1.0 ? std::string() : factor + "*";
    return std::pair(sign + factor + q.symbol, unit->interval_to_si(c));
}

std::optional<double> LinearModel::combined_shares(const Unit& y, std::size_t components) const {
    if (shares_.size() < components || components == 0) return std::nullopt;
    double squares = 0.0;
    for (const StatedShare& share : shares_) {
        const double u = unit_of(share, y).interval_to_si(share.contribution);
        squares += u * u;
    }
    return std::sqrt(squares);
}

Unit LinearModel::unit_of(const StatedShare& share, const Unit& y) const {
    if (share.unit && !(*share.unit == Unit())) return share.unit->interval();
    return cells_.unit_in_head(BudgetColumn::contribution).value_or(y).interval();
}

double LinearModel::ratio_to(const StatedShare& share, const Unit& of_coefficient, const Unit& y) const {
    return std::abs(of_coefficient.interval_to_si(coefficients_[share.quantity].value)) *
           share.standard_uncertainty / unit_of(share, y).interval_to_si(std::abs(share.contribution));
}

void LinearModel::say_what_differs(std::size_t index, const Unit& of_coefficient, const Unit& y,
                                   Proposals& proposals) const {
    for (const StatedShare& share : shares_) {
        if (share.quantity != index || share.contribution == 0.0) continue;
        const double ratio = ratio_to(share, of_coefficient, y);
        if (std::abs(ratio - 1.0) <= rounding_of_contributions) continue;
        proposals.leave_out(share.row, tell<"the contribution %1: c and u give %2">(
                                           shortest_number(share.contribution),
                                           readable_number(ratio * std::abs(share.contribution))));
    }
}

/// The unit of a coefficient. Where the sheet does not say it, the contributions that it states decide
/// between the possible ones.
Result<Unit> LinearModel::unit_of_coefficient(std::size_t index, const NotedQuantity& q,
                                              const Unit& y) const {
    const Coefficient& c = coefficients_[index];
    if (c.unit) return *c.unit;
    const Unit of = cells_.unit_in_head(BudgetColumn::contribution).value_or(y);
    const std::vector<Unit> units = units_of_coefficient(q.unit.interval(), y.interval(), of.interval());
    for (const StatedShare& share : shares_) {
        if (share.quantity != index || !(share.standard_uncertainty > 0.0) || c.value == 0.0 ||
            share.contribution == 0.0)
            continue;
        for (const Unit& unit : units)
            if (const double ratio = ratio_to(share, unit, y); ratio > 0.5 && ratio < 2.0) return unit;
        return cells_.refused(c.row, BudgetColumn::contribution,
                              tell<"the contribution does not follow from c and u in any unit; state the "
                                   "unit behind the coefficient ('-575 nm/K')">());
    }
    if (units.empty())
        return cells_.refused(c.row, BudgetColumn::unit,
                              tell<"its unit makes no coefficient of the result">());
    if (units.size() > 1 && !(units.front() == Unit()))
        return cells_.refused(c.row, BudgetColumn::c,
                              tell<"its unit may be %1 or %2: state it behind the coefficient">(
                                  units[0].text(), units[1].text()));
    return units.front();
}

}  // namespace covaria
