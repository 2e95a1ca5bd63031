#include "core/project/saved_view.h"

#include <algorithm>

namespace covaria {

const std::vector<std::string>& standard_view_names() {
    static const std::vector<std::string> names{"iso", "top", "front", "right", "bottom", "back", "left"};
    return names;
}

const SavedView* find_view(const std::vector<SavedView>& views, const std::string& name) {
    const auto found =
        std::find_if(views.begin(), views.end(), [&](const SavedView& view) { return view.name == name; });
    return found == views.end() ? nullptr : &*found;
}

}  // namespace covaria
