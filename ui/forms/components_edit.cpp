// The first change copies the model's components into the project.
#include "ui/forms/components_edit.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/project/component_edit.h"
#include "core/text/symbol.h"
#include "ui/document/quantity_edits.h"
#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/whole_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

ComponentsEdit::ComponentsEdit(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      list_(new QListWidget(this)),
      note_(new QLabel(this)),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      reset_(new QPushButton(tr("Reset"), this)),
      details_(new QWidget(this)),
      name_(new QLineEdit(details_)),
      type_(new QComboBox(details_)),
      degrees_(new QuantityEdit(details_)),
      origin_(new QLineEdit(details_)),
      distribution_(new DistributionEdit(details_)) {
    build();
    connect(&document_, &Document::project_changed, this, &ComponentsEdit::refresh);
    connect(list_, &QListWidget::currentRowChanged, this, &ComponentsEdit::show_component);
    connect(add_, &QPushButton::clicked, this, &ComponentsEdit::add_component);
    connect(remove_, &QPushButton::clicked, this, &ComponentsEdit::remove_component);
    connect(reset_, &QPushButton::clicked, this, &ComponentsEdit::reset);
    connect(name_, &QLineEdit::textEdited, this, [this](const QString& text) {
        change("name", [&](ComponentEdit& edit) { edit.name = to_std(text); });
    });
    connect(origin_, &QLineEdit::textEdited, this, [this](const QString& text) {
        change("origin", [&](ComponentEdit& edit) { edit.origin = to_std(text); });
    });
    connect(type_, &QComboBox::activated, this, [this](int row) {
        change("type", [&](ComponentEdit& edit) {
            edit.type = row == 0 ? EvaluationType::type_a : EvaluationType::type_b;
        });
    });
    connect(degrees_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        change("degrees", [&](ComponentEdit& edit) {
            edit.degrees_of_freedom = quantity ? std::optional<double>(quantity->value) : std::nullopt;
        });
    });
    connect(distribution_, &DistributionEdit::component_edited, this, [this](const ComponentEdit& edited) {
        change("distribution", [&](ComponentEdit& edit) { edit = edited; });
    });
}

void ComponentsEdit::build() {
    list_->setAccessibleName(tr("Components of uncertainty"));
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    list_->setItemDelegate(new TypesetDelegate(list_));
    name_->setAccessibleName(tr("Name of the component"));
    type_->setAccessibleName(tr("Type of evaluation"));
    degrees_->setAccessibleName(tr("Degrees of freedom"));
    origin_->setAccessibleName(tr("Origin"));
    note_->setWordWrap(true);
    reset_->setToolTip(tr("Back to the components that the model gives"));
    type_->addItems({tr("Type A (from observations)"), tr("Type B (other means)")});
    may_be_narrow(*type_);
    degrees_->set_range({0.0, Range::infinity_value, true});
    degrees_->setPlaceholderText(QStringLiteral("∞"));
    degrees_->set_help(tr("Degrees of freedom of the standard uncertainty; empty: infinitely many."));
    for (QLineEdit* edit : {name_, origin_, static_cast<QLineEdit*>(degrees_)}) keep_letters(*edit);
    auto* form = new QFormLayout(details_);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Type"), type_);
    form->addRow(tr("Degrees of freedom"), degrees_);
    origin_->setObjectName(QStringLiteral("origin"));
    keep_whole(*origin_);
    form->addRow(tr("Origin"), origin_);
    form->addRow(distribution_);
    align_labels(*form, component_label_width(*this));
    auto* buttons = new FlowLayout;
    for (QPushButton* button : {add_, remove_, reset_}) buttons->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(list_);
    layout->addWidget(note_);
    layout->addLayout(buttons);
    layout->addWidget(details_);
    layout->addStretch(1);
}

void ComponentsEdit::set_quantity(std::shared_ptr<const PreparedAnalysis> analysis,
                                  const std::string& symbol) {
    analysis_ = std::move(analysis);
    symbol_ = symbol;
    refresh();
}

