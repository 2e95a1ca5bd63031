// Edits of correlations; the core decides whether they are possible together.
#include "ui/models/input_correlation_model.h"

#include <QColor>
#include <algorithm>

#include "core/project/input_edits.h"
#include "ui/document/correlated_pair.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_address.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

bool is_pair(const covaria::CorrelationEdit& edit, const std::string& a, const std::string& b) {
    return (edit.first == a && edit.second == b) || (edit.first == b && edit.second == a);
}

template <class Container, class Value>
bool contains(const Container& container, const Value& value) {
    return std::find(container.begin(), container.end(), value) != container.end();
}

}  // namespace

InputCorrelationModel::InputCorrelationModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document_, &Document::project_changed, this, &InputCorrelationModel::refresh);
    connect(&document_.unread(), &UnreadTexts::changed, this, [this] {
        if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, rowCount() - 1));
    });
}

void InputCorrelationModel::set_analysis(std::shared_ptr<const PreparedAnalysis> analysis) {
    if (!analysis || !analysis_ || analysis->id != analysis_->id) added_.clear();
    analysis_ = std::move(analysis);
    refresh();
}

const std::vector<covaria::CorrelationEdit>& InputCorrelationModel::edits() const {
    static const std::vector<covaria::CorrelationEdit> none;
    const AnalysisEntry* entry = analysis_ ? document_.project().find_analysis(analysis_->id) : nullptr;
    return entry ? entry->correlations : none;
}

std::vector<std::string> InputCorrelationModel::shown_components() const {
    std::vector<std::string> shown;
    if (!analysis_) return shown;
    const auto add = [&](const std::string& id) {
        if (!contains(shown, id)) shown.push_back(id);
    };
    for (const ComponentCorrelation& known : analysis_->inputs.correlations) {
        add(analysis_->inputs.components[known.first].id);
        add(analysis_->inputs.components[known.second].id);
    }
    for (const covaria::CorrelationEdit& edit : edits()) {
        add(edit.first);
        add(edit.second);
    }
    for (const std::string& id : added_) add(id);
    return shown;
}

void InputCorrelationModel::refresh() {
    std::vector<std::string> shown = shown_components();
    if (analysis_)
        for (const auto& [at, text] :
             document_.unread().under({SetupOwner::analysis, analysis_->id}, correlations_part)) {
            const CorrelatedPair pair = pair_of(at.part).value_or(CorrelatedPair());
            for (const std::string& id : {pair.first, pair.second})
                if (!contains(shown, id)) shown.push_back(id);
        }
    if (shown != ids_) {
        beginResetModel();
        ids_ = shown;
        endResetModel();
    } else if (!ids_.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, rowCount() - 1));
    }
    // A text goes when another coefficient comes into its place.
    forget_unread([this](const TextPlace& at, const UnreadText& text) {
        const CorrelatedPair pair = pair_of(at.part).value_or(CorrelatedPair());
        const double now = coefficient(pair.first, pair.second);
        return to_std(number_text(now, QLocale::c())) != text.instead_of;
    });
    check();
}

TextPlace InputCorrelationModel::place(const QModelIndex& index) const {
    return {{SetupOwner::analysis, analysis_->id},
            part_of_pair(ids_[static_cast<std::size_t>(index.row())],
                         ids_[static_cast<std::size_t>(index.column())])};
}

const UnreadText* InputCorrelationModel::unread(const QModelIndex& index) const {
    return analysis_ ? document_.unread().find(place(index)) : nullptr;
}

void InputCorrelationModel::forget_unread(
    const std::function<bool(const TextPlace&, const UnreadText&)>& which) {
    if (!analysis_) return;
    const SetupAddress entry{SetupOwner::analysis, analysis_->id};
    UnreadTexts::Texts texts = document_.unread().under(entry, correlations_part);
    std::erase_if(texts, [&](const auto& one) { return which(one.first, one.second); });
    document_.unread().replace_under(entry, correlations_part, std::move(texts));
}

void InputCorrelationModel::check() {
    QString complaint;
    if (analysis_) {
        InputSet inputs = analysis_->inputs;
        Problems problems;
        apply_correlations(inputs, edits(), problems);
        if (problems.has_errors())
            complaint = to_qt(problems.items().front().message);
        else if (const auto resolved = resolved_correlations(inputs); !resolved)
            complaint = to_qt(resolved.error().message);
    }
    if (complaint == complaint_) return;
    complaint_ = complaint;
    emit complaint_changed();
}

void InputCorrelationModel::add_component(const std::string& id) {
    if (!contains(added_, id)) added_.push_back(id);
    refresh();
}

QString InputCorrelationModel::said(const std::string& id) const {
    const std::vector<UncertaintyComponent>& all = analysis_->inputs.components;
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.id == id; });
    if (known == all.end()) return to_qt(id);
    const auto at = static_cast<std::size_t>(known - all.begin());
    return to_qt(symbol_to_unicode(symbol_of_component(analysis_->inputs, at)));
}

