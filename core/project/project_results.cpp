#include "core/project/project_results.h"

#include <cmath>
#include <string>

namespace covaria {

void check_project_results(const ProjectResults& results, Problems& problems) {
    if (results.style.digits && *results.style.digits != 1 && *results.style.digits != 2)
        problems.error("/results/digits", "'digits' must be 1 or 2 (JCGM 100 7.2.6); it is " +
                                              std::to_string(*results.style.digits));
    if (const auto& k = results.coverage_factor; k && !(*k > 0.0 && std::isfinite(*k)))
        problems.error("/results/coverageFactor", "the coverage factor must be greater than zero");
}

}  // namespace covaria
