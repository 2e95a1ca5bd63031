// The tree keeps ids only and follows the document with the smallest changes, so that views keep their
// selection.
#include "ui/models/project_tree_model.h"

#include <algorithm>
#include <utility>

#include "core/kinds/registries.h"
#include "core/project/entry_names.h"
#include "core/project/stated_requirements.h"
#include "ui/document/missing_fields.h"
#include "ui/document/project_edits.h"
#include "ui/models/roles.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

QString title_of_kind(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return core_text(kind ? kind->title : asset.kind);
}

QString title_of_category(int category) {
    switch (static_cast<ProjectTreeModel::Category>(category)) {
        case ProjectTreeModel::project_row:
            break;
        case ProjectTreeModel::artefacts:
            return ProjectTreeModel::tr("Artefacts");
        case ProjectTreeModel::instruments:
            return ProjectTreeModel::tr("Instruments");
        case ProjectTreeModel::robots:
            return ProjectTreeModel::tr("Robots");
        case ProjectTreeModel::points:
            return ProjectTreeModel::tr("Points and frames");
        case ProjectTreeModel::context:
            return ProjectTreeModel::tr("Context");
        case ProjectTreeModel::laboratory:
            return ProjectTreeModel::tr("Laboratory");
        case ProjectTreeModel::analyses:
            return ProjectTreeModel::tr("Analyses");
    }
    return {};
}

struct Verdicts {
    int failed = 0, all = 0;
};

/// Verdicts on the requirements as they are now; all 0 where nothing is known.
Verdicts not_met(const AnalysisEntry& analysis, const AnalysisStatus& status) {
    if (analysis.requirements.empty() || !status.is_current()) return {};
    const std::vector<RequirementResult> verdicts = judge(*status.result, analysis);
    const auto failed = std::count_if(verdicts.begin(), verdicts.end(),
                                      [](const RequirementResult& verdict) { return !is_met(verdict); });
    return {static_cast<int>(failed), static_cast<int>(verdicts.size())};
}

int not_met_in(const Project& project, const SetupAddress& at, AnalysisRunner& runner) {
    const AnalysisEntry* analysis = at.owner == SetupOwner::analysis ? project.find_analysis(at.id) : nullptr;
    return analysis ? not_met(*analysis, runner.status(to_qt(at.id))).failed : 0;
}

/// Data of an analysis by which its icons are chosen.
QVariant sign_of(const AnalysisEntry& analysis, const AnalysisStatus& status, int role) {
    if (role == state_role) return static_cast<int>(status.state);
    if (role == verdict_role) return ProjectTreeModel::verdict_words(analysis, status);
    if (role == icon_role) return QStringLiteral("model-") + to_qt(analysis.model);
    if (role != met_role) return {};
    const auto [failed, all] = not_met(analysis, status);
    return all > 0 && failed == 0;
}

/// The name as it was typed while it is edited, else told apart from others of that name.
template <class Entry>
QString name_for(int role, const Project& project, const Entry& entry, bool of_analysis) {
    return to_qt(role == Qt::EditRole ? entry.name : shown_name(project, entry.id, of_analysis));
}

}  // namespace

ProjectTreeModel::ProjectTreeModel(Document& document, AnalysisRunner& runner, QObject* parent)
    : QAbstractItemModel(parent), document_(document), runner_(runner), ids_(read()) {
    connect(&document_, &Document::project_changed, this, &ProjectTreeModel::refresh);
    connect(&document_, &Document::problems_changed, this, &ProjectTreeModel::refresh);
    connect(&runner_, &AnalysisRunner::state_changed, this, &ProjectTreeModel::refresh_state);
}

std::array<ProjectTreeModel::Ids, ProjectTreeModel::category_count> ProjectTreeModel::read() const {
    std::array<Ids, category_count> ids;
    for (const AssetEntry& asset : document_.project().assets) {
        const AssetDescriptor* kind = find_asset_kind(asset.kind);
        ids[artefacts + (kind ? static_cast<std::size_t>(kind->category) : 0)].push_back(asset.id);
    }
    for (const AnalysisEntry& analysis : document_.project().analyses) ids[analyses].push_back(analysis.id);
    return ids;
}

void ProjectTreeModel::refresh() {
    // A view that hears of a removed row leaves it, which ends what is being typed, which changes the
    // project: that is followed when this change has been.
    changed_again_ = true;
    if (refreshing_) return;
    refreshing_ = true;
    while (std::exchange(changed_again_, false)) {
        const auto next = read();
        for (int category = 0; category < category_count; ++category)
            refresh_category(category, next[static_cast<std::size_t>(category)]);
    }
    refreshing_ = false;
    emit dataChanged(index_of(project_row), index_of(project_row).siblingAtColumn(state_column));
}

