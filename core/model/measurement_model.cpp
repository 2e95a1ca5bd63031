// Defaults for models that have only the one-trial form.
#include "core/model/measurement_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria {

namespace {

// Difference of two values of output j; of an angle, the short way round the circle.
double difference(const OutputQuantity& output, double a, double b) {
    return output.periodic ? std::remainder(a - b, 2.0 * std::numbers::pi) : a - b;
}

// Step at which rounding and the error of the extrapolated difference (of fourth order) are about equal.
// A quantity near 0 takes its scale from its standard uncertainty, and from 1 where that is 0 too.
double step_of(const InputSet& inputs, std::size_t i, double x) {
    const double u = i < inputs.quantities.size() ? standard_uncertainty_of(inputs, i) : 0.0;
    double scale = std::max(std::abs(x), std::isfinite(u) ? 10.0 * u : 0.0);
    if (scale == 0.0) scale = 1.0;
    return 1e-3 * scale;
}

class Differences {
public:
    Differences(const MeasurementModel& model, std::span<const double> x)
        : model_(model), x_(x.begin(), x.end()), low_(model.outputs().size()), high_(low_.size()) {}

    // d[j] = (y_j(x_i + h) - y_j(x_i - h)) / 2h. false: no value there.
    bool central(std::size_t i, double h, std::vector<double>& d) {
        const double x = x_[i];
        x_[i] = x + h;
        const double above = x_[i];
        bool valid = model_.evaluate(x_, high_);
        x_[i] = x - h;
        const double below = x_[i];
        valid = valid && model_.evaluate(x_, low_);
        x_[i] = x;
        for (std::size_t j = 0; valid && j < d.size(); ++j)
            d[j] = difference(model_.outputs()[j], high_[j], low_[j]) / (above - below);
        return valid;
    }

private:
    const MeasurementModel& model_;
    std::vector<double> x_, low_, high_;
};

}  // namespace

void MeasurementModel::evaluate_block(const TrialBlock& block) const {
    // Row and column of one trial; kept per thread, so that the hot loop allocates nothing.
    thread_local std::vector<double> x, y;
    x.resize(inputs().quantities.size());
    y.resize(outputs().size());
    for (std::size_t t = 0; t < block.trials; ++t) {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = block.inputs[i * block.stride + t];
        const bool valid = evaluate(x, y);
        block.valid[t] = valid ? 1 : 0;
        for (std::size_t j = 0; valid && j < y.size(); ++j) block.outputs[j * block.stride + t] = y[j];
    }
}

bool MeasurementModel::jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const {
    const std::size_t m = outputs().size();
    jacobian.resize(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(x.size()));
    Differences differences(*this, x);
    std::vector<double> wide(m), narrow(m);
    for (std::size_t i = 0; i < x.size(); ++i) {
        double h = step_of(inputs(), i, x[i]);
        // Near the edge of where the model has values, smaller steps may still fit.
        int attempts = 0;
        while (!differences.central(i, h, wide)) {
            if (++attempts == 20) return false;
            h /= 4.0;
        }
        if (!differences.central(i, h / 2.0, narrow)) return false;
        for (std::size_t j = 0; j < m; ++j)
            jacobian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) =
                (4.0 * narrow[j] - wide[j]) / 3.0;
    }
    return true;
}

bool MeasurementModel::sensitivities(std::span<const double> x, SensitivityRows& rows) const {
    Eigen::MatrixXd J(static_cast<Eigen::Index>(outputs().size()), static_cast<Eigen::Index>(x.size()));
    if (!jacobian(x, J) || !J.allFinite()) return false;
    rows.assign(outputs().size(), {});
    for (Eigen::Index j = 0; j < J.rows(); ++j)
        for (Eigen::Index i = 0; i < J.cols(); ++i)
            if (J(j, i) != 0.0)
                rows[static_cast<std::size_t>(j)].push_back({static_cast<std::size_t>(i), J(j, i)});
    return true;
}

}  // namespace covaria
