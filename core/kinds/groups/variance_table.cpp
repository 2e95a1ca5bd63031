#include "core/kinds/groups/variance_table.h"

#include "core/math/special_quantiles.h"

namespace covaria {

DataTable variance_table(std::string id, std::string title, const Unit& unit, const VarianceSource& effect,
                         const VarianceSource& rest) {
    const bool simple = unit.text().find_first_of("/*^ ") == std::string::npos;
    const std::string times_itself = simple ? "^2" : "*" + unit.text();
    const Unit square = unit.text() == "1" ? unit : Unit::parse(unit.text() + times_itself).value_or(Unit{});
    DataTable table{std::move(id),
                    std::move(title),
                    {{"source of variation"},
                     {"sum of squares", square, false, 5},
                     {"degrees of freedom"},
                     {"mean square", square, false, 5},
                     {"F", {}, true, 5},
                     {"p", {}, true, 3}},
                    {},
                    {}};
    const auto row = [&](const VarianceSource& s) {
        table.rows.push_back({s.name, s.sum_of_squares, s.degrees_of_freedom, s.mean_square(), {}, {}});
    };
    row(effect);
    row(rest);
    table.rows.push_back({tell<"total">(),
                          effect.sum_of_squares + rest.sum_of_squares,
                          effect.degrees_of_freedom + rest.degrees_of_freedom,
                          {},
                          {},
                          {}});
    if (rest.sum_of_squares > 0.0) {
        const double ratio = effect.mean_square() / rest.mean_square();
        table.rows[0][4] = ratio;
        table.rows[0][5] = f_upper_tail(ratio, effect.degrees_of_freedom, rest.degrees_of_freedom);
    }
    return table;
}

}  // namespace covaria
