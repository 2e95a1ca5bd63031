#include <Eigen/LU>
#include <span>

#include "core/kinds/geometry/results.h"
#include "core/math/dual.h"

namespace covaria::geometry {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

template <class Real>
struct CaughtOutputs {
    std::vector<Real> values;
    void set(std::size_t j, const Real& value) {
        if (j >= values.size()) values.resize(j + 1);
        values[j] = value;
    }
};

/// The equations that the parameters satisfy are sum G(v, q) = 0 over the points, G_j = sum d dd/dv_j over
/// the rows that determine v_j.
class ImplicitDerivatives {
public:
    ImplicitDerivatives(const Feature& feature, std::span<const double> x)
        : feature_(feature), form_(feature.form()), count_(facts_of(form_).parameters) {
        for (const FeaturePoint& point : feature.points) {
            Eigen::Vector3d p(0.0, 0.0, feature.fitted.origin.z());
            for (std::size_t c = 0; c < feature.coordinates(); ++c) p[Index(c)] = x[point.first_input + c];
            q_.push_back(feature.fitted.to_local<double>(p));
            mean_ += q_.back();
        }
        mean_ /= double(q_.size());
    }

    MatrixXd derivatives() {
        const auto point = [&](std::size_t i) -> const Eigen::Vector3d& { return q_[i]; };
        if (!fit<double>(feature_.fitted, point, q_.size(), v_)) return {};
        find_turns_of_parameters();
        const ResultPlaces at = places_of(feature_);
        MatrixXd all = MatrixXd::Zero(Index(at.count), Index(3 * q_.size()));
        add_results(all);
        if (feature_.has_form) add_form(all, Index(at.form));
        return all.allFinite() ? in_world(all) : MatrixXd();
    }

private:
    Parameters<Dual> parameters(bool as_variables) const {
        Parameters<Dual> v;
        for (std::size_t j = 0; j < count_; ++j) v[j] = as_variables ? Dual::variable(v_[j], j) : Dual(v_[j]);
        return v;
    }
    static Vector3<Dual> point(const Eigen::Vector3d& q, bool as_variable) {
        Vector3<Dual> p;
        for (Index c = 0; c < 3; ++c) p[c] = as_variable ? Dual::variable(q[c], std::size_t(c)) : Dual(q[c]);
        return p;
    }
    Rows<Dual> rows_at(std::size_t i, bool by_parameters) const {
        const Parameters<Dual> v = parameters(by_parameters);
        Rows<Dual> rows;
        Shape<Dual>(form_, v).rows(point(q_[i], !by_parameters), rows);
        return rows;
    }

    /// G of one point: its partial derivatives, parameters x variables.
    void add_equations(const Rows<Dual>& rows, Eigen::Ref<MatrixXd> to) const {
        for (std::size_t r = 0; r < facts_of(form_).rows; ++r) {
            const RowRange range = range_of(form_, r);
            for (std::size_t j = range.first; j < range.last; ++j) {
                const Dual G = rows.J[r][j] * rows.d[r];
                for (Index k = 0; k < to.cols(); ++k) to(Index(j), k) += G.partials()[std::size_t(k)];
            }
        }
    }

    /// dv/dq = -(sum dG/dv)^-1 dG/dq
    void find_turns_of_parameters() {
        const auto p = Index(count_);
        MatrixXd H = MatrixXd::Zero(p, p);
        turns_ = MatrixXd::Zero(p, Index(3 * q_.size()));
        for (std::size_t i = 0; i < q_.size(); ++i) {
            add_equations(rows_at(i, true), H);
            add_equations(rows_at(i, false), turns_.middleCols(Index(3 * i), 3));
        }
        Eigen::VectorXd scale = H.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
        H = scale.asDiagonal() * H * scale.asDiagonal();
        turns_ = -(scale.asDiagonal() * H.partialPivLu().solve(MatrixXd(scale.asDiagonal() * turns_)));
    }

