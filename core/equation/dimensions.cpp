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

/// Words for a kind as a product of base units, with fractional exponents too.
std::string product_words(const Kind& kind) {
    std::string text;
    for (std::size_t i = 0; i < angle; ++i)
        if (!equal(kind.exponents[i], 0.0))
            text += (text.empty() ? "" : "*") + std::string(base_units[i]) + power_words(kind.exponents[i]);
    return text;
}

Message both(const Operand& a, const Operand& b) {
    return tell<"%1 is %2, %3 is %4">(a.text, kind_words(a.kind), b.text, kind_words(b.kind));
}

KindOfResult refused(Message objection) {
    return {{}, std::move(objection)};
}

/// Kind of two operands that must be alike: that of the one that is not the literal 0.
KindOfResult alike(const Operand& a, const Operand& b, const Message& what) {
    if (!a.kind.same_dimension(b.kind)) return refused(both(a, b) + ": " + what);
    return {a.kind.any ? b.kind : a.kind};
}

/// Kind of two operands that must be alike and have the same zero of temperature.
KindOfResult alike_to_the_zero(const Operand& a, const Operand& b, const Message& what) {
    KindOfResult result = alike(a, b, what);
    if (!result.objection.empty()) return result;
    if (const Message objection = zeros_objection(a, b); !objection.empty()) return refused(objection);
    result.kind.zeros = a.kind.zeros ? a.kind.zeros : b.kind.zeros;
    return result;
}

std::optional<CelsiusZeros> multiplied(std::optional<CelsiusZeros> zeros, double factor) {
    if (zeros) zeros->count *= factor;
    return zeros;
}

bool is_multiple(const Kind& kind) {
    return kind.has_celsius() && !kind.is_celsius();
}

/// The power in which temperatures in degC are factors of a value that stands in a product.
double as_factor(const Kind& kind) {
    return kind.readings + (kind.has_celsius() ? 1.0 : 0.0);
}

double readings_of(Operation operation, const Operand& a, const Operand& b, const Kind& result) {
    double power = 0.0;
    if (result.any || result.zeros) return 0.0;  // its zeros say all that is known of it
    if (operation == O::multiply) power = as_factor(a.kind) + as_factor(b.kind);
    if (operation == O::divide) power = as_factor(a.kind) - as_factor(b.kind);
    if (operation == O::power && b.constant) power = as_factor(a.kind) * *b.constant;
    if (operation == O::square_root) power = as_factor(a.kind) / 2.0;
    if (operation == O::cube_root) power = as_factor(a.kind) / 3.0;
    if (operation == O::negate || operation == O::absolute) power = a.kind.readings;
    return equal(power, 0.0) ? 0.0 : power;
}

/// Turns may be added to what the result is made of: it is the same then, but for turns.
bool stays_on_circle(Operation operation, const Operand& a, const Operand& b, const Operand& c) {
    const auto fits = [](const Operand& o) { return o.kind.on_circle || (o.constant && o.kind.is_number()); };
    const auto whole = [](const Operand& o) {
        return o.constant && o.kind.is_number() && equal(*o.constant, std::round(*o.constant));
    };
    switch (operation) {
        case O::add:
        case O::subtract:
            return fits(a) && fits(b) && (a.kind.on_circle || b.kind.on_circle);
        case O::negate:
            return a.kind.on_circle;
        case O::multiply:
            return (a.kind.on_circle && whole(b)) || (b.kind.on_circle && whole(a));
        case O::select:
            return fits(b) && fits(c) && (b.kind.on_circle || c.kind.on_circle);
        default:
            return operation == O::arc_sine || operation == O::arc_cosine || operation == O::arc_tangent ||
                   operation == O::arc_tangent_2;
    }
}

KindOfResult of_sum(const Operand& a, const Operand& b, double sign) {
    KindOfResult result =
        alike(a, b, sign > 0.0 ? tell<"they cannot be added">() : tell<"they cannot be subtracted">());
    if (!result.objection.empty() || !(a.kind.zeros || b.kind.zeros)) return result;
    const CelsiusZeros first = a.kind.zeros.value_or(CelsiusZeros{});
    const CelsiusZeros second = b.kind.zeros.value_or(CelsiusZeros{});
    const double count = first.count + sign * second.count;
    result.kind.zeros = CelsiusZeros{equal(count, 1.0)   ? 1.0
                                     : equal(count, 0.0) ? 0.0
                                                         : count,
                                     first.of_a_sum || second.of_a_sum || first.count * second.count != 0.0};
    return result;
}

