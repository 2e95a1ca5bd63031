// Capability "seen-figures": what the residuals of one network see of its instruments, for another network.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/kinds/network/adjusted_setup.h"
#include "core/model/capability.h"
#include "core/text/plot_specification.h"

namespace covaria::network {

/// Evidence of residuals about the readings of one kind by one instrument.
struct SeenFigureOfReadings {
    double factor = 1.0;      ///< ratio to the u that was stated there
    std::optional<double> u;  ///< their u where all of them have the same, SI
    double degrees_of_freedom = infinity;
    std::size_t estimate = 0;  ///< its number in that analysis
};

class SeenFiguresSource : public Capability {
public:
    static constexpr const char* capability = "seen-figures";
    static constexpr const char* lacking = "has no readings that are more than its unknowns need";
    /// Empty: there are no such readings, or too few of them to say.
    virtual std::optional<SeenFigureOfReadings> figure_of(ReadingKind kind,
                                                          const std::string& instrument) const = 0;
    /// The day of the readings, where it is stated.
    virtual std::optional<Days> day() const = 0;
};

/// The network with its evidence, which is made when it is first asked for.
class NetworkEvidence {
public:
    explicit NetworkEvidence(AdjustedNetwork made) : network(std::move(made)) {}
    const AdjustedNetwork network;
    /// Null: nothing is redundant.
    std::shared_ptr<const evidence::RedundantReadings> readings() const;
    std::optional<SeenFigureOfReadings> figure_of(ReadingKind kind, const std::string& instrument) const;

private:
    mutable std::once_flag asked_;
    mutable std::shared_ptr<const evidence::RedundantReadings> readings_;
};

/// The readings get what other analyses see of their kind and instrument: the u that these see where each
/// has one for all of them, else that factor of what is stated here; of several, what `evidence::combined`
/// makes of them. Warns of readings that none of them sees.
void take_seen_elsewhere(AdjustedNetwork& network, const std::vector<Offered<SeenFiguresSource>>& campaigns,
                         Problems& problems);
/// Charts of figures over the campaigns that saw them.
std::vector<PlotSpecification> figures_over_campaigns(const AdjustedNetwork& network);
/// The campaigns that a set-up names; `seen_in` first.
std::vector<Offered<SeenFiguresSource>> campaigns_of(const StatedAdjustment& stated);

}  // namespace covaria::network
