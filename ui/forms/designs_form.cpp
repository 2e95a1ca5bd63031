#include "ui/forms/designs_form.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <charconv>

#include "core/project/options_json.h"
#include "ui/document/setup_address.h"
#include "ui/forms/complaint.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/whole_text.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// "120; 80; 95": with the decimal sign of the locale, one for all rows or one for each. `wrong`: the first
/// that is no number.
std::vector<double> prices_from(const QString& typed, QString& wrong) {
    std::vector<double> prices;
    for (const QString& text : typed.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        bool read = false;
        prices.push_back(QLocale().toDouble(text.trimmed(), &read));
        if (!read) prices.back() = text.trimmed().toDouble(&read);
        if (!read && wrong.isEmpty()) wrong = text;
    }
    return prices;
}

}  // namespace

DesignsForm::DesignsForm(Document& document, AnalysisRunner& runner, Selection& selection,
                         std::string analysis, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      analysis_(std::move(analysis)) {
    auto* column = new QVBoxLayout(this);
    build_head();
    build_body();
    column->addStretch(1);
    connect(&document_, &Document::project_changed, this, &DesignsForm::refresh);
    connect(&document_, &Document::problems_changed, this, &DesignsForm::refresh_problems);
    connect(&selection_, &Selection::design_changed, this, &DesignsForm::refresh);
    connect(&runner_, &AnalysisRunner::state_changed, this, [this](const QString& id) {
        if (to_std(id) == analysis_ && design() && prepared())
            outputs_->show_outputs(prepared()->model->outputs(), design()->outputs);
    });
    refresh();
}

void DesignsForm::build_head() {
    head_ = new InquiryHead(
        {QStringLiteral("design"), QStringLiteral("designs"), tr("Design"),
         tr("Adds a design of this analysis"), tr("Adds a copy of this design"), tr("Deletes this design"),
         tr("Searches for the best design"),
         tr("A design finds where to stand and what to measure: the numbers and the rows of the set-up that "
            "make the uncertainties smallest. Add one to let Covaria search.")});
    layout()->addWidget(head_);
    connect(head_, &InquiryHead::chosen, &selection_, &Selection::select_design);
    connect(head_, &InquiryHead::add_wanted, this, [this] {
        if (entry())
            selection_.select_design(
                to_qt(design_list().add(document_, analysis_, new_design(document_.project(), *entry()))));
    });
    connect(head_, &InquiryHead::duplicate_wanted, this, [this] {
        if (const Design* shown = design())
            selection_.select_design(to_qt(design_list().duplicate(document_, analysis_, shown->id)));
    });
    connect(head_, &InquiryHead::remove_wanted, this, [this] {
        const Design* shown = design();
        if (!shown) return;
        document_.unread().replace_under({SetupOwner::analysis, analysis_}, "/designs/", {});
        design_list().remove(document_, analysis_, std::string(shown->id));
    });
    connect(head_, &InquiryHead::run_wanted, this, [this] {
        if (const Design* shown = design()) runner_.designs().run(to_qt(analysis_), to_qt(shown->id));
    });
}

void DesignsForm::build_body() {
    body_ = new QWidget;
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(0, 0, 0, 0);
    build_goal(*column);
    variables_ = new QVBoxLayout;
    column->addLayout(variables_);
    auto* add = new QPushButton(tr("Add Variable"));
    add->setObjectName(QStringLiteral("add_variable"));
    add->setToolTip(tr("One more number that may be chosen"));
    column->addWidget(add, 0, Qt::AlignLeft);
    connect(add, &QPushButton::clicked, this, &DesignsForm::add_variable);
    build_choice(*column);
    build_reductions(*column);
    build_space(*column);
    build_search(*column);
    layout()->addWidget(body_);
}

void DesignsForm::build_goal(QVBoxLayout& column) {
    auto* form = new QFormLayout;
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("design_name"));
    name_->setAccessibleName(tr("Name of the design"));
    objective_ = new QComboBox;
    objective_->setObjectName(QStringLiteral("design_objective"));
    objective_->setAccessibleName(tr("Objective"));
    may_be_narrow(*objective_);
    keep_whole(*objective_);
    objective_->setToolTip(tr(
        "What is made smallest of the ratios of U to the target uncertainties; without targets to U of the "
        "present design"));
    objective_->addItem(tr("Largest ratio"), int(DesignObjective::largest));
    objective_->addItem(tr("Mean of the ratios"), int(DesignObjective::mean));
    objective_->addItem(tr("Root mean square of the ratios"), int(DesignObjective::root_mean_square));
    objective_->addItem(tr("Cost of the rows, with all targets met"), int(DesignObjective::cost));
    keep_letters(*name_);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Smallest"), objective_);
    column.addLayout(form);
    outputs_ = new OutputTicks;
    outputs_->setObjectName(QStringLiteral("design_outputs"));
    outputs_->setAccessibleName(tr("Output quantities of the design"));
    outputs_->setToolTip(tr(
        "Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands"));
    auto* title = new QLabel(tr("Outputs (none ticked: all with a target, or all measurands)"));
    title->setWordWrap(true);
    column.addWidget(title);
    column.addWidget(outputs_);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        change([this](Design& d) { d.name = to_std(name_->text()); }, QStringLiteral("name"));
    });
    connect(objective_, &QComboBox::activated, this, [this](int row) {
        const auto objective = static_cast<DesignObjective>(objective_->itemData(row).toInt());
        change([objective](Design& d) { d.objective = objective; });
    });
    connect(outputs_, &OutputTicks::ticks_edited, this, [this](const std::vector<StudyOutput>& ticked) {
        change([&](Design& d) { d.outputs = ticked; });
    });
}

