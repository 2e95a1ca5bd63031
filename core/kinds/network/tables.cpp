// Tables about a network: what its readings alone would give, and what given readings say about themselves.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/kinds/network/adjustment.h"
#include "core/kinds/network/setup.h"
#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

constexpr double outlier_limit = 3.29;  // |w| of data snooping at a significance of 0.1 %

using Matrix = Eigen::MatrixXd;

/// First-order propagation of the targets of one set-up.
struct Precision {
    Matrix readings_alone;  ///< (JᵀWJ)⁻¹ with weights of the readings, a block for each target: Eq 5
    Matrix own;             ///< A diag(u): 3 targets x readings
    Matrix shared;          ///< A F: 3 targets x m
};

/// Matrix that multiplies the residuals in the estimate, unknowns x readings.
Matrix gain_of(const NetworkSetup& setup, const JointSetUp& joint, const Sensitivities& s) {
    if (joint.together()) return least_squares_gain(s.to_point, s.u, s.shared);
    Matrix weights = s.u.cwiseAbs2().cwiseInverse().asDiagonal();
    if (setup.estimator == Estimator::linear_start) {
        Eigen::VectorXd squares(s.u.size());
        Eigen::Index row = 0;
        for (std::size_t t = 0; t < joint.targets; ++t) {
            const Eigen::VectorXd scales = linear_scales(setup, setup.targets[joint.first + t]);
            squares.segment(row, scales.size()) = scales.cwiseAbs2();
            row += scales.size();
        }
        weights = squares.asDiagonal();
    }
    const Matrix JtW = s.to_point.transpose() * weights;
    return cholesky(JtW * s.to_point).solve(JtW);
}

Precision precision_of(const NetworkSetup& setup, const JointSetUp& joint) {
    const Sensitivities s = sensitivities_of(setup, joint);
    const Matrix A = gain_of(setup, joint, s);
    const Matrix whitened = s.u.cwiseInverse().asDiagonal() * s.to_point;
    return {(whitened.transpose() * whitened).inverse(), A * s.u.asDiagonal(), A * s.shared};
}

/// Targets that are linearised at once: those estimated together, else, where there are more than
/// `most_rows` readings, one by one; one matrix of thousands would take gigabytes.
std::vector<JointSetUp> divided(const NetworkSetup& setup, std::size_t most_rows) {
    std::vector<JointSetUp> parts;
    for (const JointSetUp& joint : setup.set_ups) {
        std::size_t rows = 0;
        for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t) rows += setup.targets[t].rows;
        if (joint.together() || joint.targets == 1 || rows <= most_rows) {
            parts.push_back(joint);
            continue;
        }
        for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
            parts.push_back({joint.index, t, 1, {}});
    }
    return parts;
}

struct Variances {
    double readings_alone = 0.0, total = 0.0;
};

class PrecisionTable {
public:
    explicit PrecisionTable(const NetworkSetup& setup) : setup_(setup) {
        for (const JointSetUp& joint : divided(setup, 0)) {
            for (std::size_t t = 0; t < joint.targets; ++t) joint_of_.push_back(precisions_.size());
            precisions_.push_back(precision_of(setup, joint));
            first_of_.push_back(joint.first);
        }
    }

    Table make() const {
        const Unit mm = Unit::of("mm");
        Table table{"precision", "Standard uncertainty by the readings alone, and with the stations"};
        table.add("Quantity");
        table.add("readings alone (Eq 5)").in(mm).figure(3);
        table.add("readings and shared deviations, first order").in(mm).figure(3);
        for (std::size_t t = 0; t < setup_.targets.size(); ++t)
            for (int c = 0; c < 3; ++c)
                add(table, setup_.targets[t].name + ", " + "xyz"[c],
                    of_target(t, Eigen::Vector3d(Eigen::Vector3d::Unit(c))));
        for (const Distance& distance : setup_.distances)
            add(table,
                tell<"distance from %1 to %2">(setup_.targets[distance.from].name,
                                               setup_.targets[distance.to].name),
                of_distance(distance));
        table.notes = {
            tell<"The precision of the readings is no uncertainty of a position: it leaves out where the "
                 "sensors stand and what their readings share. Monte Carlo is in the results.">()};
        return table;
    }

private:
    static void add(Table& table, const Message& name, const Variances& v) {
        table.row({name, std::sqrt(v.readings_alone), std::sqrt(v.total)});
    }

