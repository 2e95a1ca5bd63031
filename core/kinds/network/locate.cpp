// Places of targets and stations from given readings: the least sum of squares of the readings and of what is
// stated of the stations, whatever the nominal coordinates are.
#include <algorithm>
#include <limits>
#include <utility>

#include "core/kinds/network/adjustment.h"
#include "core/kinds/network/equations.h"
#include "core/kinds/network/setup.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

/// Input quantities at their estimates.
std::vector<double> stated_values(const NetworkSetup& setup) {
    std::vector<double> x;
    for (std::size_t k = 0; k < setup.stations; ++k)
        for (const Sensor& sensor : setup.sensors)
            for (const double coordinate : sensor->station().coordinates) x.push_back(coordinate);
    for (const Target& target : setup.targets)
        for (const Sight& sight : target.sights)
            for (std::size_t i = 0; i < 3; ++i)
                if (sight.has[i]) x.push_back(i == 1 && sight.overhead ? 0.0 : sight.reading[i]);
    for (const ScaleBar& bar : setup.bars) x.push_back(bar.length);
    return x;
}

bool stands_exactly(const SensorSource& sensor) {
    return std::ranges::all_of(sensor.station_components(), [](const UncertaintyComponent& c) {
        return !(c.distribution.standard_uncertainty() > 0.0);
    });
}

/// Estimates targets by the weights of the last round, then stations by the residuals that they leave, then
/// the weights where these are now: a Gauss-Newton method for both, which ends where the sum is least.
class Location {
public:
    Location(NetworkSetup& setup, Problems& problems) : setup_(setup), problems_(problems) {
        const bool stations_too =
            setup.weights == Weights::with_stations &&
            !std::ranges::all_of(setup.sensors, [](const Sensor& sensor) { return stands_exactly(*sensor); });
        if (!stations_too) return;
        for (std::size_t k = 0; k < setup.stations; ++k)
            for (const Sensor& sensor : setup.sensors)
                setup.found.push_back({{}, StationGeometry(sensor->station())});
    }

    void run() {
        if (!weigh()) return;
        double before = std::numeric_limits<double>::infinity();
        for (int round = 0; round < most_rounds; ++round) {
            double moved = 0.0;
            if (!move_targets(moved) || !move_stations(moved)) return refuse();
            linearise_sights(setup_);
            if (!weigh()) return;
            const bool at_rounding = moved < 1e3 * enough && moved > 0.5 * before;
            if (moved < enough || at_rounding) return problems_.take(found_, {});
            before = moved;
        }
        refuse();
    }

private:
    static constexpr int most_rounds = 40;
    static constexpr double enough = 1e-10;  // m, rad

    void refuse() {
        problems_.error(
            network_fields().place(&StatedNetwork::readings),
            tell<"the readings do not lead to a position of every target: the estimation does not converge "
                 "from the nominal coordinates; look for exchanged or mistyped readings">());
    }

    /// Finds the weights at the present places; reports what is wrong with those.
    bool weigh() {
        found_ = {};
        find_weights(setup_, found_);
        if (!found_.has_errors()) return true;
        problems_.take(found_, {});
        return false;
    }

    bool move_targets(double& moved) {
        const std::vector<double> x = stated_values(setup_);
        std::vector<double> y(setup_.outputs());
        Outputs<double> out(y.data());
        std::vector<std::vector<SharedMove>>
            moves;  // far from the estimates the stations wait for the targets
        for (JointSetUp& joint : setup_.set_ups) moves.push_back(std::exchange(joint.moves, {}));
        const bool found = all_targets<double>(setup_, Inputs<double>(x.data()), out) && out.finite();
        for (std::size_t k = 0; k < moves.size(); ++k) setup_.set_ups[k].moves = std::move(moves[k]);
        if (!found) return false;
        for (std::size_t t = 0; t < setup_.targets.size(); ++t) {
            const Eigen::Vector3d at(y[3 * t], y[3 * t + 1], y[3 * t + 2]);
            moved = std::max(moved, (at - setup_.targets[t].nominal).norm());
            setup_.targets[t].nominal = at;
        }
        return true;
    }

    /// Stations of set-ups whose targets are estimated together; one target by itself says little of them.
    bool move_stations(double& moved) {
        if (setup_.found.empty()) return true;
        for (const JointSetUp& joint : setup_.set_ups) {
            if (!joint.together() || joint.by_itself()) continue;
            const Sensitivities s = sensitivities_of(setup_, joint);
            const Eigen::VectorXd by_u = s.u.cwiseInverse();
            const Eigen::VectorXd shared = estimate_of_shared(by_u.asDiagonal() * s.shared) *
                                           by_u.cwiseProduct(residuals_of(setup_, joint));
            if (!shared.allFinite()) return false;
            Eigen::Index column = 0;
            for (std::size_t k = 0; k < setup_.sensors.size(); ++k) {
                column += static_cast<Eigen::Index>(setup_.sensors[k]->systematic().size());
                move_station(joint.index, k, shared.segment<6>(column), moved);
                column += 6;
            }
        }
        return true;
    }

    /// `deviations`: of what was stated from where the station is, of standard uncertainty one each.
    void move_station(std::size_t set_up, std::size_t sensor, const Eigen::VectorXd& deviations,
                      double& moved) {
        const SensorSource& source = *setup_.sensors[sensor];
        const Eigen::VectorXd by = -station_moves(source) * deviations;
        FoundStation& found = setup_.found[set_up * setup_.sensors.size() + sensor];
        Station station = source.station();
        for (std::size_t i = 0; i < 6; ++i) {
            moved = std::max(moved, std::abs(by[static_cast<Eigen::Index>(i)] - found.moved[i]));
            found.moved[i] = by[static_cast<Eigen::Index>(i)];
            station.coordinates[i] += found.moved[i];
        }
        found.geometry = StationGeometry(station);
    }

    NetworkSetup& setup_;
    Problems& problems_;
    Problems found_;
};

/// Warns of targets far from where they were said to be: one mistyped reading, or two exchanged names.
void warn_of_far_nominals(const NetworkSetup& setup, Problems& problems) {
    constexpr double least_share = 0.01;  // as a part of the distance to the nearest station
    constexpr std::size_t most_single = 10;
    std::vector<std::size_t> far;
    for (std::size_t t = 0; t < setup.targets.size(); ++t) {
        const Target& target = setup.targets[t];
        double nearest = std::numeric_limits<double>::infinity();
        for (const Sight& sight : target.sights)
            nearest = std::min(nearest,
                               (setup.station(target, sight).X_WS().translation() - target.nominal).norm());
        if ((target.nominal - setup.stated[t]).norm() > least_share * nearest) far.push_back(t);
    }
    for (std::size_t i = 0; i < std::min(far.size(), most_single); ++i) {
        const Target& target = setup.targets[far[i]];
        const double mm = 1e3 * (target.nominal - setup.stated[far[i]]).norm();
        problems.warning(
            network_fields().place(&StatedNetwork::targets, far[i]),
            tell<"the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names "
                 "or a "
                 "unit that was mixed up (the result does not depend on the nominal coordinates)">(
                target.name, Message::number(format_short(mm))));
    }
    if (far.size() > most_single)
        problems.warning(network_fields().place(&StatedNetwork::targets),
                         tell<"the readings find %1 further targets far from their nominal coordinates">(
                             far.size() - most_single));
}

}  // namespace

void locate(NetworkSetup& setup, Problems& problems) {
    Location(setup, problems).run();
    if (!problems.has_errors()) warn_of_far_nominals(setup, problems);
}

}  // namespace covaria::network