void DesignsForm::build_choice(QVBoxLayout& column) {
    auto* group = new QGroupBox(tr("Rows to choose from"));
    auto* form = new QFormLayout(group);
    table_ = new QComboBox;
    table_->setObjectName(QStringLiteral("design_table"));
    table_->setAccessibleName(tr("Table to choose from"));
    may_be_narrow(*table_);
    keep_ = new QuantityEdit;
    keep_->setObjectName(QStringLiteral("design_keep"));
    keep_->setAccessibleName(tr("Rows to keep"));
    keep_->set_integer(true);
    keep_->set_optional(false);
    keep_->set_range({1.0, 1e6});
    candidates_ = new QLineEdit;
    candidates_->setObjectName(QStringLiteral("design_candidates"));
    candidates_->setAccessibleName(tr("File of candidates"));
    candidates_->setToolTip(tr("A CSV file beside the project with further rows; may be empty"));
    fixed_ = new QListWidget;
    fixed_->setObjectName(QStringLiteral("design_fixed"));
    fixed_->setAccessibleName(tr("Rows that stay"));
    fixed_->setToolTip(tr("Ticked rows stay in any case"));
    for (QLineEdit* edit : {candidates_, static_cast<QLineEdit*>(keep_)}) keep_letters(*edit);
    form->addRow(tr("Table"), table_);
    form->addRow(tr("Keep"), keep_);
    form->addRow(tr("Candidates"), candidates_);
    form->addRow(tr("Stay"), fixed_);
    form->addRow(tr("Prices"), build_prices());
    column.addWidget(group);
    connect(table_, &QComboBox::activated, this, [this](int row) {
        std::optional<DesignChoice> choice;
        if (row > 0 && std::size_t(row) <= offers_.size()) choice = offers_[std::size_t(row) - 1].choice;
        change([&](Design& d) { d.choose = choice; });
    });
    connect(keep_, &QuantityEdit::quantity_edited, this, [this](const std::optional<Quantity>& quantity) {
        const auto keep = static_cast<std::size_t>(quantity ? quantity->value : 1.0);
        change(
            [keep](Design& d) {
                if (d.choose) d.choose->keep = keep;
            },
            QStringLiteral("keep"));
    });
    connect(candidates_, &QLineEdit::editingFinished, this, [this] {
        change(
            [this](Design& d) {
                if (d.choose) d.choose->candidates = to_std(candidates_->text());
            },
            QStringLiteral("candidates"));
    });
    connect(fixed_, &QListWidget::itemChanged, this, &DesignsForm::take_fixed);
}

QuantityEdit* DesignsForm::whole_number(const char* name, const QString& title, double least,
                                        std::function<void(Design&, double)> set) {
    auto* edit = new QuantityEdit;
    edit->setObjectName(QString::fromLatin1(name));
    edit->setAccessibleName(title);
    edit->set_integer(true);
    edit->set_optional(false);
    edit->set_range({least, 1e12});
    connect(edit, &QuantityEdit::quantity_edited, this,
            [this, set, name](const std::optional<Quantity>& quantity) {
                change([&](Design& d) { set(d, quantity ? quantity->value : 1.0); },
                       QString::fromLatin1(name));
            });
    return edit;
}

