#include "core/kinds/sheets/theodolite_fit.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace covaria::sheets {

namespace {

/// Numbers of names in the order in which they come.
class Numbering {
public:
    std::size_t of(const std::string& name) { return numbers_.emplace(name, numbers_.size()).first->second; }
    std::size_t size() const { return numbers_.size(); }

private:
    std::map<std::string, std::size_t> numbers_;
};

double on_circle(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// Readings l = o_set + a_target + e of one series; without orientations l = a_target + e.
class SeriesAdjustment {
public:
    explicit SeriesAdjustment(bool with_orientations) : with_orientations_(with_orientations) {}

    void add(std::size_t row, const FaceReadings& r, double value) {
        rows_.push_back(row);
        sets_.push_back(set_numbers_.of(r.set));
        targets_.push_back(target_numbers_.of(r.target));
        values_.push_back(value);
    }

    /// Residuals into `residuals`, directions of the targets into `directions`, both by row.
    PooledScatter adjust(std::vector<std::optional<double>>& residuals, std::vector<double>& directions) {
        if (rows_.empty()) return {};
        begin();
        const auto n = Eigen::Index(rows_.size()), sets = Eigen::Index(orientations_.size());
        Eigen::MatrixXd design = Eigen::MatrixXd::Zero(n, sets + Eigen::Index(target_numbers_.size()));
        Eigen::VectorXd misclosure(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = std::size_t(i);
            if (with_orientations_) design(i, Eigen::Index(sets_[k])) = 1.0;
            design(i, sets + Eigen::Index(targets_[k])) = 1.0;
            misclosure[i] = on_circle(values_[k] - started(k));
        }
        // Orientations and directions may turn together: the rank is one less than the unknowns.
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor(design);
        const Eigen::VectorXd changes = factor.solve(misclosure);
        const Eigen::VectorXd left = design * changes - misclosure;
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = std::size_t(i);
            residuals[rows_[k]] = left[i];
            directions[rows_[k]] = on_circle(
                *started_targets_[targets_[k]] - *started_targets_[targets_.front()] +
                changes[sets + Eigen::Index(targets_[k])] - changes[sets + Eigen::Index(targets_.front())]);
        }
        return {left.squaredNorm(), double(n - factor.rank())};
    }

private:
    double started(std::size_t k) const {
        return started_targets_[targets_[k]].value_or(0.0) +
               (with_orientations_ ? orientations_[sets_[k]].value_or(0.0) : 0.0);
    }

    /// Values of the unknowns near which the readings are linear: the circle has been turned between sets.
    void begin() {
        started_targets_.assign(target_numbers_.size(), std::nullopt);
        orientations_.assign(with_orientations_ ? set_numbers_.size() : 0, std::nullopt);
        if (!with_orientations_) return;
        for (;;) {
            const auto unknown =
                std::ranges::find(started_targets_, false, &std::optional<double>::has_value);
            if (unknown == started_targets_.end()) return;
            *unknown = 0.0;  // the first target, or one that no reading connects with those before
            while (spread()) {
            }
        }
    }

    /// Known targets tell sets, and these tell targets; false: nothing is new.
    bool spread() {
        bool grows = false;
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            auto& target = started_targets_[targets_[k]];
            auto& orientation = orientations_[sets_[k]];
            if (target.has_value() == orientation.has_value()) continue;
            (target ? orientation : target) = on_circle(values_[k] - (target ? *target : *orientation));
            grows = true;
        }
        return grows;
    }

    bool with_orientations_;
    std::vector<std::size_t> rows_, sets_, targets_;
    std::vector<double> values_;
    Numbering set_numbers_, target_numbers_;
    std::vector<std::optional<double>> started_targets_, orientations_;
};

IndexReadings index_of(const std::vector<double>& readings) {
    IndexReadings index;
    index.count = readings.size();
    if (readings.empty()) return index;
    for (const double i : readings) index.mean += i / double(readings.size());
    for (const double i : readings) index.scatter.squares += (i - index.mean) * (i - index.mean);
    index.scatter.degrees_of_freedom = double(readings.size() - 1);
    return index;
}

TheodoliteSeries series_of(const TheodoliteSetup& setup, const std::string& name, TheodoliteFit& fit) {
    SeriesAdjustment directions(true), zeniths(false);
    std::vector<double> index, unused(setup.readings.size());
    for (std::size_t row = 0; row < setup.readings.size(); ++row) {
        const FaceReadings& r = setup.readings[row];
        if (r.series != name) continue;
        if (r.has_directions()) directions.add(row, r, r.direction());
        if (!r.has_zeniths()) continue;
        zeniths.add(row, r, r.zenith());
        index.push_back(r.index());
    }
    return {name, directions.adjust(fit.direction_residuals, fit.directions),
            zeniths.adjust(fit.zenith_residuals, unused), index_of(index)};
}

void pool(TheodoliteFit& fit) {
    for (const TheodoliteSeries& series : fit.series) {
        fit.directions_pooled += series.directions;
        fit.zeniths_pooled += series.zeniths;
        fit.index.count += series.index.count;
        fit.index.mean += double(series.index.count) * series.index.mean;
        fit.index.scatter += series.index.scatter;
    }
    if (fit.index.count > 0) fit.index.mean /= double(fit.index.count);
}

}  // namespace

double TheodoliteFit::series_with_index() const {
    return double(std::ranges::count_if(series, [](const auto& one) { return one.index.count > 0; }));
}

std::optional<double> TheodoliteFit::index_ratio() const {
    PooledScatter between{0.0, series_with_index() - 1.0};
    if (!between || !(index.scatter.squares > 0.0)) return std::nullopt;
    for (const TheodoliteSeries& one : series)
        between.squares += double(one.index.count) * std::pow(one.index.mean - index.mean, 2);
    return std::pow(between.s() / index.scatter.s(), 2);
}

TheodoliteFit fit_of(const TheodoliteSetup& setup) {
    TheodoliteFit fit;
    fit.direction_residuals.resize(setup.readings.size());
    fit.zenith_residuals.resize(setup.readings.size());
    fit.directions.resize(setup.readings.size());
    for (const FaceReadings& r : setup.readings)
        if (std::ranges::find(fit.series, r.series, &TheodoliteSeries::name) == fit.series.end())
            fit.series.push_back(series_of(setup, r.series, fit));
    pool(fit);
    return fit;
}

}  // namespace covaria::sheets
