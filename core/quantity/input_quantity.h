// Input quantities and the components of uncertainty they are made of.
//
// x_i = offset_i + sum_j factor_ij * epsilon_j: every input quantity is a number plus a linear combination of
// components. A component that occurs in several quantities (the scale of one instrument, the temperature of
// one artefact) makes them correlated, exactly and at no cost. Further correlation between components is a
// Gaussian copula.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/name.h"
#include "core/base/unit.h"
#include "core/quantity/distribution.h"

namespace covaria {

enum class EvaluationType { type_a, type_b };  // JCGM 100 2.3.2, 2.3.3

/// A component or quantity belongs to a group of contributions: {"joint", "joint 4"}, {"kind", "lengths"}.
struct GroupTag {
    std::string grouping;
    Name group = {};
    bool operator==(const GroupTag&) const = default;
};

/// A component of uncertainty epsilon_j. Its index in InputSet::components is its address for random draws.
struct UncertaintyComponent {
    std::string id = {};  ///< unique in the set: "b_1x.calibration"
    Message name = {};    ///< name for people: "calibration of the artefact"
    Unit unit = {};       ///< unit for display
    Distribution distribution = {};
    EvaluationType type = EvaluationType::type_b;
    /// Degrees of freedom of the standard uncertainty; finite ones change the draws: `drawn_distribution`.
    double degrees_of_freedom = infinity;
    /// The user asks for normal draws in spite of finite degrees of freedom, which then count in the law of
    /// propagation alone.
    bool normal_draws = false;
    Message origin = {};  ///< where the figure comes from: "artefact plate-2d, Eq. 2", "certificate ..."
    bool held = false;    ///< held at its mean: contributes nothing ("ideal robot"); keeps its address
    /// Who brings it in, for results with all of a contributor held: the id of an asset, "" = the set-up.
    Name contributor = {};
    Name contributor_name = {};  ///< its name for people; empty: as `contributor`
    /// Id of the asset that states it, where that is not the contributor: a sensor of a network.
    std::string stated_by = {};
    std::vector<GroupTag> tags = {};  ///< beside those of its quantities
    /// Belongs to one point, whose coordinates share it only because they do not lie along its direction: an
    /// edit of one of them takes its place there.
    bool local = false;
    /// Name that a component of an asset, or of an asset's model in a chain, has wherever it occurs in a
    /// project ("tracker.scale"). Empty: the component belongs to this set of inputs alone.
    std::string identity = {};
    /// JSON pointer, relative to the set-up, of the row of a table that states it ("/quantities/rows/3");
    /// empty: it is stated elsewhere.
    std::string source = {};
};

/// An output of an analysis.
struct OutputReference {
    std::string analysis;    ///< its id
    std::string group = {};  ///< group of the output
    std::string symbol = {};
    bool operator==(const OutputReference&) const = default;
};

struct Share {
    std::size_t component = 0;
    double factor = 1.0;
    bool operator==(const Share&) const = default;
};

/// Rule by which the components of one quantity combine.
enum class Combination {
    quadrature,  ///< independent components (JCGM 100 5.1.2)
    arithmetic,  ///< fully correlated: standard uncertainties add linearly
};

struct InputQuantity {
    std::string symbol = {};  ///< "b_1x"
    Message name = {};        ///< "base point 1, x"
    Unit unit = {};           ///< unit for display
    double offset = 0.0;
    std::vector<Share> shares = {};
    Combination combination = Combination::quadrature;
    Name group = {};  ///< "base", "pose 7": for filtering and grouped contributions
    std::string source =
        {};  ///< JSON pointer of the set-up field the estimate comes from, relative to the set-up
    std::vector<GroupTag> tags = {};  ///< groups of contributions; kept when components are edited
    /// The set-up says that this output of another analysis is its value; it then has no components here.
    std::optional<OutputReference> taken_from = {};
    std::string analysis = {};  ///< id of the upstream analysis it belongs to, in a chain of models
};

/// Correlation coefficient between two components; copula.h says how they are drawn.
struct ComponentCorrelation {
    std::size_t first = 0;
    std::size_t second = 0;
    double coefficient = 0.0;
};

/// Three components that are the coordinates of a vector whose direction is random, uniform on the sphere:
/// uncorrelated, but not independent. Their common distribution says which law the length has; see
/// isotropic_vector.h.
struct IsotropicVector {
    std::array<std::size_t, 3> components{};
};

/// Components whose standard uncertainties all come from one estimate of variance: the standard deviation of
/// one series of observations that serves many points, the residuals of one fit. All have its degrees of
/// freedom, and a normal or Student t distribution; the scales may differ, and they may be correlated.
/// The law of propagation counts the degrees of freedom once, with the joint variance of the members; Monte
/// Carlo draws a multivariate t distribution: normal draws over one and the same sqrt(chi^2/nu) in a trial
/// (JCGM 102 5.3.2). Members that an edit replaces leave the estimate.
struct VarianceEstimate {
    std::string id = {};  ///< unique in the set: "plate.x"
    std::vector<std::size_t> components;
    bool of_asset = false;  ///< the id names it in all of a project, as `UncertaintyComponent::identity`
};

struct InputSet {
    std::vector<UncertaintyComponent> components;
    std::vector<InputQuantity> quantities;
    std::vector<ComponentCorrelation> correlations;
    std::vector<IsotropicVector> vectors = {};
    /// Their indices are addresses for random draws. A component is in one at most.
    std::vector<VarianceEstimate> variance_estimates = {};

    /// Adds a component and returns its index.
    std::size_t add(UncertaintyComponent component);
    /// Adds a quantity with independent components of its own; `estimate` is the offset.
    std::size_t add(InputQuantity quantity, std::vector<UncertaintyComponent> own_components);
    std::size_t find(const std::string& symbol) const;  ///< index of a quantity, or npos
    /// The component rests on the estimate of variance of that id, which is added if it is new.
    void rest_on_estimate(const std::string& id, std::size_t component, bool of_asset = false);
    /// The estimate of variance that each component rests on, or npos.
    std::vector<std::size_t> estimates_of_components() const;
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

/// Symbol of a component for people: that of its quantity where that has no other, else its id.
std::string symbol_of_component(const InputSet& inputs, std::size_t component);

/// The degrees of freedom stated, or those of its Student t distribution if these are fewer.
double degrees_of_freedom_of(const UncertaintyComponent& component);
/// The distribution drawn by Monte Carlo. A normal or Student t distribution with finite degrees of freedom
/// becomes the t with these, scaled by the standard uncertainty (JCGM 101 6.4.9.4); others stay.
Distribution drawn_distribution(const UncertaintyComponent& component);

/// x_i = offset + sum factor * mean(component): the estimate of quantity i.
double estimate_of(const InputSet& inputs, std::size_t quantity);
/// Standard uncertainty of quantity i for the law of propagation, with correlations and the rule of
/// combination.
double standard_uncertainty_of(const InputSet& inputs, std::size_t quantity);
/// Effective degrees of freedom of quantity i (WelchSatterthwaite over its components).
double degrees_of_freedom_of(const InputSet& inputs, std::size_t quantity);
/// All pairwise correlations between components: those declared plus +-1 between components of arithmetic
/// quantities. Error: coefficient outside [-1, 1], index out of range, a coordinate of a vector of random
/// direction, a set of components whose matrix is not positive semi-definite (the message names the
/// components and the smallest eigenvalue), an estimate of variance whose members cannot share it.
Result<std::vector<ComponentCorrelation>> resolved_correlations(const InputSet& inputs);

}  // namespace covaria