void DesignsForm::build_search(QVBoxLayout& column) {
    auto* form = new QFormLayout;
    const auto add = [&](const char* name, const QString& title, double least, auto member) {
        using Member = std::remove_reference_t<decltype(std::declval<Design&>().*member)>;
        QuantityEdit* edit = whole_number(name, title, least, [member](Design& d, double value) {
            d.*member = static_cast<Member>(value);
        });
        form->addRow(title, edit);
        numbers_.emplace_back(edit, [member](const Design& d) { return double(d.*member); });
    };
    add("design_starts", tr("Starts"), 1.0, &Design::starts);
    add("design_most_evaluations", tr("Evaluations at most"), 1.0, &Design::most_evaluations);
    form->addRow(tr("Seed"), build_seed());
    column.addLayout(form);
}

void DesignsForm::build_space(QVBoxLayout& column) {
    auto* form = new QFormLayout;
    least_distance_ = new QuantityEdit;
    least_distance_->setObjectName(QStringLiteral("design_least_distance"));
    least_distance_->setAccessibleName(tr("Least distance"));
    least_distance_->set_unit(Unit::of("mm"));
    least_distance_->set_help(tr("Between instruments, and of them from all other points"));
    form->addRow(tr("Least distance"), least_distance_);
    column.addLayout(form);
    connect(least_distance_, &QuantityEdit::quantity_edited, this,
            [this](const std::optional<Quantity>& quantity) {
                change([&](Design& d) { d.least_distance = quantity; }, QStringLiteral("least_distance"));
            });
    keep_out_ = new DesignBoxList(tr("Keep out of"), QStringLiteral("keep_out"),
                                  tr("No instrument stands in this box"));
    hidden_by_ = new DesignBoxList(tr("Lines of sight are hidden by"), QStringLiteral("hidden_by"),
                                   tr("No line of sight passes this box"));
    for (auto [list, member] : {std::pair{keep_out_, &Design::keep_out}, {hidden_by_, &Design::hidden_by}}) {
        column.addWidget(list);
        connect(list, &DesignBoxList::edited, this,
                [this, member = member](const DesignBoxList::Edit& edit, const QString& field) {
                    change([&](Design& d) { edit(d.*member); }, field);
                });
    }
}

void DesignsForm::build_reductions(QVBoxLayout& column) {
    reductions_ = new DesignReductionList([this] { return targets(); });
    column.addWidget(reductions_);
    connect(reductions_, &DesignReductionList::edited, this,
            [this](const DesignReductionList::Edit& edit, const QString& field) {
                change([&](Design& d) { edit(d.reductions); }, field);
            });
}

QLineEdit* DesignsForm::build_prices() {
    prices_ = new QLineEdit;
    prices_->setObjectName(QStringLiteral("design_prices"));
    prices_->setAccessibleName(tr("Prices of the rows"));
    prices_->setPlaceholderText(QStringLiteral("120; 80; 95"));
    keep_whole(*prices_);
    prices_->setToolTip(
        tr("What the rows cost, separated by semicolons; needed where the cost is to be small") +
        QLatin1Char('\n') + tr("one for all rows, or one for each: 120; 80; 95"));
    connect(prices_, &QLineEdit::editingFinished, this, [this] {
        QString wrong;
        const std::vector<double> prices = prices_from(prices_->text(), wrong);
        if (!wrong.isEmpty())
            return prices_->setToolTip(tr("'%1' is no number; separate prices by semicolons").arg(wrong));
        change(
            [&prices](Design& d) {
                if (d.choose) d.choose->prices = prices;
            },
            QStringLiteral("prices"));
    });
    return prices_;
}

QLineEdit* DesignsForm::build_seed() {
    seed_ = new QLineEdit;
    seed_->setObjectName(QStringLiteral("design_seed"));
    seed_->setAccessibleName(tr("Seed"));
    seed_->setToolTip(tr("Of the random starts: a whole number from 0 to 18446744073709551615"));
    connect(seed_, &QLineEdit::editingFinished, this, [this] {
        if (const auto seed = seed_from(to_std(seed_->text().trimmed())))
            change([seed](Design& d) { d.seed = *seed; }, QStringLiteral("seed"));
        else if (const Design* shown = design())
            seed_->setText(QString::number(shown->seed));
    });
    return seed_;
}

const Design* DesignsForm::design() const {
    return design_list().find(document_.project(), analysis_, to_std(selection_.design()));
}

const PreparedAnalysis* DesignsForm::prepared() const {
    return runner_.status(to_qt(analysis_)).prepared.get();
}

void DesignsForm::change(const std::function<void(Design&)>& edit, const QString& merge_key) {
    design_list().change(document_, analysis_, to_std(selection_.design()), edit, merge_key);
}

