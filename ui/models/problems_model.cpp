// Problems in words, with the place as people name it.
#include "ui/models/problems_model.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "core/project/entry_names.h"
#include "core/project/remedies.h"
#include "core/text/symbol.h"
#include "ui/document/correlated_pair.h"
#include "ui/document/missing_fields.h"
#include "ui/document/setup_address.h"
#include "ui/document/setup_cells.h"
#include "ui/models/roles.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// " (l_S)", of a row that states a quantity.
QString symbol_words(const FieldSpec& table, const Setup* setup, int row) {
    const auto* rows = setup ? std::get_if<SetupTable>(&value_of(table, *setup)) : nullptr;
    const auto at = static_cast<std::size_t>(row);
    if (!table.states_quantities || !rows || row < 0 || at >= rows->rows.size()) return {};
    const auto* symbol = cell_in<std::string>(table, rows->rows[at], "symbol");
    return symbol && !symbol->empty() ? QStringLiteral(" (%1)").arg(to_qt(symbol_to_unicode(*symbol)))
                                      : QString();
}

QString field_words(const SetupSchema* schema, const Setup* setup, const QStringList& parts) {
    const FieldSpec* field = schema && !parts.isEmpty() ? schema->find(to_std(parts[0])) : nullptr;
    if (!field) return parts.join(QStringLiteral(" › "));
    QString words = core_text(field->title);
    if (parts.size() > 2 && parts[1] == QStringLiteral("rows"))
        words += ProblemsModel::tr(", row %1").arg(parts[2].toInt() + 1) +
                 symbol_words(*field, setup, parts[2].toInt());
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
    if (path.starts_with("/review/")) return ProblemsModel::tr("Project: review");
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

/// Words for a member of one of the analysis' lists: "/links/0/analysis".
QString member_words(const AnalysisEntry& analysis, const QStringList& parts) {
    if (parts.size() < 2) return {};
    const auto at = static_cast<std::size_t>(parts[1].toUInt());
    const auto words = [&](const char* list, const auto& members, const auto& say) {
        return parts[0] == QLatin1String(list) && at < members.size() ? say(members[at]) : QString();
    };
    const auto called = [&](const QString& what, const std::string& name) {
        return name.empty() ? what + QLatin1Char(' ') + parts[1]
                            : what + QStringLiteral(" “%1”").arg(to_qt(name));
    };
    const auto of_symbol = [](const QString& what, const std::string& symbol) {
        return what.arg(to_qt(symbol_to_unicode(symbol)));
    };
    for (const QString& found :
         {words(
              "links", analysis.links,
              [&](const InputLink& link) { return of_symbol(ProblemsModel::tr("link of %1"), link.input); }),
          words("inputs", analysis.inputs,
                [&](const InputEdit& e) { return of_symbol(ProblemsModel::tr("change of %1"), e.symbol); }),
          words("requirements", analysis.requirements,
                [&](const Requirement& r) {
                    return of_symbol(ProblemsModel::tr("requirement on %1"), r.symbol);
                }),
          words("studies", analysis.studies,
                [&](const Study& study) { return called(ProblemsModel::tr("study"), study.name); }),
          words("designs", analysis.designs,
                [&](const Design& design) { return called(ProblemsModel::tr("design"), design.name); })})
        if (!found.isEmpty()) return found;
    return {};
}

/// Words for one of the certificates of an asset or analysis: "/certificates/0/number"; else empty.
QString certificate_words(const Project& project, const SetupAddress& address, const QStringList& parts) {
    if (parts.size() < 2 || parts[0] != QStringLiteral("certificates")) return {};
    const AnalysisEntry* analysis =
        address.owner == SetupOwner::analysis ? project.find_analysis(address.id) : nullptr;
    const AssetEntry* asset = address.owner == SetupOwner::asset ? project.find_asset(address.id) : nullptr;
    if (!analysis && !asset) return {};
    const auto& all = analysis ? analysis->certificates : asset->certificates;
    const auto at = static_cast<std::size_t>(parts[1].toUInt());
    return at < all.size() && !all[at].number.empty() ? to_qt(name_of(all[at]))
                                                      : ProblemsModel::tr("certificate %1").arg(at + 1);
}

/// Words for a part of an entry: "/setup/quantities/rows/2/value".
QString part_words(const Project& project, const SetupAddress& address, const std::string& part) {
    QStringList parts = to_qt(part).split('/', Qt::SkipEmptyParts);
    if (parts.isEmpty()) return {};
    if (parts.first() == QStringLiteral("options"))
        return ProblemsModel::tr("evaluation, %1").arg(in_words(parts.mid(1).join(QStringLiteral(", "))));
    const AnalysisEntry* analysis =
        address.owner == SetupOwner::analysis ? project.find_analysis(address.id) : nullptr;
    if (const auto pair = analysis ? pair_in(*analysis, part) : std::nullopt)
        return ProblemsModel::tr("correlation of %1 and %2")
            .arg(to_qt(symbol_to_unicode(pair->first)), to_qt(symbol_to_unicode(pair->second)));
    const QString member = analysis ? member_words(*analysis, parts) : QString();
    if (!member.isEmpty()) return member;
    if (const QString words = certificate_words(project, address, parts); !words.isEmpty()) return words;
    if (parts.first() == QStringLiteral("measured")) return ProblemsModel::tr("date of the measurement");
    if (parts.first() != QStringLiteral("setup")) return parts.join(QStringLiteral(" › "));
    parts.removeFirst();
    return field_words(find_schema(project, address), find_setup(project, address), parts);
}

/// Data of a cell that takes a remedy: it looks like a link.
QVariant remedy_data(const Remedy* remedy, int role) {
    if (!remedy) return {};
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return to_qt(remedy->words);
    if (role == Qt::ForegroundRole) return QGuiApplication::palette().color(QPalette::Link);
    if (role != Qt::FontRole) return {};
    QFont font = QGuiApplication::font();
    font.setUnderline(true);
    return font;
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

int ProblemsModel::remedies() const {
    std::size_t most = 0;
    for (const Problem& problem : problems_) most = std::max(most, problem.remedies.size());
    return std::min(static_cast<int>(most), column_count - remedy_column);
}

const Remedy* ProblemsModel::remedy_at(const QModelIndex& index) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || index.column() < remedy_column) return nullptr;
    const auto& remedies = problems_[static_cast<std::size_t>(index.row())].remedies;
    const auto at = static_cast<std::size_t>(index.column() - remedy_column);
    return at < remedies.size() ? &remedies[at] : nullptr;
}

