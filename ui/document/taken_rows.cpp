#include "ui/document/taken_rows.h"

#include <algorithm>
#include <set>

namespace covaria::ui {

namespace {

/// "/observations/rows/2/y" -> "/observations/rows/2"; empty: the place is in no row.
std::string row_in(const std::string& place) {
    static const std::string rows = "/rows/";
    const std::size_t at = place.find(rows);
    return at == std::string::npos ? std::string() : place.substr(0, place.find('/', at + rows.size()));
}

std::set<std::string> rows_of(const InputQuantity& quantity, const InputSet& inputs) {
    std::set<std::string> rows{row_in(quantity.source)};
    for (const Share& share : quantity.shares) rows.insert(row_in(inputs.components[share.component].source));
    rows.erase(std::string());
    return rows;
}

}  // namespace

std::map<std::string, InputLink> taken_rows(const AnalysisEntry& analysis, const MadeAnalysis& made) {
    std::map<std::string, InputLink> taken;
    if (analysis.links.empty() || !made.inputs) return taken;
    std::map<std::string, int> quantities;
    for (const InputQuantity& quantity : made.inputs->quantities) {
        const auto link = std::find_if(analysis.links.begin(), analysis.links.end(),
                                       [&](const InputLink& one) { return one.input == quantity.symbol; });
        for (const std::string& row : rows_of(quantity, *made.inputs)) {
            ++quantities[row];
            if (link != analysis.links.end()) taken.insert_or_assign(row, *link);
        }
    }
    std::erase_if(taken, [&](const auto& row) { return quantities[row.first] > 1; });
    return taken;
}

}  // namespace covaria::ui
