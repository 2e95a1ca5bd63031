#include "core/text/readable_unit.h"

#include <cmath>
#include <optional>

#include "core/text/display_units.h"

namespace covaria {

Unit readable_unit(double si, const Unit& usual) {
    const auto reads = [si](const Unit& unit) {
        const double shown = std::abs(unit.interval_from_si(si));
        return shown >= 1.0 && shown < 1000.0;
    };
    if (!(std::abs(si) > 0.0) || usual.has_offset() || reads(usual)) return usual;
    std::optional<Unit> best;
    for (const Unit& unit : DisplayUnits::choices(usual)) {
        // Prefixes, not other systems: a millimetre becomes a nanometre, and no inch.
        const double step = std::log10(unit.interval_from_si(usual.interval_to_si(1.0)));
        const bool is_prefix = std::abs(step / 3.0 - std::round(step / 3.0)) < 1e-9;
        if (is_prefix && reads(unit) && !best) best = unit;
    }
    return best.value_or(usual);
}

}  // namespace covaria
