#include "core/kinds/network/sensitivities.h"

#include "core/kinds/network/equations.h"
#include "core/model/equation_model.h"
#include "core/model/sensitivity_rows.h"

namespace covaria::network {

namespace {

struct InputRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Collects the gradient of outputs by the coordinates of at most three targets, eight at a time.
class Gradient {
public:
    static constexpr std::size_t most = 9;
    explicit Gradient(std::size_t first_output) : first_output_(first_output) {}
    void begin(std::size_t first) { first_ = first; }
    void set(std::size_t output, const Dual& value) {
        if (output - first_output_ >= by_.size()) by_.resize(output - first_output_ + 1);
        for (std::size_t k = 0; k < Dual::size && first_ + k < most; ++k)
            by_[output - first_output_][first_ + k] = value.partials()[k];
    }
    const std::vector<std::array<double, most>>& values() const { return by_; }

private:
    std::size_t first_output_, first_ = 0;
    std::vector<std::array<double, most>> by_;
};

/// The sensitivity coefficients of targets that are estimated together, or of one by itself. At the estimates
/// X the condition g(X, x) = Jᵀ W r = 0 holds, so that dX/dx = −(∂g/∂X)⁻¹ ∂g/∂x; a station and the readings
/// of one sight change r and J in the rows of that sight only.
class LeastSquaresSensitivities {
public:
    LeastSquaresSensitivities(const NetworkSetup& setup, const Part& part, std::size_t set_up,
                              std::span<const double> x, const Eigen::Vector3d* X)
        : setup_(setup),
          part_(part),
          set_up_(set_up),
          x_(x),
          X_(X),
          n_(Eigen::Index(part.unknowns())),
          by_point_(Eigen::MatrixXd::Zero(n_, n_)),
          by_station_(Eigen::MatrixXd::Zero(n_, 6 * Eigen::Index(setup.sensors.size()))),
          bent_by_station_(by_station_) {}

    /// The coordinates of target t are the outputs 3 (first + t) ....
    bool add_to(std::size_t first, SensitivityRows& rows) {
        linearise();
        std::size_t row = 0;
        for (std::size_t t = 0; t < part_.count; ++t)
            for (const Sight& sight : part_.targets[t].sights) row = add(sight, t, row);
        for (const std::size_t b : part_.bars) add(setup_.bars[b], row++);
        if (part_.joint && part_.joint->finds_stations()) follow_stations();
        const Eigen::MatrixXd minus_inverse = -by_point_.inverse();
        if (!minus_inverse.allFinite()) return false;
        const Eigen::MatrixXd by_stations = minus_inverse * by_station_,
                              by_readings = minus_inverse * by_reading_;
        for (Eigen::Index i = 0; i < by_stations.cols(); ++i)
            put(setup_.station_input(set_up_, 0) + std::size_t(i), by_stations.col(i), first, rows);
        for (Eigen::Index i = 0; i < by_readings.cols(); ++i)
            put(inputs_[std::size_t(i)], by_readings.col(i), first, rows);
        return by_stations.allFinite() && by_readings.allFinite();
    }

private:
    /// W r and W J at the estimates.
    void linearise() {
        const Inputs<double> x(x_.data());
        for (std::size_t t = 0; t < part_.count; ++t)
            for (const Sight& sight : part_.targets[t].sights)
                places_[sight.sensor] = place_of<double>(setup_, x, set_up_, sight.sensor);
        at_.read(part_, x);
        at_.take(part_, places_.data(), x, X_);
        at_.weigh(part_);
        std::array<double, most_joint_rows> column, weighted;
        std::array<double, 3 * most_joint_targets> unit{};
        weighted_gradients_.resize(Eigen::Index(at_.rows), n_);
        gradients_.resize(Eigen::Index(at_.rows), n_);
        by_reading_ = Eigen::MatrixXd::Zero(n_, Eigen::Index(at_.rows));
        inputs_.resize(at_.rows);
        for (Eigen::Index k = 0; k < n_; ++k) {
            unit[std::size_t(k)] = 1.0;
            at_.multiply(part_, unit.data(), column.data());
            unit[std::size_t(k)] = 0.0;
            at_.weigh(part_, column.data(), weighted.data());
            for (std::size_t i = 0; i < at_.rows; ++i) {
                gradients_(Eigen::Index(i), k) = column[i];
                weighted_gradients_(Eigen::Index(i), k) = weighted[i];
            }
        }
    }

