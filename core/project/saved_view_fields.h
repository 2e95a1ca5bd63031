// Saved views as project files have them.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/saved_view.h"

namespace covaria {

const JsonFields<SavedView>& saved_view_fields();

/// The list of the views of an analysis. A name that is taken, and a direction or size of zero, are reported.
struct SavedViewList {
    void read(ObjectReader& reader, const std::string& key, bool required,
              std::vector<SavedView>& member) const;
    void write(JsonWriter& out, const std::vector<SavedView>& member) const;
};

}  // namespace covaria
