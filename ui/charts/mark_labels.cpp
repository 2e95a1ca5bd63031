// Labels of vertical marks in rows above the plot area.
#include "ui/charts/mark_labels.h"

#include <algorithm>
#include <cmath>

namespace covaria::ui {
namespace {

using Row = std::vector<MarkLabel*>;

/// Pushes neighbours apart to the right, then back from the right end.
void spread(Row& row, double low, double high, double gap) {
    std::sort(row.begin(), row.end(), [](const MarkLabel* a, const MarkLabel* b) { return a->at < b->at; });
    double least = low;
    for (MarkLabel* label : row) {
        label->left = std::max(label->at - 0.5 * label->width, least);
        least = label->left + label->width + gap;
    }
    double most = high;
    for (auto it = row.rbegin(); it != row.rend(); ++it) {
        (*it)->left = std::min((*it)->left, most - (*it)->width);
        most = (*it)->left - gap;
    }
}

/// Whether every label is above its mark and the row holds them all.
bool is_clear(const Row& row, double low) {
    return std::all_of(row.begin(), row.end(), [low](const MarkLabel* label) {
        const double off = std::abs(label->left + 0.5 * label->width - label->at);
        return label->left >= low - 0.5 && off <= 0.5 * label->width;
    });
}

}  // namespace

int place_mark_labels(std::vector<MarkLabel>& labels, double low, double high, double gap) {
    if (labels.empty()) return 0;
    Row all, lower, upper;
    for (MarkLabel& label : labels) {
        all.push_back(&label);
        (label.prominent ? upper : lower).push_back(&label);
    }
    spread(all, low, high, gap);
    if (is_clear(all, low) || upper.empty() || lower.empty()) return 1;
    spread(lower, low, high, gap);
    spread(upper, low, high, gap);
    for (MarkLabel* label : upper) label->row = 1;
    return 2;
}

}  // namespace covaria::ui
