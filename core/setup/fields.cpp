#include "core/setup/fields.h"

namespace covaria::detail {

SetupValue value_of_cell(const SetupCell& cell, const Unit& unit) {
    if (const double* number = std::get_if<double>(&cell)) return Quantity{unit.to_si(*number), Unit{}};
    if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
    if (const bool* flag = std::get_if<bool>(&cell)) return *flag;
    return {};
}

std::string row_place(const std::string& table_place, std::size_t row) {
    return table_place + "/rows/" + std::to_string(row);
}

}  // namespace covaria::detail
