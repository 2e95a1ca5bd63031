// Units of measurement: parsing ("um", "1/K", "N*m", "degC"), dimensions, conversion to and from SI.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace covaria {

/// Exponents of length, mass, time, current, temperature, amount, luminous intensity, plane angle.
/// Plane angle is kept apart so that a length typed into an angle field is refused.
struct Dimension {
    std::array<std::int8_t, 8> exponents{};
    bool operator==(const Dimension&) const = default;
    bool is_one() const { return *this == Dimension{}; }
};

class Unit {
public:
    Unit() = default;  ///< the unit one
    /// Parses products, quotients (from left to right) and powers of known units: "mm", "1/K", "um/m", "N*m",
    /// "mV/V", "m/s^2" or "m/s2", "W/(m*K)" or "W/(m K)", "degC", "arcsec", "%". Both "u" and the micro sign
    /// are read as micro; signs for degree, ohm, product and powers are accepted too. In a compound, degC
    /// stands for an interval of temperature. Error: unknown or malformed unit.
    static Result<Unit> parse(std::string_view text);
    /// Makes a unit from a literal in code that is known to be right; terminates on a malformed text.
    static Unit of(std::string_view text);

    const std::string& text() const { return text_; }  ///< plain ASCII, as written in files ("um", "m/s^2")
    const std::string& display() const { return display_; }  ///< text for people ("µm", "°", "N·m")
    const Dimension& dimension() const { return dimension_; }

    double to_si(double value) const { return interval_to_si(value) + offset_; }
    double from_si(double value) const { return interval_from_si(value - offset_); }
    /// Conversion of differences and uncertainties: without the offset of degC.
    double interval_to_si(double value) const { return value * numerator_ / denominator_; }
    double interval_from_si(double value) const { return value * denominator_ / numerator_; }

    /// Whether zero on the scale is not zero (degC): such a unit states values, `interval()` their
    /// differences.
    bool has_offset() const { return offset_ != 0.0; }
    /// The unit of differences and uncertainties of values in this unit: K for degC, else itself.
    Unit interval() const;

    bool operator==(const Unit& other) const { return text_ == other.text_; }

private:
    std::string text_ = "1";
    std::string display_ = "1";
    Dimension dimension_{};
    // Kept as a quotient: a millimetre is the exact 1/1000, not the rounded 0.001, so 0.066 mm is 6.6e-5 m to
    // the last bit.
    double numerator_ = 1.0;
    double denominator_ = 1.0;
    double offset_ = 0.0;
};

/// A number as somebody typed it, with its unit: nothing is lost by conversion until `si()` is asked for.
struct Quantity {
    double value = 0.0;
    Unit unit = {};
    double si() const { return unit.to_si(value); }
    bool operator==(const Quantity&) const = default;
};

}  // namespace covaria