    /// Along g, of the target t of the network.
    struct Along {
        Eigen::VectorXd own, shared;
        double readings_alone;
    };
    Along along(std::size_t t, const Eigen::Vector3d& g) const {
        const std::size_t k = joint_of_[t];
        const auto row = static_cast<Eigen::Index>(3 * (t - first_of_[k]));
        const Precision& p = precisions_[k];
        return {p.own.middleRows(row, 3).transpose() * g, p.shared.middleRows(row, 3).transpose() * g,
                g.dot(p.readings_alone.block<3, 3>(row, row) * g)};
    }

    Variances of_target(std::size_t t, const Eigen::Vector3d& g) const {
        const Along a = along(t, g);
        return {a.readings_alone, a.own.squaredNorm() + a.shared.squaredNorm()};
    }

    Variances of_distance(const Distance& d) const {
        const Target &from = setup_.targets[d.from], &to = setup_.targets[d.to];
        const Eigen::Vector3d g = (to.nominal - from.nominal).normalized();
        const Along a = along(d.from, g), b = along(d.to, g);
        const double alone = a.readings_alone + b.readings_alone;
        if (joint_of_[d.from] == joint_of_[d.to])
            return {alone, (b.own - a.own).squaredNorm() + (b.shared - a.shared).squaredNorm()};
        const Eigen::VectorXd common = from.set_up == to.set_up ? a.shared : systematic(a.shared);
        return {alone, a.own.squaredNorm() + b.own.squaredNorm() + a.shared.squaredNorm() +
                           b.shared.squaredNorm() - 2.0 * common.dot(b.shared)};
    }

    /// Without the stations: what another set-up has in common.
    Eigen::VectorXd systematic(Eigen::VectorXd shared) const {
        Eigen::Index column = 0;
        for (const Sensor& sensor : setup_.sensors) {
            column += static_cast<Eigen::Index>(sensor->systematic().size());
            shared.segment<6>(column).setZero();
            column += 6;
        }
        return shared;
    }

    const NetworkSetup& setup_;
    std::vector<Precision> precisions_;
    std::vector<std::size_t> joint_of_;  ///< precision of each target
    std::vector<std::size_t> first_of_;  ///< target of each precision
};

/// Residuals of given readings, judged with everything that makes them uncertain, the stations too, whatever
/// the weights of the estimate (W. Baarda's data snooping, for correlated readings).
class ResidualTable {
public:
    explicit ResidualTable(const NetworkSetup& setup) : setup_(setup) {
        table_.id = "residuals";
        table_.title = known_text<"Residuals of the readings">();
        table_.add("Target");
        table_.add("Sensor");
        table_.add(known_text<"Reading">());
        table_.add("residual").figure(3);
        table_.add(known_text<"u of the reading">()).figure(2);
        table_.add(known_text<"redundancy">()).figure(2);
        table_.add("w").symbol().figure(3);
        table_.add(known_text<"remark">());
        for (const JointSetUp& joint : divided(setup, most_joint_rows)) add(joint);
        finish();
    }

    Table take() { return std::move(table_); }

    void warn(Problems& problems) const {
        if (!too_large()) return;
        problems.warning(worst_.source,
                         tell<"%1 The residuals are larger than the uncertainties allow; the largest for its "
                              "uncertainty is the %2. Look for mistyped or exchanged readings, or figures of "
                              "the instruments that are too small">(test_words(), worst_.name));
    }

private:
    struct Worst {
        double w = 0.0;
        std::string source = network_fields().place(&StatedNetwork::readings);
        Message name = {};
    };

    void add(const JointSetUp& joint) {
        const Sensitivities s = sensitivities_of(setup_, joint);
        // Units of the readings alone are used: their covariance is I + AAᵀ there, and W its inverse.
        const Eigen::VectorXd by_u = s.u.cwiseInverse();
        const Matrix J = by_u.asDiagonal() * s.to_point, A = by_u.asDiagonal() * s.shared;
        const Matrix W = Matrix::Identity(J.rows(), J.rows()) - A * estimate_of_shared(A);
        const Matrix WJ = W * J;
        const Matrix gain = cholesky(J.transpose() * WJ).solve(WJ.transpose());
        const Eigen::VectorXd e = residuals_of(setup_, joint), scaled = by_u.cwiseProduct(e);
        const Eigen::VectorXd We = W * scaled - WJ * (gain * scaled);
        const auto weight_of = [&](Eigen::Index i) { return W(i, i) - WJ.row(i).dot(gain.col(i)); };
        const auto redundancy_of = [&](Eigen::Index i) { return 1.0 - J.row(i).dot(gain.col(i)); };
        const auto w_of = [&](Eigen::Index i) {
            const double tested = weight_of(i);
            return tested > 1e-9 * W(i, i) ? We[i] / std::sqrt(tested) : 0.0;
        };
        chi_square_ += scaled.dot(We);
        degrees_ += static_cast<int>(J.rows() - J.cols());
        Eigen::Index row = 0;
        for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
            for (const Sight& sight : setup_.targets[t].sights)
                for (std::size_t i = 0; i < 3; ++i) {
                    if (!sight.has[i]) continue;
                    add_row(setup_.targets[t], sight, i, {e[row], s.u[row], redundancy_of(row), w_of(row)});
                    ++row;
                }
        for (const std::size_t b : joint.bars) {
            add_bar(setup_.bars[b], {e[row], s.u[row], redundancy_of(row), w_of(row)});
            ++row;
        }
    }

