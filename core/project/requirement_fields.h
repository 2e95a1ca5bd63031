// The figures of a requirement, each declared once: for the project file and for forms.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "core/project/json_fields.h"
#include "core/project/project.h"
#include "core/setup/setup_schema.h"

namespace covaria {

struct RequirementField {
    using Member =
        std::variant<std::optional<Quantity> Requirement::*, double Requirement::*, GuardRule Requirement::*>;
    const char* key;    ///< the key in the project file
    const char* title;  ///< the title for people
    const char* help;
    Member member;             ///< the member; a number has the default of `Requirement`
    bool is_interval = false;  ///< whether it is a difference of temperatures, not a temperature
};

inline bool is_choice(const RequirementField& field) {
    return std::holds_alternative<GuardRule Requirement::*>(field.member);
}
/// A guard rule as files and people call it.
struct GuardRuleChoice {
    GuardRule rule;
    Choice choice;
};
const std::vector<GuardRuleChoice>& guard_rules();

/// The value of a field that is no choice, guard factors as a quantity of the unit 1. In `set_value` nullopt
/// stands for the default.
std::optional<Quantity> value_of(const Requirement& requirement, const RequirementField& field);
void set_value(Requirement& requirement, const RequirementField& field, const std::optional<Quantity>& value);

inline bool is_number(const RequirementField& field) {
    return std::holds_alternative<double Requirement::*>(field.member);
}

/// All fields in the order of the project file.
const std::array<RequirementField, 8>& requirement_fields();

/// The fields of a requirement in project files: the output that it is for, and its figures.
const JsonFields<Requirement>& requirement_object();

}  // namespace covaria
