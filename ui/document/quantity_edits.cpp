// Edits of input quantities in the document.
#include "ui/document/quantity_edits.h"

#include <algorithm>

#include "core/text/symbol.h"
#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

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

QString quantity_notes(const Project& project, const std::string& analysis, const std::string& symbol) {
    if (const AnalysisEntry* entry = project.find_analysis(analysis))
        for (const QuantityNotes& notes : entry->quantity_notes)
            if (notes.symbol == symbol) return to_qt(notes.notes);
    return {};
}

void set_quantity_notes(Document& document, const std::string& analysis, const std::string& symbol,
                        const QString& notes) {
    document.apply(
        Document::tr("Change notes of %1").arg(to_qt(symbol_to_unicode(symbol))),
        [&](Project& project) {
            AnalysisEntry* entry = find_analysis_entry(project, analysis);
            if (!entry) return;
            auto& all = entry->quantity_notes;
            const auto known = std::find_if(all.begin(), all.end(),
                                            [&](const QuantityNotes& n) { return n.symbol == symbol; });
            if (notes.isEmpty() && known != all.end())
                all.erase(known);
            else if (known != all.end())
                known->notes = to_std(notes);
            else if (!notes.isEmpty())
                all.push_back({symbol, to_std(notes)});
        },
        QStringLiteral("quantity-notes:%1:%2").arg(to_qt(analysis), to_qt(symbol)));
}

std::optional<InputLink> find_link(const Project& project, const std::string& analysis,
                                   const std::string& symbol) {
    if (const AnalysisEntry* entry = project.find_analysis(analysis))
        for (const InputLink& link : entry->links)
            if (link.input == symbol) return link;
    return {};
}

void set_link(Document& document, const std::string& analysis, const std::string& symbol,
              const std::optional<InputLink>& link) {
    const QString shown = to_qt(symbol_to_unicode(symbol));
    document.apply(
        link ? Document::tr("Take %1 from an analysis").arg(shown)
             : Document::tr("Remove the link of %1").arg(shown),
        [&](Project& project) {
            AnalysisEntry* entry = find_analysis_entry(project, analysis);
            if (!entry) return;
            const auto known = std::find_if(entry->links.begin(), entry->links.end(),
                                            [&](const InputLink& other) { return other.input == symbol; });
            const bool new_link = known == entry->links.end();
            if (!link && !new_link) entry->links.erase(known);
            if (!link) return;
            if (new_link)
                entry->links.push_back(*link);
            else
                *known = *link;
            std::erase_if(entry->inputs, [&](const InputEdit& edit) { return edit.symbol == symbol; });
            std::erase_if(entry->correlations, [&](const CorrelationEdit& edit) {
                return edit.first == symbol || edit.second == symbol;
            });
        });
}

}  // namespace covaria::ui
