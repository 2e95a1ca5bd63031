#include "core/kinds/pose/tables.h"

#include <cmath>
#include <map>

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/pose/equations.h"
#include "core/math/decompositions.h"
#include "core/math/special_quantiles.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria::pose {

namespace {

constexpr std::size_t most_tested_points = 100;  // the test works on the whole covariance of a set
constexpr double outlier_limit = 3.29;           // 0.1 %, as for readings of a network (W. Baarda)
constexpr double level_of_all_sets = 0.01;

using Points = std::vector<Eigen::Vector3d>;

/// Root mean square distance after the best rotation and translation of q (from its centroid) onto l.
double rms_of(const Eigen::Matrix3d& H, double squares, std::size_t n) {
    Eigen::Matrix3d R;
    if (!registration<double>(H, R)) return infinity;
    return std::sqrt(std::max(0.0, squares - 2.0 * (R.transpose() * H).trace()) / static_cast<double>(n));
}

/// Tries what mixes up coordinates: a mirrored frame 0, and every exchange of two names.
std::optional<FrameFit::Explanation> explanation_of(const Points& l, const Points& q, double rms) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    double squares = 0.0;
    for (std::size_t i = 0; i < l.size(); ++i) {
        H += q[i] * l[i].transpose();
        squares += q[i].squaredNorm() + l[i].squaredNorm();
    }
    std::optional<FrameFit::Explanation> best;
    double least = rms / 3.0;
    const auto consider = [&](const Eigen::Matrix3d& other, auto exchanged) {
        const double found = rms_of(other, squares, l.size());
        if (found >= least) return;
        least = found;
        best = FrameFit::Explanation{found, exchanged};
    };
    using Exchanged = std::optional<std::pair<std::size_t, std::size_t>>;
    consider(-H, Exchanged{});
    for (std::size_t i = 0; i < l.size(); ++i)
        for (std::size_t j = i + 1; j < l.size(); ++j)
            consider(H - (q[i] - q[j]) * (l[i] - l[j]).transpose(), Exchanged{{i, j}});
    return best;
}

class Fitting {
public:
    Fitting(const FrameRule& rule, const Points& points, const InputSet& inputs, std::size_t first_input,
            const std::string& set)
        : rule_(rule), points_(points), inputs_(inputs), first_(first_input) {
        fit_.set = set;
    }

    FrameFit fit() {
        const Eigen::Isometry3d X_0F = frame_of(rule_, points_);
        R_ = X_0F.linear();
        double squares = 0.0, scale = 0.0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            fit_.names.push_back(rule_.points[i].name);
            fit_.residual.push_back(X_0F.inverse() * points_[i] - rule_.points[i].local);
            squares += fit_.residual.back().squaredNorm();
            scale += rule_.centred[i].squaredNorm();
        }
        fit_.rms = std::sqrt(squares / static_cast<double>(points_.size()));
        fit_.u_residual.assign(points_.size(), Eigen::Vector3d::Zero());
        fit_.redundancy.assign(points_.size(), Eigen::Vector3d::Ones());
        if (points_.size() <= most_tested_points) {
            test();
            if (squares > 1e-18 * scale)
                fit_.explanation = explanation_of(rule_.centred, centred(), fit_.rms);
        }
        return std::move(fit_);
    }