    struct Numbers {
        double residual, u, redundancy, w;
    };

    void add_row(const Target& target, const Sight& sight, std::size_t i, const Numbers& numbers) {
        const Message names[] = {tell<"distance">(), tell<"azimuth">(), tell<"elevation">()};
        const Unit unit = Unit::of(i == 0 || (i == 1 && sight.overhead) ? "mm" : "arcsec");
        const std::string& sensor = setup_.sensors[sight.sensor].name;
        put(target.name, sensor, names[i], unit, numbers);
        compare(numbers.w, sight.source[i], reading_words(i, target.name, sensor));
    }

    static Message reading_words(std::size_t i, const std::string& target, const std::string& sensor) {
        if (i == 0) return tell<"distance of %1 by %2">(target, sensor);
        return i == 1 ? tell<"azimuth of %1 by %2">(target, sensor)
                      : tell<"elevation of %1 by %2">(target, sensor);
    }

    void add_bar(const ScaleBar& bar, const Numbers& numbers) {
        put(setup_.targets[bar.from].name + " – " + setup_.targets[bar.to].name, tell<"scale bar">(),
            tell<"length">(), Unit::of("mm"), numbers);
        compare(numbers.w, bar.source,
                tell<"length of the %1">(
                    scale_bar_words(setup_.targets[bar.from].name, setup_.targets[bar.to].name)));
    }

    void compare(double w, const std::string& source, const Message& name) {
        if (std::abs(w) > worst_.w) worst_ = {std::abs(w), source, name};
    }

    void put(const std::string& target, const Message& sensor, const Message& reading, const Unit& unit,
             const Numbers& numbers) {
        const bool controlled = numbers.redundancy > 1e-6;
        Message remark = controlled ? Message() : tell<"not controlled">();
        if (controlled && std::abs(numbers.w) > outlier_limit) {
            remark = tell<"outlier?">();
            ++outliers_;
        }
        table_.row({target, sensor, reading, Quantity{unit.from_si(numbers.residual), unit},
                    Quantity{unit.from_si(numbers.u), unit}, std::max(0.0, numbers.redundancy),
                    controlled ? Cell(numbers.w) : Cell(), remark});
    }

    void finish() {
        if (degrees_ <= 0) {
            table_.notes.push_back(
                tell<"No redundancy: as many readings as unknowns, so nothing can be checked.">());
            return;
        }
        table_.notes.push_back(test_words());
        table_.notes.push_back(
            too_large()        ? tell<"The residuals are larger than the uncertainties allow.">()
            : p_value() > 0.99 ? tell<"The residuals are smaller than the uncertainties lead to expect.">()
                               : tell<"The residuals agree with the uncertainties.">());
        if (outliers_ > 0)
            table_.notes.push_back(
                tell<"%1 readings have |w| > 3.29 (0.1 %); where several do, look at the largest first.">(
                    outliers_));
    }

    double p_value() const { return chi_squared_upper_tail(chi_square_, degrees_); }

    bool too_large() const { return degrees_ > 0 && p_value() < 0.01; }

    Message test_words() const {
        return tell<"Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.">(
            Message::number(format_short(chi_square_)), degrees_,
            Message::number(format_short(p_value(), 2)));
    }

    const NetworkSetup& setup_;
    Table table_;
    Worst worst_;
    double chi_square_ = 0.0;
    int degrees_ = 0, outliers_ = 0;
};

}  // namespace

void check_residuals(const NetworkSetup& setup, Problems& problems) {
    ResidualTable(setup).warn(problems);
}

std::vector<Table> network_evaluation(const NetworkSetup& setup) {
    std::vector<Table> tables{PrecisionTable(setup).make()};
    if (setup.measured) tables.push_back(ResidualTable(setup).take());
    return tables;
}

}  // namespace covaria::network
