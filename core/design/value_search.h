// The search for values: a global method, then local ones from the present design and from random starts.
#pragma once

#include <vector>

#include "core/design/search.h"

namespace covaria::detail {

struct FoundValues {
    std::vector<double> values;
    bool feasible = false;
};

/// Finds values for these rows, which mean nothing without a table; the first start is at `from`. Throws
/// Stopped.
FoundValues find_values(SearchBook& book, const std::vector<std::size_t>& rows,
                        const std::vector<double>& from);

}  // namespace covaria::detail
