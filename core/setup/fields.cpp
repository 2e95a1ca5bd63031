#include "core/setup/fields.h"

namespace covaria {

std::array<ColumnSpec, 3> by_axis(const AxisKeys& keys, const std::string& help, const Further& more) {
    std::array<ColumnSpec, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
        std::string own = help;
        if (const auto at = own.find('*'); at != std::string::npos) own.replace(at, 1, along_axes[i]);
        columns[i] = detail::spec_of<ColumnSpec>(keys[i], keys[i], own, more);
    }
    return columns;
}

namespace detail {

SetupValue value_of_cell(const SetupCell& cell, const Unit& unit) {
    if (const double* number = std::get_if<double>(&cell)) return Quantity{unit.to_si(*number), Unit{}};
    if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
    if (const bool* flag = std::get_if<bool>(&cell)) return *flag;
    return {};
}

std::string row_place(const std::string& table_place, std::size_t row) {
    return table_place + "/rows/" + std::to_string(row);
}

}  // namespace detail

}  // namespace covaria
