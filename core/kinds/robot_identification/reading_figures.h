// Which stated figure each component of an identification's readings comes from. Shared by the ways of
// identification that fit an arm to readings.
#pragma once

#include <map>
#include <set>

#include "core/kinds/points/component_evidence.h"
#include "core/kinds/robot_identification/least_squares.h"

namespace covaria {

/// Encoder or repeatability of a joint.
FigureOfComponent figure_of_joint_reading(const UncertaintyComponent& component, const InputQuantity& input);

/// Figures of the components of input quantities, each of which has an owner: a pose, a measured point.
class FiguresOfReadings {
public:
    explicit FiguresOfReadings(const InputSet& inputs) : inputs_(inputs) {}

    template <class FigureOf>
    void take(std::size_t quantity, std::size_t owner, FigureOf figure_of) {
        const InputQuantity& input = inputs_.quantities[quantity];
        for (const Share& share : input.shares) {
            const auto [known, added] = owner_of_.try_emplace(share.component, owner);
            if (!added && known->second != owner) shared_.insert(share.component);
            figures_.insert_or_assign(share.component, figure_of(inputs_.components[share.component], input));
        }
    }
    /// Without components that several owners share, as a tracker's scale: the unknowns take them up.
    std::map<std::size_t, FigureOfComponent> of_one_owner() const;

private:
    const InputSet& inputs_;
    std::map<std::size_t, FigureOfComponent> figures_;
    std::map<std::size_t, std::size_t> owner_of_;
    std::set<std::size_t> shared_;
};

/// Evidence from a fit with the stated uncertainties; its problems will be those of the fit that follows.
template <class Calibration>
ComponentEvidence evidence_as_stated(Calibration stated) {
    Problems unsaid;
    return fit(stated, unsaid) ? stated.statistics.evidence : ComponentEvidence();
}

/// Adds the standardised residual of every row, which no figure states by itself.
void name_standardised(const identification::FitStatistics& statistics,
                       evidence::RedundantReadings& readings);

}  // namespace covaria
