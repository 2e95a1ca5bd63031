// Ticks of axes.
#include "ui/charts/ticks.h"

#include <algorithm>
#include <cmath>

#include "core/report/number_format.h"

namespace covaria::ui {
namespace {

double nice_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
}

/// Numbers from 0.001 to 100 000 are written out.
int exponent_for(double largest, double step) {
    if (largest < 1e5 && (largest >= 0.01 || step >= 1e-3)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

int decimals_of(double step) {
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
}

Ticks one_two_five(double low, double high, QChar mark) {
    Ticks result;
    for (int decade = static_cast<int>(std::floor(low)); decade <= high; ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double at = decade + std::log10(factor);
            if (at < low - 1e-9 || at > high + 1e-9) continue;
            result.ticks.push_back(
                {at, number_text(factor * std::pow(10.0, decade), std::max(0, -decade), mark)});
        }
    return result;
}

Ticks linear_on_logarithmic(double low, double high, int most, QChar mark) {
    Ticks result = linear_ticks(std::pow(10.0, low), std::pow(10.0, high), most, mark);
    for (Tick& tick : result.ticks) tick.at = std::log10(tick.at);
    return result;
}

}  // namespace

QString number_text(double value, int decimals, QChar decimal_mark) {
    QString text = QString::fromStdString(format_decimals(value, decimals));
    const bool negative = text.startsWith(u'-');
    if (negative) text.remove(0, 1);
    const auto point = text.indexOf(u'.');
    const auto whole = point < 0 ? text.size() : point;
    if (point >= 0) text[point] = decimal_mark;
    if (whole > 4)
        for (auto i = whole - 3; i > 0; i -= 3) text.insert(i, QChar(0x202f));
    return negative ? QChar(0x2212) + text : text;
}

QString power_of_ten(int exponent) {
    static const QString figures = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10");
    if (exponent < 0) text += QChar(0x207b);
    for (const QChar digit : QString::number(std::abs(exponent))) text += figures[digit.digitValue()];
    return text;
}

Ticks linear_ticks(double low, double high, int most, QChar decimal_mark) {
    Ticks result;
    if (!(high > low)) return result;
    const double step = nice_step((high - low) / std::max(most, 1));
    result.exponent = exponent_for(std::max(std::abs(low), std::abs(high)), step);
    const double unit = std::pow(10.0, result.exponent);
    const int decimals = decimals_of(step / unit);
    const double slack = 1e-9 * (high - low);
    for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
        result.ticks.push_back({i * step, number_text(i * step / unit, decimals, decimal_mark)});
    return result;
}

Ticks logarithmic_ticks(double low, double high, int most, QChar decimal_mark) {
    const int first = static_cast<int>(std::ceil(low - 1e-9)),
              last = static_cast<int>(std::floor(high + 1e-9));
    if (last - first >= 1) {
        Ticks result;
        const int step = std::max(1, static_cast<int>(std::ceil((last - first) / double(std::max(most, 1)))));
        for (int decade = first; decade <= last; decade += step)
            result.ticks.push_back({double(decade), power_of_ten(decade)});
        return result;
    }
    Ticks fine = one_two_five(low, high, decimal_mark);
    const bool enough = fine.ticks.size() >= 2 && static_cast<int>(fine.ticks.size()) <= most + 1;
    return enough ? fine : linear_on_logarithmic(low, high, most, decimal_mark);
}

QString title_with_exponent(const QString& title, int exponent) {
    if (exponent == 0) return title;
    const QString power = power_of_ten(exponent);
    const auto open = title.lastIndexOf(u'(');
    const auto reciprocal = title.lastIndexOf(QLatin1String("(1/"));
    if (reciprocal >= 0) return QString(title).replace(reciprocal + 1, 1, power);
    if (open < 0 || !title.endsWith(u')')) return title + QStringLiteral(" (%1)").arg(power);
    return QString(title).insert(open + 1, power + u' ');
}

}  // namespace covaria::ui
