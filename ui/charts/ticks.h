// Where an axis has its ticks and what they say: steps of 1, 2 or 5 times a power of ten.
#pragma once

#include <QString>
#include <vector>

namespace covaria::ui {

struct Tick {
    double at = 0.0;  ///< on the axis; of a logarithmic axis, log10 of the value
    QString text;
};

struct Ticks {
    std::vector<Tick> ticks;
    int exponent = 0;  ///< texts are in units of 10^exponent, which the axis' title says
};

/// Ticks inside [low, high], no more than `most` + 1; all texts have the same number of decimals.
Ticks linear_ticks(double low, double high, int most, QChar decimal_mark = u'.');
/// The same for log10 of the value: whole decades, or 1-2-5 inside a decade.
Ticks logarithmic_ticks(double low, double high, int most, QChar decimal_mark = u'.');
/// "x (mm)" with 10^-6 becomes "x (10⁻⁶ mm)".
QString title_with_exponent(const QString& title, int exponent);
/// A number with a true minus sign, rounded to `decimals`, digits in groups of three from 10 000 up.
QString number_text(double value, int decimals, QChar decimal_mark = u'.');
/// 10 to that power, in superscript figures.
QString power_of_ten(int exponent);

}  // namespace covaria::ui