    /// Readings as variables 3, 4, 5.
    struct SightInputs {
        const double* x;
        const Sight& sight;
        Dual operator[](std::size_t i) const {
            for (std::size_t o = 0; o < 3; ++o)
                if (sight.has[o] && sight.input[o] == i) return Dual::variable(x[i], 3 + o);
            return Dual(x[i]);
        }
    };

    /// Adds the effect on g of a sight of target t, whose readings are the rows from `row` on; the row after.
    std::size_t add(const Sight& sight, std::size_t t, std::size_t row) {
        const std::size_t station = setup_.station_input(set_up_, sight.sensor);
        const Inputs<Dual> by_station(x_.data(), station);
        const Place<Dual> moved = place_of<Dual>(setup_, by_station, set_up_, sight.sensor);
        const Eigen::Vector3d& at = X_[t];
        const auto column_of = [&](Eigen::MatrixXd& by, std::size_t k) {
            return k < 6 ? by.col(Eigen::Index(6 * sight.sensor + k)).data() : nullptr;
        };
        const std::size_t behind = add(
            sight, t, row, moved, at.cast<Dual>(), by_station,
            [&](std::size_t k) { return column_of(by_station_, k); },
            [&](std::size_t k) { return column_of(bent_by_station_, k); });
        const Vector3<Dual> X(Dual::variable(at[0], 0), Dual::variable(at[1], 1), Dual::variable(at[2], 2));
        const Place<double>& fixed = places_[sight.sensor];
        const Place<Dual> place{fixed.R.cast<Dual>(), fixed.o.cast<Dual>()};
        std::array<double*, 3> of_reading{};
        for (std::size_t o = 0, r = row; o < 3; ++o) {
            if (!sight.has[o]) continue;
            inputs_[r] = sight.input[o];
            of_reading[o] = by_reading_.col(Eigen::Index(r++)).data();
        }
        const auto nowhere = [](std::size_t) -> double* { return nullptr; };
        add(
            sight, t, row, place, X, SightInputs{x_.data(), sight},
            [&](std::size_t k) -> double* {
                if (k < 3) return by_point_.col(Eigen::Index(3 * t + k)).data();
                return k < 6 ? of_reading[k - 3] : nullptr;
            },
            nowhere);
        return behind;
    }

    /// Adds ∂g/∂(variable k) by the readings of one sight to change(k), where that is not null; to bend(k)
    /// the part that the change of J makes.
    template <class In, class Change, class Bend>
    std::size_t add(const Sight& sight, std::size_t t, std::size_t row, const Place<Dual>& place,
                    const Vector3<Dual>& X, const In& x, const Change& change, const Bend& bend) {
        const View<Dual> view(place, X);
        const ReadAngles<Dual> read(sight, x);
        for (std::size_t o = 0; o < 3; ++o) {
            if (!sight.has[o]) continue;
            const Vector3<Dual> j = gradient<Dual>(sight, o, place, view, read);
            const Dual r = residual<Dual>(sight, o, view, x, read);
            for (std::size_t k = 0; k < Dual::size; ++k) {
                double* to = change(k);
                if (!to) continue;
                Eigen::Map<Eigen::VectorXd> g(to, n_);
                if (r.partials()[k] != 0.0)
                    g += weighted_gradients_.row(Eigen::Index(row)).transpose() * r.partials()[k];
                double* bent = bend(k);
                for (int c = 0; c < 3; ++c) {
                    const double change_of_J = j[c].partials()[k] * at_.weighted[row];
                    g[Eigen::Index(3 * t) + c] += change_of_J;
                    if (bent) bent[Eigen::Index(3 * t) + c] += change_of_J;
                }
            }
            ++row;
        }
        return row;
    }