/// Products with a pure number keep what is known of a temperature; elsewhere it is a thermodynamic one.
KindOfResult of_product(const Operand& a, const Operand& b, double exponent) {
    KindOfResult result{a.kind.times(b.kind, exponent)};
    const auto factor = [](const Operand& o) { return o.constant && o.kind.is_number() && !o.kind.any; };
    if (a.kind.zeros && factor(b))
        result.kind.zeros = multiplied(a.kind.zeros, std::pow(*b.constant, exponent));
    else if (b.kind.zeros && factor(a) && exponent > 0.0)
        result.kind.zeros = multiplied(b.kind.zeros, *a.constant);
    else
        for (const Operand* operand : {&a, &b})
            if (result.objection.empty()) result.objection = sum_objection(*operand);
    return result;
}

KindOfResult of_number(const Operand& a, const Message& what, const Kind& result) {
    if (!a.kind.is_number()) return refused(tell<"%1 is %2: %3">(a.text, kind_words(a.kind), what));
    return {result};
}

KindOfResult of_power(const Operand& base, const Operand& exponent) {
    if (!exponent.kind.is_number())
        return refused(tell<"the exponent %1 is %2: an exponent must be a pure number">(
            exponent.text, kind_words(exponent.kind)));
    if (base.kind.is_number()) return {Kind{}};
    if (!exponent.constant)
        return refused(tell<"%1 is %2: its exponent must be a constant, or the dimension would vary">(
            base.text, kind_words(base.kind)));
    return {base.kind.raised(*exponent.constant)};
}

KindOfResult of_arithmetic(Operation operation, const Operand& a, const Operand& b) {
    switch (operation) {
        case O::add:
            return of_sum(a, b, 1.0);
        case O::subtract:
            return of_sum(a, b, -1.0);
        case O::multiply:
            return of_product(a, b, 1.0);
        case O::divide:
            return of_product(a, b, -1.0);
        case O::power:
            return of_power(a, b);
        case O::arc_tangent_2: {
            const KindOfResult result = alike(a, b, tell<"atan2 needs two quantities of one kind">());
            return result.objection.empty() ? KindOfResult{plane_angle()} : result;
        }
        default:  // hypot, min, max
            return alike_to_the_zero(a, b, tell<"a function of both needs quantities of one kind">());
    }
}

KindOfResult of_function(Operation operation, const Operand& a) {
    switch (operation) {
        case O::negate: {
            KindOfResult result{a.kind};
            result.kind.zeros = multiplied(a.kind.zeros, -1.0);
            return result;
        }
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
            return of_number(a, tell<"sin, cos and tan need an angle or a pure number">(), Kind{});
        case O::arc_sine:
        case O::arc_cosine:
        case O::arc_tangent:
            return of_number(a, tell<"an inverse function of an angle needs a pure number">(), plane_angle());
        default:
            return of_number(
                a, tell<"this function needs a pure number: divide by a quantity of the same kind">(),
                Kind{});
    }
}

KindOfResult of_condition(Operation operation, const Operand& a, const Operand& b) {
    if (is_comparison(operation)) {
        KindOfResult result = alike_to_the_zero(a, b, tell<"they cannot be compared">());
        if (result.objection.empty()) result.kind = Kind::of_condition();
        return result;
    }
    for (const Operand* operand : {&a, &b})
        if (!(operation == O::logical_not && operand == &b) && !operand->kind.condition)
            return refused(tell<"%1 is not a condition: write a comparison, as in x > 0">(operand->text));
    return {Kind::of_condition()};
}

KindOfResult kind_by_operands(Operation operation, const Operand& a, const Operand& b, const Operand& c) {
    if (is_condition(operation)) return of_condition(operation, a, b);
    if (operation == O::select) {
        if (!a.kind.condition)
            return refused(tell<"%1 is not a condition: write a comparison, as in if(x > 0, x, 0)">(a.text));
        if (b.kind.condition || c.kind.condition)
            return refused(tell<"both values of 'if' must be numbers, not conditions">());
        return alike_to_the_zero(b, c, tell<"both values of 'if' must be of one kind">());
    }
    for (const Operand* operand : {&a, &b})
        if (operand->kind.condition)
            return refused(tell<"%1 is a condition: use it as the first argument of if(...)">(operand->text));
    const bool one = operands_of(operation) == 1;
    KindOfResult result = one ? of_function(operation, a) : of_arithmetic(operation, a, b);
    if ((one || operation == O::power) && result.objection.empty() && !result.kind.zeros)
        result.objection = sum_objection(a);
    return result;
}

}  // namespace

