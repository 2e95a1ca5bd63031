// Labels of vertical marks in rows above the plot area, moved aside so that none covers another.
#pragma once

#include <vector>

namespace covaria::ui {

struct MarkLabel {
    double at = 0.0;  ///< wanted place of its middle
    double width = 0.0;
    bool prominent = false;  ///< goes to the upper row when one row does not do
    double left = 0.0;       ///< result
    int row = 0;             ///< result: 0 is next to the plot area
};

/// Places labels between `low` and `high` with `gap` between neighbours. Returns the number of rows.
int place_mark_labels(std::vector<MarkLabel>& labels, double low, double high, double gap);

}  // namespace covaria::ui
