// projects/seen-chain.covaria, from the rounds of a total station to the pose on the certificate, against the
// same chain written by hand: analysis of variance, Gauss-Newton, a frame from three points.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/math/special_quantiles.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::seen_chain_test {
namespace {

using Eigen::Vector3d;

enum Kind { direction, zenith, distance };
constexpr std::size_t kinds = 3;

struct Reading {
    Kind kind;
    std::string from, to, round;
    double value = 0.0;  ///< m, rad
};

class Columns {
public:
    Columns(const Project& project, const std::string& analysis, const std::string& table)
        : table_(std::get<SetupTable>(project.find_analysis(analysis)->setup.values.at(table))) {
        for (const ColumnSpec& column : find_model("network-adjustment")->schema.find(table)->columns)
            keys_.push_back(column.key);
    }
    std::size_t rows() const { return table_.rows.size(); }
    std::string text(std::size_t row, const std::string& key) const {
        const auto* text = std::get_if<std::string>(&table_.rows[row][at(key)]);
        return text ? *text : std::string();
    }
    double number(std::size_t row, const std::string& key) const {
        return table_.units[at(key)].to_si(std::get<double>(table_.rows[row][at(key)]));
    }

private:
    std::size_t at(const std::string& key) const {
        return static_cast<std::size_t>(std::ranges::find(keys_, key) - keys_.begin());
    }
    const SetupTable& table_;
    std::vector<std::string> keys_;
};

std::vector<Reading> readings_of(const Project& project, const std::string& analysis) {
    const Columns table(project, analysis, "readings");
    std::vector<Reading> readings;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const std::string kind = table.text(i, "kind");
        const Kind of = kind == "direction" ? direction : kind == "zenith-angle" ? zenith : distance;
        readings.push_back({of, table.text(i, "from"), table.text(i, "to"), table.text(i, "round"),
                            table.number(i, of == distance ? "length" : "angle")});
    }
    return readings;
}

