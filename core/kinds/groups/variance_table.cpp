#include "core/kinds/groups/variance_table.h"

#include "core/math/special_quantiles.h"

namespace covaria {

Table variance_table(std::string id, std::string title, const Unit& unit, const VarianceSource& effect,
                     const VarianceSource& rest) {
    const bool simple = unit.text().find_first_of("/*^ ") == std::string::npos;
    const std::string times_itself = simple ? "^2" : "*" + unit.text();
    const Unit square = unit.text() == "1" ? unit : Unit::parse(unit.text() + times_itself).value_or(Unit{});
    Table table{std::move(id), std::move(title)};
    table.add("source of variation");
    table.add("sum of squares").in(square).figure(5);
    table.add("degrees of freedom");
    table.add("mean square").in(square).figure(5);
    table.add("F").symbol().figure(5);
    table.add("p").symbol().figure(3);
    const auto cells = [](const VarianceSource& s) {
        return std::vector<Cell>{s.name, s.sum_of_squares, s.degrees_of_freedom, s.mean_square()};
    };
    std::vector<Cell> first = cells(effect);
    if (rest.sum_of_squares > 0.0) {
        const double ratio = effect.mean_square() / rest.mean_square();
        first.push_back(ratio);
        first.push_back(f_upper_tail(ratio, effect.degrees_of_freedom, rest.degrees_of_freedom));
    }
    table.row(std::move(first));
    table.row(cells(rest));
    table.row({tell<"total">(), effect.sum_of_squares + rest.sum_of_squares,
               effect.degrees_of_freedom + rest.degrees_of_freedom});
    return table;
}

}  // namespace covaria
