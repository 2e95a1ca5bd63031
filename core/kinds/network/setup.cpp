// Reads the set-up of "points from sensors".
#include "core/kinds/network/setup.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/kinds/instruments/sensor.h"
#include "core/kinds/network/readings.h"
#include "core/math/frames.h"

namespace covaria::network {

namespace {

constexpr double least_sine = 1e-6;

using Stated = StatedNetwork;

template <class Row>
std::string place(std::vector<Row> Stated::*table, std::size_t row) {
    return network_fields().place(table, row);
}

/// Indices of the sensors (by id) and of the targets (by name) in the network.
struct Names {
    std::map<std::string, std::size_t> sensors, targets;

    std::size_t target_called(const std::string& name, const std::string& path, Problems& problems) const {
        const auto found = targets.find(name);
        if (found != targets.end()) return found->second;
        problems.error(path, tell<"there is no target %1">(name));
        return 0;
    }
};

/// The sights of all targets: as read, or as the sensors would see the nominal targets.
class SightReading {
public:
    SightReading(const Stated& stated, const Names& names, NetworkSetup& network, Problems& problems)
        : stated_(stated), names_(names), network_(network), problems_(problems) {}

    void read() {
        if (network_.measured)
            take_readings();
        else
            predict_readings();
        if (problems_.has_errors()) return;
        for (Target& target : network_.targets) {
            if (network_.measured) target.nominal = start_of(target);
            check(target);
        }
        if (!problems_.has_errors()) linearise_sights(network_);
    }

private:
    void predict_readings() {
        for (std::size_t t = 0; t < network_.targets.size(); ++t) {
            const std::string path = place(&Stated::targets, t);
            for (std::size_t s = 0; s < network_.sensors.size(); ++s) {
                const SensorSource& source = *network_.sensors[s];
                if (!sees(s, t)) continue;
                Sight sight;
                sight.sensor = s;
                for (std::size_t i = 0; i < 3; ++i) {
                    sight.has[i] = source.reads(observables[i]);
                    sight.source[i] = path;
                }
                sight.reading = readings_of(network_.geometry[s], network_.targets[t].nominal);
                network_.targets[t].sights.push_back(sight);
            }
        }
        warn_of_unseen();
    }

    bool sees(std::size_t s, std::size_t t) {
        const SensorSource& source = *network_.sensors[s];
        if (source.sees(network_.geometry[s].in_axes(network_.targets[t].nominal))) return true;
        unseen_.push_back({s, t});
        return false;
    }

    /// Warns of sensors that see nothing of a target, one by one, or in large networks by sensor.
    void warn_of_unseen() {
        constexpr std::size_t most_single = 30;
        std::map<std::size_t, std::size_t> counts;
        for (const auto& [s, t] : unseen_) {
            ++counts[s];
            if (unseen_.size() <= most_single)
                problems_.warning(place(&Stated::targets, t),
                                  tell<"%1 does not see target %2: it is out of its range or field of view">(
                                      network_.sensors[s].name, network_.targets[t].name));
        }
        if (unseen_.size() <= most_single) return;
        for (const auto& [s, count] : counts)
            problems_.warning(
                network_fields().place(&Stated::targets),
                tell<"%1 does not see %2 of the %3 targets: they are out of its range or field of view">(
                    network_.sensors[s].name, count, network_.targets.size()));
    }

    void take_readings() {
        for (std::size_t row = 0; row < stated_.readings.size(); ++row) {
            const Stated::Reading& stated = stated_.readings[row];
            const std::string path = place(&Stated::readings, row);
            const std::size_t target = names_.target_called(stated.target, path, problems_);
            const auto sensor = names_.sensors.find(stated.sensor.id);
            if (sensor == names_.sensors.end()) {
                problems_.error(path, tell<"the sensor %1 is not listed in the network">(stated.sensor.id));
                continue;
            }
            Sight sight;
            sight.sensor = sensor->second;
            for (std::size_t i = 0; i < 3; ++i) {
                sight.has[i] = stated.values[i].has_value();
                sight.reading[i] = stated.values[i].value_or(0.0);
                sight.source[i] = path;
                if (!sight.has[i] || stated.sensor->reads(observables[i])) continue;
                const auto& columns = network_fields().columns(&Stated::readings);
                const std::string& column = columns.key(&Stated::Reading::values, i);
                problems_.error(path + "/" + column, tell<"%1 reads no %2 according to its description">(
                                                         stated.sensor.name, column));
            }
            if (network_.targets[target].sights.size() >= most_sensors)
                problems_.error(path, tell<"more than %1 rows for target %2">(most_sensors,
                                                                              network_.targets[target].name));
            network_.targets[target].sights.push_back(sight);
        }
    }