    void add_results(MatrixXd& all) const {
        const auto catch_at = [&](const Parameters<Dual>& v, const Vector3<Dual>& mean, Index variables) {
            CaughtOutputs<Dual> caught;
            set_results<Dual>(feature_, v, mean, [&](std::size_t j, const Dual& y) { caught.set(j, y); });
            MatrixXd partials = MatrixXd::Zero(all.rows(), variables);
            for (std::size_t j = 0; j < caught.values.size(); ++j)
                for (Index k = 0; k < variables; ++k)
                    partials(Index(j), k) = caught.values[j].partials()[std::size_t(k)];
            return partials;
        };
        all = catch_at(parameters(true), point(mean_, false), Index(count_)) * turns_;
        const MatrixXd by_mean = catch_at(parameters(false), point(mean_, true), 3) / double(q_.size());
        for (std::size_t i = 0; i < q_.size(); ++i) all.middleCols(Index(3 * i), 3) += by_mean;
    }

    /// Adds factor * dd_i to a row.
    void add_deviation(Eigen::Ref<Eigen::RowVectorXd> row, std::size_t i, double factor, bool squared) const {
        const auto of = [&](bool by_parameters) {
            const Rows<Dual> rows = rows_at(i, by_parameters);
            return squared ? square_of<Dual>(form_, rows) : deviation_of<Dual>(form_, rows);
        };
        const Dual by_v = of(true), by_q = of(false);
        for (std::size_t j = 0; j < count_; ++j) row += factor * by_v.partials()[j] * turns_.row(Index(j));
        for (Index c = 0; c < 3; ++c) row[Index(3 * i) + c] += factor * by_q.partials()[std::size_t(c)];
    }

    void add_form(MatrixXd& all, Index first) const {
        const Shape<double> shape(form_, v_);
        Rows<double> rows;
        std::size_t highest = 0, lowest = 0;
        double high = 0.0, low = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < q_.size(); ++i) {
            shape.rows(q_[i], rows);
            const double d = deviation_of<double>(form_, rows);
            squares += square_of<double>(form_, rows);
            if (i == 0 || d > high) high = d, highest = i;
            if (i == 0 || d < low) low = d, lowest = i;
        }
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(all.cols());
        add_deviation(row, highest, form_ == Form::line ? 2.0 : 1.0, false);
        if (form_ != Form::line) add_deviation(row, lowest, -1.0, false);
        all.row(first) = row;
        all.row(first + 1) = root_mean_square(squares);
    }

    /// d sqrt(sum d^2 / n): what a point moves, and what moves with the parameters, which of forms whose
    /// sum of squares is least is nothing.
    Eigen::RowVectorXd root_mean_square(double squares) const {
        const double factor = 0.5 / std::sqrt(squares * double(q_.size()));
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(turns_.cols()),
                           by_parameters = Eigen::RowVectorXd::Zero(Index(count_));
        for (std::size_t i = 0; i < q_.size(); ++i) {
            const Dual by_v = square_of<Dual>(form_, rows_at(i, true)),
                       by_q = square_of<Dual>(form_, rows_at(i, false));
            for (std::size_t j = 0; j < count_; ++j) by_parameters[Index(j)] += by_v.partials()[j];
            for (Index c = 0; c < 3; ++c) row[Index(3 * i) + c] = by_q.partials()[std::size_t(c)];
        }
        return factor * (row + by_parameters * turns_);
    }

    MatrixXd in_world(const MatrixXd& local) const {
        const auto c = Index(feature_.coordinates());
        MatrixXd world(local.rows(), c * Index(q_.size()));
        const Eigen::Matrix3d R_T = feature_.fitted.axes.transpose();
        for (std::size_t i = 0; i < q_.size(); ++i)
            world.middleCols(c * Index(i), c) = local.middleCols(Index(3 * i), 3) * R_T.leftCols(c);
        return world;
    }

    const Feature& feature_;
    Form form_;
    std::size_t count_;
    std::vector<Eigen::Vector3d> q_;
    Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
    Parameters<double> v_{};
    MatrixXd turns_;  ///< dv/dq
};

}  // namespace

MatrixXd derivatives_of(const Feature& feature, std::span<const double> x) {
    return ImplicitDerivatives(feature, x).derivatives();
}

}  // namespace covaria::geometry
