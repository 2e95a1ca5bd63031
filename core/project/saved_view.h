// A named way to look at the scene of an analysis: no result depends on it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace covaria {

struct SavedView {
    using Vector = std::array<double, 3>;
    std::string name = {};
    Vector direction = {0, 1, 0};  ///< direction from the eye into the scene, in W
    Vector up = {0, 0, 1};         ///< direction that is up in the picture; not along `direction`
    Vector centre = {0, 0, 0};     ///< point in the middle of the picture, m
    double width = 0.0;            ///< width of what is seen there, m
    double height = 0.0;
    bool perspective = false;
    std::vector<std::string> hidden = {};  ///< items of the scene that are hidden: "body:moving platform"
    std::string only = {};                 ///< item that is shown alone; empty: all but `hidden`
    bool operator==(const SavedView&) const = default;
};

/// Names that a view cannot have, because they are those of the standard views, which `covaria render
/// --view` takes as well.
const std::vector<std::string>& standard_view_names();

/// The view of that name, or null.
const SavedView* find_view(const std::vector<SavedView>& views, const std::string& name);

}  // namespace covaria
