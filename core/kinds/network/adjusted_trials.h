// Trials of an adjusted network: its unknowns for readings that deviate, with the factor at the estimates.
#pragma once

#include <span>

#include "core/adjustment/lanes.h"
#include "core/kinds/network/near_predictions.h"
#include "core/model/measurement_model.h"

namespace covaria::network {

/// The unknowns where J₀ᵀ C⁻¹ (x − h(y)) = 0, with J₀ the derivatives at the estimates. A step of the search
/// is a right-hand side and a back substitution, for some trials at once, none of which takes notice of the
/// others.
class AdjustedTrials {
public:
    /// `network` was adjusted, and outlives this.
    explicit AdjustedTrials(const AdjustedNetwork& network);

    /// C⁻¹ J₀: a row for each reading.
    const adjustment::SparseRows& weighted() const { return weighted_; }
    /// The state of one trial; false: the search does not end.
    bool find_state(std::span<const double> x, std::vector<double>& state) const;
    /// The unknowns of one trial, or of a block, then the distances that are asked for.
    bool evaluate(std::span<const double> x, std::span<double> y) const;
    void evaluate(const TrialBlock& block) const;

private:
    template <class Numbers>
    struct Buffers;
    template <class Numbers, class Readings>
    void search(const Readings& x, Buffers<Numbers>& buffers) const;
    template <class Numbers, class Readings>
    void set_gradient(const Readings& x, bool has_moved, Buffers<Numbers>& buffers) const;
    template <class Numbers, class Readings>
    Numbers whole_residual(const Readings& x, std::size_t reading, const Buffers<Numbers>& buffers) const;
    template <class Numbers>
    void set_states(Buffers<Numbers>& buffers) const;
    template <class Numbers>
    void take_step(Buffers<Numbers>& buffers) const;
    template <class Numbers, class Put>
    void put_outputs(const Buffers<Numbers>& buffers, const Put& put) const;
    template <class Numbers>
    void evaluate_some(const TrialBlock& block, std::size_t first) const;

    const AdjustedNetwork& network_;
    NearPredictions near_;
    adjustment::SparseRows weighted_;
};

}  // namespace covaria::network
