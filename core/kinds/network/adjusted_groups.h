// Readings that may be wrong together.
#pragma once

#include "core/adjustment/group_test.h"
#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

struct GroupOfReadings {
    Message words;
    std::vector<std::size_t> readings;
    adjustment::GroupTest test;
};

/// Groups of two readings or more that others control, by stations, rounds, targets and frames, the least
/// probable first; none for a network that is too large.
std::vector<GroupOfReadings> groups_of(const AdjustedNetwork& network);
Table groups_table(const std::vector<GroupOfReadings>& groups);

}  // namespace covaria::network