    /// Stations that are found move with the residuals, m = M r, and J with them; r itself does not, to first
    /// order where they were found.
    void follow_stations() {
        const JointSetUp& joint = *part_.joint;
        Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(by_station_.cols(), Eigen::Index(at_.rows));
        const SharedWeight* weight = joint.shared.data();
        for (std::size_t k = 0; k < joint.moves.size(); ++k)
            for (const SharedWeight* end = joint.end_of_shared(k); weight != end; ++weight)
                for (std::size_t i = 0; i < 6; ++i)
                    moves(Eigen::Index(6 * joint.moves[k].sensor + i), Eigen::Index(weight->row)) +=
                        joint.moves[k].by[i] * weight->estimate * joint.by_u[weight->row];
        const Eigen::MatrixXd by_residual = bent_by_station_ * moves;
        by_reading_ += by_residual;
        by_point_ -= by_residual * gradients_;
        std::size_t row = 0;
        for (std::size_t t = 0; t < part_.count; ++t)
            for (const Sight& sight : part_.targets[t].sights)
                for (const bool has : sight.has)
                    if (has) {
                        const std::array<double, 6>& by = joint.by_station[row];
                        for (std::size_t i = 0; i < 6; ++i)
                            by_station_.col(Eigen::Index(6 * sight.sensor + i)) -=
                                by_residual.col(Eigen::Index(row)) * by[i];
                        ++row;
                    }
    }

    /// Adds the part of a calibrated length: r = x − |X_to − X_from|.
    void add(const ScaleBar& bar, std::size_t row) {
        const auto to = Eigen::Index(3 * (bar.to - part_.first)),
                   from = Eigen::Index(3 * (bar.from - part_.first));
        const Eigen::Vector3d& j = at_.gradients[row];
        inputs_[row] = bar.input;
        by_reading_.col(Eigen::Index(row)) = weighted_gradients_.row(Eigen::Index(row)).transpose();
        const auto of_residual = by_reading_.col(Eigen::Index(row));
        by_point_.middleCols<3>(to) -= of_residual * j.transpose();
        by_point_.middleCols<3>(from) += of_residual * j.transpose();
        const double length = (X_[bar.to - part_.first] - X_[bar.from - part_.first]).norm();
        const Eigen::Matrix3d turn =
            (Eigen::Matrix3d::Identity() - j * j.transpose()) * (at_.weighted[row] / length);
        by_point_.block<3, 3>(to, to) += turn;
        by_point_.block<3, 3>(from, from) += turn;
        by_point_.block<3, 3>(to, from) -= turn;
        by_point_.block<3, 3>(from, to) -= turn;
    }

    template <class Column>
    void put(std::size_t input, const Column& dX, std::size_t first, SensitivityRows& rows) const {
        for (Eigen::Index i = 0; i < n_; ++i)
            if (dX[i] != 0.0) rows[3 * first + std::size_t(i)].push_back({input, dX[i]});
    }

    const NetworkSetup& setup_;
    const Part part_;
    const std::size_t set_up_;
    std::span<const double> x_;
    const Eigen::Vector3d* X_;
    const Eigen::Index n_;  ///< unknowns
    std::array<Place<double>, most_sensors> places_;
    Linearised<double> at_;
    Eigen::MatrixXd gradients_, weighted_gradients_;  ///< J and W J, readings x unknowns
    Eigen::MatrixXd by_point_;                        ///< ∂g/∂X
    Eigen::MatrixXd by_station_;                      ///< ∂g by the six coordinates of each station
    Eigen::MatrixXd bent_by_station_;                 ///< part of `by_station_` from the change of J
    Eigen::MatrixXd by_reading_;                      ///< ∂g by each reading and calibrated length
    std::vector<std::size_t> inputs_;                 ///< input quantity of each reading
};

class RowMaker {
public:
    RowMaker(const NetworkSetup& setup, std::span<const double> x, SensitivityRows& rows)
        : setup_(setup), x_(x), rows_(rows), sum_(x.size()) {}

    bool make() {
        rows_.assign(setup_.outputs(), {});
        if (!find_positions()) return false;
        for (const JointSetUp& joint : setup_.set_ups)
            if (!add_targets(joint)) return false;
        return add_derived();
    }

private:
    bool find_positions() {
        std::vector<double> y(setup_.outputs());
        Outputs<double> values(y.data());
        if (!all_targets<double>(setup_, Inputs<double>(x_.data()), values) || !values.finite()) return false;
        for (std::size_t t = 0; t < setup_.targets.size(); ++t)
            positions_.emplace_back(y[3 * t], y[3 * t + 1], y[3 * t + 2]);
        return true;
    }

    bool add_targets(const JointSetUp& joint) {
        if (joint.by_itself() || joint.together())
            return LeastSquaresSensitivities(setup_, part_of(setup_, joint), joint.index, x_,
                                             &positions_[joint.first])
                .add_to(joint.first, rows_);
        const bool nonlinear = setup_.estimator == Estimator::nonlinear;
        for (std::size_t t = 0; t < joint.targets; ++t)
            if (!(nonlinear ? add_alone(joint, joint.first + t) : add_explicit(joint, joint.first + t)))
                return false;
        return true;
    }