    /// Start of the search for a target: the place nearest to the lines and planes in which its angles were
    /// read, unless the nominal coordinates explain its readings better.
    Eigen::Vector3d start_of(const Target& target) const {
        Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
        Eigen::Vector3d g = Eigen::Vector3d::Zero();
        for (const Sight& sight : target.sights) {
            if (!sight.has[1]) continue;
            const Eigen::Isometry3d& X_WS = network_.station(target, sight).X_WS();
            const ReadDirections<double> e(sight.reading[1], sight.has[2] ? sight.reading[2] : 0.0);
            const auto add = [&](const Eigen::Vector3d& direction, double along) {
                const Eigen::Vector3d a = X_WS.linear() * direction;
                N += a * a.transpose();
                g += a * (a.dot(X_WS.translation() - target.nominal) + along);
            };
            add(e.azimuth, 0.0);
            if (sight.has[2]) add(e.elevation, 0.0);
            if (sight.has[2] && sight.has[0]) add(e.r, sight.reading[0]);
        }
        constexpr double least_spread = 1e-4;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of_lines(N);
        if (!(of_lines.eigenvalues()[0] > least_spread)) return target.nominal;
        const Eigen::Vector3d found =
            target.nominal + of_lines.eigenvectors() * of_lines.eigenvalues().cwiseInverse().asDiagonal() *
                                 of_lines.eigenvectors().transpose() * g;
        return misfit_at(target, found) < misfit_at(target, target.nominal) ? found : target.nominal;
    }

    /// Sum of squares of the residuals at p, as displacements.
    double misfit_at(const Target& target, const Eigen::Vector3d& p) const {
        double sum = 0.0;
        for (const Sight& sight : target.sights) {
            const Eigen::Vector3d v = network_.station(target, sight).in_axes(p);
            for (std::size_t i = 0; i < 3; ++i) {
                if (!sight.has[i]) continue;
                const double arm = i == 0 ? 1.0 : i == 1 ? v.head<2>().norm() : v.norm();
                sum += std::pow(arm * residual_of(network_, target, sight, i, p), 2);
            }
        }
        return sum;
    }

    void check(Target& target) {
        target.has_linear_start = false;
        for (const Sight& sight : target.sights) {
            const Sensor& sensor = network_.sensors[sight.sensor];
            const Eigen::Vector3d v = network_.station(target, sight).in_axes(target.nominal);
            if (v.norm() == 0.0)
                problems_.error(sight.source[0],
                                tell<"target %1 is at the place of %2">(target.name, sensor.name));
            else if (sensor->glyph() == "camera" && v.x() <= 0.0)
                problems_.error(sight.source[0],
                                tell<"target %1 is behind the camera %2">(target.name, sensor.name));
            target.rows += static_cast<std::size_t>(std::count(sight.has.begin(), sight.has.end(), true));
            target.has_linear_start = target.has_linear_start || (sight.has[1] && sight.has[2]);
        }
    }

    const Stated& stated_;
    const Names& names_;
    NetworkSetup& network_;
    Problems& problems_;
    std::vector<std::pair<std::size_t, std::size_t>> unseen_;  ///< sensor, target
};

class SetupReading {
public:
    SetupReading(const Stated& stated, Problems& problems) : stated_(stated), problems_(problems) {}

    std::optional<NetworkSetup> read() {
        take_choices();
        take_sensors();
        take_targets();
        if (problems_.has_errors()) return {};
        SightReading(stated_, names_, network_, problems_).read();
        if (problems_.has_errors()) return {};
        take_distances();
        take_angles();
        take_frames();
        take_scale_bars();
        if (problems_.has_errors()) return {};
        return std::move(network_);
    }

private:
    void take_choices() {
        network_.estimator = stated_.estimator;
        network_.weights =
            stated_.estimator == Estimator::nonlinear ? stated_.weights : Weights::observations_only;
        network_.measured = stated_.measured;
    }

    void take_sensors() {
        if (stated_.sensors.rows.size() > most_sensors)
            return problems_.error(
                sensor_list_fields().place(&SensorList::rows),
                tell<"a network has at most %1 sensors; divide it into several analyses">(most_sensors));
        network_.sensors = sensors_of(stated_.sensors, problems_);
        for (std::size_t s = 0; s < network_.sensors.size(); ++s)
            names_.sensors.emplace(network_.sensors[s].id, s);
        for (const Sensor& sensor : network_.sensors) network_.geometry.emplace_back(sensor->station());
    }

