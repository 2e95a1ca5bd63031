// Dimensions of expressions, with fractional exponents, and the rule of each operation.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/base/unit.h"
#include "core/equation/operations.h"

namespace covaria::equation {

/// Number of times the zero of the Celsius scale is in a value: 1 in a temperature stated in degC, 0 in the
/// difference of two. A sum of two temperatures has two zeros and no meaning, until it is halved.
struct CelsiusZeros {
    double count = 0.0;
    bool of_a_sum = false;  ///< such temperatures have been added
    bool is_meaningful() const;
    bool is_reading() const;     ///< one zero
    bool is_difference() const;  ///< no zero
    bool operator==(const CelsiusZeros&) const = default;
};

/// Kind of a value inside an equation: a number with a dimension, or a condition (true or false).
struct Kind {
    std::array<double, 8> exponents{};  ///< exponents as in covaria::Dimension
    bool condition = false;
    bool any = false;                        ///< the literal 0 fits every dimension
    std::optional<CelsiusZeros> zeros = {};  ///< empty: not known (in K), or no temperature
    /// The power in which temperatures in degC are factors of the value: 1 in R*t, 0 in t_1/t_2. Only what
    /// has none means something by itself.
    double readings = 0.0;
    /// An angle that is the same after a full turn: one that was read, of an inverse function, a sum of such.
    bool on_circle = false;

    static Kind of(const Unit& unit);
    static Kind of_condition();
    /// Plane angle counts as a number: the radian is one.
    bool is_number() const;
    bool same_dimension(const Kind& other) const;
    Kind raised(double exponent) const;
    Kind times(const Kind& other, double exponent_of_other) const;
    bool is_celsius() const { return zeros && zeros->is_reading(); }
    bool is_difference() const { return zeros && zeros->is_difference(); }
    /// A temperature in degC, or a multiple of one, or a sum: not a difference.
    bool has_celsius() const { return zeros && !zeros->is_difference(); }
};

/// The coherent SI unit: "m", "N", "kg*m^2"; empty if an exponent is not whole.
std::string coherent_unit(const Kind& kind);
/// Words for messages: "m", "a pure number", "a condition".
Message kind_words(const Kind& kind);

struct Operand {
    Kind kind;
    std::optional<double> constant;  ///< its value, if it does not depend on quantities
    Message text;                    ///< its text in messages: 'theta'
};

/// Whether angles in this unit are on a circle: those in rev are counts of turns.
bool is_circle_unit(const Unit& unit);

/// Kind of the result; or what is wrong, in words.
struct KindOfResult {
    Kind kind;
    Message objection = {};
};
/// The operand (0, 1, 2) in which a temperature in degC would be taken in kelvin, or a multiple of one as if
/// it were a temperature.
std::optional<std::size_t> misused_reading(Operation operation, const Operand& a, const Operand& b,
                                           const Operand& c);
KindOfResult kind_of(Operation operation, const Operand& a, const Operand& b, const Operand& c);
/// Why two operands of one dimension cannot be equal, compared or chosen between: one a temperature in degC,
/// the other a difference or the number 0. Empty if they can.
Message zeros_objection(const Operand& a, const Operand& b);
/// Why a value means nothing by itself: a sum of temperatures in degC. Empty if it does.
Message sum_objection(const Operand& a);

}  // namespace covaria::equation
