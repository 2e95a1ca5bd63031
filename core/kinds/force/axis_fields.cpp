#include "core/kinds/force/axis_fields.h"

namespace covaria {

const std::vector<ChoiceOf<std::size_t>>& axis_choices() {
    static const auto choices = [] {
        std::vector<ChoiceOf<std::size_t>> made;
        for (std::size_t i = 0; i < most_channels; ++i)
            made.push_back({i, force_axes[i].key, force_axes[i].key});
        return made;
    }();
    return choices;
}

std::array<ColumnSpec, most_channels> axis_columns(const Unit& unit, const std::string& help) {
    std::array<ColumnSpec, most_channels> columns;
    for (std::size_t i = 0; i < most_channels; ++i)
        columns[i] = {.key = force_axes[i].key,
                      .title = force_axes[i].key,
                      .unit = unit,
                      .optional = true,
                      .help = help};
    return columns;
}

}  // namespace covaria