Kind Kind::of(const Unit& unit) {
    Kind kind;
    for (std::size_t i = 0; i < kind.exponents.size(); ++i) kind.exponents[i] = unit.dimension().exponents[i];
    if (unit.has_offset()) kind.zeros = CelsiusZeros{1.0, false};
    kind.on_circle = is_circle_unit(unit);
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
    result.zeros.reset();
    return result;
}

Kind Kind::times(const Kind& other, double exponent_of_other) const {
    Kind result = *this;
    for (std::size_t i = 0; i < exponents.size(); ++i)
        result.exponents[i] += exponent_of_other * other.exponents[i];
    result.any = any || other.any;
    result.zeros.reset();
    return result;
}

std::string coherent_unit(const Kind& kind) {
    for (const detail::UnitEntry& unit : detail::unit_table())
        if (unit.numerator == unit.denominator && unit.offset == 0.0 && !unit.one_kind_only &&
            same_exponents(kind, unit.dimension))
            return std::string(unit.name);
    for (const double e : kind.exponents)
        if (!equal(e, std::round(e)) || std::abs(e) > 9.0) return {};
    std::string product = product_words(kind);
    return product.empty() ? "rad" + power_words(kind.exponents[angle]) : product;
}

Message kind_words(const Kind& kind) {
    if (kind.condition) return tell<"a condition">();
    if (kind.is_number()) return tell<"a pure number">();
    Kind without_angle = kind;
    without_angle.exponents[angle] = 0.0;
    const std::string unit = coherent_unit(without_angle);
    return tell<"measured in %1">((unit.empty() ? product_words(kind) : unit));
}

bool is_circle_unit(const Unit& unit) {
    return unit.dimension() == Unit::of("rad").dimension() && !(unit == Unit::of("rev"));
}

bool CelsiusZeros::is_reading() const {
    return equal(count, 1.0);
}

bool CelsiusZeros::is_difference() const {
    return equal(count, 0.0);
}

bool CelsiusZeros::is_meaningful() const {
    return !of_a_sum || equal(count, 0.0) || equal(count, 1.0);
}

Message zeros_objection(const Operand& a, const Operand& b) {
    if ((a.kind.is_celsius() && b.kind.is_difference()) || (a.kind.is_difference() && b.kind.is_celsius())) {
        const bool first = a.kind.is_celsius();
        return tell<"%1 is a temperature in degC, %2 a difference of temperatures: give differences in K">(
            (first ? a : b).text, (first ? b : a).text);
    }
    const auto bare_zero = [](const Operand& o) { return o.kind.any && o.constant; };
    if ((a.kind.is_celsius() && bare_zero(b)) || (b.kind.is_celsius() && bare_zero(a)))
        return tell<
            "%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero">(
            (a.kind.is_celsius() ? a : b).text);
    return {};
}

Message sum_objection(const Operand& a) {
    if (!a.kind.zeros || a.kind.zeros->is_meaningful()) return {};
    return tell<
        "%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum "
        "by the number of temperatures for their mean">(a.text);
}

std::optional<std::size_t> misused_reading(Operation operation, const Operand& a, const Operand& b,
                                           const Operand& c) {
    const std::array<const Kind*, 3> kinds{&a.kind, &b.kind, &c.kind};
    const auto first = [&](const auto& is_misused) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (is_misused(*kinds[i])) return i;
        return {};
    };
    const auto factor = [](const Kind& kind) { return kind.readings != 0.0; };
    switch (operation) {
        case O::multiply:
        case O::divide:
        case O::negate:
        case O::square_root:
        case O::cube_root:
            return {};
        case O::add:
        case O::subtract:
            return first(factor);
        case O::absolute:
            return a.kind.has_celsius() ? std::optional<std::size_t>(0) : std::nullopt;
        case O::power:
            if (as_factor(b.kind) != 0.0) return 1;
            return as_factor(a.kind) != 0.0 && !b.constant ? std::optional<std::size_t>(0) : std::nullopt;
        case O::minimum:
        case O::maximum:
        case O::select:
            return first([&](const Kind& kind) { return factor(kind) || is_multiple(kind); });
        default:
            if (is_comparison(operation))
                return first([&](const Kind& kind) { return factor(kind) || is_multiple(kind); });
            return first([](const Kind& kind) { return as_factor(kind) != 0.0; });
    }
}

KindOfResult kind_of(Operation operation, const Operand& a, const Operand& b, const Operand& c) {
    KindOfResult result = kind_by_operands(operation, a, b, c);
    result.kind.readings = readings_of(operation, a, b, result.kind);
    result.kind.on_circle = stays_on_circle(operation, a, b, c);
    return result;
}

}  // namespace covaria::equation