double on_circle(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

struct SeenByHand {
    std::array<double, kinds> u{}, nu{};
};

/// Directions less the means of targets and rounds; the others less the means of targets.
SeenByHand rounds_by_hand(const std::vector<Reading>& readings) {
    SeenByHand seen;
    std::map<std::string, std::vector<double>> of_target[kinds];
    for (const Reading& r : readings) of_target[r.kind][r.to].push_back(r.value);
    auto& rounds = of_target[direction];
    const std::vector<double> first = rounds.begin()->second;
    for (auto& [target, values] : rounds) {
        const double at = values[0] - first[0];
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = on_circle(values[k] - first[k] - at);  // small: the orientation of the round is off
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const auto& all = of_target[kind];
        const std::size_t n = all.size(), m = all.begin()->second.size();
        std::vector<double> of_round(m, 0.0);
        double sum = 0.0;
        if (kind == direction)
            for (std::size_t k = 0; k < m; ++k)
                for (const auto& [target, values] : all)
                    of_round[k] +=
                        (values[k] - std::accumulate(values.begin(), values.end(), 0.0) / double(m)) /
                        double(n);
        for (const auto& [target, values] : all) {
            const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(m);
            for (std::size_t k = 0; k < m; ++k) sum += std::pow(values[k] - mean - of_round[k], 2);
        }
        seen.nu[kind] = double((kind == direction ? n - 1 : n) * (m - 1));
        seen.u[kind] = std::sqrt(sum / seen.nu[kind]);
    }
    return seen;
}

struct PointsByHand {
    std::map<std::string, Vector3d> points;
    std::vector<std::string> names;  ///< the points that are found, in the order of the covariance
    std::array<Eigen::MatrixXd, kinds> covariance;
};

/// Two pillars that are known, an orientation at each.
PointsByHand network_by_hand(const Project& project, const SeenByHand& seen) {
    const std::vector<Reading> readings = readings_of(project, "network");
    const Columns table(project, "network", "points");
    PointsByHand made;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const std::string name = table.text(i, "name");
        if (table.text(i, "plane") == "fixed")
            made.points[name] = {table.number(i, "x"), table.number(i, "y"), table.number(i, "z")};
        else
            made.names.push_back(name);
    }
    const auto value = [&](Kind kind, const std::string& from, const std::string& to) {
        return std::ranges::find_if(
                   readings, [&](const Reading& r) { return r.kind == kind && r.from == from && r.to == to; })
            ->value;
    };
    std::map<std::string, double> orientation;
    for (const auto& [a, b] : {std::pair("S1", "S2"), std::pair("S2", "S1")}) {
        const Vector3d v = made.points[b] - made.points[a];
        orientation[a] = std::atan2(v.y(), v.x()) - value(direction, a, b);
    }
    for (const std::string& name : made.names) {
        const double s = value(distance, "S1", name), z = value(zenith, "S1", name),
                     a = orientation["S1"] + value(direction, "S1", name);
        made.points[name] = made.points["S1"] +
                            s * Vector3d(std::sin(z) * std::cos(a), std::sin(z) * std::sin(a), std::cos(z));
    }
    const auto n = static_cast<Eigen::Index>(readings.size()),
               unknowns = static_cast<Eigen::Index>(3 * made.names.size() + 2);
    std::map<std::string, Eigen::Index> at{{"S1", unknowns - 2}, {"S2", unknowns - 1}};
    std::map<std::string, Eigen::Index> column;
    for (std::size_t k = 0; k < made.names.size(); ++k)
        column[made.names[k]] = static_cast<Eigen::Index>(3 * k);
    Eigen::MatrixXd A, gain;
    for (int step = 0; step < 12; ++step) {
        A = Eigen::MatrixXd::Zero(n, unknowns);
        Eigen::VectorXd e(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Reading& r = readings[static_cast<std::size_t>(i)];
            const Vector3d v = made.points[r.to] - made.points[r.from];
            const double across = v.head<2>().norm(), weight = 1.0 / seen.u[r.kind];
            Vector3d slope;
            if (r.kind == distance) {
                slope = v.normalized();
                e[i] = r.value - v.norm();
            } else if (r.kind == zenith) {
                slope = Vector3d(v.x() * v.z() / across, v.y() * v.z() / across, -across) / v.squaredNorm();
                e[i] = r.value - std::atan2(across, v.z());
            } else {
                slope = Vector3d(-v.y(), v.x(), 0.0) / (across * across);
                e[i] = on_circle(r.value - (std::atan2(v.y(), v.x()) - orientation[r.from]));
                A(i, at[r.from]) = -weight;
            }
            if (column.contains(r.to)) A.block<1, 3>(i, column[r.to]) = weight * slope.transpose();
            e[i] *= weight;
        }
        gain = (A.transpose() * A).ldlt().solve(A.transpose());
        const Eigen::VectorXd change = gain * e;
        for (const std::string& name : made.names) made.points[name] += change.segment<3>(column[name]);
        for (const auto& [station, k] : at) orientation[station] += change[k];
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        Eigen::MatrixXd own = gain;
        for (Eigen::Index i = 0; i < n; ++i)
            if (readings[static_cast<std::size_t>(i)].kind != kind) own.col(i).setZero();
        made.covariance[kind] = own * own.transpose();
    }
    return made;
}

/// x along the first two points, the third on the positive side of it; the origin from the first.
Vector3d place_by_hand(const std::map<std::string, Vector3d>& points) {
    const auto frame = [&](const std::string& letter, const std::string& end, const Vector3d& shift) {
        const Vector3d a = points.at(letter + "1" + end), b = points.at(letter + "2" + end),
                       c = points.at(letter + "3" + end);
        Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
        X.linear().col(0) = (b - a).normalized();
        X.linear().col(2) = X.linear().col(0).cross(c - a).normalized();
        X.linear().col(1) = X.linear().col(2).cross(X.linear().col(0));
        X.translation() = a + X.linear() * shift;
        return X;
    };
    const Eigen::Isometry3d base = frame("B", "", Vector3d::Zero()),
                            plate = frame("P", " in place", Vector3d(0.2, 0.15, 0.0));
    return base.linear().transpose() * (plate.translation() - base.translation());
}

