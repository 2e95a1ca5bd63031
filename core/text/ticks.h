// Ticks of an axis and their labels: steps of 1, 2 or 5 times a power of ten.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/text/numbers.h"

namespace covaria {

struct Tick {
    double at = 0.0;  ///< position on the axis; of a logarithmic axis, log10 of the value
    std::string text;
};

struct Ticks {
    std::vector<Tick> ticks;
    int exponent = 0;  ///< texts are in units of 10^exponent, which the axis' title says
};

/// Ticks inside [low, high], no more than `most` + 1; all texts have the same number of decimals.
/// `exponent`: their power of ten; empty: what suits the range.
Ticks linear_ticks(double low, double high, int most, const NumberLocale& locale = {},
                   std::optional<int> exponent = {});
/// The power of ten, a multiple of three, of an axis to `largest` whose numbers are not written out.
int axis_exponent(double largest);
/// The same for log10 of the value: whole decades, or 1-2-5 inside a decade.
Ticks logarithmic_ticks(double low, double high, int most, const NumberLocale& locale = {});

}  // namespace covaria
