// Reads the set-up of "points from sensors".
#include "core/kinds/network/setup.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/kinds/instruments/sensor.h"
#include "core/math/frames.h"

namespace covaria::network {

namespace {

constexpr double least_sine = 1e-6;

class SetupReading {
public:
    SetupReading(const SetupReader& setup, const AssetLibrary& assets, Problems& problems)
        : setup_(setup), assets_(assets), problems_(problems) {}

    std::optional<NetworkSetup> read() {
        read_choices();
        read_sensors();
        read_targets();
        read_distances();
        read_angles();
        read_frames();
        read_scale_bars();
        if (problems_.has_errors()) return {};
        if (network_.measured)
            read_readings();
        else
            predict_readings();
        for (Target& target : network_.targets) finish(target);
        if (problems_.has_errors()) return {};
        return std::move(network_);
    }

private:
    static std::string row_path(const char* table, std::size_t row) {
        return std::string("/") + table + "/rows/" + std::to_string(row);
    }

    void read_choices() {
        const std::string estimator = setup_.text("estimator");
        network_.estimator = estimator == "linear"         ? Estimator::linear
                             : estimator == "linear-start" ? Estimator::linear_start
                                                           : Estimator::nonlinear;
        network_.weights =
            network_.estimator == Estimator::nonlinear && setup_.text("weights") == "with-stations"
                ? Weights::with_stations
                : Weights::observations_only;
        network_.measured = setup_.text("evaluation") == "a-posteriori";
    }

    void read_sensors() {
        if (setup_.rows("sensors") > most_sensors)
            return problems_.error("/sensors", "a network has at most " + std::to_string(most_sensors) +
                                                   " sensors; divide it into several analyses");
        for (std::size_t row = 0; row < setup_.rows("sensors"); ++row) {
            const std::string id = setup_.cell_text("sensors", row, "sensor");
            const AssetLibrary::Entry* entry = assets_.find(id);
            if (!offers<SensorSource>(entry))
                problems_.error(row_path("sensors", row), "'" + id + "' is no sensor");
            else if (!sensor_index_.try_emplace(id, network_.sensors.size()).second)
                problems_.error(row_path("sensors", row), "the sensor " + entry->name + " is listed twice");
            else
                network_.sensors.push_back({id, entry->name.empty() ? id : entry->name, entry->asset});
        }
    }

    void read_targets() {
        std::size_t set_up = 0;
        for (std::size_t row = 0; row < setup_.rows("targets"); ++row) {
            Target target;
            target.name = setup_.cell_text("targets", row, "name");
            target.nominal = setup_.cell_vector("targets", row, "x");
            if (row > 0 && setup_.cell_flag("targets", row, "new_set_up")) ++set_up;
            target.set_up = set_up;
            if (!target_index_.try_emplace(target.name, row).second)
                problems_.error(row_path("targets", row), "two targets are called " + target.name);
            network_.targets.push_back(std::move(target));
        }
        for (std::size_t t = 0; t < network_.targets.size(); ++t) {
            if (network_.set_ups.size() <= network_.targets[t].set_up)
                network_.set_ups.push_back({network_.targets[t].set_up, t, 0, {}});
            ++network_.set_ups.back().targets;
        }
        network_.stations = network_.set_ups.size();
    }

    std::size_t target_called(const std::string& name, const std::string& path) {
        const auto found = target_index_.find(name);
        if (found != target_index_.end()) return found->second;
        problems_.error(path, "there is no target " + name);
        return 0;
    }

    void read_distances() {
        for (std::size_t row = 0; row < setup_.rows("distances"); ++row) {
            const std::string path = row_path("distances", row);
            const std::size_t from = target_called(setup_.cell_text("distances", row, "from"), path);
            const std::size_t to = target_called(setup_.cell_text("distances", row, "to"), path);
            const auto p = [&](std::size_t i) { return network_.targets[i].nominal; };
            if (!problems_.has_errors() && (from == to || (p(from) - p(to)).norm() == 0.0))
                problems_.error(path, "a distance needs two targets at different places");
            network_.distances.push_back({from, to});
        }
    }

    void read_scale_bars() {
        for (std::size_t row = 0; row < setup_.rows("scale_bars"); ++row) {
            ScaleBar bar;
            bar.source = row_path("scale_bars", row);
            const std::string from = setup_.cell_text("scale_bars", row, "from"),
                              to = setup_.cell_text("scale_bars", row, "to");
            bar.from = target_called(from, bar.source);
            bar.to = target_called(to, bar.source);
            bar.name = "scale bar " + from + " – " + to;
            bar.u = setup_.cell_number("scale_bars", row, "u");
            if (!setup_.cell_empty("scale_bars", row, "distribution"))
                bar.distribution = setup_.cell_text("scale_bars", row, "distribution");
            bar.constrains = setup_.cell_text("scale_bars", row, "role") == "constraint";
            if (!problems_.has_errors()) take_length(bar, row);
            if (bar.constrains) check_constraint(bar);
            network_.bars.push_back(std::move(bar));
        }
    }