void DesignsForm::change_variable(std::size_t variable, const std::function<void(DesignVariable&)>& edit,
                                  const QString& field) {
    change(
        [&](Design& d) {
            if (variable < d.variables.size()) edit(d.variables[variable]);
        },
        field.isEmpty() ? field : QStringLiteral("variable-%1-%2").arg(variable).arg(field));
}

TextPlace DesignsForm::place(const std::string& part) const {
    const Design* shown = design();
    const auto index = entry() && shown ? shown - entry()->designs.data() : 0;
    return {{SetupOwner::analysis, analysis_}, "/designs/" + std::to_string(index) + part};
}

void DesignsForm::refresh() {
    // A design is chosen only for the analysis being looked at, as with studies.
    const bool looked_at = selection_.analysis() == to_qt(analysis_);
    if (entry() && looked_at && !entry()->designs.empty() && !design())
        selection_.select_design(to_qt(entry()->designs.front().id));
    head_->show_items(entry() ? &entry()->designs : nullptr, selection_.design());
    const Design* shown = design();
    body_->setVisible(shown != nullptr);
    if (!shown) return;
    if (!name_->hasFocus() || name_->text() != to_qt(shown->name)) name_->setText(to_qt(shown->name));
    objective_->setCurrentIndex(objective_->findData(int(shown->objective)));
    if (prepared()) outputs_->show_outputs(prepared()->model->outputs(), shown->outputs);
    refresh_variables(*shown);
    refresh_choice(*shown);
    least_distance_->set_place(document_.unread(), place("/leastDistance"));
    least_distance_->set_quantity(shown->least_distance);
    for (const auto& [edit, value_of_design] : numbers_) {
        edit->set_place(document_.unread(), place("/" + to_std(edit->objectName())));
        edit->set_quantity(Quantity{value_of_design(*shown), {}});
    }
    keep_out_->show_boxes(shown->keep_out, document_.unread(), place("/keepOut"));
    hidden_by_->show_boxes(shown->hidden_by, document_.unread(), place("/hiddenBy"));
    refresh_reductions(*shown);
    if (!seed_->hasFocus()) seed_->setText(QString::number(shown->seed));
    refresh_problems();
}

std::vector<StudyTargetChoice> DesignsForm::targets() const {
    if (!entry()) return {};
    auto choices = study_targets(document_.project(), *entry(), prepared() ? &prepared()->inputs : nullptr);
    std::erase_if(choices, [](const StudyTargetChoice& choice) { return choice.target.whole; });
    return choices;
}

QString DesignsForm::title_of(const StudyAxis& number) const {
    const auto target =
        find_study_target(document_.project(), *entry(), prepared() ? &prepared()->inputs : nullptr, number);
    return target ? to_qt(target->title.message()) : QString();
}

void DesignsForm::refresh_reductions(const Design& shown) {
    std::vector<QString> titles;
    for (const DesignReduction& reduction : shown.reductions) titles.push_back(title_of(reduction.number));
    reductions_->show_reductions(shown.reductions, titles, document_.unread(), place("/reductions"));
}

void DesignsForm::add_variable_edit() {
    const std::size_t number = variable_edits_.size();
    auto* edit = new StudyAxisEdit([this] { return targets(); }, StudyAxisEdit::Use::variable, number);
    variables_->addWidget(edit);
    variable_edits_.push_back(edit);
    connect(edit, &StudyAxisEdit::edited, this,
            [this, number](const std::function<void(StudyAxis&)>& how, const QString& field) {
                change_variable(
                    number,
                    [&how](DesignVariable& variable) {
                        const StudyAxis before = variable.number;
                        how(variable.number);
                        variable.number.values = before.values;
                        variable.number.spacing = before.spacing;
                        if (variable.number.target != before.target)
                            variable.tolerance = 0.0;
                        else if (!(variable.number.unit == before.unit))
                            variable.tolerance = variable.number.unit.interval_from_si(
                                before.unit.interval_to_si(variable.tolerance));
                    },
                    field);
            });
    connect(edit, &StudyAxisEdit::tolerance_edited, this, [this, number](double tolerance) {
        change_variable(
            number, [tolerance](DesignVariable& variable) { variable.tolerance = tolerance; },
            QStringLiteral("tolerance"));
    });
    connect(edit, &StudyAxisEdit::remove_wanted, this, [this, number] {
        change([number](Design& d) {
            if (number < d.variables.size()) d.variables.erase(d.variables.begin() + std::ptrdiff_t(number));
        });
    });
}

