// Which set-ups of a GSI file are one network, because sights tell where they stand.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/readers/gsi_set_ups.h"

namespace covaria {

class GsiTies {
public:
    explicit GsiTies(const GsiContent& content);
    /// A set-up is tied where it has two points as far apart as another one has them, or sees two whose
    /// coordinates the file states. Those of most sights that are tied to each other are a network.
    bool are_any() const { return std::ranges::find(tied_, true) != tied_.end(); }
    bool is_tied(std::size_t set_up) const { return tied_[set_up]; }
    std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(tied_, true)); }
    /// The name of the point of a set-up.
    const std::string& station(std::size_t set_up) const { return stations_[set_up]; }
    /// Points with coordinates of their own.
    const std::map<std::string, const GsiPoint*>& control() const { return control_; }
    bool are_heights_of_ground() const;

private:
    using Places = std::map<std::string, std::array<double, 3>>;
    void name_stations();
    void find_ties();
    Places places_from(std::size_t set_up) const;
    void take_largest(const std::vector<std::size_t>& leaders);

    const GsiContent& content_;
    std::vector<std::string> stations_;
    std::map<std::string, const GsiPoint*> control_;
    std::vector<bool> tied_;
};

}  // namespace covaria
