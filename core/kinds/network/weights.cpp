// Weights of a network, and whether its targets can be localised at all.
#include <Eigen/Cholesky>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/kinds/instruments/sensor.h"
#include "core/kinds/network/adjustment.h"
#include "core/kinds/network/setup.h"
#include "core/math/decompositions.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

Message names_of(const NetworkSetup& setup, const Target& target) {
    std::string names;
    for (const Sight& sight : target.sights)
        names += (names.empty() ? "" : ", ") + setup.sensors[sight.sensor].name;
    return names.empty() ? tell<"no sensor">() : Message(names);
}

bool only_distances(const Target& target) {
    for (const Sight& sight : target.sights)
        if (sight.has[1] || sight.has[2]) return false;
    return true;
}

/// Smallest over largest extent of the stations: next to 0 where they lie in a plane.
double spread_off_a_plane(const NetworkSetup& setup, const Target& target) {
    Eigen::MatrixXd positions(3, static_cast<Eigen::Index>(target.sights.size()));
    for (std::size_t i = 0; i < target.sights.size(); ++i)
        positions.col(static_cast<Eigen::Index>(i)) =
            setup.station(target, target.sights[i]).X_WS().translation();
    positions.colwise() -= positions.rowwise().mean().eval();
    const Eigen::VectorXd values = singular_values(positions).singularValues();
    return values.size() < 3 || values[0] == 0.0 ? 0.0 : values[2] / values[0];
}

class WeightMaker {
public:
    WeightMaker(NetworkSetup& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    void make(Target& target, const std::string& path) {
        if (target.rows == 0) return refuse(target, path);
        Sensitivities s = sensitivities_at(setup_, target);
        if (!localises(s.to_point)) return refuse(target, path);
        s.u = weighting_uncertainties(s.to_point, s.u, s.shared);
        keep_weights(target, s.u);
        const Eigen::MatrixXd weighted = s.u.cwiseInverse().asDiagonal() * s.to_point;
        warn(target, path, 1.0 / singular_values(weighted).singularValues()[2]);
        const Eigen::MatrixXd own =
            least_squares_gain(s.to_point, s.u, Eigen::MatrixXd(s.u.size(), 0)) * s.u.asDiagonal();
        Eigen::Map<Eigen::Matrix3d>(target.inverse_normal.data()) = own * own.transpose();
        find_linear_start(target, s);
        if (setup_.estimator != Estimator::nonlinear && !target.has_linear_start)
            return problems_.error(
                path, tell<"target %1 has no linear equations that localise it (a distance without angles "
                           "has none): use the non-linear estimator">(target.name));
    }

private:
    void refuse(const Target& target, const std::string& path) {
        problems_.error(
            path, tell<"target %1 cannot be localised from what %2 read: the readings leave a direction "
                       "undetermined; add a sensor or a reading">(target.name, names_of(setup_, target)));
    }

    void warn(const Target& target, const std::string& path, double u) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Sight& sight : target.sights)
            nearest = std::min(nearest,
                               (setup_.station(target, sight).X_WS().translation() - target.nominal).norm());
        if (u > 0.01 * nearest)
            problems_.warning(
                path,
                tell<"target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m">(
                    target.name, Message::number(format_short(u)), Message::number(format_short(nearest))));
        if (only_distances(target) && spread_off_a_plane(setup_, target) < 1e-3)
            problems_.warning(path, tell<"the stations that measure target %1 lie in one plane and read "
                                         "distances only: its mirror image behind that plane fits as well; "
                                         "the one near the nominal coordinates is taken">(target.name));
    }

    static void keep_weights(Target& target, const Eigen::VectorXd& u) {
        Eigen::Index row = 0;
        for (Sight& sight : target.sights)
            for (std::size_t i = 0; i < 3; ++i)
                if (sight.has[i]) sight.u[i] = u[row++];
    }

    void find_linear_start(Target& target, const Sensitivities& s) {
        const Eigen::VectorXd scales = linear_scales(setup_, target);
        const Eigen::VectorXd values = singular_values(scales.asDiagonal() * s.to_point).singularValues();
        target.has_linear_start = values.size() == 3 && values[2] > 1e-9 * values[0];
    }

    NetworkSetup& setup_;
    Problems& problems_;
};

std::size_t rows_of(const NetworkSetup& setup, const JointSetUp& joint) {
    std::size_t rows = joint.bars.size();
    for (std::size_t t = 0; t < joint.targets; ++t) rows += setup.targets[joint.first + t].rows;
    return rows;
}

