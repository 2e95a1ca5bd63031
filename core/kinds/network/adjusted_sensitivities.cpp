#include "core/kinds/network/adjusted_sensitivities.h"

#include "core/kinds/network/adjusted_checks.h"

namespace covaria::network {

namespace {

class AdjustedSensitivities : public SensitivitySource {
public:
    AdjustedSensitivities(const AdjustedNetwork& network, const AdjustedTrials& trials,
                          std::vector<double> state)
        : network_(network),
          weighted_(trials.weighted()),
          state_(std::move(state)),
          design_(design_of(network, state_.data())) {
        constexpr double rounding = 1e-14;
        const adjustment::SparseRows at_estimates = design_of(network, network.state.data());
        is_at_estimates_ = (design_ - at_estimates).norm() <= rounding * at_estimates.norm();
    }

    bool row(std::size_t output, std::vector<Sensitivity>& row) const override {
        row.clear();
        const Eigen::VectorXd by_reading = weighted_ * implied(wanted(output));
        if (!by_reading.allFinite()) return false;
        row.reserve(static_cast<std::size_t>(by_reading.size()));
        for (Eigen::Index i = 0; i < by_reading.size(); ++i)
            if (by_reading[i] != 0.0) row.push_back({static_cast<std::size_t>(i), by_reading[i]});
        return true;
    }

private:
    /// The gradient of an output by the unknowns.
    Eigen::VectorXd wanted(std::size_t output) const {
        const std::size_t unknowns = network_.place_of.size();
        if (output >= unknowns) return gradient_of_distance(network_, output - unknowns, state_.data());
        Eigen::VectorXd e = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns));
        e[static_cast<Eigen::Index>(output)] = 1.0;
        return e;
    }

    /// The vector (J₀ᵀ C⁻¹ J)⁻ᵀ e, in steps with the factor at the estimates. Where J is J₀ there is one
    /// step, which takes away what the factor has rounded.
    Eigen::VectorXd implied(const Eigen::VectorXd& e) const {
        const int most_steps = is_at_estimates_ ? 1 : 30;
        Eigen::VectorXd z = network_.adjusted->cofactors(e);
        for (int k = 0; k < most_steps; ++k) {
            const Eigen::VectorXd forward = weighted_ * z;
            const Eigen::VectorXd left = e - design_.transpose() * forward;
            const Eigen::VectorXd change = network_.adjusted->cofactors(left);
            z += change;
            if (change.norm() <= 1e-13 * z.norm()) break;
        }
        return z;
    }

    const AdjustedNetwork& network_;
    const adjustment::SparseRows& weighted_;
    std::vector<double> state_;
    adjustment::SparseRows design_;
    bool is_at_estimates_ = false;
};

}  // namespace

std::unique_ptr<const SensitivitySource> sensitivities_at(const AdjustedNetwork& network,
                                                          const AdjustedTrials& trials,
                                                          std::span<const double> x) {
    std::vector<double> state;
    if (!trials.find_state(x, state)) return nullptr;
    return std::make_unique<AdjustedSensitivities>(network, trials, std::move(state));
}

}  // namespace covaria::network
