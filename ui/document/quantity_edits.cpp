// Edits of input quantities in the document.
#include "ui/document/quantity_edits.h"

#include <algorithm>

#include "ui/document/setup_address.h"

namespace covaria::ui {

namespace {

bool is_empty(const InputEdit& edit) {
    return edit == InputEdit{.symbol = edit.symbol};
}

}  // namespace

InputEdit find_input_edit(const Project& project, const std::string& analysis, const std::string& symbol) {
    if (const AnalysisEntry* entry = project.find_analysis(analysis))
        for (const InputEdit& edit : entry->inputs)
            if (edit.symbol == symbol) return edit;
    return {.symbol = symbol};
}

void change_input(Document& document, const std::string& analysis, const std::string& symbol,
                  const QString& text, const std::function<void(InputEdit&)>& change,
                  const QString& merge_key) {
    const auto edit_project = [&](Project& project) {
        AnalysisEntry* entry = find_analysis_entry(project, analysis);
        if (!entry) return;
        auto& edits = entry->inputs;
        auto edit =
            std::find_if(edits.begin(), edits.end(), [&](const auto& e) { return e.symbol == symbol; });
        if (edit == edits.end()) edit = edits.insert(edits.end(), {.symbol = symbol});
        change(*edit);
        if (is_empty(*edit)) edits.erase(edit);
    };
    document.apply(text, edit_project, merge_key);
}

}  // namespace covaria::ui
