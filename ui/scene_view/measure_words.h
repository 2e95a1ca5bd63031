// The words of the measuring tool of the scene.
#pragma once

#include <QString>

#include "core/text/display_units.h"
#include "viz/scene/measurement.h"

namespace covaria::ui {

/// Units and digits of a read-out.
struct MeasureStyle {
    DisplayUnits units = {};
    int digits = 2;  ///< significant ones of u
};

/// "1 234.567 mm, u = 0.012 mm", or the value alone. Lengths in `length` unless the user chose a unit.
QString measured_value(const Measurement& measurement, const MeasureStyle& style, const LengthUnit& length);
/// The value with the measured items before it, and with the reason where u is not stated.
QString measured_words(const Measurement& measurement, const MeasureStyle& style, const LengthUnit& length);

}  // namespace covaria::ui
