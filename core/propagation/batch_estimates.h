// Estimates from batches of trials: the best value of each figure of an output and an honest standard error.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace covaria::detail {

/// Figures of one output in one batch, or of its control (the linear part, as deviation from its centre).
struct BatchFigures {
    static constexpr std::size_t count = 4;
    std::array<double, count> values{};  ///< mean, variance, ends of the symmetric interval
};

/// Batches are independent, so the scatter of a figure between them gives its standard error. With a control
/// whose expectation is known the figure is regressed on that of the control over the batches and read where
/// the control has its expectation (Lavenberg and Welch, Management Science 27 (1981) 322; for quantiles Hsu
/// and Nelson, ibid. 36 (1990) 835): standard errors are those of that regression. Ends of intervals are a
/// curve of those of the control where the model is: they have a square term, without which the curve would
/// be read off by its curvature times the scatter of a batch. Means and variances need none: their regression
/// is unbiased. Where almost nothing is left but a curve, its cube makes the residuals, which are then no
/// scatter: what a cubic term would change, beyond its own noise, is part of the standard error, and so is
/// how far the expectation of the control may be off.
class BatchEstimates {
public:
    struct Control {
        std::size_t output = 0;
        /// Exact value of each figure; NaN: not known.
        std::array<double, BatchFigures::count> expectation{};
        std::array<double, BatchFigures::count> error{};  ///< largest error of that value
    };
    struct Estimate {
        double value = 0.0;
        /// Standard error; twice as much is held with 95.45 %, however few the batches (Student's t).
        double standard_error = 0.0;
        double gain = 1.0;        ///< variance without the control over the variance with it
        bool controlled = false;  ///< otherwise the value is the mean of the batches
        double slope = 0.0;       ///< regression of the figure on that of its control
    };
    /// Fewer batches say too little about a slope and a scatter.
    static constexpr std::uint64_t least_batches = 10;

    BatchEstimates(std::size_t outputs, const std::vector<Control>& controls);
    /// Adds the figures of one batch: outputs, then controls, as in the constructor. Batches come in order.
    void add(const std::vector<BatchFigures>& figures);
    /// Drops the controls, as what is known of them proves not to hold for these trials.
    void forget_controls();
    std::uint64_t batches() const { return batches_; }
    /// Estimate of a figure; its standard error is NaN with fewer than `least_batches`.
    Estimate estimate(std::size_t output, std::size_t figure) const;

private:
    struct Sums {
        double expectation = 0.0, error = 0.0;
        double y = 0.0, yy = 0.0;  ///< Welford sums
        /// Powers 0 ... 6 of v = l - expectation, l the control.
        std::array<double, 7> v{};
        /// d = y - l, less that of the first batch, which keeps its digits: sums of d, d v, ... d v^3, and
        /// d^2.
        double first_d = 0.0;
        std::array<double, 4> dv{};
        double dd = 0.0;
    };
    struct Fit;
    static Fit fitted(const Sums& sums, Eigen::Index terms);
    Estimate controlled(const Sums& sums, std::size_t figure) const;
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> control_of_;  ///< output -> place among the controls, or none
    std::vector<std::array<Sums, BatchFigures::count>> sums_;
    std::uint64_t batches_ = 0;
};

}  // namespace covaria::detail
