// The readings of a target by a sensor, linearised: what the instrument alone and every network of it go by.
#pragma once

#include "core/kinds/instruments/sensor.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

/// Readings of a target by a sensor, to first order: a row for every observable.
struct LinearReading : ReadingSensitivity {
    Eigen::Vector3d v;  ///< the target in the sensor's axes

    /// Factor by which a reading's own deviation is multiplied.
    double scale(Observable observable) const;
    /// Change of the reading per unit of the component.
    double effect_of(const SystematicDeviation& deviation, Observable observable) const;
};
LinearReading linear_reading(const Station& station, const Eigen::Vector3d& p_W);
/// The same for an azimuth that was read, which decides what "across" is where the target is overhead.
LinearReading linear_reading(const StationGeometry& station, const Eigen::Vector3d& p_W, double azimuth);

/// Components that all readings of a sensor share, independent: its systematic deviations, then the six
/// coordinates of its station, or six combinations of them where they are correlated.
std::vector<UncertaintyComponent> shared_components(const SensorSource& sensor);
/// Their standard uncertainties.
Eigen::VectorXd shared_uncertainties(const SensorSource& sensor);
/// Moves of the station, six coordinates by the last six of them, per standard uncertainty: their covariance
/// is F Fᵀ.
Eigen::Matrix<double, 6, 6> station_moves(const SensorSource& sensor);
/// Change of the readings, less what the sensor is taken to see from its station, per unit of each of them:
/// 3 (by Observable) x components. A station that is thought to be further along makes a target seem further
/// along too: its columns are minus `to_station`.
Eigen::Matrix<double, 3, Eigen::Dynamic> shared_effects(const SensorSource& sensor,
                                                        const LinearReading& reading);

}  // namespace covaria
