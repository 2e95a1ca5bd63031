// Numbers and quantities as people type and read them, in their locale.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

#include "core/base/error.h"
#include "core/base/unit.h"
#include "core/text/numbers.h"

namespace covaria::ui {

/// "6.1×10⁻⁵" becomes "6.1e-5", the power of ten as programs write it; other texts stay.
QString with_plain_exponent(QString text);

/// "1.000 25 V" becomes "1.00025 V": the number at its begin loses the spaces between groups of digits.
QString without_groups(const QString& text);

/// A number in the locale's writing, or with a decimal point, powers of ten in either form; no digit
/// grouping. Empty: not a number.
std::optional<double> parse_number(const QString& text, const QLocale& locale);

/// Unit as typed: "um", "µm", "°", "N·m". Error: unknown unit.
Result<Unit> parse_unit(const QString& text);

/// "0.5 um", "1,5", "12 °C"; a number without a unit is in `unit`. An empty text is an empty optional.
/// Errors: not a number, unknown unit, a unit of another dimension than `unit`.
Result<std::optional<Quantity>> parse_quantity(const QString& text, const Unit& unit, const QLocale& locale);

/// The parts of "100.021 47(35) g", a value with the standard uncertainty of its last digits in parentheses,
/// or of "100.021 47(0.000 35) g" (JCGM 100 7.2.2): "100.02147 g", "0.00035 g".
struct ConciseText {
    QString value, uncertainty;
};
/// Empty: the text is none of these.
std::optional<ConciseText> concise_parts(const QString& text);

/// Shortest text that reads back to the same number.
QString number_text(double value, const QLocale& locale);
/// Number and unit: "0.5 µm"; the unit one is left out.
QString quantity_text(const Quantity& quantity, const QLocale& locale);

/// The number in another unit of the same dimension, cleaned of the last digit's conversion noise.
double converted(double value, const Unit& from, const Unit& to);
/// A difference or an uncertainty in another unit, without the zero of degC, cleaned likewise.
double converted_interval(double value, const Unit& from, const Unit& to);

}  // namespace covaria::ui