private:
    Points centred() const {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : points_) mean += p / static_cast<double>(points_.size());
        Points q;
        for (const Eigen::Vector3d& p : points_) q.push_back(p - mean);
        return q;
    }

    /// Changes of the coordinates by the six parameters of the frame, which take them up.
    Eigen::MatrixXd design() const {
        Eigen::MatrixXd A(3 * points_.size(), 6);
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const auto row = static_cast<Eigen::Index>(3 * i);
                A.block<3, 1>(row, k) = Eigen::Vector3d::Unit(k);
                A.block<3, 1>(row, 3 + k) = Eigen::Vector3d::Unit(k).cross(rule_.centred[i]);
            }
        return A;
    }

    /// Deviations of the coordinates along the axes of the frame, one column for each component.
    Eigen::MatrixXd deviations() const {
        std::map<std::size_t, Eigen::Index> columns;
        for (std::size_t i = first_; i < first_ + 3 * points_.size(); ++i)
            for (const Share& share : inputs_.quantities[i].shares)
                columns.emplace(share.component, static_cast<Eigen::Index>(columns.size()));
        Eigen::MatrixXd F = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * points_.size()),
                                                  static_cast<Eigen::Index>(columns.size()));
        for (std::size_t i = 0; i < 3 * points_.size(); ++i)
            for (const Share& share : inputs_.quantities[first_ + i].shares)
                F(static_cast<Eigen::Index>(i), columns.at(share.component)) +=
                    share.factor * inputs_.components[share.component].distribution.standard_uncertainty();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(3 * i);
            F.middleRows<3>(row) = (R_.transpose() * F.middleRows<3>(row)).eval();
        }
        return F;
    }

    /// Chi-square of what the frame cannot take up, with its full covariance: that of the weighted
    /// adjustment, whatever the weights of the fit.
    void test() {
        const Eigen::Index n = static_cast<Eigen::Index>(3 * points_.size());
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(design());
        const Eigen::MatrixXd Q = qr.householderQ();
        const Eigen::MatrixXd rest = Q.rightCols(n - 6);
        const Eigen::MatrixXd G = rest.transpose() * deviations();
        const Eigen::MatrixXd of_residuals = rest * G;
        Eigen::VectorXd e(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto point = static_cast<std::size_t>(i / 3);
            e[i] = fit_.residual[point][i % 3];
            fit_.u_residual[point][i % 3] = of_residuals.row(i).norm();
            fit_.redundancy[point][i % 3] = rest.row(i).squaredNorm();
        }
        const Eigen::MatrixXd covariance = G * G.transpose();
        const Eigen::LDLT<Eigen::MatrixXd> ldlt(covariance);
        const Eigen::VectorXd D = ldlt.vectorD();
        Eigen::VectorXd y = ldlt.transpositionsP() * (rest.transpose() * e);
        ldlt.matrixL().solveInPlace(y);
        for (Eigen::Index k = 0; k < D.size(); ++k) {
            if (!(D[k] > 1e-12 * D.maxCoeff())) continue;  // a direction without stated uncertainty
            fit_.chi_square += y[k] * y[k] / D[k];
            ++fit_.degrees_of_freedom;
        }
    }

    const FrameRule& rule_;
    const Points& points_;
    const InputSet& inputs_;
    std::size_t first_;
    Eigen::Matrix3d R_ = Eigen::Matrix3d::Identity();
    FrameFit fit_;
};

struct Largest {
    std::size_t point = 0;
    int axis = 0;
    double normalised = 0.0;
};