    void take_length(ScaleBar& bar, std::size_t row) {
        const double nominal_length = (nominal(bar.to) - nominal(bar.from)).norm();
        bar.length = nominal_length;
        if (nominal_length == 0.0)
            return problems_.error(bar.source, "a calibrated length needs two targets at different places");
        if (setup_.cell_empty("scale_bars", row, "length")) {
            if (network_.measured) problems_.error(bar.source, "the calibrated length is missing");
            return;
        }
        const double length = setup_.cell_number("scale_bars", row, "length");
        if (network_.measured)
            bar.length = length;
        else if (std::abs(length - nominal_length) > std::max(5.0 * bar.u, 1e-3 * length))
            problems_.warning(bar.source, "the nominal targets of the " + bar.name +
                                              " are at another distance than its calibrated length; the "
                                              "design takes their distance");
    }

    void check_constraint(const ScaleBar& bar) {
        if (network_.weights != Weights::with_stations)
            return problems_.error(bar.source,
                                   "a calibrated length can be a constraint only of the non-linear estimator "
                                   "with weights from readings and stations");
        if (!problems_.has_errors() && network_.targets[bar.from].set_up != network_.targets[bar.to].set_up)
            problems_.error(bar.source, "the targets of the " + bar.name +
                                            " belong to two set-ups, which are estimated one after the "
                                            "other: it can only be a check");
    }

    const Eigen::Vector3d& nominal(std::size_t target) const { return network_.targets[target].nominal; }

    void read_angles() {
        for (std::size_t row = 0; row < setup_.rows("angles"); ++row) {
            const std::string path = row_path("angles", row);
            const auto target = [&](const char* column) {
                return target_called(setup_.cell_text("angles", row, column), path);
            };
            const Angle angle{target("from"), target("at"), target("to")};
            if (problems_.has_errors()) continue;
            const double sine = sine_of_corner(nominal(angle.at), nominal(angle.from), nominal(angle.to));
            if (!(sine > least_sine))
                problems_.error(path,
                                "the targets of an angle must be at three places off one line: at 0° "
                                "and 180° an angle has no sign and no derivative");
            network_.angles.push_back(angle);
        }
    }

    void read_frames() {
        std::set<std::string> names;
        for (std::size_t row = 0; row < setup_.rows("frames"); ++row) {
            const std::string path = row_path("frames", row);
            const auto target = [&](const char* column) {
                return target_called(setup_.cell_text("frames", row, column), path);
            };
            TargetFrame frame{setup_.cell_text("frames", row, "name"),
                              {target("origin"), target("on_x"), target("in_xy")}};
            if (!names.insert(frame.name).second || target_index_.count(frame.name) > 0)
                problems_.error(path, "the name " + frame.name + " is taken by another frame or a target");
            if (problems_.has_errors()) continue;
            const auto& t = frame.targets;
            if (!(sine_of_corner(nominal(t[0]), nominal(t[1]), nominal(t[2])) > least_sine))
                problems_.error(path, "the three targets of frame " + frame.name +
                                          " lie on one line: its axes are undefined");
            else if (std::abs(frame_of(network_, frame).linear()(2, 0)) > 1.0 - least_sine)
                problems_.warning(path, "the x-axis of frame " + frame.name +
                                            " is vertical: its Z-Y-X angles are undefined (gimbal lock)");
            network_.frames.push_back(std::move(frame));
        }
    }

    void predict_readings() {
        for (std::size_t t = 0; t < network_.targets.size(); ++t)
            for (std::size_t s = 0; s < network_.sensors.size(); ++s) {
                const SensorSource& source = network_.sensors[s].source();
                if (!sees(s, t)) continue;
                Sight sight;
                sight.sensor = s;
                for (std::size_t i = 0; i < 3; ++i) {
                    sight.has[i] = source.reads(observables[i]);
                    sight.source[i] = row_path("targets", t);
                }
                sight.reading = readings_of(source.station(), network_.targets[t].nominal);
                network_.targets[t].sights.push_back(sight);
            }
        warn_of_unseen();
    }

    bool sees(std::size_t s, std::size_t t) {
        const SensorSource& source = network_.sensors[s].source();
        if (source.sees(source.station().X_WS().inverse() * network_.targets[t].nominal)) return true;
        unseen_.push_back({s, t});
        return false;
    }

