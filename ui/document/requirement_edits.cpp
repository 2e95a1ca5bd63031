#include "ui/document/requirement_edits.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/text/symbol.h"
#include "ui/document/setup_address.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

bool asks_for_nothing(const Requirement& r) {
    Requirement bare;
    bare.symbol = r.symbol;
    bare.group = r.group;
    return r == bare;
}

}  // namespace

bool is_about(const Requirement& requirement, const OutputQuantity& output) {
    return requirement.symbol == output.symbol && requirement.group == output.group;
}

const Requirement* find_requirement(const AnalysisEntry& analysis, const OutputQuantity& output) {
    const auto found = std::ranges::find_if(analysis.requirements,
                                            [&](const Requirement& r) { return is_about(r, output); });
    return found == analysis.requirements.end() ? nullptr : &*found;
}

QString complaint_of_target(const std::optional<Quantity>& target) {
    if (!target || target->value > 0.0) return {};
    return to_qt(tell<"the %1 must be greater than zero">(tell<"target uncertainty">()));
}

QString complaint_of_limits(const std::optional<Quantity>& lower, const std::optional<Quantity>& upper) {
    if (!lower || !upper || lower->si() < upper->si()) return {};
    return to_qt(tell<"the %1 must be above the lower limit">(tell<"upper limit">()));
}

void change_requirements(Document& document, const std::string& analysis,
                         const std::vector<OutputQuantity>& outputs,
                         const std::function<void(Requirement&)>& edit, const QString& key) {
    if (outputs.empty()) return;
    const QString words =
        outputs.size() == 1
            ? Document::tr("Change the requirement for %1").arg(to_qt(symbol_to_unicode(outputs[0].symbol)))
            : Document::tr("Change the requirements for %1 results").arg(outputs.size());
    document.apply(
        words,
        [&](Project& project) {
            AnalysisEntry* entry = find_analysis_entry(project, analysis);
            if (!entry) return;
            auto& all = entry->requirements;
            for (const OutputQuantity& output : outputs) {
                auto found =
                    std::ranges::find_if(all, [&](const Requirement& r) { return is_about(r, output); });
                if (found == all.end())
                    found = all.insert(all.end(), Requirement{output.group, output.symbol});
                edit(*found);
                if (asks_for_nothing(*found)) all.erase(found);
            }
        },
        key);
}

}  // namespace covaria::ui