/// Components that no other quantity has.
std::vector<const UncertaintyComponent*> ComponentsEdit::own_components() const {
    std::vector<const UncertaintyComponent*> found;
    const InputSet& inputs = analysis_->inputs;
    const std::size_t quantity = inputs.find(symbol_);
    if (quantity == InputSet::npos) return found;
    for (const Share& share : inputs.quantities[quantity].shares) {
        const auto shares_it = [&](const InputQuantity& other) {
            return std::any_of(other.shares.begin(), other.shares.end(),
                               [&](const Share& s) { return s.component == share.component; });
        };
        if (std::count_if(inputs.quantities.begin(), inputs.quantities.end(), shares_it) == 1)
            found.push_back(&inputs.components[share.component]);
    }
    return found;
}

std::vector<ComponentEdit> ComponentsEdit::model_components() const {
    std::vector<ComponentEdit> found;
    for (const UncertaintyComponent* component : own_components())
        found.push_back(to_edit(*component, language_of_window()));
    return found;
}

/// Whether the model says that Monte Carlo draws the component normally; edited components cannot say so.
bool ComponentsEdit::draws_normal(int row) const {
    if (find_input_edit(document_.project(), analysis_->id, symbol_).components) return false;
    const auto own = own_components();
    return row < static_cast<int>(own.size()) && own[static_cast<std::size_t>(row)]->normal_draws;
}

std::vector<ComponentEdit> ComponentsEdit::components() const {
    if (!analysis_) return {};
    const InputEdit edit = find_input_edit(document_.project(), analysis_->id, symbol_);
    return edit.components ? *edit.components : model_components();
}

void ComponentsEdit::write(const QString& text, std::vector<ComponentEdit> components,
                           const QString& merge_key) {
    change_input(
        document_, analysis_->id, symbol_, text,
        [&](InputEdit& edit) { edit.components = std::move(components); }, merge_key);
}

void ComponentsEdit::change(const QString& what, const std::function<void(ComponentEdit&)>& edit) {
    std::vector<ComponentEdit> all = components();
    const int row = list_->currentRow();
    if (row < 0 || row >= static_cast<int>(all.size())) return;
    edit(all[static_cast<std::size_t>(row)]);
    const QString key =
        QStringLiteral("component:%1:%2:%3:%4").arg(to_qt(analysis_->id), to_qt(symbol_), what).arg(row);
    write(tr("Change component of %1").arg(to_qt(symbol_to_unicode(symbol_))), std::move(all), key);
}

void ComponentsEdit::add_component() {
    if (!analysis_) return;
    std::vector<ComponentEdit> all = components();
    const std::size_t quantity = analysis_->inputs.find(symbol_);
    ComponentEdit added;
    added.name = to_std(tr("component %1").arg(all.size() + 1));
    if (quantity != InputSet::npos) added.unit = analysis_->inputs.quantities[quantity].unit.interval();
    set_distribution(added, Distribution::normal(0.0));
    all.push_back(added);
    const int row = static_cast<int>(all.size()) - 1;
    write(tr("Add component to %1").arg(to_qt(symbol_to_unicode(symbol_))), std::move(all));
    list_->setCurrentRow(row);
}

void ComponentsEdit::remove_component() {
    std::vector<ComponentEdit> all = components();
    const int row = list_->currentRow();
    if (row < 0 || row >= static_cast<int>(all.size())) return;
    all.erase(all.begin() + row);
    forget_unread();
    write(tr("Remove component of %1").arg(to_qt(symbol_to_unicode(symbol_))), std::move(all));
}

void ComponentsEdit::reset() {
    if (!analysis_) return;
    forget_unread();
    change_input(document_, analysis_->id, symbol_,
                 tr("Reset components of %1").arg(to_qt(symbol_to_unicode(symbol_))),
                 [](InputEdit& edit) { edit.components.reset(); });
}