void ProjectTreeModel::refresh_category(int category, const Ids& next) {
    Ids& ids = ids_[static_cast<std::size_t>(category)];
    const QModelIndex top = index(category, 0);
    const auto keep = [&](const std::string& id) {
        return std::find(next.begin(), next.end(), id) != next.end();
    };
    for (int row = static_cast<int>(ids.size()) - 1; row >= 0; --row) {
        if (keep(ids[static_cast<std::size_t>(row)])) continue;
        beginRemoveRows(top, row, row);
        ids.erase(ids.begin() + row);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < next.size(); ++i) {
        const int row = static_cast<int>(i);
        const auto from = std::find(ids.begin() + row, ids.end(), next[i]);
        if (from == ids.begin() + row && from != ids.end()) continue;
        if (from != ids.end()) {
            beginMoveRows(top, static_cast<int>(from - ids.begin()), static_cast<int>(from - ids.begin()),
                          top, row);
            std::rotate(ids.begin() + row, from, from + 1);
            endMoveRows();
        } else {
            beginInsertRows(top, row, row);
            ids.insert(ids.begin() + row, next[i]);
            endInsertRows();
        }
    }
    if (!ids.empty())
        emit dataChanged(index(0, 0, top), index(static_cast<int>(ids.size()) - 1, column_count - 1, top));
}

void ProjectTreeModel::refresh_state(const QString& id) {
    const QModelIndex changed = index_of({SetupOwner::analysis, to_std(id)});
    if (changed.isValid()) emit dataChanged(changed, changed.siblingAtColumn(state_column));
}

QModelIndex ProjectTreeModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row() + 1) : quintptr{0});
}

QModelIndex ProjectTreeModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || is_category(index)) return {};
    return createIndex(static_cast<int>(index.internalId()) - 1, 0, quintptr{0});
}

int ProjectTreeModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return category_count;
    if (!is_category(parent) || parent.column() != 0) return 0;
    return static_cast<int>(ids_[static_cast<std::size_t>(parent.row())].size());
}

int ProjectTreeModel::columnCount(const QModelIndex&) const {
    return column_count;
}

SetupAddress ProjectTreeModel::address(const QModelIndex& index) const {
    if (is_category(index) && index.row() == project_row) return project_address;
    if (!index.isValid() || is_category(index)) return {};
    const std::size_t category = index.internalId() - 1;
    return {category == analyses ? SetupOwner::analysis : SetupOwner::asset,
            ids_[category][static_cast<std::size_t>(index.row())]};
}

QModelIndex ProjectTreeModel::index_of(const SetupAddress& address) const {
    if (address.owner == SetupOwner::project) return index_of(project_row);
    for (int category = artefacts; category < category_count; ++category) {
        if ((category == analyses) != (address.owner == SetupOwner::analysis)) continue;
        const Ids& ids = ids_[static_cast<std::size_t>(category)];
        const auto found = std::find(ids.begin(), ids.end(), address.id);
        if (found != ids.end()) return index(static_cast<int>(found - ids.begin()), 0, index(category, 0));
    }
    return {};
}

QVariant ProjectTreeModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    if (is_category(index)) return category_data(index.row(), index.column(), role);
    const SetupAddress at = address(index);
    switch (role) {
        case id_role:
            return to_qt(at.id);
        case category_role:
            return static_cast<int>(index.internalId()) - 1;
        case path_role:
            return to_qt(entry_path(document_.project(), at));
        case help_role:
            return help_anchor(document_.project(), at);
        case problem_role:
            return problems_of(at);
        case worst_role:
            return static_cast<int>(worst_of(at));
        case incomplete_role:
            return is_incomplete(at);
        case count_role:
            return is_incomplete(at) ? static_cast<int>(found_in(at).size())
                                     : not_met_in(document_.project(), at, runner_);
        default:
            break;
    }
    if (at.owner == SetupOwner::analysis) {
        const AnalysisEntry* analysis = document_.project().find_analysis(at.id);
        return analysis ? analysis_data(*analysis, index.column(), role) : QVariant();
    }
    const AssetEntry* asset = document_.project().find_asset(at.id);
    return asset ? asset_data(*asset, index.column(), role) : QVariant();
}

QVariant ProjectTreeModel::category_data(int category, int column, int role) const {
    if (role == category_role) return category;
    if (category == project_row) return project_data(column, role);
    return role == Qt::DisplayRole && column == name_column ? title_of_category(category) : QVariant();
}