/// Set-ups with too many readings to estimate all their targets at once: each target by itself.
void divide_large_set_ups(NetworkSetup& setup, Problems& problems) {
    std::vector<JointSetUp> divided;
    for (JointSetUp& joint : setup.set_ups) {
        const std::size_t rows = rows_of(setup, joint);
        if (rows <= most_joint_rows) {
            divided.push_back(std::move(joint));
            continue;
        }
        if (!joint.bars.empty())
            problems.error(setup.bars[joint.bars.front()].source,
                           tell<"a calibrated length cannot be a constraint of a set-up with more than %1 "
                                "readings (this one has %2): make it a check">(most_joint_rows, rows));
        problems.warning(network_fields().place(&StatedNetwork::targets),
                         tell<"the %1 readings of one set-up are too many to be weighed together: each "
                              "target is estimated from its own readings, weighted with the stations">(rows));
        for (std::size_t t = 0; t < joint.targets; ++t) {
            setup.targets[joint.first + t].divided = true;
            divided.push_back({joint.index, joint.first + t, 1, {}});
        }
    }
    setup.set_ups = std::move(divided);
}

void assign_scale_bars(NetworkSetup& setup) {
    for (JointSetUp& joint : setup.set_ups) joint.bars.clear();
    for (std::size_t b = 0; b < setup.bars.size(); ++b)
        for (JointSetUp& joint : setup.set_ups)
            if (setup.bars[b].constrains && joint.index == setup.targets[setup.bars[b].from].set_up)
                joint.bars.push_back(b);
}

void keep_rows(const Eigen::MatrixXd& M, std::vector<double>& rows) {
    for (Eigen::Index i = 0; i < M.rows(); ++i)
        for (Eigen::Index k = 0; k < M.cols(); ++k) rows.push_back(M(i, k));
}

/// Without those that have no uncertainty.
Eigen::MatrixXd uncertain_columns(const Eigen::MatrixXd& shared) {
    Eigen::MatrixXd kept(shared.rows(), shared.cols());
    Eigen::Index column = 0;
    for (Eigen::Index k = 0; k < shared.cols(); ++k)
        if (shared.col(k).squaredNorm() > 0.0) kept.col(column++) = shared.col(k);
    return kept.leftCols(column);
}

/// A deviation of one station has to do with its own readings only: most of A and S is zero.
void keep_shared(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, JointSetUp& joint) {
    for (Eigen::Index k = 0; k < A.cols(); ++k) {
        for (Eigen::Index i = 0; i < A.rows(); ++i)
            if (A(i, k) != 0.0 || S(k, i) != 0.0)
                joint.shared.push_back({static_cast<std::size_t>(i), A(i, k), S(k, i)});
        joint.ends_of_shared.push_back(joint.shared.size());
    }
}

/// Moves of the stations by all shared deviations with an uncertainty, those that `uncertain_columns` keeps.
std::vector<SharedMove> moves_of(const NetworkSetup& setup, const Eigen::MatrixXd& shared) {
    std::vector<SharedMove> moves;
    Eigen::Index column = 0;
    for (std::size_t s = 0; s < setup.sensors.size(); ++s) {
        const SensorSource& source = *setup.sensors[s];
        const auto own = static_cast<Eigen::Index>(source.systematic().size());
        const Eigen::Matrix<double, 6, 6> T = station_moves(source);
        for (Eigen::Index k = 0; k < own + 6; ++k, ++column) {
            if (!(shared.col(column).squaredNorm() > 0.0)) continue;
            SharedMove& move = moves.emplace_back(SharedMove{.sensor = s});
            for (Eigen::Index i = 0; k >= own && i < 6; ++i)
                move.by[static_cast<std::size_t>(i)] = -T(i, k - own);
        }
    }
    return moves;
}

/// Whether the stations are stated so loosely that the second-order part of their effect on a reading is as
/// large as the reading's own uncertainty, as displacements. At a quarter of that, u changes by
/// a ten-millionth (lsm-network).
bool stations_are_open(const NetworkSetup& setup, const JointSetUp& joint, const Sensitivities& all) {
    const double own = all.u.cwiseQuotient(all.to_point.rowwise().norm()).minCoeff();
    double bent = 0.0;
    for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
        for (const Sight& sight : setup.targets[t].sights) {
            const Eigen::Matrix<double, 6, 6> T = station_moves(*setup.sensors[sight.sensor]);
            const double d = setup.station(setup.targets[t], sight).in_axes(setup.targets[t].nominal).norm();
            const double along = T.topRows<3>().norm(), turn = T.bottomRows<3>().norm();
            bent = std::max(bent, d * turn * turn + along * along / d);
        }
    return bent > own;
}