struct PoseByHand {
    Vector3d estimate, u, nu;
};

PoseByHand chain_by_hand(const Project& project) {
    const SeenByHand seen = rounds_by_hand(readings_of(project, "rounds"));
    PointsByHand network = network_by_hand(project, seen);
    PoseByHand pose;
    pose.estimate = place_by_hand(network.points);
    const auto unknowns = network.covariance[0].cols();
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, unknowns);
    for (std::size_t k = 0; k < network.names.size(); ++k)
        for (int c = 0; c < 3; ++c) {
            const auto difference = [&](double h) {
                auto plus = network.points, minus = network.points;
                plus[network.names[k]][c] += h;
                minus[network.names[k]][c] -= h;
                return Vector3d((place_by_hand(plus) - place_by_hand(minus)) / (2.0 * h));
            };
            J.col(static_cast<Eigen::Index>(3 * k) + c) = (4.0 * difference(5e-4) - difference(1e-3)) / 3.0;
        }
    for (int c = 0; c < 3; ++c) {
        double sum = 0.0, by_nu = 0.0;
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            const double part = J.row(c) * network.covariance[kind] * J.row(c).transpose();
            sum += part;
            by_nu += part * part / seen.nu[kind];
        }
        pose.u[c] = std::sqrt(sum);
        pose.nu[c] = sum * sum / by_nu;
    }
    return pose;
}

UncertaintyResult result_of(const Project& project) {
    Problems problems;
    const auto prepared = made_analysis(project, "pose", problems);
    if (!prepared) {
        for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
        throw std::runtime_error("no pose");
    }
    return run_analysis(*prepared).value();
}

void expect_chain(const Project& project) {
    const UncertaintyResult result = result_of(project);
    const PoseByHand by_hand = chain_by_hand(project);
    for (std::size_t c = 0; c < 3; ++c) {
        const FirstOrderOutput& found = result.outputs[c].first_order;
        const auto k = static_cast<Eigen::Index>(c);
        EXPECT_NEAR(found.estimate, by_hand.estimate[k], 1e-9) << c;
        EXPECT_NEAR(found.standard_uncertainty, by_hand.u[k], 1e-9 * by_hand.u[k]) << c;
        EXPECT_NEAR(found.effective_degrees_of_freedom, by_hand.nu[k], 1e-7 * by_hand.nu[k]) << c;
        const double U = t_quantile(0.5 * (1.0 + result.coverage_probability), by_hand.nu[k]) * by_hand.u[k];
        EXPECT_NEAR(found.expanded_uncertainty, U, 1e-8 * U) << c;
    }
}

Project chain() {
    LoadedProject loaded = load_project(data_directory() / "projects/seen-chain.covaria");
    for (const Problem& p : loaded.problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return loaded.project;
}

TEST(SeenChain, IsTheChainByHand) {
    expect_chain(chain());
}

TEST(SeenChain, AReadingOfTheRoundsChangesTheCertificate) {
    Project project = chain();
    const double before = result_of(project).outputs[0].first_order.expanded_uncertainty;
    for (AnalysisEntry& analysis : project.analyses) {
        if (analysis.id != "rounds") continue;
        auto& table = std::get<SetupTable>(analysis.setup.values.at("readings"));
        const auto& columns = find_model("network-adjustment")->schema.find("readings")->columns;
        for (std::size_t c = 0; c < columns.size(); ++c)
            if (columns[c].key == "angle")
                table.rows[0][c] = std::get<double>(table.rows[0][c]) +
                                   0.002 * table.units[c].from_si(std::numbers::pi / 200.0);
    }
    EXPECT_GT(result_of(project).outputs[0].first_order.expanded_uncertainty, 1.05 * before);
    expect_chain(project);
}

}  // namespace
}  // namespace covaria::seen_chain_test
