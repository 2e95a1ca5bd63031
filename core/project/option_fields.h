// The evaluation options as people meet them, each declared once and bound to its member: project file, its
// JSON schema, form and `covaria describe` follow. EvaluationOptions::check says which options may stand
// together.
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
    std::function<void(EvaluationOptions&, const std::string&)> set;  ///< takes one of the field's choices
};
/// A whole number of 64 bits, which is a text in files because all of its bits count.
struct SeedOption {
    std::uint64_t EvaluationOptions::*member;
};

using OptionMember =
    std::variant<ChosenOption, SeedOption, std::uint64_t EvaluationOptions::*, int EvaluationOptions::*,
                 double EvaluationOptions::*, std::optional<double> EvaluationOptions::*,
                 std::optional<Quantity> EvaluationOptions::*, bool EvaluationOptions::*>;

struct OptionField {
    const char* key;    ///< the key in files
    const char* title;  ///< the title for people
    const char* help;
    OptionMember member;
    std::vector<Method> methods;  ///< methods that use the option
    Range range = {};
    bool below_high = false;           ///< whether the value is less than range.high, not equal to it
    std::vector<Choice> choices = {};  ///< choices of a ChosenOption
    /// Whether 0 means that it is not asked for, in which case forms say nothing.
    bool none_at_zero = false;
};

/// All options in the order of files and forms.
const std::vector<OptionField>& option_fields();

/// The number 2^53, beyond which doubles skip some whole numbers.
inline constexpr double largest_whole_number = 9007199254740992.0;

/// The whole or real number of a member, empty where none is given; choices, flags and quantities have none.
std::optional<double> number_of(const OptionMember& member, const EvaluationOptions& options);
/// Sets the number of a member; `value` must be in the field's range, and whole where the member is.
void set_number(const OptionMember& member, EvaluationOptions& options, std::optional<double> value);

}  // namespace covaria
