#include "core/kinds/instruments/linear_reading.h"
#include "core/kinds/instruments/sensor.h"
#include "core/quantity/input_quantity.h"

#include <cmath>

namespace covaria {

double LinearReading::scale(Observable observable) const {
    return observable == Observable::azimuth ? azimuth_scale : 1.0;
}

double LinearReading::effect_of(const SystematicDeviation& deviation, Observable observable) const {
    const double effect = deviation.effect(observable, v);
    return observable == Observable::azimuth && !overhead ? effect / v.head<2>().norm() : effect;
}

LinearReading linear_reading(const Station& station, const Eigen::Vector3d& p_W) {
    const StationGeometry geometry(station);
    const Eigen::Vector3d v = geometry.in_axes(p_W);
    return linear_reading(geometry, p_W, std::atan2(v.y(), v.x()));
}

LinearReading linear_reading(const StationGeometry& station, const Eigen::Vector3d& p_W, double azimuth) {
    return {reading_sensitivity(station, p_W, azimuth), station.in_axes(p_W)};
}

std::vector<UncertaintyComponent> shared_components(const SensorSource& sensor) {
    std::vector<UncertaintyComponent> components;
    for (const SystematicDeviation& s : sensor.systematic()) components.push_back(s.component);
    for (std::size_t i = 0; i < 6; ++i) {
        const std::string number = std::to_string(i + 1);
        if (sensor.station_correlations().empty())
            components.push_back(sensor.station_components()[i]);
        else
            components.push_back(
                {.id = "station." + number,
                 .name = tell<"station, combination %1">(number),
                 .unit = Unit::of("1"),
                 .distribution = Distribution::normal(1.0),
                 .origin = tell<"instrument: standard uncertainties and correlation of the station">()});
    }
    return components;
}

Eigen::VectorXd shared_uncertainties(const SensorSource& sensor) {
    const auto own = static_cast<Eigen::Index>(sensor.systematic().size());
    Eigen::VectorXd u(own + 6);
    for (Eigen::Index k = 0; k < own; ++k)
        u[k] = sensor.systematic()[static_cast<std::size_t>(k)].component.distribution.standard_uncertainty();
    for (std::size_t i = 0; i < 6; ++i)
        u[own + static_cast<Eigen::Index>(i)] =
            sensor.station_correlations().empty()
                ? sensor.station_components()[i].distribution.standard_uncertainty()
                : 1.0;
    return u;
}

Eigen::Matrix<double, 6, 6> station_moves(const SensorSource& sensor) {
    if (!sensor.station_correlations().empty()) return station_factor(sensor);
    return Eigen::Matrix<double, 6, 1>(shared_uncertainties(sensor).tail<6>()).asDiagonal();
}

Eigen::Matrix<double, 3, Eigen::Dynamic> shared_effects(const SensorSource& sensor,
                                                        const LinearReading& reading) {
    const auto own = static_cast<Eigen::Index>(sensor.systematic().size());
    Eigen::Matrix<double, 3, Eigen::Dynamic> effects(3, own + 6);
    for (Eigen::Index k = 0; k < own; ++k)
        for (Observable o : observables)
            effects(static_cast<int>(o), k) =
                reading.effect_of(sensor.systematic()[static_cast<std::size_t>(k)], o);
    if (sensor.station_correlations().empty())
        effects.rightCols<6>() = -reading.to_station;
    else
        effects.rightCols<6>() = -reading.to_station * station_factor(sensor);
    return effects;
}

}  // namespace covaria
