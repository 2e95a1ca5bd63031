// The forms that points are fitted to, and what each of them has.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/message.h"

namespace covaria::geometry {

enum class Form { point, line_2d, line, plane, circle_2d, circle, sphere, cylinder, cone };

inline constexpr std::size_t most_parameters = 6;
inline constexpr std::size_t most_rows = 3;

struct FormFacts {
    std::size_t parameters;
    std::size_t rows;          ///< equations of a point
    std::size_t redundancy;    ///< independent deviations of a point
    std::size_t least_points;  ///< fewer determine no form, or several
    bool has_direction;
    bool has_diameter;
    bool is_flat = false;  ///< lies in the xy-plane: z does not matter
};

constexpr FormFacts facts_of(Form form) {
    switch (form) {
        case Form::point:
            return {3, 3, 3, 1, false, false};
        case Form::line_2d:
            return {2, 1, 1, 2, true, false, true};
        case Form::line:
            return {4, 3, 2, 2, true, false};
        case Form::plane:
            return {3, 1, 1, 3, true, false};
        case Form::circle_2d:
            return {3, 1, 1, 3, false, true, true};
        case Form::circle:
            return {6, 2, 1, 3, true, true};
        case Form::sphere:
            return {4, 1, 1, 4, false, true};
        case Form::cylinder:
            return {5, 1, 1, 6, true, true};
        case Form::cone:
            break;
    }
    return {6, 1, 1, 7, true, true};
}

/// Parameters of the form that a row of its points' equations determines. Those of a circle's plane do not
/// depend on the radial deviations: the plane comes first, the circle in it second (as NIST's).
struct RowRange {
    std::size_t first, last;
};
constexpr RowRange range_of(Form form, std::size_t row) {
    if (form != Form::circle) return {0, facts_of(form).parameters};
    return row == 0 ? RowRange{0, 3} : RowRange{3, 6};
}

Message words_of(Form form);

/// n - p: deviations from the form that are free.
constexpr std::size_t degrees_of_freedom(Form form, std::size_t points) {
    const FormFacts facts = facts_of(form);
    const std::size_t all = facts.redundancy * points;
    const std::size_t fitted = form == Form::circle ? 3 : facts.parameters;
    return all > fitted ? all - fitted : 0;
}

}  // namespace covaria::geometry
