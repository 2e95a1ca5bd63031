// The fields of a sensor's set-up.
#pragma once

#include <array>

#include "core/setup/setup_schema.h"

namespace covaria {

/// Fields of the sections "Station", "Readings", "Specification", "Shared by all readings", "Uncertainty of
/// the station".
SetupSchema sensor_schema();

/// The six coordinates of a station, in order: keys of their standard uncertainties and what they are.
struct StationCoordinate {
    const char* key;     ///< "u_station_x"
    const char* symbol;  ///< "x_0"
    const char* name;
    const char* unit;
};
const std::array<StationCoordinate, 6>& station_coordinates();

}  // namespace covaria