    /// A target with weights of its readings alone.
    bool add_alone(const JointSetUp& joint, std::size_t t) {
        const Part part{&setup_, &setup_.targets[t], 1, {}, setup_.targets[t].inverse_normal.data(), nullptr,
                        0};
        return LeastSquaresSensitivities(setup_, part, joint.index, x_, &positions_[t]).add_to(t, rows_);
    }

    /// A target whose estimate is given in closed form (Eqs 3 and 4).
    bool add_explicit(const JointSetUp& joint, std::size_t t) {
        std::vector<InputRange> ranges{{setup_.station_input(joint.index, 0), 6 * setup_.sensors.size()}};
        for (const Sight& sight : setup_.targets[t].sights)
            for (std::size_t i = 0; i < 3; ++i)
                if (sight.has[i]) add(ranges, sight.input[i]);
        for (const InputRange& range : ranges)
            for (std::size_t done = 0; done < range.count; done += Dual::size) {
                const std::size_t at = range.first + done;
                const Inputs<Dual> variables(x_.data(), at);
                DualRows out(rows_, at, std::min(Dual::size, range.count - done));
                locate_stations(setup_, variables, joint.index, places_.data());
                if (!some_targets(setup_, joint, t, 1, places_.data(), variables, out)) return false;
                if (!out.finite()) return false;
            }
        return true;
    }

    static void add(std::vector<InputRange>& ranges, std::size_t input) {
        InputRange& last = ranges.back();
        if (input == last.first + last.count)
            ++last.count;
        else
            ranges.push_back({input, 1});
    }

    /// Adds the rows of distances, angles, frames and bars, by the chain rule from those of the coordinates.
    bool add_derived() {
        std::size_t out = 3 * setup_.targets.size();
        for (const Distance& d : setup_.distances) out = add(d, {d.from, d.to}, out);
        for (const Angle& a : setup_.angles) out = add(a, {a.from, a.at, a.to}, out);
        for (const TargetFrame& f : setup_.frames)
            out = add(f, {f.targets[0], f.targets[1], f.targets[2]}, out);
        for (const ScaleBar& b : setup_.bars) {
            out = add(b, {b.from, b.to}, out);
            rows_[out - 1].push_back({b.input, -1.0});
            sum_.add(rows_[out - 1], 1.0);
            rows_[out - 1] = sum_.take();
        }
        return true;
    }

    template <class Item>
    std::size_t add(const Item& item, const std::vector<std::size_t>& targets, std::size_t out) {
        Gradient gradient(out);
        for (std::size_t first = 0; first < 3 * targets.size(); first += Dual::size) {
            gradient.begin(first);
            const auto target = [&](std::size_t t) {
                const auto place =
                    static_cast<std::size_t>(std::find(targets.begin(), targets.end(), t) - targets.begin());
                Vector3<Dual> p;
                for (int c = 0; c < 3; ++c) {
                    const std::size_t k = 3 * place + static_cast<std::size_t>(c);
                    p[c] = k >= first && k < first + Dual::size ? Dual::variable(positions_[t][c], k - first)
                                                                : Dual(positions_[t][c]);
                }
                return p;
            };
            const Inputs<Dual> constants(x_.data(), x_.size());
            Derived<Dual, Inputs<Dual>, Gradient, decltype(target)>(setup_, constants, target, gradient)
                .put(item, out);
        }
        for (const auto& by : gradient.values()) {
            for (std::size_t k = 0; k < 3 * targets.size(); ++k)
                sum_.add(rows_[3 * targets[k / 3] + k % 3], by[k]);
            rows_[out++] = sum_.take();
        }
        return out;
    }

    const NetworkSetup& setup_;
    std::span<const double> x_;
    SensitivityRows& rows_;
    RowSum sum_;
    std::array<Place<Dual>, most_sensors> places_;
    std::vector<Eigen::Vector3d> positions_;
};

}  // namespace

bool network_sensitivities(const NetworkSetup& setup, std::span<const double> x, SensitivityRows& rows) {
    return RowMaker(setup, x, rows).make();
}

}  // namespace covaria::network
