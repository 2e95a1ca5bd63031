// From components of uncertainty to values of the input quantities, trial by trial.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/propagation/trial_rows.h"
#include "core/quantity/isotropic_vector.h"

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
    TrialRows latent;
    TrialRows draw;
};

/// Immutable; shared by all threads. Held components stay at their mean and keep their address, so the draws
/// of all others are the same numbers with and without them.
class DrawPlan {
public:
    /// `correlations` as from `resolved_correlations`. With `only`, all other components are held.
    DrawPlan(const InputSet& inputs, const std::vector<ComponentCorrelation>& correlations,
             std::optional<std::size_t> only = {});

    std::size_t quantities() const { return constant_.size(); }
    std::size_t latent_rows() const { return latent_rows_; }
    /// Row i of `inputs` = quantity i of trials first ... first + count - 1 (count <= block_trials). No
    /// allocation. Lanes up to the next multiple of 8 repeat the last trial.
    void draw(std::uint64_t seed, std::uint64_t first, std::size_t count, TrialRows& inputs,
              DrawWorkspace& workspace) const;

private:
    /// Where each component goes; fills in the constant parts.
    std::vector<ComponentDraw> terms_of(const InputSet& inputs, std::optional<std::size_t> only);
    void add_group(const std::vector<std::size_t>& set, const std::vector<ComponentDraw>& draws,
                   const std::vector<ComponentCorrelation>& correlations);
    void add_vector(const DrawnVector& vector, const std::vector<ComponentDraw>& draws);
    void mark_first_terms();
    void add_terms(const ComponentDraw& component, const double* epsilon, std::size_t count,
                   TrialRows& inputs) const;
    void draw_group(const CorrelatedDraws& group, std::uint64_t seed, std::uint64_t first, std::size_t count,
                    TrialRows& inputs, DrawWorkspace& workspace) const;

    void draw_vector(const VectorDraws& vector, std::uint64_t seed, std::uint64_t first, std::size_t count,
                     TrialRows& inputs, DrawWorkspace& workspace) const;

    std::vector<double> constant_;  ///< offset and constant components of each quantity
    std::vector<bool> drawn_;       ///< quantity has at least one term
    std::vector<ComponentDraw> independent_;
    std::vector<CorrelatedDraws> correlated_;
    std::vector<VectorDraws> vectors_;
    std::size_t latent_rows_ = 0;
};

/// F with F F^T = R for a positive semi-definite correlation matrix; columns = rank of R, rows of unit
/// length.
Eigen::MatrixXd correlation_factor(const Eigen::MatrixXd& correlation);

/// Components that are correlated with each other, directly or through others: sorted sets of two or more.
std::vector<std::vector<std::size_t>> correlated_sets(std::size_t components,
                                                      const std::vector<ComponentCorrelation>& correlations);

}  // namespace covaria::detail
