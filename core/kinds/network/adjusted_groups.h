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

/// Stations, rounds, targets and frames of two readings or more that others control, the least probable
/// first; none of a network that is too large.
std::vector<GroupOfReadings> groups_of(const AdjustedNetwork& network);
Table groups_table(const std::vector<GroupOfReadings>& groups);

}  // namespace covaria::network