Largest largest_of(const FrameFit& fit) {
    Largest largest;
    for (std::size_t i = 0; i < fit.names.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (std::abs(fit.normalised(i, c)) > std::abs(largest.normalised))
                largest = {i, c, fit.normalised(i, c)};
    return largest;
}

std::string coordinate_name(const FrameFit& fit, const Largest& at) {
    return fit.names[at.point] + ", " + "xyz"[at.axis];
}

std::string figure(double value, const char* unit = "") {
    return format_short(value) + unit;
}

Message words_of(const FrameFit& fit, const FrameFit::Explanation& explanation) {
    const std::string now = figure(1e3 * explanation.rms, " mm"), before = figure(1e3 * fit.rms, " mm");
    if (!explanation.exchanged)
        return tell<
            "the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs "
            "and the order of its axes">(now, before);
    return tell<"with %1 and %2 exchanged the residuals are %3 instead of %4: check the names">(
        fit.names[explanation.exchanged->first], fit.names[explanation.exchanged->second], now, before);
}

/// Words of a warning, without what would explain the misfit.
Message misfit_of(const FrameFit& fit, bool failed) {
    if (!failed) return tell<"the points of '%1' do not fit their nominal coordinates">(fit.set);
    const Largest largest = largest_of(fit);
    return tell<
        "the points of '%1' do not fit their nominal coordinates within the stated uncertainties: "
        "chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)">(
        fit.set, figure(fit.chi_square), fit.degrees_of_freedom, figure(largest.normalised),
        coordinate_name(fit, largest));
}

bool fails(const FrameFit& fit, std::size_t sets) {
    return fit.degrees_of_freedom > 0 && fit.probability() < level_of_all_sets / static_cast<double>(sets);
}

Table summary_table(const std::vector<FrameFit>& fits) {
    Table table{"fits", known_text<"Fit of the measured points to their nominal coordinates">()};
    table.add("set");
    table.add("points");
    table.add(known_text<"root mean square residual">()).in(Unit::of("mm")).figure(3);
    table.add(known_text<"redundancy">());
    table.add(known_text<"chi-square">()).figure(4);
    table.add("p").symbol().figure(2);
    table.add(known_text<"largest normalised residual">()).figure(3);
    table.add(known_text<"of">());
    table.add(known_text<"remark">());
    for (const FrameFit& fit : fits) {
        const Largest largest = largest_of(fit);
        const bool tested = fit.degrees_of_freedom > 0;
        Message remark = !tested                   ? tell<"not tested">()
                         : fails(fit, fits.size()) ? tell<"residuals larger than stated">()
                                                   : tell<"agrees">();
        if (fit.explanation && (!tested || fails(fit, fits.size())))
            remark += Message("; ") + words_of(fit, *fit.explanation);
        table.row({fit.set, double(fit.names.size()), fit.rms,
                   tested ? Cell(double(fit.degrees_of_freedom)) : Cell(),
                   tested ? Cell(fit.chi_square) : Cell(), tested ? Cell(fit.probability()) : Cell(),
                   tested ? Cell(largest.normalised) : Cell(),
                   tested ? Cell(coordinate_name(fit, largest)) : Cell(), remark});
    }
    table.notes = {tell<
        "Chi-square of the residuals with the full covariance of the stated uncertainties; nominal "
        "coordinates are taken as exact. p is the probability of a larger value if all is as stated; the "
        "test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and "
        "sets of more than %1 points.">(most_tested_points)};
    return table;
}

Table residual_table(const std::vector<FrameFit>& fits) {
    Table table{"residuals", known_text<"Residuals of the points, along the axes of their frame">()};
    table.add("set");
    table.add("point");
    for (const std::string& head :
         {known_text<"residual x">(), known_text<"residual y">(), known_text<"residual z">()})
        table.add(head).in(Unit::of("mm")).figure(3);
    for (const char* axis : {"w_x", "w_y", "w_z"}) table.add(axis).symbol().figure(3);
    for (const std::string& head :
         {known_text<"redundancy x">(), known_text<"redundancy y">(), known_text<"redundancy z">()})
        table.add(head).figure(2);
    table.add(known_text<"remark">());
    for (const FrameFit& fit : fits)
        for (std::size_t i = 0; i < fit.names.size(); ++i) {
            std::vector<Cell> row{fit.set, fit.names[i]};
            bool outlier = false;
            for (int c = 0; c < 3; ++c) row.emplace_back(fit.residual[i][c]);
            for (int c = 0; c < 3; ++c) {
                const double w = fit.normalised(i, c);
                outlier = outlier || std::abs(w) > outlier_limit;
                row.push_back(fit.u_residual[i][c] > 0.0 ? Cell(w) : Cell());
            }
            for (int c = 0; c < 3; ++c)
                row.push_back(fit.degrees_of_freedom > 0 ? Cell(fit.redundancy[i][c]) : Cell());
            row.emplace_back(outlier ? tell<"outlier?">() : Message());
            table.row(std::move(row));
        }
    table.notes = {
        tell<"Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| > "
             "3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in "
             "its residual.">()};
    return table;
}

}  // namespace

double FrameFit::probability() const {
    return chi_squared_upper_tail(chi_square, degrees_of_freedom);
}

double FrameFit::normalised(std::size_t point, int axis) const {
    const double u = u_residual[point][axis];
    return u > 0.0 ? residual[point][axis] / u : 0.0;
}

std::vector<FrameFit> frame_fits(const PoseSetup& setup, const InputSet& inputs) {
    std::vector<FrameFit> fits;
    if (!setup.a_posteriori) return fits;
    if (setup.base.least_squares)
        fits.push_back(Fitting(setup.base, setup.base_points, inputs, 0, "base").fit());
    if (!setup.moving.least_squares) return fits;
    const std::size_t per_pose = 3 * setup.moving.points.size();
    for (std::size_t k = 0; k < setup.poses.size(); ++k)
        fits.push_back(Fitting(setup.moving, setup.poses[k].points, inputs,
                               3 * setup.base.points.size() + k * per_pose, setup.poses[k].name)
                           .fit());
    return fits;
}

std::vector<Table> fit_tables(const std::vector<FrameFit>& fits) {
    if (fits.empty()) return {};
    return {summary_table(fits), residual_table(fits)};
}

void warn_of_misfits(const std::vector<FrameFit>& fits, Problems& problems, bool can_be_seen) {
    for (const FrameFit& fit : fits) {
        const bool failed = fails(fit, fits.size());
        if (!failed && (fit.degrees_of_freedom > 0 || !fit.explanation)) continue;
        Problem problem{.severity = Severity::warning,
                        .path = pose_fields().place(&PoseSetup::measured),
                        .message = misfit_of(fit, failed)};
        if (fit.explanation)
            problem.message += "; " + words_of(fit, *fit.explanation);
        else if (can_be_seen)
            problem.remedies = {remedy_as_seen(pose_fields().place(&PoseSetup::uncertainties))};
        problems.add(std::move(problem));
    }
}

}  // namespace covaria::pose