void InputCorrelationModel::remove_component(int row) {
    const std::string id = ids_[static_cast<std::size_t>(row)];
    std::erase(added_, id);
    forget_unread([&id](const TextPlace& at, const UnreadText&) {
        return at.part.starts_with(correlations_part + id + "|") || at.part.ends_with("|" + id);
    });
    document_.apply(tr("Remove correlations of %1").arg(said(id)), [&](Project& project) {
        if (AnalysisEntry* entry = find_analysis_entry(project, analysis_->id))
            std::erase_if(entry->correlations, [&](const covaria::CorrelationEdit& edit) {
                return edit.first == id || edit.second == id;
            });
    });
    refresh();
}

std::vector<std::string> InputCorrelationModel::other_components() const {
    std::vector<std::string> others;
    if (!analysis_) return others;
    // Components of an analysis that a link comes from are correlated there, not here.
    std::vector<bool> upstream(analysis_->inputs.components.size(), false), own = upstream;
    for (const InputQuantity& quantity : analysis_->inputs.quantities)
        for (const Share& share : quantity.shares)
            (quantity.analysis.empty() ? own : upstream)[share.component] = true;
    for (std::size_t c = 0; c < own.size(); ++c)
        if (const std::string& id = analysis_->inputs.components[c].id;
            (own[c] || !upstream[c]) && !contains(ids_, id))
            others.push_back(id);
    for (const InputQuantity& quantity : analysis_->inputs.quantities)  // a quantity as a whole
        if (quantity.analysis.empty() && quantity.shares.size() > 1 && !contains(ids_, quantity.symbol))
            others.push_back(quantity.symbol);
    return others;
}

int InputCorrelationModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(ids_.size());
}

double InputCorrelationModel::coefficient(const std::string& a, const std::string& b) const {
    if (a == b) return 1.0;
    for (const covaria::CorrelationEdit& edit : edits())
        if (is_pair(edit, a, b)) return edit.coefficient;
    const InputSet& inputs = analysis_->inputs;
    for (const ComponentCorrelation& known : inputs.correlations)
        if (is_pair({inputs.components[known.first].id, inputs.components[known.second].id, 0.0}, a, b))
            return known.coefficient;
    return 0.0;
}

QModelIndex InputCorrelationModel::index_of(const std::string& a, const std::string& b) const {
    const auto row = std::find(ids_.begin(), ids_.end(), a), column = std::find(ids_.begin(), ids_.end(), b);
    return row == ids_.end() || column == ids_.end()
               ? QModelIndex()
               : index(static_cast<int>(row - ids_.begin()), static_cast<int>(column - ids_.begin()));
}

QVariant InputCorrelationModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const std::string& a = ids_[static_cast<std::size_t>(index.row())];
    const std::string& b = ids_[static_cast<std::size_t>(index.column())];
    const UnreadText* kept = unread(index);
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return kept ? kept->text : number_text(coefficient(a, b), QLocale());
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::BackgroundRole:
            if (kept) return refused_ground();
            return complaint_.isEmpty() || a == b || coefficient(a, b) == 0.0 ? QVariant()
                                                                              : QVariant(refused_ground());
        case Qt::ToolTipRole:
            if (kept) return kept->reason;
            return complaint_.isEmpty() ? to_qt(a + ", " + b) : complaint_;
        case problem_role:
            return kept ? kept->reason : complaint_;
        default:
            return {};
    }
}

QVariant InputCorrelationModel::headerData(int section, Qt::Orientation, int role) const {
    if (role != Qt::DisplayRole || section < 0 || section >= rowCount()) return {};
    return to_qt(ids_[static_cast<std::size_t>(section)]);
}

Qt::ItemFlags InputCorrelationModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && index.row() != index.column() ? flags | Qt::ItemIsEditable : flags;
}

bool InputCorrelationModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
    const QString typed = value.toString();
    const std::optional<double> r = parse_number(typed, QLocale());
    const std::string a = ids_[static_cast<std::size_t>(index.row())];
    const std::string b = ids_[static_cast<std::size_t>(index.column())];
    if (!r || *r < -1.0 || *r > 1.0) {
        const std::string now = to_std(number_text(coefficient(a, b), QLocale::c()));
        const QString reason =
            r ? tr("The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.")
              : tr("The correlation coefficient of %1 and %2 is a number; “%3” is not.");
        document_.unread().set(place(index), {typed, reason.arg(said(a), said(b), typed), now});
        return true;
    }
    document_.unread().remove(place(index));
    for (const std::string& id : {a, b})
        if (!contains(added_, id)) added_.push_back(id);  // stays in sight when its last coefficient goes
    document_.apply(tr("Change correlation of %1 and %2").arg(said(a), said(b)), [&](Project& project) {
        AnalysisEntry* entry = find_analysis_entry(project, analysis_->id);
        if (!entry) return;
        auto& all = entry->correlations;
        const auto known =
            std::find_if(all.begin(), all.end(), [&](const auto& edit) { return is_pair(edit, a, b); });
        if (known == all.end())
            all.push_back({a, b, *r});
        else
            known->coefficient = *r;
    });
    return true;
}

}  // namespace covaria::ui