    /// One by one, or in large networks by sensor.
    void warn_of_unseen() {
        constexpr std::size_t most_single = 30;
        std::map<std::size_t, std::size_t> counts;
        for (const auto& [s, t] : unseen_) {
            ++counts[s];
            if (unseen_.size() <= most_single)
                problems_.warning(row_path("targets", t), network_.sensors[s].name + " does not see target " +
                                                              network_.targets[t].name +
                                                              ": it is out of its range or field of view");
        }
        if (unseen_.size() <= most_single) return;
        for (const auto& [s, count] : counts)
            problems_.warning("/targets", network_.sensors[s].name + " does not see " +
                                              std::to_string(count) + " of the " +
                                              std::to_string(network_.targets.size()) +
                                              " targets: they are out of its range or field of view");
    }

    void read_readings() {
        static const char* const columns[] = {"distance", "azimuth", "elevation"};
        for (std::size_t row = 0; row < setup_.rows("readings"); ++row) {
            const std::string path = row_path("readings", row);
            const std::size_t target = target_called(setup_.cell_text("readings", row, "target"), path);
            const std::string id = setup_.cell_text("readings", row, "sensor");
            const auto sensor = sensor_index_.find(id);
            if (sensor == sensor_index_.end()) {
                problems_.error(path, "the sensor " + id + " is not listed in the network");
                continue;
            }
            Sight sight;
            sight.sensor = sensor->second;
            for (std::size_t i = 0; i < 3; ++i) {
                sight.has[i] = !setup_.cell_empty("readings", row, columns[i]);
                if (sight.has[i]) sight.reading[i] = setup_.cell_number("readings", row, columns[i]);
                sight.source[i] = path;
                if (sight.has[i] && !network_.sensors[sight.sensor].source().reads(observables[i]))
                    problems_.error(path + "/" + columns[i], network_.sensors[sight.sensor].name +
                                                                 " reads no " + columns[i] +
                                                                 " according to its description");
            }
            if (network_.targets[target].sights.size() >= most_sensors)
                problems_.error(path, "more than " + std::to_string(most_sensors) + " rows for target " +
                                          network_.targets[target].name);
            network_.targets[target].sights.push_back(sight);
        }
    }

    void finish(Target& target) {
        bool located = false;
        for (Sight& sight : target.sights) {
            const Sensor& sensor = network_.sensors[sight.sensor];
            const Eigen::Vector3d v = sensor.source().station().X_WS().inverse() * target.nominal;
            if (v.norm() == 0.0) {
                problems_.error(sight.source[0],
                                "target " + target.name + " is at the place of " + sensor.name);
                continue;
            }
            if (sensor.source().glyph() == "camera" && v.x() <= 0.0)
                problems_.error(sight.source[0],
                                "target " + target.name + " is behind the camera " + sensor.name);
            const LinearReading reading = sensitivity_of(network_, sight, target.nominal);
            sight.overhead = reading.overhead;
            for (std::size_t i = 0; i < 3; ++i)
                if (sight.has[i]) take_uncertainty(target, sight, i, reading);
            located = located || (sight.has[1] && sight.has[2]);
        }
        target.has_linear_start = located;
    }

    void take_uncertainty(Target& target, Sight& sight, std::size_t i, const LinearReading& reading) {
        const SensorSource& source = network_.sensors[sight.sensor].source();
        const Observable o = observables[i];
        sight.u[i] = source.reading(o, reading.v).distribution.standard_uncertainty() * reading.scale(o);
        ++target.rows;
    }

    const SetupReader& setup_;
    const AssetLibrary& assets_;
    Problems& problems_;
    NetworkSetup network_;
    std::map<std::string, std::size_t> sensor_index_, target_index_;
    std::vector<std::pair<std::size_t, std::size_t>> unseen_;  ///< sensor, target
};

}  // namespace

Eigen::Isometry3d frame_of(const NetworkSetup& setup, const TargetFrame& frame) {
    const auto p = [&](std::size_t i) { return setup.targets[frame.targets[i]].nominal; };
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = axes_3_2_1<double>(p(0), p(1), p(2), ThirdPoint::positive_y);
    X.translation() = p(0);
    return X;
}

LinearReading sensitivity_of(const NetworkSetup& setup, const Sight& sight, const Eigen::Vector3d& p) {
    return linear_reading(setup.sensors[sight.sensor].source().station(), p,
                          sight.has[1] ? sight.reading[1] : 0.0);
}

std::array<double, 3> readings_of(const Station& station, const Eigen::Vector3d& p) {
    const Eigen::Vector3d v = station.X_WS().inverse() * p;
    return {v.norm(), std::atan2(v.y(), v.x()), std::atan2(v.z(), v.head<2>().norm())};
}

std::optional<NetworkSetup> read_network_setup(const SetupReader& setup, const AssetLibrary& assets,
                                               Problems& problems) {
    return SetupReading(setup, assets, problems).read();
}

}  // namespace covaria::network
