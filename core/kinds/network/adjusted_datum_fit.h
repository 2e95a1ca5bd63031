// Whether the network that the readings draw is the one that the approximate coordinates of its datum draw.
#pragma once

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

/// The plane of an adjusted network laid onto the approximate coordinates of its datum, turned and grown as
/// fits best.
struct DatumFit {
    double scale = 1.0;   ///< size by the coordinates over size by the readings
    double misfit = 0.0;  ///< standard deviation of what is left, over that of the coordinates
};
/// Nothing where fewer than three points of the datum have coordinates.
std::optional<DatumFit> datum_fit(const AdjustedNetwork& network);
/// Warns where the coordinates draw another network: of another size, its mirror image, points exchanged, one
/// far off.
void check_datum(const AdjustedNetwork& network, Problems& problems);

}  // namespace covaria::network
