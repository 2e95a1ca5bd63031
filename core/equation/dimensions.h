// Dimensions of expressions, with fractional exponents, and the rule of each operation.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/unit.h"
#include "core/equation/operations.h"

namespace covaria::equation {

/// Of a value inside an equation: a number with a dimension, or a condition (true or false).
struct Kind {
    std::array<double, 8> exponents{};  ///< as in covaria::Dimension
    bool condition = false;
    bool any = false;  ///< the literal 0 fits every dimension

    static Kind of(const Unit& unit);
    static Kind of_condition();
    /// Plane angle counts as a number: the radian is one.
    bool is_number() const;
    bool same_dimension(const Kind& other) const;
    Kind raised(double exponent) const;
    Kind times(const Kind& other, double exponent_of_other) const;
};

/// The coherent SI unit: "m", "N", "kg*m^2"; empty if an exponent is not whole.
std::string coherent_unit(const Kind& kind);
/// For messages: "m", "a pure number", "a condition".
std::string kind_words(const Kind& kind);

struct Operand {
    Kind kind;
    std::optional<double> constant;  ///< its value, if it does not depend on quantities
    std::string text;                ///< for messages: 'theta'
};

/// Kind of the result; or what is wrong, in words.
struct KindOfResult {
    Kind kind;
    std::string objection = {};
};
KindOfResult kind_of(Operation operation, const Operand& a, const Operand& b, const Operand& c);

}  // namespace covaria::equation
