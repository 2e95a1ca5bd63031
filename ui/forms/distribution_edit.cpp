// The parameters come from distribution_kinds(); a new kind needs no line here.
#include "ui/forms/distribution_edit.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/project/component_edit.h"
#include "core/text/display_units.h"
#include "core/text/numbers.h"
#include "ui/document/quantity_text.h"
#include "ui/forms/complaint.h"
#include "ui/forms/form_labels.h"
#include "ui/models/number_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// Key of a list of parameters: of the values or edges (part 0), or of the probabilities.
std::string list_key(const std::string& distribution, std::size_t part) {
    const DistributionKindInfo* kind = find_distribution_kind(distribution);
    return part == 0 && kind ? std::string(kind->list) : "probabilities";
}

/// A distribution of the kind with parameters that are always possible.
Result<Distribution> any_of_kind(const DistributionKindInfo& kind) {
    static const std::map<std::string_view, double> usual{
        {"low", -1.0},   {"beta", 0.5},     {"inexactness", 0.1},         {"shape", 2.0},
        {"alpha", 2.0},  {"log_mean", 0.0}, {"degrees_of_freedom", 10.0}, {"location", 0.0},
        {"number", 9.0}, {"trials", 10.0},  {"probability", 0.5},         {"zero", 0.0}};
    if (kind.key == "histogram")
        return distribution_from(kind.key, std::vector<double>{-1.0, 0.0, 1.0, 0.5, 0.5});
    if (kind.parameters.empty()) return distribution_from(kind.key, std::vector<double>{-1.0, 1.0, 0.5, 0.5});
    std::vector<double> parameters;
    for (const DistributionParameterInfo& info : kind.parameters) {
        const auto found = usual.find(info.key);
        const bool is_location = info.key == "mean" && !info.is_interval;
        parameters.push_back(is_location ? 0.0 : found == usual.end() ? 1.0 : found->second);
    }
    return distribution_from(kind.key, parameters);
}

/// Whether kind and parameters say all about the distribution (not of one shifted beyond its kind).
bool is_plain(const Distribution& distribution) {
    const auto again = distribution_from(distribution.kind(), distribution_parameters(distribution));
    return again &&
           std::abs(again->mean() - distribution.mean()) <= 1e-9 * distribution.standard_uncertainty();
}

/// A distribution of the same kind with the wanted u, and with the wanted mean where the kind allows it.
Distribution fitted(const Distribution& distribution, double mean, double u) {
    const double own = distribution.standard_uncertainty();
    if (!(u > 0.0) || !std::isfinite(own) || !(own > 0.0)) return distribution;
    const Distribution wide = distribution.scaled(u / own);
    if (!is_plain(wide)) return distribution;
    const Distribution moved = wide.shifted(mean - wide.mean());
    return is_plain(moved) ? moved : wide;
}