QVariant ProjectTreeModel::project_data(int column, int role) const {
    const QString problems = problems_of(project_address);
    const QString title = to_qt(document_.project().title);
    switch (role) {
        case Qt::DisplayRole:
            if (column != name_column) return problems.isEmpty() ? QString() : tr("has problems");
            return title.isEmpty() ? tr("Untitled project") : title;
        case Qt::EditRole:
            return title;
        case Qt::ToolTipRole:
            return (title.isEmpty() ? QString() : title + QLatin1Char('\n')) +
                   (problems.isEmpty() ? tr("Title, notes, certificate and contents of the report")
                                       : problems);
        case problem_role:
            return problems;
        case worst_role:
            return static_cast<int>(worst_of(project_address));
        default:
            return {};
    }
}

QVariant ProjectTreeModel::asset_data(const AssetEntry& asset, int column, int role) const {
    const QString problems = problems_of({SetupOwner::asset, asset.id});
    if (role == Qt::DisplayRole || role == Qt::EditRole) {
        if (column == name_column) return name_for(role, document_.project(), asset, false);
        return problems.isEmpty()                             ? QString()
               : is_incomplete({SetupOwner::asset, asset.id}) ? tr("incomplete")
                                                              : tr("has problems");
    }
    if (role != Qt::ToolTipRole) return {};
    return to_qt(asset.name) + QLatin1Char('\n') + (problems.isEmpty() ? title_of_kind(asset) : problems);
}

QString ProjectTreeModel::verdict_words(const AnalysisEntry& analysis, const AnalysisStatus& status) {
    const auto [failed, all] = not_met(analysis, status);
    return failed == 0 ? QString() : tr("%1 of %2 requirements not met").arg(failed).arg(all);
}

QVariant ProjectTreeModel::analysis_data(const AnalysisEntry& analysis, int column, int role) const {
    const AnalysisStatus& status = runner_.status(to_qt(analysis.id));
    if (const QVariant sign = sign_of(analysis, status, role); sign.isValid()) return sign;
    if (role == Qt::DisplayRole || role == Qt::EditRole)
        return column == name_column ? name_for(role, document_.project(), analysis, true)
                                     : words(status.state);
    if (role != Qt::ToolTipRole) return {};
    if (status.state == RunState::failed || status.state == RunState::incomplete) return status.message;
    const ModelDescriptor* model = find_model(analysis.model);
    const QString problems = problems_of({SetupOwner::analysis, analysis.id});
    const QString verdict = verdict_words(analysis, status);
    return to_qt(analysis.name) + QLatin1Char('\n') + core_text(model ? model->title : analysis.model) +
           QStringLiteral(": ") + words(status.state) +
           (verdict.isEmpty() ? verdict : QLatin1Char('\n') + verdict) +
           (problems.isEmpty() ? problems : QLatin1Char('\n') + problems);
}

Severity ProjectTreeModel::worst_of(const SetupAddress& address) const {
    for (const Problem& problem : found_in(address))
        if (problem.severity == Severity::error) return Severity::error;
    return Severity::warning;
}

bool ProjectTreeModel::is_incomplete(const SetupAddress& address) const {
    const Project& project = document_.project();
    return lack_of(project, document_.problems(), entry_path(project, address)) == Lack::fields;
}

std::vector<Problem> ProjectTreeModel::found_in(const SetupAddress& address) const {
    const std::string path = entry_path(document_.project(), address);
    std::vector<Problem> found;
    for (const Problem& problem : document_.problems().items()) {
        const bool inside = problem.path == path || problem.path.starts_with(path + '/');
        const bool of_entry = problem.path.starts_with("/assets") || problem.path.starts_with("/analyses");
        if (address.owner == SetupOwner::project ? !of_entry : inside) found.push_back(problem);
    }
    return found;
}

QString ProjectTreeModel::problems_of(const SetupAddress& address) const {
    QStringList messages;
    for (const Problem& problem : found_in(address)) messages << to_qt(problem.message);
    return messages.join('\n');
}

QVariant ProjectTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == name_column ? tr("Project") : tr("State");
}

Qt::ItemFlags ProjectTreeModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractItemModel::flags(index);
    const bool category = is_category(index) && index.row() != project_row;
    const bool renames = index.isValid() && !category && index.column() == name_column;
    return renames ? flags | Qt::ItemIsEditable : flags;
}

bool ProjectTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable) || name.isEmpty()) return false;
    rename(document_, address(index), name);
    return true;
}

QString ProjectTreeModel::words(RunState state) {
    switch (state) {
        case RunState::running:
            return tr("running");
        case RunState::up_to_date:
            return tr("up to date");
        case RunState::failed:
            return tr("failed");
        case RunState::incomplete:
            return tr("incomplete");
        default:
            return tr("out of date");
    }
}

}  // namespace covaria::ui