bool ProblemsModel::take_remedy(const QModelIndex& index) {
    const Remedy* found = remedy_at(index);
    if (!found) return false;
    const Remedy remedy = *found;  // the problems change with the project
    const auto changed = mended(document_.project(), remedy);
    if (!changed) {
        emit remedy_refused(to_qt(changed.error().message));
        return false;
    }
    document_.apply(to_qt(remedy.words), [&](Project& project) { project = *changed; });
    return true;
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
    const QString name = to_qt(shown_name(project, address.id, address.owner == SetupOwner::analysis));
    const QString part = part_words(project, address, path.substr(entry_path(project, address).size()));
    return part.isEmpty() ? name : name + ": " + part;
}

QString ProblemsModel::missing_words(const Document& document, const std::string& analysis) {
    const Project& project = document.project();
    const SetupAddress own{SetupOwner::analysis, analysis};
    const std::string entry = entry_path(project, own);
    const auto missing = next_missing(project, document.problems(), entry);
    if (entry.empty() || !missing) return {};
    return address_of_path(project, missing->path) == own
               ? part_words(project, own, missing->path.substr(entry.size()))
               : place_words(project, missing->path);
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Problem& problem = problems_[static_cast<std::size_t>(index.row())];
    // Of every column: a delegate knows by it that the row is no head of a tree.
    if (role == severity_role) return static_cast<int>(problem.severity);
    if (index.column() >= remedy_column) return remedy_data(remedy_at(index), role);
    switch (role) {
        case path_role:
            return to_qt(problem.path);
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
    if (section >= remedy_column) return section == remedy_column ? tr("Way out") : tr("or");
    return section == severity_column ? tr("Kind") : section == place_column ? tr("Place") : tr("Problem");
}

}  // namespace covaria::ui
