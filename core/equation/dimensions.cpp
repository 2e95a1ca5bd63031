// The rules of dimensions.
#include "core/equation/dimensions.h"

#include <algorithm>
#include <cmath>

#include "core/base/unit_table.h"

namespace covaria::equation {

namespace {

using O = Operation;

constexpr std::size_t angle = 7;
constexpr std::array<const char*, 8> base_units{"m", "kg", "s", "A", "K", "mol", "cd", "rad"};

bool equal(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

bool same_exponents(const Kind& kind, const Dimension& dimension) {
    for (std::size_t i = 0; i < kind.exponents.size(); ++i)
        if (!equal(kind.exponents[i], dimension.exponents[i])) return false;
    return true;
}

Kind plane_angle() {
    Kind kind;
    kind.exponents[angle] = 1.0;
    return kind;
}

std::string power_words(double exponent) {
    std::string text = std::to_string(exponent);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "1" ? "" : "^" + text;
}

/// As a product of base units, fractional exponents too.
std::string product_words(const Kind& kind) {
    std::string text;
    for (std::size_t i = 0; i < angle; ++i)
        if (!equal(kind.exponents[i], 0.0))
            text += (text.empty() ? "" : "*") + std::string(base_units[i]) + power_words(kind.exponents[i]);
    return text;
}

std::string both(const Operand& a, const Operand& b) {
    return a.text + " is " + kind_words(a.kind) + ", " + b.text + " is " + kind_words(b.kind);
}

KindOfResult refused(std::string objection) {
    return {{}, std::move(objection)};
}

/// Of two operands that must be alike: the one that is not the literal 0.
KindOfResult alike(const Operand& a, const Operand& b, const std::string& what) {
    if (!a.kind.same_dimension(b.kind)) return refused(both(a, b) + ": " + what);
    return {a.kind.any ? b.kind : a.kind};
}

KindOfResult of_number(const Operand& a, const std::string& what, const Kind& result) {
    if (!a.kind.is_number()) return refused(a.text + " is " + kind_words(a.kind) + ": " + what);
    return {result};
}

KindOfResult of_power(const Operand& base, const Operand& exponent) {
    if (!exponent.kind.is_number())
        return refused("the exponent " + exponent.text + " is " + kind_words(exponent.kind) +
                       ": an exponent must be a pure number");
    if (base.kind.is_number()) return {Kind{}};
    if (!exponent.constant)
        return refused(base.text + " is " + kind_words(base.kind) +
                       ": its exponent must be a constant, or the dimension would vary");
    return {base.kind.raised(*exponent.constant)};
}

KindOfResult of_arithmetic(Operation operation, const Operand& a, const Operand& b) {
    switch (operation) {
        case O::add:
        case O::subtract:
            return alike(a, b, operation == O::add ? "they cannot be added" : "they cannot be subtracted");
        case O::multiply:
            return {a.kind.times(b.kind, 1.0)};
        case O::divide:
            return {a.kind.times(b.kind, -1.0)};
        case O::power:
            return of_power(a, b);
        case O::arc_tangent_2: {
            const KindOfResult result = alike(a, b, "atan2 needs two quantities of one kind");
            return result.objection.empty() ? KindOfResult{plane_angle()} : result;
        }
        default:  // hypot, min, max
            return alike(a, b, "a function of both needs quantities of one kind");
    }
}

KindOfResult of_function(Operation operation, const Operand& a) {
    switch (operation) {
        case O::negate:
        case O::absolute:
            return {a.kind};
        case O::sign:
            return {Kind{}};
        case O::square_root:
            return {a.kind.raised(0.5)};
        case O::cube_root:
            return {a.kind.raised(1.0 / 3.0)};
        case O::sine:
        case O::cosine:
        case O::tangent:
            return of_number(a, "sin, cos and tan need an angle or a pure number", Kind{});
        case O::arc_sine:
        case O::arc_cosine:
        case O::arc_tangent:
            return of_number(a, "an inverse function of an angle needs a pure number", plane_angle());
        default:
            return of_number(a, "this function needs a pure number: divide by a quantity of the same kind",
                             Kind{});
    }
}

KindOfResult of_condition(Operation operation, const Operand& a, const Operand& b) {
    if (is_comparison(operation)) {
        KindOfResult result = alike(a, b, "they cannot be compared");
        if (result.objection.empty()) result.kind = Kind::of_condition();
        return result;
    }
    for (const Operand* operand : {&a, &b})
        if (!(operation == O::logical_not && operand == &b) && !operand->kind.condition)
            return refused(operand->text + " is not a condition: write a comparison, as in x > 0");
    return {Kind::of_condition()};
}

}  // namespace

Kind Kind::of(const Unit& unit) {
    Kind kind;
    for (std::size_t i = 0; i < kind.exponents.size(); ++i) kind.exponents[i] = unit.dimension().exponents[i];
    return kind;
}

Kind Kind::of_condition() {
    Kind kind;
    kind.condition = true;
    return kind;
}

bool Kind::is_number() const {
    return any ||
           std::all_of(exponents.begin(), exponents.begin() + angle, [](double e) { return equal(e, 0.0); });
}

bool Kind::same_dimension(const Kind& other) const {
    if (any || other.any) return true;
    return std::equal(exponents.begin(), exponents.begin() + angle, other.exponents.begin(), equal);
}

Kind Kind::raised(double exponent) const {
    Kind result = *this;
    for (double& e : result.exponents) e *= exponent;
    return result;
}

Kind Kind::times(const Kind& other, double exponent_of_other) const {
    Kind result = *this;
    for (std::size_t i = 0; i < exponents.size(); ++i)
        result.exponents[i] += exponent_of_other * other.exponents[i];
    result.any = any || other.any;
    return result;
}

std::string coherent_unit(const Kind& kind) {
    for (const detail::UnitEntry& unit : detail::unit_table())
        if (unit.numerator == unit.denominator && unit.offset == 0.0 && same_exponents(kind, unit.dimension))
            return std::string(unit.name);
    for (const double e : kind.exponents)
        if (!equal(e, std::round(e)) || std::abs(e) > 9.0) return {};
    std::string product = product_words(kind);
    return product.empty() ? "rad" + power_words(kind.exponents[angle]) : product;
}

std::string kind_words(const Kind& kind) {
    if (kind.condition) return "a condition";
    if (kind.is_number()) return "a pure number";
    Kind without_angle = kind;
    without_angle.exponents[angle] = 0.0;
    const std::string unit = coherent_unit(without_angle);
    return "measured in " + (unit.empty() ? product_words(kind) : unit);
}

KindOfResult kind_of(Operation operation, const Operand& a, const Operand& b, const Operand& c) {
    if (is_condition(operation)) return of_condition(operation, a, b);
    if (operation == O::select) {
        if (!a.kind.condition)
            return refused(a.text + " is not a condition: write a comparison, as in if(x > 0, x, 0)");
        if (b.kind.condition || c.kind.condition)
            return refused("both values of 'if' must be numbers, not conditions");
        return alike(b, c, "both values of 'if' must be of one kind");
    }
    for (const Operand* operand : {&a, &b})
        if (operand->kind.condition)
            return refused(operand->text + " is a condition: use it as the first argument of if(...)");
    return operands_of(operation) == 1 ? of_function(operation, a) : of_arithmetic(operation, a, b);
}

}  // namespace covaria::equation
