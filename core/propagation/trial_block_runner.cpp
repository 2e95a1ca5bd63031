// One block of trials.
#include "core/propagation/trial_block_runner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria::detail {
namespace {

/// x - x is 0 for finite x and not a number otherwise; eight sums side by side for vector code.
bool all_finite(const double* y, std::size_t n) {
    double sums[8] = {};
    for (std::size_t t = 0; t + 8 <= n; t += 8)
        for (std::size_t lane = 0; lane < 8; ++lane) sums[lane] += y[t + lane] - y[t + lane];
    double sum = 0.0;
    for (double s : sums) sum += s;
    for (std::size_t t = n / 8 * 8; t < n; ++t) sum += y[t] - y[t];
    return sum == 0.0;
}

}  // namespace

TrialBlockRunner::TrialBlockRunner(const TrialSource& source)
    : source_(&source),
      inputs_(source.plan->quantities()),
      outputs_(source.rows()),
      workspace_(source.plan->latent_rows()),
      flags_(block_trials) {
    for (std::size_t j = 0; j < source.outputs(); ++j)
        if (source.model->outputs()[j].periodic) periodic_.push_back(j);
}

void TrialBlockRunner::run(std::uint64_t first, std::size_t count) {
    trials_ = count;
    source_->plan->draw(source_->seed, first, count, inputs_, workspace_);
    std::fill(flags_.begin(), flags_.end(), std::uint8_t{1});
    source_->model->evaluate_block({inputs_.data(), outputs_.data(), flags_.data(), block_trials, count});
    mark_not_finite();
    if (source_->linear) source_->linear->evaluate(inputs_, count, outputs_.row(source_->outputs()));
    valid_ = static_cast<std::size_t>(std::count_if(flags_.begin(),
                                                    flags_.begin() + static_cast<std::ptrdiff_t>(count),
                                                    [](std::uint8_t flag) { return flag != 0; }));
    if (valid_ != trials_) compact();
    unwrap();
}

void TrialBlockRunner::mark_not_finite() {
    for (std::size_t j = 0; j < source_->outputs(); ++j) {
        const double* y = outputs_.row(j);
        if (all_finite(y, trials_)) continue;
        for (std::size_t t = 0; t < trials_; ++t)
            if (!std::isfinite(y[t])) flags_[t] = 0;
    }
}

void TrialBlockRunner::compact() {
    for (std::size_t j = 0; j < source_->rows(); ++j) {
        double* y = outputs_.row(j);
        std::size_t kept = 0;
        for (std::size_t t = 0; t < trials_; ++t) {
            y[kept] = y[t];
            kept += flags_[t] != 0;
        }
    }
}

void TrialBlockRunner::unwrap() {
    constexpr double turn = 2 * std::numbers::pi;
    for (std::size_t j : periodic_) {
        double* y = outputs_.row(j);
        const double centre = source_->estimate(static_cast<Eigen::Index>(j));
        for (std::size_t t = 0; t < valid_; ++t) y[t] -= turn * std::nearbyint((y[t] - centre) / turn);
    }
}

}  // namespace covaria::detail
