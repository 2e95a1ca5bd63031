// The search for the least sum of squares of a network adjustment, by Gauss-Newton steps with the factor of
// each place.
#include <cmath>

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

namespace {

class AdjustmentSearch {
public:
    AdjustmentSearch(AdjustedNetwork& network, Problems& problems) : network_(network), problems_(problems) {}

    void run() {
        constexpr int most_steps = 100;
        if (const auto few = too_few_readings(network_))
            return problems_.error(adjustment_fields().place(&StatedAdjustment::readings), *few);
        for (int k = 0; k < most_steps; ++k) {
            const auto adjusted = std::make_shared<const adjustment::Adjustment>(
                design_of(network_, network_.state.data()), network_.whitening, network_.datum,
                network_.adjusted.get());
            if (adjusted->open().cols() > 0) return refuse(adjusted);
            if (!adjusted->is_solved()) break;
            network_.adjusted = adjusted;
            if (!step(*adjusted)) break;
            if (settled_) return;
        }
        network_.adjusted = nullptr;
        problems_.error(
            adjustment_fields().place(&StatedAdjustment::readings),
            tell<"the readings do not lead to a place of every point: the adjustment does not converge; "
                 "look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, "
                 "m and mm), and for coordinates that are far off">());
    }

    /// Searches with robust weights: residuals beyond some u count by their first power, those of a
    /// contradiction less and less.
    void run_robustly() {
        constexpr int steps = 40;
        constexpr double bend = 1.0;  // in u
        const adjustment::SparseRows own = network_.whitening;
        Eigen::VectorXd before = network_.state;
        std::optional<adjustment::Adjustment> last;
        for (int k = 0; k < steps; ++k) {
            const Eigen::VectorXd r = own * residuals_of(network_, network_.state.data());
            const Eigen::VectorXd weights =
                r.unaryExpr([](double v) { return std::sqrt(bend / std::fmax(bend, std::abs(v))); });
            network_.whitening = adjustment::SparseRows(weights.asDiagonal() * own);
            last = adjustment::Adjustment(design_of(network_, network_.state.data()), network_.whitening,
                                          network_.datum, last ? &*last : nullptr);
            const adjustment::Adjustment& adjusted = *last;
            if (!adjusted.is_solved()) break;
            const Eigen::VectorXd change =
                adjusted.step(adjusted.whitened().transpose() * Eigen::VectorXd(weights.cwiseProduct(r)));
            if (!change.allFinite()) break;
            before = network_.state;
            network_.state = moved_by(adjusted, change);
            if (change.cwiseProduct(adjusted.scale()).lpNorm<Eigen::Infinity>() < 1e-3) break;
        }
        if (!network_.state.allFinite()) network_.state = before;
        network_.whitening = own;
    }

private:
    void refuse(const std::shared_ptr<const adjustment::Adjustment>& adjusted) {
        constexpr std::size_t most_said = 10;
        const std::vector<Message> open = open_directions(network_, *adjusted);
        network_.adjusted = nullptr;
        network_.unsolved = adjusted;
        const std::string place = adjustment_fields().place(&StatedAdjustment::points);
        for (std::size_t i = 0; i < std::min(open.size(), most_said); ++i) problems_.error(place, open[i]);
        if (open.size() > most_said)
            problems_.error(
                place, tell<"and %1 further ways in which the points can move">(open.size() - most_said));
    }

    Eigen::VectorXd whitened_at(const Eigen::VectorXd& state) const {
        return network_.whitening * residuals_of(network_, state.data());
    }

    /// Whether the search may end with this step. Each step is as much shorter as the one before, and so is
    /// the change of the derivatives: the place where they were taken is then near enough to the estimates.
    bool is_settled(double length) const {
        constexpr double enough = 1e-9;  // as a part of a reading's u
        constexpr double nothing = 3e-7, next_to_nothing = 1e-8;
        const bool at_rounding = length < 1e-5 && length > 0.5 * last_;
        const bool follows = std::isfinite(last_) && length * length < enough * last_ &&
                             (length < nothing * last_ || length < next_to_nothing);
        return length < enough || at_rounding || follows;
    }