std::vector<std::array<double, 6>> station_derivatives(const NetworkSetup& setup, const JointSetUp& joint) {
    std::vector<std::array<double, 6>> by_station;
    for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
        for (const Sight& sight : setup.targets[t].sights) {
            const LinearReading reading = sensitivity_of(setup, setup.targets[t], sight);
            for (std::size_t i = 0; i < 3; ++i) {
                if (!sight.has[i]) continue;
                auto& by = by_station.emplace_back();
                for (std::size_t c = 0; c < 6; ++c)
                    by[c] = reading.to_station(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c));
            }
        }
    return by_station;
}

void add_weights(const NetworkSetup& setup, JointSetUp& joint) {
    joint.moves.clear();
    joint.by_station.clear();
    joint.by_u.clear();
    joint.inverse_normal.clear();
    joint.shared.clear();
    joint.ends_of_shared.clear();
    const Sensitivities all = sensitivities_of(setup, joint);
    const Eigen::MatrixXd F = uncertain_columns(all.shared);
    const Eigen::MatrixXd gain = least_squares_gain(all.to_point, all.u, F);
    const Eigen::MatrixXd own = gain * all.u.asDiagonal(), shared = gain * F;
    const Eigen::MatrixXd A = all.u.cwiseInverse().asDiagonal() * F;
    for (const double u : all.u) joint.by_u.push_back(1.0 / u);
    keep_shared(A, estimate_of_shared(A), joint);
    keep_rows(own * own.transpose() + shared * shared.transpose(), joint.inverse_normal);
    if (!stations_are_open(setup, joint, all)) return;
    joint.moves = moves_of(setup, all.shared);
    joint.by_station = station_derivatives(setup, joint);
}

/// C⁻¹ of readings: W = diag(1/u) (I − A S) diag(1/u).
Eigen::MatrixXd weights_of(const Eigen::VectorXd& u, const Eigen::MatrixXd& F) {
    const Eigen::VectorXd by_u = u.cwiseInverse();
    const Eigen::MatrixXd A = by_u.asDiagonal() * F;
    const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(u.size(), u.size()) - A * estimate_of_shared(A);
    return by_u.asDiagonal() * left * by_u.asDiagonal();
}

/// Weights of one target by itself. C falls into blocks, as two sensors share nothing that would be a
/// property of either.
void add_blocks(const NetworkSetup& setup, JointSetUp& joint) {
    joint.blocks.clear();
    joint.inverse_normal.clear();
    const Sensitivities all = sensitivities_of(setup, joint);
    std::map<std::size_t, std::vector<std::size_t>> rows_of_sensors;
    std::size_t row = 0;
    for (const Sight& sight : setup.targets[joint.first].sights)
        for (const bool has : sight.has)
            if (has) rows_of_sensors[sight.sensor].push_back(row++);
    Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
    for (auto& [sensor, rows] : rows_of_sensors) {
        const Eigen::MatrixXd J = all.to_point(rows, Eigen::all);
        const Eigen::MatrixXd W = weights_of(all.u(rows), uncertain_columns(all.shared(rows, Eigen::all)));
        N += J.transpose() * W * J;
        WeightBlock& block = joint.blocks.emplace_back();
        keep_rows(W, block.weights);
        block.rows = std::move(rows);
    }
    keep_rows(N.inverse(), joint.inverse_normal);
}

}  // namespace

Eigen::VectorXd linear_scales(const NetworkSetup& setup, const Target& target) {
    Eigen::VectorXd scales(static_cast<Eigen::Index>(target.rows));
    Eigen::Index row = 0;
    for (const Sight& sight : target.sights) {
        const Eigen::Vector3d v = setup.station(target, sight).in_axes(target.nominal);
        if (sight.has[0]) scales[row++] = sight.has[1] && sight.has[2] ? 1.0 : 0.0;
        if (sight.has[1]) scales[row++] = sight.overhead ? 1.0 : v.head<2>().norm();
        if (sight.has[2]) scales[row++] = sight.has[1] ? v.norm() : 0.0;
    }
    return scales;
}

