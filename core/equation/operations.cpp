// The table of functions.
#include "core/equation/operations.h"

#include <algorithm>
#include <array>

namespace covaria::equation {

namespace {

constexpr std::size_t any_number = 16;

}  // namespace

const std::vector<FunctionInfo>& functions() {
    using O = Operation;
    static const std::vector<FunctionInfo> table{{"sqrt", O::square_root, 1, 1},
                                                 {"cbrt", O::cube_root, 1, 1},
                                                 {"exp", O::exponential, 1, 1},
                                                 {"log", O::logarithm, 1, 1},
                                                 {"ln", O::logarithm, 1, 1},
                                                 {"log10", O::logarithm_10, 1, 1},
                                                 {"log2", O::logarithm_2, 1, 1},
                                                 {"sin", O::sine, 1, 1},
                                                 {"cos", O::cosine, 1, 1},
                                                 {"tan", O::tangent, 1, 1},
                                                 {"asin", O::arc_sine, 1, 1},
                                                 {"acos", O::arc_cosine, 1, 1},
                                                 {"atan", O::arc_tangent, 1, 1},
                                                 {"sinh", O::hyperbolic_sine, 1, 1},
                                                 {"cosh", O::hyperbolic_cosine, 1, 1},
                                                 {"tanh", O::hyperbolic_tangent, 1, 1},
                                                 {"asinh", O::area_sine, 1, 1},
                                                 {"acosh", O::area_cosine, 1, 1},
                                                 {"atanh", O::area_tangent, 1, 1},
                                                 {"abs", O::absolute, 1, 1},
                                                 {"sign", O::sign, 1, 1},
                                                 {"atan2", O::arc_tangent_2, 2, 2},
                                                 {"hypot", O::hypotenuse, 2, any_number},
                                                 {"min", O::minimum, 2, any_number},
                                                 {"max", O::maximum, 2, any_number},
                                                 {"pow", O::power, 2, 2},
                                                 {"if", O::select, 3, 3},
                                                 {"complex", O::complex_number, 2, 2, true},
                                                 {"polar", O::polar_number, 2, 2, true},
                                                 {"re", O::real_part, 1, 1, true},
                                                 {"im", O::imaginary_part, 1, 1, true},
                                                 {"conj", O::conjugate, 1, 1, true},
                                                 {"arg", O::argument, 1, 1, true}};
    return table;
}

const FunctionInfo* find_function(std::string_view name) {
    const auto& table = functions();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const FunctionInfo& f) { return f.name == name; });
    return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    for (const FunctionInfo& f : functions()) names.emplace_back(f.name);
    return names;
}

bool is_reserved(std::string_view name) {
    static constexpr std::array<std::string_view, 5> words{"pi", "and", "or", "not", "solve"};
    const FunctionInfo* function = find_function(name);
    return (function && !function->may_be_a_name) ||
           std::find(words.begin(), words.end(), name) != words.end();
}

bool is_comparison(Operation operation) {
    return operation >= Operation::less && operation <= Operation::not_equal;
}

bool is_logical(Operation operation) {
    return operation >= Operation::logical_and && operation <= Operation::logical_not;
}

bool is_condition(Operation operation) {
    return is_comparison(operation) || is_logical(operation);
}

int operands_of(Operation operation) {
    using O = Operation;
    if (operation <= O::unknown) return 0;
    if (operation == O::select) return 3;
    if (operation >= O::real_part) return 1;
    if (operation == O::negate || operation == O::integer_power || operation == O::logical_not) return 1;
    return operation >= O::square_root && operation <= O::sign ? 1 : 2;
}

}  // namespace covaria::equation
