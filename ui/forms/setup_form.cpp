// Rows of label and editor in sections that fold; both hide where their fields are not used.
#include "ui/forms/setup_form.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <utility>

#include "core/text/symbol.h"
#include "ui/document/missing_fields.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/help_place.h"
#include "ui/forms/table_editor.h"
#include "ui/theme/core_text.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr qsizetype most_messages = 5;  // at a field; all are in the problems list

void show_row(QFormLayout& form, QWidget& editor, QWidget* head, bool shown) {
    form.setRowVisible(&editor, shown);
    if (head) form.setRowVisible(head, shown);
}

/// Number of rows of a table; empty for other fields.
QString rows_of(FieldEditor& editor) {
    auto* table = qobject_cast<TableEditor*>(&editor);
    return table ? QString::number(table->model().rowCount()) : QString();
}

QWidget* in_a_row(QWidget& title, QWidget& tools) {
    auto* whole = new QWidget;
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&title, 1);
    row->addWidget(&tools);
    return whole;
}

}  // namespace

SetupForm::SetupForm(Document& document, SetupAddress address, QWidget* parent)
    : SetupForm(document, address, find_schema(document.project(), address), parent) {}

SetupForm::SetupForm(Document& document, SetupAddress address, const SetupSchema* schema, QWidget* parent)
    : QWidget(parent),
      document_(document),
      address_(std::move(address)),
      schema_(schema),
      groups_(new FoldGroups(this)),
      taken_(new QLabel(this)) {
    taken_->setWordWrap(true);
    taken_->setObjectName(QStringLiteral("taken"));
    taken_->setContentsMargins(16, 8, 16, 8);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(taken_);
    column->addWidget(groups_);
    if (schema_) build();
    refresh();
    refresh_problems();
    connect(&document_, &Document::project_changed, this, &SetupForm::refresh);
    connect(&document_, &Document::problems_changed, this, &SetupForm::refresh_problems);
}

void SetupForm::build() {
    std::string section;
    add_section({});  // holds the fields before all sections
    for (const FieldSpec& field : schema_->fields()) {
        if (field.section != section && !field.section.empty()) add_section(core_text(field.section));
        section = field.section;
        add_field(field);
    }
}

void SetupForm::add_section(const QString& title) {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->setVerticalSpacing(4);
    const bool is_first = sections_.size() == 1 && rows_.empty();
    sections_.push_back({groups_->add(page, title, is_first), form});
}

void SetupForm::add_field(const FieldSpec& field) {
    FieldEditor* editor = make_field_editor(field, {document_, address_, schema_}, this);
    QLabel* title = make_form_label(field.title, this);
    title->setToolTip(help_text(field));
    title->setBuddy(editor);
    set_help_place(*editor, help_anchor(document_.project(), address_, field.key));
    QFormLayout& form = *sections_.back().form;
    QWidget* head = nullptr;
    if (editor->is_wide() && groups_->title(sections_.back().group) == title->text()) {
        groups_->head(sections_.back().group)->setToolTip(title->toolTip());
        delete std::exchange(title, nullptr);  // the heading says it
        form.addRow(editor);
    } else if (editor->is_wide()) {
        title->setWordWrap(false);
        title->setMinimumWidth(0);
        title->setMaximumWidth(QWIDGETSIZE_MAX);
        auto* table = qobject_cast<TableEditor*>(editor);
        head = table ? in_a_row(*title, *table->take_tools()) : title;
        form.addRow(head);
        form.addRow(editor);
    } else {
        form.addRow(title, editor);
    }
    rows_.push_back({&field, editor, head, sections_.size() - 1});
    connect(editor, &FieldEditor::edited, this,
            [this, &field](const SetupValue& value) { write(field, value); });
    connect(editor, &FieldEditor::part_selected, this,
            [this, &field](const QString& part) { emit part_selected('/' + to_qt(field.key) + part); });
}

FieldEditor* SetupForm::editor(const std::string& key) const {
    for (const Row& row : rows_)
        if (row.field->key == key) return row.editor;
    return nullptr;
}

void SetupForm::write(const FieldSpec& field, const SetupValue& value) {
    const QString key = QStringLiteral("setup:%1:%2").arg(to_qt(address_.id), to_qt(field.key));
    document_.apply(
        tr("Change %1").arg(core_text(field.title)),
        [&](Project& project) {
            Setup* setup = find_setup(project, address_);
            if (!setup) return;
            if (std::holds_alternative<std::monostate>(value))
                setup->values.erase(field.key);
            else
                setup->values[field.key] = value;
        },
        key);
}

