// The evaluation options as people meet them, each declared once and bound to its member: project file, its
// JSON schema, form and `covaria describe` follow. What an option may be together with others is
// EvaluationOptions::check.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/propagation/options.h"
#include "core/setup/setup_schema.h"

namespace covaria {

/// A member that is an enumeration, by the keys of its choices.
struct ChosenOption {
    std::function<std::string(const EvaluationOptions&)> get;
    std::function<void(EvaluationOptions&, const std::string&)> set;  ///< one of the field's choices
};
/// A whole number of 64 bits, all of which count: a text in files.
struct SeedOption {
    std::uint64_t EvaluationOptions::*member;
};

using OptionMember =
    std::variant<ChosenOption, SeedOption, std::uint64_t EvaluationOptions::*, int EvaluationOptions::*,
                 double EvaluationOptions::*, std::optional<double> EvaluationOptions::*,
                 std::optional<Quantity> EvaluationOptions::*, bool EvaluationOptions::*>;

struct OptionField {
    const char* key;    ///< in files
    const char* title;  ///< for people
    const char* help;
    OptionMember member;
    std::vector<Method> methods;  ///< that use it
    Range range = {};
    bool below_high = false;           ///< less than range.high, not equal to it
    std::vector<Choice> choices = {};  ///< of a ChosenOption
    bool none_at_zero = false;         ///< 0: not asked for; forms say nothing then
};

/// All options in the order of files and forms.
const std::vector<OptionField>& option_fields();

inline constexpr double largest_whole_number = 9007199254740992.0;  ///< 2^53: beyond, doubles skip some

/// The whole or real number of a member, empty where none is given; not of choices, flags and quantities.
std::optional<double> number_of(const OptionMember& member, const EvaluationOptions& options);
/// `value`: whole and in the field's range where the member is one.
void set_number(const OptionMember& member, EvaluationOptions& options, std::optional<double> value);

}  // namespace covaria