/// "Laser tracker, distance; Laser tracker, azimuth; …"
QString ComponentsEdit::shared_names(std::size_t quantity) const {
    constexpr qsizetype most = 8;
    const auto own = own_components();
    QStringList names;
    for (const Share& share : analysis_->inputs.quantities[quantity].shares) {
        const UncertaintyComponent& component = analysis_->inputs.components[share.component];
        if (std::find(own.begin(), own.end(), &component) == own.end())
            names << to_qt(to_edit(component, language_of_window()).name);
    }
    const bool more = names.size() > most;
    return names.mid(0, most).join(QStringLiteral("; ")) + (more ? QStringLiteral("; …") : QString());
}

QString ComponentsEdit::note() const {
    if (!analysis_) return {};
    const auto& linked = analysis_->linked;
    if (std::any_of(linked.begin(), linked.end(),
                    [this](const LinkedInput& one) { return one.symbol == symbol_; }))
        return tr("Its uncertainty comes from another analysis.");
    const std::size_t quantity = analysis_->inputs.find(symbol_);
    if (quantity == InputSet::npos) return {};
    const bool edited = find_input_edit(document_.project(), analysis_->id, symbol_).components.has_value();
    const std::size_t all = analysis_->inputs.quantities[quantity].shares.size();
    if (!edited && all > model_components().size())
        return tr("Components that it shares with other quantities are edited where they are stated.") +
               QLatin1Char('\n') + shared_names(quantity);
    return list_->count() > 0 ? QString() : tr("It has no component of uncertainty yet.");
}

std::string ComponentsEdit::components_part() const {
    return "/inputs/" + symbol_ + "/components/";
}

/// Texts that could not be read go with the components they stood in.
void ComponentsEdit::forget_unread() {
    document_.unread().replace_under({SetupOwner::analysis, analysis_->id}, components_part(), {});
}

void ComponentsEdit::refresh() {
    const std::vector<ComponentEdit> all = components();
    const int row = std::clamp(list_->currentRow(), 0, std::max(0, static_cast<int>(all.size()) - 1));
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > static_cast<int>(all.size())) delete list_->takeItem(list_->count() - 1);
        for (int i = 0; i < static_cast<int>(all.size()); ++i) {
            if (i == list_->count()) list_->addItem(QString());
            list_->item(i)->setText(to_qt(all[static_cast<std::size_t>(i)].name));
        }
        if (!all.empty()) list_->setCurrentRow(row);
    }
    const int lines = std::clamp(list_->count(), 1, 4);
    const int line = std::max(list_->sizeHintForRow(0), fontMetrics().height());
    list_->setFixedHeight(lines * line + 2 * list_->frameWidth());
    note_->setText(note());
    note_->setVisible(!note_->text().isEmpty());
    add_->setEnabled(analysis_ != nullptr);
    reset_->setEnabled(analysis_ && find_input_edit(document_.project(), analysis_->id, symbol_).components);
    show_component();
}

void ComponentsEdit::show_component() {
    const std::vector<ComponentEdit> all = components();
    const int row = list_->currentRow();
    const bool some = row >= 0 && row < static_cast<int>(all.size());
    details_->setVisible(some);
    remove_->setEnabled(some);
    if (!some) return;
    const ComponentEdit& shown = all[static_cast<std::size_t>(row)];
    const auto show_text = [](QLineEdit& edit, const QString& text) {
        if (edit.text() == text) return;
        edit.setText(text);
        edit.setCursorPosition(0);  // the beginning of a long one is in view
    };
    show_text(*name_, to_qt(shown.name));
    show_text(*origin_, to_qt(shown.origin));
    type_->setCurrentIndex(shown.type == EvaluationType::type_a ? 0 : 1);
    const TextPlace place{{SetupOwner::analysis, analysis_->id}, components_part() + std::to_string(row)};
    distribution_->set_place(document_.unread(), place);
    degrees_->set_place(document_.unread(), {place.entry, place.part + "/degreesOfFreedom"});
    degrees_->set_quantity(shown.degrees_of_freedom
                               ? std::optional<Quantity>({*shown.degrees_of_freedom, Unit()})
                               : std::nullopt);
    distribution_->set_component(shown, draws_normal(row));
}

}  // namespace covaria::ui