std::optional<std::vector<double>> numbers_of(const QString& text, const QLocale& locale) {
    std::vector<double> numbers;
    for (const QString& part : text.split(';', Qt::SkipEmptyParts)) {
        const auto number = parse_number(part, locale);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace

DistributionEdit::DistributionEdit(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      parameters_(new QFormLayout),
      picture_(new DensityPicture(this)),
      summary_(new QLabel(this)) {
    for (const DistributionKindInfo& kind : distribution_kinds())
        kind_->addItem(core_text(kind.title), to_qt(kind.key));
    kind_->setAccessibleName(tr("Distribution"));
    kind_->setObjectName("distribution");
    may_be_narrow(*kind_);
    unit_->setAccessibleName(tr("Unit"));
    unit_->setObjectName("unit");
    summary_->setWordWrap(true);
    auto* head = new QFormLayout;
    head->addRow(tr("Distribution"), kind_);
    head->addRow(tr("Unit"), unit_);
    align_labels(*head, component_label_width(*this));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(head);
    layout->addLayout(parameters_);
    layout->addWidget(picture_);
    layout->addWidget(summary_);
    connect(kind_, &QComboBox::activated, this,
            [this](int row) { choose_kind(kind_->itemData(row).toString()); });
    connect(unit_, &QComboBox::activated, this, &DistributionEdit::choose_unit);
}

bool DistributionEdit::is_list() const {
    const DistributionKindInfo* kind = find_distribution_kind(component_.distribution);
    return kind && kind->parameters.empty();
}

bool DistributionEdit::is_histogram() const {
    return component_.distribution == "histogram";
}

void DistributionEdit::set_place(UnreadTexts& unread, const TextPlace& place) {
    unread_ = &unread;
    place_ = place;
}

void DistributionEdit::set_component(const ComponentEdit& component, bool normal_draws) {
    component_ = component;
    normal_draws_ = normal_draws;
    kind_->setCurrentIndex(kind_->findData(to_qt(component.distribution)));
    unit_->clear();
    for (const Unit& unit : DisplayUnits::choices(component.unit.interval()))
        unit_->addItem(to_qt(unit.display()), to_qt(unit.text()));
    if (component.unit.has_offset())  // from a file: a deviation in degC is one in K
        unit_->addItem(to_qt(component.unit.display()), to_qt(component.unit.text()));
    unit_->setCurrentIndex(unit_->findData(to_qt(component.unit.text())));
    if (shown_kind_ != component.distribution) rebuild_parameters();
    show_values();
    show_summary();
}

void DistributionEdit::choose_kind(const QString& key) {
    const DistributionKindInfo* kind = find_distribution_kind(to_std(key));
    if (!kind || component_.distribution == kind->key) return;
    if (unread_) unread_->replace_under(place_.entry, place_.part + "/", {});
    const Result<Distribution> start = any_of_kind(*kind);
    if (!start) return;
    const Result<Distribution> before = distribution_of(component_);
    set_distribution(component_,
                     before ? fitted(*start, before->mean(), before->standard_uncertainty()) : *start);
    rebuild_parameters();
    show_values();
    show_summary();
    emit component_edited(component_);
}

void DistributionEdit::choose_unit(int index) {
    const Result<Unit> unit = Unit::parse(to_std(unit_->itemData(index).toString()));
    if (!unit || *unit == component_.unit) return;
    set_component(in_unit(component_, *unit), normal_draws_);
    emit component_edited(component_);
}

void DistributionEdit::rebuild_parameters() {
    shown_kind_ = component_.distribution;
    while (parameters_->rowCount() > 0) parameters_->removeRow(0);
    edits_.clear();
    lists_.clear();
    const DistributionKindInfo* kind = find_distribution_kind(shown_kind_);
    if (!kind) return;
    if (is_list()) {
        add_list(is_histogram() ? tr("Edges of the cells") : tr("Values"), 0);
        add_list(tr("Probabilities"), 1);
    }
    for (std::size_t i = 0; i < kind->parameters.size(); ++i) add_parameter(i, kind->parameters[i]);
    align_labels(*parameters_, component_label_width(*this));
}

void DistributionEdit::add_parameter(std::size_t index, const DistributionParameterInfo& info) {
    auto* edit = new QuantityEdit(this);
    keep_letters(*edit);
    edit->set_keeps_unit(false);
    edit->set_interval(true);
    edit->set_optional(false);
    edit->setAccessibleName(core_text(info.title));
    edit->setObjectName(to_qt(info.key));
    parameters_->addRow(as_label(core_text(info.title)), edit);
    edits_.push_back(edit);
    connect(edit, &QuantityEdit::quantity_edited, this,
            [this, index](const std::optional<Quantity>& quantity) { set_parameter(index, quantity); });
}

void DistributionEdit::add_list(const QString& title, std::size_t part) {
    auto* line = new QLineEdit(this);
    line->setAccessibleName(title);
    line->setPlaceholderText(tr("numbers with ; between"));
    parameters_->addRow(title, line);
    lists_.push_back(line);
    connect(line, &QLineEdit::editingFinished, this, [this, line, part] { set_list(part, line->text()); });
}

void DistributionEdit::set_parameter(std::size_t index, const std::optional<Quantity>& quantity) {
    if (!quantity || index >= component_.parameters.size()) return;
    component_.parameters[index] = quantity->value;
    show_summary();
    emit component_edited(component_);
}

void DistributionEdit::set_list(std::size_t part, const QString& text) {
    const auto numbers = numbers_of(text, locale());
    complain(part, numbers ? QString() : tr("“%1” are not all numbers.").arg(text));
    const auto other = numbers_of(lists_[1 - part]->text(), locale());
    if (!numbers || !other) return;
    std::vector<double> all = part == 0 ? *numbers : *other;
    const std::vector<double>& probabilities = part == 0 ? *other : *numbers;
    const bool complete = all.size() == probabilities.size() + (is_histogram() ? 1 : 0);
    complain(1, complete         ? QString()
                : is_histogram() ? tr("There must be one edge more than probabilities.")
                                 : tr("There must be as many probabilities as values."));
    if (complete) complain(0, {});
    all.insert(all.end(), probabilities.begin(), probabilities.end());
    if (!complete || all == component_.parameters) return;
    component_.parameters = all;
    show_summary();
    emit component_edited(component_);
}

void DistributionEdit::show_values() {
    const DistributionKindInfo* kind = find_distribution_kind(component_.distribution);
    for (std::size_t i = 0; kind && i < edits_.size() && i < component_.parameters.size(); ++i) {
        const Unit unit = kind->parameters[i].has_unit ? component_.unit : Unit();
        edits_[i]->set_unit(unit);
        if (unread_) edits_[i]->set_place(*unread_, place_of(std::string(kind->parameters[i].key)));
        edits_[i]->set_quantity(Quantity{component_.parameters[i], unit});
    }
    for (std::size_t part = 0; part < lists_.size(); ++part) {
        const UnreadText* kept =
            unread_ ? unread_->find(place_of(list_key(component_.distribution, part))) : nullptr;
        const QString text = list_text(part);
        if (kept && kept->instead_of != to_std(text)) {
            unread_->remove(place_of(list_key(component_.distribution, part)));
            kept = nullptr;
        }
        lists_[part]->setText(kept ? kept->text : text);
        mark(*lists_[part], kept ? kept->reason : QString(), {});
    }
}

QString DistributionEdit::list_text(std::size_t part) const {
    const std::size_t first = first_list_size(component_.parameters.size());
    const std::size_t begin = part == 0 ? 0 : first;
    const std::size_t end = part == 0 ? first : component_.parameters.size();
    QStringList texts;
    for (std::size_t i = begin; i < end; ++i) texts << number_text(component_.parameters[i], locale());
    return texts.join("; ");
}

/// Lists are read together: what cannot be read holds the run until it can.
void DistributionEdit::complain(std::size_t list, const QString& complaint) {
    mark(*lists_[list], complaint, {});
    if (!unread_) return;
    const TextPlace place = place_of(list_key(component_.distribution, list));
    if (complaint.isEmpty())
        unread_->remove(place);
    else
        unread_->set(place, {lists_[list]->text(), complaint, to_std(list_text(list))});
}

void DistributionEdit::show_summary() {
    const Result<Distribution> distribution = distribution_of(component_);
    const Result<Distribution> drawn = drawn_distribution(component_, normal_draws_);
    picture_->set_distribution(drawn ? std::optional<Distribution>(*drawn) : std::nullopt);
    const QString complaint = distribution ? QString() : to_qt(distribution.error().message);
    for (QuantityEdit* edit : edits_) edit->set_complaint(complaint);
    if (!distribution) {
        summary_->setText(complaint);
        return;
    }
    const double u = component_.unit.interval_from_si(distribution->standard_uncertainty());
    const QString unit = component_.unit == Unit() ? QString() : ' ' + to_qt(component_.unit.display());
    QString words = std::isfinite(u) ? QStringLiteral("u = ") + localized(format_significant(u, 3)) + unit
                                     : tr("This distribution has no finite standard uncertainty.");
    if (drawn && drawn->kind() != distribution->kind())
        words +=
            QLatin1Char('\n') + tr("Monte Carlo draws: %1, ν = %2")
                                    .arg(core_text(drawn->title()),
                                         localized(format_degrees_of_freedom(drawn->degrees_of_freedom())));
    summary_->setText(words);
}

}  // namespace covaria::ui
