// Readings that are more than their unknowns need, each with the stated uncertainty that it rests on: what
// any family of models offers that residuals may speak for or against.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/adjustment/sparse_factor.h"
#include "core/base/message.h"
#include "core/base/unit.h"

namespace covaria::evidence {

/// A standard uncertainty that a project states, for one reading or for many of one kind.
struct StatedFigure {
    Message name = {};        ///< "slope distances of TS1"
    Unit unit = {};           ///< unit in which it is shown
    double least = 0.0;       ///< smallest standard uncertainty of its readings, SI
    double most = 0.0;        ///< largest of them
    std::size_t count = 0;    ///< number of its readings
    std::string source = {};  ///< place in the set-up, where it or the first of its readings stands
};

/// The choice in the set-up by which uncertainties are those that the residuals see, and stay so when
/// readings change.
struct TakeOver {
    std::string field;               ///< key; empty: there is no such choice
    std::string as_stated, as_seen;  ///< its values
};

/// A place for what is computed of readings that nobody changes any more. A copy may be changed, and begins
/// anew.
class ComputedOnce {
public:
    struct Place;
    ComputedOnce();
    ComputedOnce(const ComputedOnce&) : ComputedOnce() {}
    ComputedOnce& operator=(const ComputedOnce&);
    Place& place() const { return *place_; }

private:
    std::shared_ptr<Place> place_;
};

/// A quantity that residuals are drawn over beside their order: a distance, a height.
struct Abscissa {
    Message name = {};  ///< "distance"
    Unit unit = {};
    std::vector<double> values = {};  ///< one for each reading, SI; NaN where a reading has none
};

/// Readings at the least sum of squares with the stated uncertainties, about which they count as linear in
/// their unknowns.
struct RedundantReadings {
    static constexpr std::size_t no_figure = static_cast<std::size_t>(-1);

    adjustment::SparseRows design = {};  ///< readings x unknowns
    /// Whitening as `adjustment::whitening`; no block joins figures. Empty: readings share sources of
    /// uncertainty, and `shares` says which.
    adjustment::SparseRows whitening = {};
    Eigen::VectorXd residuals = {};       ///< reading less adjusted reading, SI
    std::vector<std::size_t> datum = {};  ///< unknowns
    /// One for each reading; `no_figure`: its u is not asked about, or is of several figures (`shares`).
    std::vector<std::size_t> figure_of = {};
    /// A matrix for each figure, readings x components of one standard uncertainty: its product with its
    /// transpose is the figure's part of the covariance.
    std::vector<Eigen::MatrixXd> shares = {};
    Eigen::MatrixXd others = {};  ///< share of what is not asked about
    std::vector<StatedFigure> figures = {};
    std::vector<Message> names = {};  ///< names of the readings
    std::vector<double> w = {};  ///< standardised residuals as stated; NaN where nothing controls a reading
    std::vector<Abscissa> abscissas = {};
    std::vector<std::size_t> measurands = {};  ///< unknowns whose mean u says what follows
    Unit unit_of_measurands = {};
    TakeOver take_over = {};
    ComputedOnce computed = {};
};

}  // namespace covaria::evidence
