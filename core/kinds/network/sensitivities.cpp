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

/// The sensitivity coefficients of a target that is estimated by itself. At its estimate X the condition
/// g(X, x) = Jᵀ W r = 0 holds, so that dX/dx = −(∂g/∂X)⁻¹ ∂g/∂x; of the terms of g only those of one sight
/// depend on its station and readings.
class TargetByItself {
public:
    TargetByItself(const NetworkSetup& setup, const JointSetUp& joint, std::span<const double> x,
                   const Eigen::Vector3d& X)
        : setup_(setup), joint_(joint), x_(x), X_(X), by_station_(6 * setup.sensors.size(), zero) {}

    bool add_to(SensitivityRows& rows) {
        linearise();
        std::size_t row = 0;
        for (const Sight& sight : target().sights) row = add(sight, row);
        const Eigen::Matrix3d minus_inverse = -by_point_.inverse();
        if (!minus_inverse.allFinite()) return false;
        for (std::size_t i = 0; i < by_station_.size(); ++i)
            put(setup_.station_input(joint_.index, 0) + i, minus_inverse * by_station_[i], rows);
        for (const auto& [input, change] : by_reading_) put(input, minus_inverse * change, rows);
        return finite_;
    }

private:
    static inline const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    const Target& target() const { return setup_.targets[joint_.first]; }

    /// W r and W J at the estimate.
    void linearise() {
        const Inputs<double> x(x_.data());
        for (const Sight& sight : target().sights)
            places_[sight.sensor] = place_of<double>(setup_, x, joint_.index, sight.sensor);
        const Part part = part_of(setup_, joint_);
        at_.read(part, x);
        at_.take(part, places_.data(), x, &X_);
        at_.weigh(part);
        std::array<double, most_joint_rows> column, weighted;
        weighted_gradients_.resize(at_.rows);
        for (int c = 0; c < 3; ++c) {
            for (std::size_t i = 0; i < at_.rows; ++i) column[i] = at_.gradients[i][c];
            at_.weigh(part, column.data(), weighted.data());
            for (std::size_t i = 0; i < at_.rows; ++i) weighted_gradients_[i][c] = weighted[i];
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

    std::size_t add(const Sight& sight, std::size_t first_row) {
        const std::size_t station = setup_.station_input(joint_.index, sight.sensor);
        const Inputs<Dual> by_station(x_.data(), station);
        const Place<Dual> moved = place_of<Dual>(setup_, by_station, joint_.index, sight.sensor);
        const Changes of_station = changes(sight, first_row, moved, X_.cast<Dual>(), by_station);
        const Vector3<Dual> X(Dual::variable(X_[0], 0), Dual::variable(X_[1], 1), Dual::variable(X_[2], 2));
        const Place<double>& at = places_[sight.sensor];
        const Place<Dual> place{at.R.cast<Dual>(), at.o.cast<Dual>()};
        const Changes of_rest = changes(sight, first_row, place, X, SightInputs{x_.data(), sight});
        for (std::size_t i = 0; i < 6; ++i) by_station_[6 * sight.sensor + i] += of_station.g.col(int(i));
        by_point_ += of_rest.g.leftCols<3>();
        for (std::size_t o = 0; o < 3; ++o)
            if (sight.has[o]) by_reading_.emplace_back(sight.input[o], of_rest.g.col(3 + int(o)));
        return first_row + of_rest.rows;
    }

    /// What the variables do to g through the readings of one sight.
    struct Changes {
        Eigen::Matrix<double, 3, Dual::size> g = Eigen::Matrix<double, 3, Dual::size>::Zero();
        std::size_t rows = 0;
    };
    template <class In>
    Changes changes(const Sight& sight, std::size_t row, const Place<Dual>& place, const Vector3<Dual>& X,
                    const In& x) {
        Changes sum;
        const View<Dual> view(place, X);
        const ReadAngles<Dual> read(sight, x);
        for (std::size_t o = 0; o < 3; ++o) {
            if (!sight.has[o]) continue;
            const Vector3<Dual> j = gradient<Dual>(sight, o, place, view, read);
            const Dual r = residual<Dual>(sight, o, view, x, read);
            for (std::size_t k = 0; k < Dual::size; ++k)
                for (int c = 0; c < 3; ++c)
                    sum.g(c, int(k)) += j[c].partials()[k] * at_.weighted[row] +
                                        weighted_gradients_[row][c] * r.partials()[k];
            ++row;
            ++sum.rows;
        }
        return sum;
    }

    void put(std::size_t input, const Eigen::Vector3d& dX, SensitivityRows& rows) {
        finite_ = finite_ && dX.allFinite();
        for (std::size_t c = 0; c < 3; ++c)
            if (dX[int(c)] != 0.0) rows[3 * joint_.first + c].push_back({input, dX[int(c)]});
    }

    const NetworkSetup& setup_;
    const JointSetUp& joint_;
    std::span<const double> x_;
    const Eigen::Vector3d X_;
    std::array<Place<double>, most_sensors> places_;
    Linearised<double> at_;
    std::vector<Eigen::Vector3d> weighted_gradients_;  ///< by reading
    Eigen::Matrix3d by_point_ = Eigen::Matrix3d::Zero();
    std::vector<Eigen::Vector3d> by_station_;
    std::vector<std::pair<std::size_t, Eigen::Vector3d>> by_reading_;
    bool finite_ = true;
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
        if (joint.by_itself())
            return TargetByItself(setup_, joint, x_, positions_[joint.first]).add_to(rows_);
        if (joint.together()) return add_part(joint, joint.first, joint.targets);
        for (std::size_t t = 0; t < joint.targets; ++t)
            if (!add_part(joint, joint.first + t, 1)) return false;
        return true;
    }

    bool add_part(const JointSetUp& joint, std::size_t first, std::size_t count) {
        std::vector<InputRange> ranges{{setup_.station_input(joint.index, 0), 6 * setup_.sensors.size()}};
        for (std::size_t t = first; t < first + count; ++t)
            for (const Sight& sight : setup_.targets[t].sights)
                for (std::size_t i = 0; i < 3; ++i)
                    if (sight.has[i]) add(ranges, sight.input[i]);
        for (const std::size_t b : joint.bars) add(ranges, setup_.bars[b].input);
        for (const InputRange& range : ranges)
            for (std::size_t done = 0; done < range.count; done += Dual::size) {
                const std::size_t at = range.first + done;
                const Inputs<Dual> variables(x_.data(), at);
                DualRows out(rows_, at, std::min(Dual::size, range.count - done));
                locate_stations(setup_, variables, joint.index, places_.data());
                if (!some_targets(setup_, joint, first, count, places_.data(), variables, out)) return false;
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

    /// By the chain rule, from the coordinates.
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