Sensitivities sensitivities_at(const NetworkSetup& setup, const Target& target) {
    const auto rows = static_cast<Eigen::Index>(target.rows);
    Eigen::Index shared = 0;
    for (const Sensor& sensor : setup.sensors)
        shared += 6 + static_cast<Eigen::Index>(sensor->systematic().size());
    Sensitivities s{Eigen::MatrixXd(rows, 3), Eigen::MatrixXd::Zero(rows, shared), Eigen::VectorXd(rows)};
    Eigen::Index row = 0;
    for (const Sight& sight : target.sights) {
        Eigen::Index column = 0;
        for (std::size_t k = 0; k < sight.sensor; ++k)
            column += 6 + static_cast<Eigen::Index>(setup.sensors[k]->systematic().size());
        const SensorSource& source = *setup.sensors[sight.sensor];
        const LinearReading reading = sensitivity_of(setup, target, sight);
        const Eigen::Matrix3Xd effects = shared_effects(source, reading);
        const Eigen::VectorXd u = shared_uncertainties(source);
        for (std::size_t i = 0; i < 3; ++i) {
            if (!sight.has[i]) continue;
            const auto g = static_cast<Eigen::Index>(i);
            s.to_point.row(row) = reading.to_point.row(g);
            for (Eigen::Index k = 0; k < effects.cols(); ++k)
                s.shared(row, column + k) = effects(g, k) * u[k];
            s.u[row++] = sight.u[i];
        }
    }
    return s;
}

Sensitivities sensitivities_of(const NetworkSetup& setup, const JointSetUp& joint) {
    const auto rows = static_cast<Eigen::Index>(rows_of(setup, joint));
    Eigen::Index row = 0;
    Sensitivities all;
    all.to_point = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(3 * joint.targets));
    all.u.resize(rows);
    for (std::size_t t = 0; t < joint.targets; ++t) {
        const Target& target = setup.targets[joint.first + t];
        const Sensitivities one = sensitivities_at(setup, target);
        all.shared.conservativeResize(rows, one.shared.cols());
        all.to_point.block(row, static_cast<Eigen::Index>(3 * t), one.u.size(), 3) = one.to_point;
        all.shared.middleRows(row, one.u.size()) = one.shared;
        all.u.segment(row, one.u.size()) = one.u;
        row += one.u.size();
    }
    for (const std::size_t b : joint.bars) {
        const ScaleBar& bar = setup.bars[b];
        const Eigen::Vector3d along =
            (setup.targets[bar.to].nominal - setup.targets[bar.from].nominal).normalized();
        const auto column = [&](std::size_t t) { return static_cast<Eigen::Index>(3 * (t - joint.first)); };
        all.to_point.block<1, 3>(row, column(bar.from)) = -along.transpose();
        all.to_point.block<1, 3>(row, column(bar.to)) = along.transpose();
        all.shared.row(row).setZero();
        all.u[row++] = bar.u;
    }
    return all;
}

Eigen::VectorXd residuals_of(const NetworkSetup& setup, const JointSetUp& joint) {
    Eigen::VectorXd e(static_cast<Eigen::Index>(rows_of(setup, joint)));
    Eigen::Index row = 0;
    for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t) {
        const Target& target = setup.targets[t];
        for (const Sight& sight : target.sights)
            for (std::size_t i = 0; i < 3; ++i)
                if (sight.has[i]) e[row++] = residual_of(setup, target, sight, i, target.nominal);
    }
    for (const std::size_t b : joint.bars) {
        const ScaleBar& bar = setup.bars[b];
        e[row++] = bar.length - (setup.targets[bar.to].nominal - setup.targets[bar.from].nominal).norm();
    }
    return e;
}

void divide_set_ups(NetworkSetup& setup, Problems& problems) {
    if (setup.weights == Weights::observations_only) return;
    assign_scale_bars(setup);
    divide_large_set_ups(setup, problems);
}

void find_weights(NetworkSetup& setup, Problems& problems) {
    WeightMaker maker(setup, problems);
    for (std::size_t t = 0; t < setup.targets.size(); ++t)
        maker.make(setup.targets[t], network_fields().place(&StatedNetwork::targets, t));
    if (setup.weights == Weights::observations_only || problems.has_errors()) return;
    for (JointSetUp& joint : setup.set_ups)
        joint.targets == 1 && setup.targets[joint.first].divided ? add_blocks(setup, joint)
                                                                 : add_weights(setup, joint);
}

}  // namespace covaria::network
