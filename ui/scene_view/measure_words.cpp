#include "ui/scene_view/measure_words.h"

#include "core/result/result_style.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "ui/models/number_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int digits_without_u = 7;

Unit unit_of(const Measurement& measurement, const MeasureStyle& style, const LengthUnit& length) {
    if (measurement.is_angle()) return style.units.of(Unit::of("deg"));
    return style.units.of(Unit::of(length.text == "µm" ? "um" : length.text));
}

QString with_unit(const std::string& number, const Unit& unit) {
    return to_qt(grouped_digits(number, user_numbers()) + unit_after_number(unit));
}

QString name(const Measurement& measurement, std::size_t i) {
    return QStringLiteral("<b>%1</b>").arg(to_qt(measurement.names[i]).toHtmlEscaped());
}

QString reason(const Measurement& measurement) {
    const QString place = to_qt(measurement.place).toHtmlEscaped();
    switch (measurement.reason) {
        case NotStated::none:
            return {};
        case NotStated::no_result:
            return tr("the picture shows no result of the analysis");
        case NotStated::no_quantities:
            return tr("the coordinates of %1 are no quantities of the analysis").arg(place);
        case NotStated::constant:
            return tr("%1 is a constant: no uncertainty is stated for it").arg(place);
        case NotStated::not_finite:
            return tr("the joint covariance of the points is not known");
        case NotStated::not_linear:
            return measurement.is_angle()
                       ? tr("the angle is too close to 0° or 180°, or the points are too close, for the law "
                            "of "
                            "propagation")
                       : tr("the points are too close to each other for the law of propagation");
    }
    return {};
}

}  // namespace

QString measured_value(const Measurement& measurement, const MeasureStyle& style, const LengthUnit& length) {
    const Unit unit = unit_of(measurement, style, length);
    const double value = unit.interval_from_si(measurement.value);
    if (!measurement.u) return with_unit(format_significant(value, digits_without_u), unit);
    const double u = unit.interval_from_si(*measurement.u);
    return tr("%1, u = %2")
        .arg(with_unit(format_to_match(value, u, style.digits), unit),
             with_unit(format_significant(u, style.digits), unit));
}

QString measured_words(const Measurement& measurement, const MeasureStyle& style, const LengthUnit& length) {
    const QString value = measured_value(measurement, style, length);
    QString text = measurement.is_angle()
                       ? tr("Angle at %1 between %2 and %3: %4")
                             .arg(name(measurement, 1), name(measurement, 0), name(measurement, 2), value)
                       : tr("Distance %1 to %2: %3").arg(name(measurement, 0), name(measurement, 1), value);
    if (!measurement.u) text += tr("; u not stated, because %1").arg(reason(measurement));
    return text;
}

}  // namespace covaria::ui
