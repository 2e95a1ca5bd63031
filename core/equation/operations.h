// The operations and functions of equations, with their names and numbers of arguments.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace covaria::equation {

enum class Operation : std::uint8_t {
    constant,
    symbol,  ///< a quantity, a definition or an unknown, by name (in the parsed text only)
    input,
    unknown,
    add,
    subtract,
    multiply,
    divide,
    negate,
    power,          ///< a^b
    integer_power,  ///< a^n, n constant
    less,
    less_or_equal,
    greater,
    greater_or_equal,
    equal,
    not_equal,
    logical_and,
    logical_or,
    logical_not,
    select,  ///< a ? b : c
    square_root,
    cube_root,
    exponential,
    logarithm,
    logarithm_10,
    logarithm_2,
    sine,
    cosine,
    tangent,
    arc_sine,
    arc_cosine,
    arc_tangent,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    area_sine,
    area_cosine,
    area_tangent,
    absolute,
    sign,
    arc_tangent_2,
    hypotenuse,
    minimum,
    maximum,
    // Operations on complex numbers, which are gone before anything is compiled (complex_numbers.h).
    complex_number,  ///< from real and imaginary part
    polar_number,    ///< from modulus and argument
    real_part,
    imaginary_part,
    conjugate,
    argument,
};
inline constexpr std::size_t operations = static_cast<std::size_t>(Operation::maximum) + 1;

struct FunctionInfo {
    std::string_view name;
    Operation operation;
    std::size_t fewest;  ///< arguments
    std::size_t most;    ///< more than two: from left to right
    /// A function only where a parenthesis follows: `re` may be the name of a quantity.
    bool may_be_a_name = false;
};

/// Functions that equations may call.
const std::vector<FunctionInfo>& functions();
const FunctionInfo* find_function(std::string_view name);
std::vector<std::string> function_names();

/// A name that no quantity or definition may have: a function (but for those that may be names), "pi", "if",
/// "and", "or", "not", "solve".
bool is_reserved(std::string_view name);

bool is_comparison(Operation operation);
bool is_logical(Operation operation);
/// Gives true or false: comparisons, and, or, not.
bool is_condition(Operation operation);
/// Operands that the operation has.
int operands_of(Operation operation);

}  // namespace covaria::equation
