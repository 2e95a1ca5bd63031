#include "ui/models/impact_table_model.h"

#include <QGuiApplication>

#include "core/impact/impact_document.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

struct ImpactHead {
    const char* key;
    QString words;
};

std::vector<ImpactHead> column_heads() {
    return {{"file", ImpactTableModel::tr("File")},
            {"number", ImpactTableModel::tr("Number")},
            {"analysis name", ImpactTableModel::tr("Analysis")},
            {"group", ImpactTableModel::tr("Group")},
            {"symbol", ImpactTableModel::tr("Result")},
            {"unit", ImpactTableModel::tr("Unit")},
            {"estimate before", ImpactTableModel::tr("y before")},
            {"estimate after", ImpactTableModel::tr("y after")},
            {"U before", ImpactTableModel::tr("U before")},
            {"U after", ImpactTableModel::tr("U after")},
            {"change in u", ImpactTableModel::tr("Change / u")},
            {"change in U", ImpactTableModel::tr("Change / U")},
            {"change of U", ImpactTableModel::tr("Change of U in %")},
            {"verdict before", ImpactTableModel::tr("Verdict before")},
            {"verdict after", ImpactTableModel::tr("Verdict after")},
            {"to amend", ImpactTableModel::tr("To amend")}};
}

}  // namespace

void ImpactTableModel::set_impact(std::shared_ptr<const Impact> impact, bool is_evaluated) {
    impact_ = std::move(impact);
    is_evaluated_ = is_evaluated;
    if (!impact_) return set_contents({}, {}, {}, true);
    if (!is_evaluated_) {
        Table files{"users", "Files", impact_->using_it.size()};
        files.add("file", [&impact = *impact_](std::size_t row) -> Cell { return impact.using_it[row]; })
            .window(to_std(tr("File")));
        return set_contents(impact_, std::move(files), {"file"}, true);
    }
    Table table = impact_table(*impact_);
    std::vector<std::string> keys;
    for (const ImpactHead& head : column_heads()) {
        std::ranges::find(table.columns, head.key, &Column::key)->title = running_text(to_std(head.words));
        keys.emplace_back(head.key);
    }
    table.columns.front().cell = Cells(
        [&impact = *impact_](std::size_t row) -> Cell { return file_in_folder(impact.rows[row].file); });
    set_contents(impact_, std::move(table), std::move(keys), true);
}

QStringList ImpactTableModel::usually_hidden() {
    return {tr("Group"), tr("Change / u"), tr("Change of U in %")};
}

std::string ImpactTableModel::file_of(int row) const {
    const auto at = static_cast<std::size_t>(row);
    return is_evaluated_ ? impact_->rows[at].file : impact_->using_it[at];
}

QVariant ImpactTableModel::extra(std::size_t row, std::size_t column, int role) const {
    if (role == Qt::ToolTipRole)
        return tr("%1\nDouble click: opens it").arg(to_qt(file_of(static_cast<int>(row))));
    if (role != Qt::ForegroundRole || !is_evaluated_ || key(column) != "verdict after") return {};
    const ImpactRow& of = impact_->rows[row];
    if (!of.verdict_changes() || !of.after.met) return {};
    const Tokens& tokens = tokens_of(QGuiApplication::palette());
    return *of.after.met ? tokens.green : tokens.red;
}

}  // namespace covaria::ui
