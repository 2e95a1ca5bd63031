// Problems in words, with the place as people name it.
#include "ui/models/problems_model.h"

#include <algorithm>

#include "core/text/symbol.h"
#include "ui/document/correlated_pair.h"
#include "ui/document/missing_fields.h"
#include "ui/document/setup_address.h"
#include "ui/models/roles.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QString field_words(const SetupSchema* schema, const QStringList& parts) {
    const FieldSpec* field = schema && !parts.isEmpty() ? schema->find(to_std(parts[0])) : nullptr;
    if (!field) return parts.join(QStringLiteral(" › "));
    QString words = core_text(field->title);
    if (parts.size() > 2 && parts[1] == QStringLiteral("rows"))
        words += ProblemsModel::tr(", row %1").arg(parts[2].toInt() + 1);
    if (parts.size() > 3) {
        const std::size_t by_key = SetupSchema::column(*field, to_std(parts[3]));
        const std::size_t column = by_key < field->columns.size() ? by_key : parts[3].toUInt();
        if (column < field->columns.size()) words += ", " + core_text(field->columns[column].title);
    }
    return words;
}

QString words_of_project(const std::string& path) {
    for (const CertificateField& field : certificate_fields())
        if (path == pointer_of(field))
            return ProblemsModel::tr("Project: certificate, %1").arg(core_text(field.title));
    return path.starts_with("/report/") ? ProblemsModel::tr("Project: report") : to_qt(path);
}

/// "coverageProbability" -> "coverage probability"
QString in_words(const QString& key) {
    QString words;
    for (const QChar c : key) {
        if (c.isUpper()) words += QLatin1Char(' ');
        words += c.toLower();
    }
    return words;
}

}  // namespace

ProblemsModel::ProblemsModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document), problems_(document.problems().items()) {
    connect(&document_, &Document::problems_changed, this, [this] { show(document_.problems()); });
}

void ProblemsModel::show(const Problems& problems) {
    beginResetModel();
    problems_ = problems.items();
    std::stable_sort(problems_.begin(), problems_.end(),
                     [](const Problem& a, const Problem& b) { return a.severity > b.severity; });
    endResetModel();
}

int ProblemsModel::errors() const {
    return static_cast<int>(std::count_if(problems_.begin(), problems_.end(),
                                          [](const Problem& p) { return p.severity == Severity::error; }));
}

int ProblemsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(problems_.size());
}

int ProblemsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
}

QString ProblemsModel::place_words(const Project& project, const std::string& path) {
    const SetupAddress address = address_of_path(project, path);
    if (address.owner == SetupOwner::project) return words_of_project(path);
    if (address.id.empty()) return to_qt(path);
    const std::string entry = entry_path(project, address);
    QString name = to_qt(address.id);
    if (const AssetEntry* asset = project.find_asset(address.id); asset && address.owner == SetupOwner::asset)
        name = to_qt(asset->name);
    if (const AnalysisEntry* analysis = project.find_analysis(address.id);
        analysis && address.owner == SetupOwner::analysis)
        name = to_qt(analysis->name);
    QStringList parts = to_qt(path.substr(entry.size())).split('/', Qt::SkipEmptyParts);
    if (parts.isEmpty()) return name;
    if (parts.first() == QStringLiteral("options"))
        return name + ": " + tr("evaluation, %1").arg(in_words(parts.mid(1).join(QStringLiteral(", "))));
    if (const AnalysisEntry* analysis = project.find_analysis(address.id);
        analysis && address.owner == SetupOwner::analysis)
        if (const auto pair = pair_in(*analysis, path.substr(entry.size())))
            return name + ": " +
                   tr("correlation of %1 and %2")
                       .arg(to_qt(symbol_to_unicode(pair->first)), to_qt(symbol_to_unicode(pair->second)));
    if (parts.first() != QStringLiteral("setup")) return name + ": " + parts.join(QStringLiteral(" › "));
    parts.removeFirst();
    return name + ": " + field_words(find_schema(project, address), parts);
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Problem& problem = problems_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case path_role:
            return to_qt(problem.path);
        case severity_role:
            return static_cast<int>(problem.severity);
        case incomplete_role:
            return is_to_give(problem);
        case Qt::ToolTipRole:
            return to_qt(problem.message);
        case Qt::DisplayRole:
            break;
        default:
            return {};
    }
    if (index.column() == severity_column && is_to_give(problem)) return tr("To give");
    if (index.column() == severity_column)
        return problem.severity == Severity::error ? tr("Error") : tr("Warning");
    if (index.column() == message_column) return to_qt(problem.message);
    if (problem.file.empty()) return place_words(document_.project(), problem.path);
    const QString line = problem.line > 0 ? tr(", line %1").arg(problem.line) : QString();
    return to_qt(problem.file) + line + (problem.path.empty() ? QString() : ": " + to_qt(problem.path));
}

bool ProblemsModel::is_to_give(const Problem& problem) const {
    return problem.severity == Severity::error &&
           is_missing(document_.project(), document_.problems(), problem);
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section + 1;
    return section == severity_column ? tr("Kind") : section == place_column ? tr("Place") : tr("Problem");
}

}  // namespace covaria::ui
