// Plan by which components of uncertainty become values of the input quantities, trial by trial.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/propagation/trial_rows.h"
#include "core/quantity/component_pairs.h"
#include "core/quantity/isotropic_vector.h"
#include "core/random/sobol_points.h"

namespace covaria::detail {

/// x_quantity (+)= factor * epsilon; the first term of a quantity also brings in its constant part.
struct DrawTerm {
    std::size_t quantity = 0;
    double factor = 1.0;
    bool first = false;
};

struct ComponentDraw {
    std::uint32_t address = 0;  ///< index of the component in declared order
    Distribution distribution = {};
    std::vector<DrawTerm> terms = {};
    static constexpr std::size_t no_estimate = static_cast<std::size_t>(-1);
    /// Number of the estimate of variance in the plan. Draws are then mean + scale z / sqrt(chi^2/nu).
    std::size_t estimate = no_estimate;
};

/// chi^2/nu of an estimate of variance: one draw a trial for all of its members.
struct EstimateDraws {
    std::uint32_t address = 0;  ///< index of the estimate in declared order
    Distribution ratio = {};
};

/// Components with a Gaussian copula: z = factor * (independent standard normal draws, one per address).
struct CorrelatedDraws {
    std::vector<std::uint32_t> addresses;
    Eigen::MatrixXd factor;              ///< one row per member
    std::vector<ComponentDraw> members;  ///< held members have no terms
};

/// A vector of random direction: three uniform numbers at the addresses of its members make all three.
struct VectorDraws {
    VectorLength length;
    std::array<ComponentDraw, 3> members;  ///< held members have no terms
};

/// Scratch memory of one thread.
struct DrawWorkspace {
    explicit DrawWorkspace(std::size_t latent_rows) : latent(latent_rows), draw(1) {}
    TrialRows latent;  ///< a row for each estimate of variance, then those of one group
    TrialRows draw;
};

/// Immutable; shared by all threads. Held components stay at their mean and keep their address, so the draws
/// of all others are the same numbers with and without them.
class DrawPlan {
public:
    /// `correlations` as from `resolved_correlations`. With `only`, all other components are held.
    DrawPlan(const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations,
             std::optional<std::size_t> only = {});

    /// Draws then take these points, and no notice of the seed.
    void use(std::shared_ptr<const SobolPoints> points) { points_ = std::move(points); }
    /// Largest difference between a coefficient of the copula that the distributions need and the one that is
    /// drawn: 0 where the needed ones can all hold at once.
    double largest_compromise() const { return largest_compromise_; }
    std::size_t quantities() const { return constant_.size(); }
    std::size_t latent_rows() const { return estimates_.size() + latent_rows_; }
    /// Row i of `inputs` = quantity i of trials first ... first + count - 1 (count <= block_trials). No
    /// allocation. Lanes up to the next multiple of 8 repeat the last trial.
    void draw(std::uint64_t seed, std::uint64_t first, std::size_t count, TrialRows& inputs,
              DrawWorkspace& workspace) const;

private:
    /// Terms of each component: the quantities that its draws go to; fills in the constant parts.
    std::vector<ComponentDraw> terms_of(const InputSet& inputs, std::optional<std::size_t> only);
    /// Finds the components that are drawn with an estimate of variance in common.
    void add_estimates(const InputSet& inputs, std::vector<ComponentDraw>& draws);
    void add_group(const std::vector<std::size_t>& set, const std::vector<ComponentDraw>& draws,
                   const std::vector<ComponentCorrelation>& correlations);
    void add_vector(const DrawnVector& vector, const std::vector<ComponentDraw>& draws);
    void mark_first_terms();
    /// The draws of (seed, purpose, address) for consecutive trials.
    void fill(DrawPurpose purpose, std::uint64_t seed, std::uint32_t address, std::uint64_t first,
              std::span<double> u) const;
    void draw_estimates(std::uint64_t seed, std::uint64_t first, std::size_t count,
                        DrawWorkspace& workspace) const;
    /// Turns uniform numbers into values of an independent component, in place.
    void realise(const ComponentDraw& component, std::span<double> p, const DrawWorkspace& workspace) const;
    /// Does the same with standard normal draws.
    void realise_scores(const ComponentDraw& component, std::span<double> z,
                        const DrawWorkspace& workspace) const;
    void add_terms(const ComponentDraw& component, const double* epsilon, std::size_t count,
                   TrialRows& inputs) const;
    void draw_group(const CorrelatedDraws& group, std::uint64_t seed, std::uint64_t first, std::size_t count,
                    TrialRows& inputs, DrawWorkspace& workspace) const;

    void draw_vector(const VectorDraws& vector, std::uint64_t seed, std::uint64_t first, std::size_t count,
                     TrialRows& inputs, DrawWorkspace& workspace) const;

    std::vector<double> constant_;  ///< offset and constant components of each quantity
    std::vector<bool> drawn_;       ///< quantity has at least one term
    std::vector<EstimateDraws> estimates_;
    std::vector<ComponentDraw> independent_;
    std::vector<CorrelatedDraws> correlated_;
    std::vector<VectorDraws> vectors_;
    std::shared_ptr<const SobolPoints> points_;  ///< null: plain draws
    double largest_compromise_ = 0.0;
    std::size_t latent_rows_ = 0;  ///< number of rows of the largest group
};

/// F with F F^T = R for a positive semi-definite correlation matrix; columns = rank of R, rows of unit
/// length.
Eigen::MatrixXd correlation_factor(const Eigen::MatrixXd& correlation);

}  // namespace covaria::detail
