// A sheet that has nothing but sensitivity coefficients, as a linear measurement equation.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/readers/budget_cells.h"

namespace covaria {

/// A sensitivity coefficient as the sheet states it.
struct Coefficient {
    int row = 0;
    double value = 1.0;
    std::optional<Unit> unit = {};
    bool stated = false;  ///< false where it is taken as 1
};
Result<Coefficient> coefficient_of(const BudgetCells& cells, int row);

/// A contribution |c| u that the sheet states beside its factors.
struct StatedShare {
    int row = 0;
    std::size_t quantity = 0;  ///< index of the quantity
    double contribution = 0.0;
    std::optional<Unit> unit = {};      ///< unit; empty: that of the head, else of the result
    double standard_uncertainty = 0.0;  ///< standard uncertainty of the component, in SI
};

/// The sensitivity coefficients of the sheet, one for each quantity, and the contributions stated with them.
class LinearModel {
public:
    explicit LinearModel(const BudgetCells& cells) : cells_(cells) {}

    void add(const Coefficient& c) { coefficients_.push_back(c); }
    void add(const StatedShare& share) { shares_.push_back(share); }

    /// The term " + 11.5 [nm/K]*x" of a quantity, and its coefficient in SI. Stated contributions that do not
    /// follow are reported.
    Result<std::pair<std::string, double>> term_of(std::size_t index, const NotedQuantity& q, const Unit& y,
                                                   bool first, Proposals& proposals) const;
    /// The root of the sum of the squares of the shares, in SI; empty unless each of the components has one.
    std::optional<double> combined_shares(const Unit& y, std::size_t components) const;

private:
    Result<Unit> unit_of_coefficient(std::size_t index, const NotedQuantity& q, const Unit& y) const;
    Unit unit_of(const StatedShare& share, const Unit& y) const;
    double ratio_to(const StatedShare& share, const Unit& of_coefficient, const Unit& y) const;
    void say_what_differs(std::size_t index, const Unit& of_coefficient, const Unit& y,
                          Proposals& proposals) const;

    const BudgetCells& cells_;
    std::vector<Coefficient> coefficients_;
    std::vector<StatedShare> shares_;
};

}  // namespace covaria