void SetupForm::refresh() {
    const Setup* setup = find_setup(document_.project(), address_);
    setEnabled(setup != nullptr);
    say_what_is_taken();
    if (!setup) return;
    std::vector<bool> used(sections_.size(), false);
    std::vector<QStringList> counts(sections_.size());
    for (const Row& row : rows_) {
        const bool shown = is_shown(*schema_, *row.field, *setup);
        show_row(*sections_[row.section].form, *row.editor, row.head, shown);
        if (const QString rows = rows_of(*row.editor); shown && !rows.isEmpty()) counts[row.section] << rows;
        if (!shown) forget_unread("/setup/" + row.field->key);
        used[row.section] = used[row.section] || shown;
        row.editor->set_value(value_of(*row.field, *setup));
    }
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        groups_->set_shown(sections_[i].group, used[i]);
        groups_->set_summary(sections_[i].group, counts[i].join(QStringLiteral(", ")));
    }
}

/// Links take the place of what the fields state of their quantities.
void SetupForm::say_what_is_taken() {
    constexpr std::size_t most_named = 3;
    const AnalysisEntry* analysis =
        address_.owner == SetupOwner::analysis ? document_.project().find_analysis(address_.id) : nullptr;
    std::map<std::string, std::vector<std::string>> inputs;  // by id of the analysis
    if (analysis)
        for (const InputLink& link : analysis->links) inputs[link.output.analysis].push_back(link.input);
    QStringList words;
    for (const auto& [from, symbols] : inputs) {
        const AnalysisEntry* source = document_.project().find_analysis(from);
        QStringList named;
        for (std::size_t i = 0; i < std::min(symbols.size(), most_named); ++i)
            named << to_qt(to_unicode(symbol_text(symbols[i])));
        if (symbols.size() > most_named) named << QStringLiteral("… (%1)").arg(symbols.size());
        words << tr("From “%1”: %2. What is stated of them here is not used.")
                     .arg(source ? to_qt(source->name) : to_qt(from), named.join(QStringLiteral(", ")));
    }
    taken_->setText(words.join(QLatin1Char('\n')));
    taken_->setVisible(!words.isEmpty());
}

/// A field that is not used holds no run.
void SetupForm::forget_unread(const std::string& part) {
    document_.unread().remove({address_, part});
    document_.unread().replace_under(address_, part + "/", {});
}

void SetupForm::refresh_problems() {
    const std::string prefix = setup_path(document_.project(), address_) + '/';
    for (const Row& row : rows_) {
        const std::string path = prefix + row.field->key;
        QStringList messages;
        std::vector<std::string> places;
        bool lacks = false;
        for (const Problem& problem : document_.problems().items()) {
            if (problem.path != path && !problem.path.starts_with(path + '/')) continue;
            lacks = true;
            if (is_missing(document_.project(), document_.problems(), problem)) continue;
            messages << to_qt(problem.message);
            places.push_back(problem.path.substr(path.size()));
        }
        if (lacks) groups_->offer(sections_[row.section].group);
        if (const auto more = messages.size() - most_messages; more > 0) {
            messages.resize(most_messages);
            messages << tr("and %n more", nullptr, int(more));
        }
        row.editor->set_complaint(messages.join('\n'));
        row.editor->set_problem_places(places);
    }
}

void SetupForm::focus_first() {
    for (const Row& row : rows_)
        if (sections_[row.section].form->isRowVisible(row.editor)) {
            FoldGroups::reveal(*row.editor);
            return row.editor->focus_part({});
        }
}

bool SetupForm::focus_field(const std::string& path) {
    const std::string prefix = setup_path(document_.project(), address_);
    const std::string relative = path.starts_with(prefix + '/') ? path.substr(prefix.size()) : path;
    if (relative.size() < 2) return false;
    const std::size_t slash = relative.find('/', 1);
    FieldEditor* found = editor(relative.substr(1, slash == std::string::npos ? slash : slash - 1));
    if (!found) return false;
    FoldGroups::reveal(*found);
    found->focus_part(slash == std::string::npos ? std::string() : relative.substr(slash));
    return true;
}

}  // namespace covaria::ui
