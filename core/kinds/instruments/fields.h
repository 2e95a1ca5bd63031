// The set-up of a sensor.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/instruments/sensor.h"
#include "core/setup/fields.h"

namespace covaria {

enum class InstrumentKind { total_station, tracker, scanner, camera, distance_meter, generic };

/// The set-up as typed, SI.
struct StatedInstrument {
    PoseValue placement;
    StationAngles angles = StationAngles::zyx;
    InstrumentKind kind = InstrumentKind::total_station;
    bool reads_distance = true, reads_azimuth = true, reads_elevation = true;
    double distance_constant = 0.0;  ///< a, m
    double distance_scale = 0.0;     ///< b of a + b L
    double angle_azimuth = 0.0;      ///< rad
    double angle_elevation = 0.0;    ///< rad
    double across_constant = 0.0;    ///< constant of both angles, across the line of sight, m
    std::string meaning;             ///< meaning of these five
    double view_nearest = 0.0, view_farthest = Range::infinity_value;
    std::optional<double> view_azimuth, view_elevation;  ///< full angles
    double u_scale = 0.0, u_zero = 0.0, u_index = 0.0, u_collimation = 0.0, u_axis_tilt = 0.0,
           u_beam_offset = 0.0, u_refraction = 0.0;
    std::string distribution;  ///< distribution of these seven
    std::array<double, 6> u_station{};
    std::string station_distribution;
    std::vector<StationCorrelation> correlations;
};
const Fields<StatedInstrument>& sensor_fields();

/// The six coordinates of a station, in order: keys of their standard uncertainties and what they are.
struct StationCoordinate {
    const char* key;     ///< "u_station_x"
    const char* symbol;  ///< "x_0"
    const char* name;
    const char* unit;
};
const std::array<StationCoordinate, 6>& station_coordinates();

}  // namespace covaria
