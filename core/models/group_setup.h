// The set-up of "observations in groups" and its analysis of variance (JCGM 100 H.5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/data_table.h"
#include "core/model/setup_schema.h"

namespace covaria::group_observations {

/// K observations of one day, SI.
struct Group {
    std::string name;
    double mean = 0.0;
    double standard_deviation = 0.0;  ///< of a single observation
};

struct GroupSetup {
    std::vector<Group> groups;   ///< J
    std::size_t per_group = 0;   ///< K
    bool between_counts = true;  ///< the uncertainty includes the effect of the groups
    std::string symbol, name;
    Unit unit;
};

/// Letters as in JCGM 100 H.5.2.
struct Variances {
    double mean = 0.0;        ///< of the means of the groups
    double s_of_means = 0.0;  ///< s(Vbar_j)
    double s_a = 0.0;         ///< from the scatter of the means: sqrt(K) s(Vbar_j)
    double s_b = 0.0;         ///< from the scatter within the groups
    double nu_a = 0.0, nu_b = 0.0;
    double ratio = 0.0;      ///< F = s_a^2/s_b^2
    double s_between = 0.0;  ///< sqrt((s_a^2 - s_b^2)/K), 0 if that is negative
    double u = 0.0;          ///< of the mean
    double degrees_of_freedom = 0.0;
};

SetupSchema group_schema();
std::optional<GroupSetup> read_group_setup(const SetupReader& reader, Problems& problems);
Variances variances_of(const GroupSetup& setup);
std::vector<DataTable> group_evaluation(const GroupSetup& setup, const Variances& v);

}  // namespace covaria::group_observations