    /// The part of a step that is taken. Where readings hardly tell a direction, their curvature makes steps
    /// along it too long: each leads back beyond the one before.
    double part_of(const Eigen::VectorXd& change) {
        double part = 1.0;
        if (last_change_.size() > 0) {
            const double along = change.dot(last_change_) / last_change_.squaredNorm();
            // The whole steps before and now tell how much too long they are.
            if (along < 0.0) part = last_part_ / (1.0 - along);
            constexpr double least = 0.2;
            part = std::clamp(part, least, 1.0);
            if (part > 0.7) part = 1.0;
        }
        last_change_ = change;
        last_part_ = part;
        return part;
    }

    /// Takes the whole step, or halves it until the sum falls; false where it never does.
    bool step(const adjustment::Adjustment& adjusted) {
        const Eigen::VectorXd r = whitened_.size() > 0 ? whitened_ : whitened_at(network_.state);
        const Eigen::VectorXd change = adjusted.step(adjusted.whitened().transpose() * r);
        if (!change.allFinite()) return false;
        const double length = change.cwiseProduct(adjusted.scale()).lpNorm<Eigen::Infinity>();
        const double before = r.squaredNorm();
        const double whole = part_of(change.cwiseProduct(adjusted.scale()));
        for (double part = whole; part > 1e-6; part *= 0.5) {
            const Eigen::VectorXd moved = moved_by(adjusted, part * change);
            whitened_ = whitened_at(moved);
            const double sum = whitened_.squaredNorm();
            // Near the end the sum only rounds; the datum's own part may raise it a little.
            if (!(sum <= before * (1.0 + 1e-9) + 1e-9) && length > 1e-3) continue;
            network_.state = moved;
            settled_ = part == whole && is_settled(length);
            last_ = part == whole ? length : std::numeric_limits<double>::infinity();
            if (part != whole) last_change_.resize(0);
            return true;
        }
        return false;
    }

    /// The state after `change`; directions that no reading determines stay where the points of the datum
    /// were stated.
    Eigen::VectorXd moved_by(const adjustment::Adjustment& adjusted, const Eigen::VectorXd& change) const {
        Eigen::VectorXd from_stated = change;
        for (std::size_t k = 0; k < network_.place_of.size(); ++k) {
            const auto place = static_cast<Eigen::Index>(network_.place_of[k]);
            from_stated[static_cast<Eigen::Index>(k)] += network_.state[place] - network_.stated[place];
        }
        adjusted.to_datum(from_stated);
        Eigen::VectorXd state = network_.state;
        for (std::size_t k = 0; k < network_.place_of.size(); ++k) {
            const auto place = static_cast<Eigen::Index>(network_.place_of[k]);
            state[place] = network_.stated[place] + from_stated[static_cast<Eigen::Index>(k)];
        }
        return state;
    }

    AdjustedNetwork& network_;
    Problems& problems_;
    Eigen::VectorXd whitened_;  ///< whitened residuals at the state; none before the first step
    bool settled_ = false;
    double last_ = std::numeric_limits<double>::infinity();
    Eigen::VectorXd last_change_;  ///< the step before, whole; none at first and after one that was halved
    double last_part_ = 1.0;       ///< the part of it that was taken
};

}  // namespace

void start_robustly(AdjustedNetwork& network) {
    Problems none;
    AdjustmentSearch(network, none).run_robustly();
}

void adjust(AdjustedNetwork& network, Problems& problems) {
    AdjustmentSearch(network, problems).run();
    if (network.adjusted)
        network.reliability = adjustment::reliability_of(*network.adjusted, network.whitening, network.blocks,
                                                         residuals_of(network, network.state.data()));
}

}  // namespace covaria::network