    void take_targets() {
        std::size_t set_up = 0;
        for (std::size_t row = 0; row < stated_.targets.size(); ++row) {
            const Stated::Target& stated = stated_.targets[row];
            if (row > 0 && stated.new_set_up) ++set_up;
            if (!names_.targets.try_emplace(stated.name, row).second)
                problems_.error(place(&Stated::targets, row), tell<"two targets are called %1">(stated.name));
            network_.targets.push_back({.name = stated.name, .nominal = stated.nominal, .set_up = set_up});
            network_.stated.push_back(stated.nominal);
        }
        for (std::size_t t = 0; t < network_.targets.size(); ++t) {
            if (network_.set_ups.size() <= network_.targets[t].set_up)
                network_.set_ups.push_back({network_.targets[t].set_up, t, 0, {}});
            ++network_.set_ups.back().targets;
        }
        network_.stations = network_.set_ups.size();
    }

    std::size_t called(const std::string& name, const std::string& path) {
        return names_.target_called(name, path, problems_);
    }

    void take_distances() {
        for (std::size_t row = 0; row < stated_.distances.size(); ++row) {
            const std::string path = place(&Stated::distances, row);
            const std::size_t from = called(stated_.distances[row].from, path);
            const std::size_t to = called(stated_.distances[row].to, path);
            if (!problems_.has_errors() && (from == to || (nominal(from) - nominal(to)).norm() == 0.0))
                problems_.error(path, tell<"a distance needs two targets at different places">());
            network_.distances.push_back({from, to});
        }
    }

    void take_scale_bars() {
        for (std::size_t row = 0; row < stated_.bars.size(); ++row) {
            const Stated::Bar& stated = stated_.bars[row];
            ScaleBar bar{.u = stated.u,
                         .distribution = stated.distribution,
                         .constrains = stated.constrains,
                         .name = scale_bar_words(stated.from, stated.to),
                         .source = place(&Stated::bars, row)};
            bar.from = called(stated.from, bar.source);
            bar.to = called(stated.to, bar.source);
            if (!problems_.has_errors()) take_length(bar, stated.length);
            if (bar.constrains) check_constraint(bar);
            network_.bars.push_back(std::move(bar));
        }
    }

    void take_length(ScaleBar& bar, const std::optional<double>& length) {
        const double nominal_length = (nominal(bar.to) - nominal(bar.from)).norm();
        bar.length = nominal_length;
        if (nominal_length == 0.0)
            return problems_.error(bar.source,
                                   tell<"a calibrated length needs two targets at different places">());
        if (!length) {
            if (network_.measured) problems_.error(bar.source, tell<"the calibrated length is missing">());
            return;
        }
        if (network_.measured)
            bar.length = *length;
        else if (std::abs(*length - nominal_length) > std::max(5.0 * bar.u, 1e-3 * *length))
            problems_.warning(bar.source,
                              tell<"the nominal targets of the %1 are at another distance than its "
                                   "calibrated length; the design takes their distance">(words_of(bar)));
    }

    Message words_of(const ScaleBar& bar) const {
        return scale_bar_words(network_.targets[bar.from].name, network_.targets[bar.to].name);
    }

    void check_constraint(const ScaleBar& bar) {
        if (network_.weights != Weights::with_stations)
            return problems_.error(bar.source,
                                   tell<"a calibrated length can be a constraint only of the non-linear "
                                        "estimator with weights from readings and stations">());
        if (!problems_.has_errors() && network_.targets[bar.from].set_up != network_.targets[bar.to].set_up)
            problems_.error(bar.source,
                            tell<"the targets of the %1 belong to two set-ups, which are estimated one after "
                                 "the other: it can only be a check">(words_of(bar)));
    }

    const Eigen::Vector3d& nominal(std::size_t target) const { return network_.targets[target].nominal; }

    void take_angles() {
        for (std::size_t row = 0; row < stated_.angles.size(); ++row) {
            const std::string path = place(&Stated::angles, row);
            const auto& [from, at, to] = stated_.angles[row];
            const Angle angle{called(from, path), called(at, path), called(to, path)};
            if (problems_.has_errors()) continue;
            const double sine = sine_of_corner(nominal(angle.at), nominal(angle.from), nominal(angle.to));
            if (!(sine > least_sine))
                problems_.error(path, tell<"the targets of an angle must be at three places off one line: at "
                                           "0° and 180° an angle has no sign and no derivative">());
            network_.angles.push_back(angle);
        }
    }