void DesignsForm::add_variable() {
    const Design* shown = design();
    if (!entry() || !shown) return;
    if (const auto next = next_variable(document_.project(), *entry(), shown->variables))
        change([&next](Design& d) { d.variables.push_back(*next); });
}

void DesignsForm::refresh_variables(const Design& shown) {
    for (std::size_t i = shown.variables.size(); i < variable_edits_.size(); ++i) {
        const TextPlace gone = place("/variables/" + std::to_string(i) + "/");
        document_.unread().replace_under(gone.entry, gone.part, {});
    }
    while (variable_edits_.size() < shown.variables.size()) add_variable_edit();
    for (std::size_t i = 0; i < variable_edits_.size(); ++i) {
        variable_edits_[i]->setVisible(i < shown.variables.size());
        if (i >= shown.variables.size()) continue;
        const DesignVariable& variable = shown.variables[i];
        variable_edits_[i]->set_place(document_.unread(), place("/variables/" + std::to_string(i)));
        const auto target = find_study_target(document_.project(), *entry(),
                                              prepared() ? &prepared()->inputs : nullptr, variable.number);
        variable_edits_[i]->show_axis(variable.number, target ? &*target : nullptr, false);
        variable_edits_[i]->show_tolerance(variable.tolerance);
    }
}

void DesignsForm::refresh_choice(const Design& shown) {
    const QSignalBlocker tables(table_), rows(fixed_);
    offers_ = tables_to_choose_from(document_.project(), *entry());
    table_->clear();
    table_->addItem(tr("none"));
    for (const DesignTableOffer& offer : offers_) {
        table_->addItem(to_qt(to_unicode(core_title(offer.title))));
        if (shown.choose && offer.choice.asset == shown.choose->asset &&
            offer.choice.table == shown.choose->table)
            table_->setCurrentIndex(table_->count() - 1);
    }
    for (QWidget* each : std::initializer_list<QWidget*>{keep_, candidates_, fixed_, prices_})
        each->setEnabled(shown.choose.has_value());
    fixed_->clear();
    keep_->set_place(document_.unread(), place("/choose/keep"));
    keep_->set_quantity(Quantity{shown.choose ? double(shown.choose->keep) : 1.0, {}});
    candidates_->setText(shown.choose ? to_qt(shown.choose->candidates) : QString());
    QStringList prices;
    if (shown.choose)
        for (const double price : shown.choose->prices)
            prices << QLocale().toString(price, 'g', QLocale::FloatingPointShortest);
    if (!prices_->hasFocus()) prices_->setText(prices.join(QStringLiteral("; ")));
    Problems ignored;  // the list of problems has them
    const auto table = shown.choose ? find_design_table(document_.project(), *entry(), *shown.choose, ignored)
                                    : std::optional<DesignTable>();
    for (std::size_t row = 0; table && row < table->rows.rows.size(); ++row) {
        auto* item = new QListWidgetItem(
            QStringLiteral("%1: %2").arg(row + 1).arg(to_qt(row_words(table->rows, row))), fixed_);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        const bool stays = std::ranges::count(shown.choose->fixed, row) > 0;
        item->setCheckState(stays ? Qt::Checked : Qt::Unchecked);
    }
}

void DesignsForm::take_fixed() {
    std::vector<std::size_t> fixed;
    for (int row = 0; row < fixed_->count(); ++row)
        if (fixed_->item(row)->checkState() == Qt::Checked) fixed.push_back(std::size_t(row));
    change([&](Design& d) {
        if (d.choose) d.choose->fixed = fixed;
    });
}

void DesignsForm::refresh_problems() {
    if (!entry() || !design()) return;
    const TextPlace here = place("/variables/");
    const std::string prefix = entry_path(document_.project(), here.entry) + here.part;
    for (std::size_t i = 0; i < variable_edits_.size(); ++i)
        variable_edits_[i]->set_complaint(problems_below(document_.problems(), prefix + std::to_string(i)));
}

bool DesignsForm::focus_field(const std::string& path) {
    const std::string prefix =
        entry_path(document_.project(), {SetupOwner::analysis, analysis_}) + "/designs/";
    if (!path.starts_with(prefix) || !entry()) return false;
    std::size_t index = 0;
    std::from_chars(path.data() + prefix.size(), path.data() + path.size(), index);
    if (index < entry()->designs.size()) selection_.select_design(to_qt(entry()->designs[index].id));
    return true;
}

}  // namespace covaria::ui
