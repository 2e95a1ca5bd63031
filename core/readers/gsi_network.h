// Set-ups of a GSI file that see common points, as one network.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/readers/gsi_ties.h"
#include "core/readers/network_entry.h"
#include "core/readers/reader.h"

namespace covaria {

class GsiNetwork {
public:
    GsiNetwork(const GsiContent& content, const GsiTies& ties, Proposals& proposals)
        : content_(content), ties_(ties), proposals_(proposals) {}
    /// Adds the network of the set-ups that are tied.
    void propose(const std::string& title, const std::string& source);
    /// Whether the point is in the network, with its coordinates.
    bool holds(const std::string& point) const { return names_.contains(point); }

private:
    /// Standard deviations of one reading, m or rad; of a distance with a part in proportion.
    struct Figures {
        double direction = 0.0, zenith = 0.0, distance = 0.0, of_distance = 0.0;
    };
    void take_figures();
    void take_set_up(std::size_t number);
    void add(const GsiSetUp& set_up, const GsiSight& sight, const char* kind, double value, double u,
             const std::string& round);
    void take_points();
    bool are_stations_told() const;

    const GsiContent& content_;
    const GsiTies& ties_;
    Proposals& proposals_;
    NetworkEntry entry_;
    Figures figures_;
    std::set<std::string> names_;
    bool has_heights_ = true;  ///< whether the heights in the file are those above ground points
    std::size_t rounds_ = 0, without_distance_ = 0;
    bool has_pairs_ = false;  ///< whether any sight is in both faces
};

}  // namespace covaria
