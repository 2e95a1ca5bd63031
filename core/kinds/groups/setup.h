// The set-up of "observations in groups" and its analysis of variance (JCGM 100 H.5).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/asset.h"
#include "core/setup/fields.h"
#include "core/text/table.h"

namespace covaria::group_observations {

/// The observations of one day, SI.
struct Group {
    std::string name;
    double count = 0.0;
    double mean = 0.0;            ///< less the reference: metres that differ by micrometres keep their digits
    double sum_of_squares = 0.0;  ///< sum of the squared deviations from the mean
};

/// Basis of the mean and its uncertainty.
enum class Between {
    included,    ///< the scatter of the groups' means (JCGM 100 H.5.2.3)
    components,  ///< the components of variance, which also weight the groups
    none,        ///< all observations as independent (H.5.2.4)
};

/// The set-up as typed.
struct StatedGroups {
    enum class Data { observations, summary };
    struct Observation {
        std::string group;
        double value = 0.0;  ///< given in `unit`
    };
    struct Summary {
        std::string group;
        double mean = 0.0, s = 0.0;  ///< given in `unit`
        std::optional<int> n;        ///< empty: per_group
    };
    std::string symbol, name;
    Unit unit;
    Data data = Data::observations;
    std::vector<Observation> observations;
    std::vector<Summary> summaries;
    int per_group = 0;
    Between between = Between::included;
    std::optional<double> stated_within;   ///< standard deviation of an observation, SI
    std::optional<double> stated_between;  ///< standard deviation of the groups, SI
};
const Fields<StatedGroups>& group_fields();

struct GroupSetup : StatedGroups {
    std::vector<Group> groups;  ///< J
    double reference = 0.0;     ///< the first value; all means are relative to it
};

/// Letters as in JCGM 100 H.5.2; with groups of different size as in S. R. Searle, G. Casella, C. E.
/// McCulloch: Variance Components (1992), 3.6.
struct Variances {
    double observations = 0.0;                           ///< N
    double mean = 0.0;                                   ///< the estimate
    double s_of_means = 0.0;                             ///< s(Vbar_j), of the means without weights
    double between_squares = 0.0, within_squares = 0.0;  ///< sums of squares
    double nu_a = 0.0, nu_b = 0.0;                       ///< J - 1, N - J
    double group_size = 0.0;  ///< n_0 = (N - sum n_j^2/N)/(J - 1): K for groups of one size
    double s_a = 0.0;         ///< root of the mean square between the groups, from their means
    double s_b = 0.0;         ///< within the groups
    double ratio = 0.0;       ///< F = s_a^2/s_b^2; infinite where s_b is 0
    double s_between = 0.0;   ///< sqrt((s_a^2 - s_b^2)/n_0), 0 if that is negative
    double u = 0.0;           ///< standard uncertainty of the mean
    double degrees_of_freedom = 0.0;
};

SetupSchema group_schema();
std::optional<GroupSetup> read_group_setup(const SetupReader& reader, const AssetLibrary& assets,
                                           Problems& problems);
Variances variances_of(const GroupSetup& setup);
std::vector<Table> group_evaluation(const GroupSetup& setup, const Variances& v);

}  // namespace covaria::group_observations