    void take_frames() {
        std::set<std::string> names;
        for (std::size_t row = 0; row < stated_.frames.size(); ++row) {
            const std::string path = place(&Stated::frames, row);
            const auto& [name, origin, on_x, in_xy] = stated_.frames[row];
            TargetFrame frame{name, {called(origin, path), called(on_x, path), called(in_xy, path)}};
            if (!names.insert(frame.name).second || names_.targets.count(frame.name) > 0)
                problems_.error(path, tell<"the name %1 is taken by another frame or a target">(frame.name));
            if (problems_.has_errors()) continue;
            const auto& t = frame.targets;
            if (!(sine_of_corner(nominal(t[0]), nominal(t[1]), nominal(t[2])) > least_sine))
                problems_.error(path,
                                tell<"the three targets of frame %1 lie on one line: its axes are undefined">(
                                    frame.name));
            else if (std::abs(frame_of(network_, frame).linear()(2, 0)) > 1.0 - least_sine)
                problems_.warning(
                    path,
                    tell<"the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)">(
                        frame.name));
            network_.frames.push_back(std::move(frame));
        }
    }

    const Stated& stated_;
    Problems& problems_;
    NetworkSetup network_;
    Names names_;
};

}  // namespace

Message scale_bar_words(const std::string& from, const std::string& to) {
    return tell<"scale bar %1 – %2">(from, to);
}

std::vector<Sensor> sensors_of(const SensorList& list, Problems& problems) {
    std::vector<Sensor> sensors;
    std::set<std::string> ids;
    for (std::size_t row = 0; row < list.rows.size(); ++row) {
        const Sensor& sensor = list.rows[row].sensor;
        if (!sensor) continue;
        if (ids.insert(sensor.id).second)
            sensors.push_back(sensor);
        else
            problems.error(sensor_list_fields().place(&SensorList::rows, row),
                           tell<"the sensor %1 is listed twice">(sensor.name));
    }
    return sensors;
}

Eigen::Isometry3d frame_of(const NetworkSetup& setup, const TargetFrame& frame) {
    const auto p = [&](std::size_t i) { return setup.targets[frame.targets[i]].nominal; };
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = axes_3_2_1<double>(p(0), p(1), p(2), ThirdPoint::positive_y);
    X.translation() = p(0);
    return X;
}

LinearReading sensitivity_of(const NetworkSetup& setup, const Target& target, const Sight& sight) {
    return linear_reading(setup.station(target, sight), target.nominal,
                          sight.has[1] ? sight.reading[1] : 0.0);
}

void linearise_sights(NetworkSetup& setup) {
    using Moved = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;
    for (Target& target : setup.targets)
        for (Sight& sight : target.sights) {
            const SensorSource& source = *setup.sensors[sight.sensor];
            const LinearReading reading = sensitivity_of(setup, target, sight);
            sight.overhead = reading.overhead;
            for (std::size_t i = 0; i < 3; ++i) {
                if (!sight.has[i]) continue;
                const Observable o = observables[i];
                sight.u[i] =
                    source.reading(o, reading.v).distribution.standard_uncertainty() * reading.scale(o);
                if (setup.found.empty()) continue;
                const FoundStation& station =
                    setup.found[target.set_up * setup.sensors.size() + sight.sensor];
                sight.raised[i] =
                    reading.to_station.row(static_cast<Eigen::Index>(i)).dot(Moved(station.moved.data()));
            }
        }
}

double residual_of(const NetworkSetup& setup, const Target& target, const Sight& sight, std::size_t i,
                   const Eigen::Vector3d& p) {
    const StationGeometry& station = setup.station(target, sight);
    const double difference = sight.reading[i] - readings_of(station, p)[i];
    if (i != 1) return difference + sight.raised[i];
    if (!sight.overhead) return std::remainder(difference, 2.0 * std::numbers::pi) + sight.raised[i];
    const Eigen::Vector3d v = station.in_axes(p);
    return std::sin(sight.reading[1]) * v.x() - std::cos(sight.reading[1]) * v.y() + sight.raised[i];
}

std::array<double, 3> readings_of(const StationGeometry& station, const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = station.in_axes(p);
    return {v.norm(), std::atan2(v.y(), v.x()), std::atan2(v.z(), v.head<2>().norm())};
}

std::optional<NetworkSetup> network_setup(const StatedNetwork& stated, Problems& problems) {
    return SetupReading(stated, problems).read();
}

std::optional<NetworkSetup> read_network_setup(const SetupReader& setup, const AssetLibrary& assets,
                                               Problems& problems) {
    return network_setup(network_fields().read(setup, assets, problems), problems);
}

}  // namespace covaria::network
