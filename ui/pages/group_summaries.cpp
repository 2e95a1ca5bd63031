#include "ui/pages/group_summaries.h"

#include <QCoreApplication>

#include "core/project/option_fields.h"
#include "ui/models/project_tree_model.h"
#include "ui/theme/core_text.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

QString method_words(const EvaluationOptions& options) {
    for (const OptionField& field : option_fields()) {
        const auto* chosen = std::get_if<ChosenOption>(&field.member);
        if (!chosen || field.key != std::string("method")) continue;
        for (const Choice& choice : field.choices)
            if (choice.key == chosen->get(options)) return core_text(choice.title);
    }
    return {};
}

QString count_words(std::size_t count) {
    return count == 0 ? FoldGroups::tr("none") : QString::number(count);
}

}  // namespace

void summarise_groups(FoldGroups& groups, const AnalysisEntry& analysis, const AnalysisStatus& status) {
    const QString verdict = ProjectTreeModel::verdict_words(analysis, status);
    const QString notes = to_qt(analysis.notes).section(QLatin1Char('\n'), 0, 0);
    groups.set_summary(inputs_group,
                       status.prepared ? count_words(status.prepared->inputs.quantities.size()) : QString());
    groups.set_summary(options_group, method_words(analysis.options));
    groups.set_summary(studies_group, count_words(analysis.studies.size()));
    groups.set_summary(designs_group, count_words(analysis.designs.size()));
    groups.set_summary(requirements_group,
                       verdict.isEmpty() ? count_words(analysis.requirements.size()) : verdict);
    groups.set_summary(certificates_group, count_words(analysis.certificates.size()));
    groups.set_summary(notes_group, notes.isEmpty() ? FoldGroups::tr("none") : notes);
}

}  // namespace covaria::ui
