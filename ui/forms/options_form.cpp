// One row per option; rows that the method does not use are hidden.
#include "ui/forms/options_form.h"

#include <algorithm>

#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr double largest_count = 9007199254740992.0;  // 2^53: every whole number up to it is a double
const std::vector<Method> always{Method::first_order, Method::monte_carlo, Method::adaptive};
const std::vector<Method> with_trials{Method::monte_carlo, Method::adaptive};

/// The option that a JSON pointer names: "/analyses/0/options/coverageProbability" -> "coverage_probability".
QString key_of_path(const std::string& path) {
    QString key;
    for (const char c : path.substr(path.rfind('/') + 1)) {
        if (c >= 'A' && c <= 'Z') key += '_';
        key += QChar(c).toLower();
    }
    return key;
}

/// The other way round, relative to the analysis: "/options/coverageProbability".
std::string place_of_option(const QString& key) {
    std::string place = "/options/";
    for (qsizetype i = 0; i < key.size(); ++i)
        place += key[i] == u'_' && i + 1 < key.size() ? key[++i].toUpper().toLatin1() : key[i].toLatin1();
    return place;
}

}  // namespace

OptionsForm::OptionsForm(Document& document, std::string analysis, QWidget* parent)
    : QWidget(parent),
      document_(document),
      analysis_(std::move(analysis)),
      layout_(new QFormLayout(this)),
      method_(new QComboBox(this)),
      variance_reduction_(new QComboBox(this)),
      second_order_(new QCheckBox(tr("Second-order terms"), this)) {
    build_method();
    build_common();
    build_monte_carlo();
    build_adaptive();
    connect(&document_, &Document::project_changed, this, &OptionsForm::refresh);
    connect(&document_, &Document::problems_changed, this, &OptionsForm::refresh_problems);
    refresh();
    refresh_problems();
}

void OptionsForm::build_method() {
    method_->addItem(tr("Law of propagation only"), static_cast<int>(Method::first_order));
    method_->addItem(tr("Monte Carlo, fixed number of trials"), static_cast<int>(Method::monte_carlo));
    method_->addItem(tr("Monte Carlo, adaptive"), static_cast<int>(Method::adaptive));
    method_->setAccessibleName(tr("Method"));
    method_->setObjectName("method");
    layout_->addRow(tr("Method"), method_);
    connect(method_, &QComboBox::activated, this, [this](int row) {
        const auto method = static_cast<Method>(method_->itemData(row).toInt());
        change("method", [&](EvaluationOptions& options) { options.method = method; });
    });
}

void OptionsForm::build_common() {
    add(
        {"coverage_probability",
         tr("Coverage probability"),
         tr("Between 0 and 1, usually 0.95."),
         false,
         {0.0, 1.0, true}},
        always, [](const EvaluationOptions& o) { return o.coverage_probability; },
        [](EvaluationOptions& o, std::optional<double> value) {
            o.coverage_probability = value.value_or(0.95);
        });
    add(
        {"coverage_factor",
         tr("Coverage factor"),
         tr("A fixed k for U = k u; empty: U by the effective degrees of freedom (law of propagation), or "
            "half of the "
            "coverage interval (Monte Carlo)."),
         false,
         {0.0, Range::infinity_value, true},
         true},
        always, [](const EvaluationOptions& o) { return o.coverage_factor; },
        [](EvaluationOptions& o, std::optional<double> value) { o.coverage_factor = value; });
    second_order_->setObjectName("second_order");
    second_order_->setToolTip(
        tr("Adds the second-order terms of the law of propagation (NOTE to JCGM 100 5.1.2)."));
    layout_->addRow(QString(), second_order_);
    connect(second_order_, &QCheckBox::clicked, this, [this](bool checked) {
        change("second_order", [&](EvaluationOptions& options) { options.second_order = checked; });
    });
    add(
        {"significant_digits",
         tr("Significant digits"),
         tr("Of the numerical tolerance: adaptive procedure and validation (JCGM 101 7.9, 8)."),
         true,
         {1.0, 4.0}},
        always, [](const EvaluationOptions& o) { return o.significant_digits; },
        [](EvaluationOptions& o, std::optional<double> value) {
            o.significant_digits = static_cast<int>(value.value_or(2.0));
        });
}

void OptionsForm::build_monte_carlo() {
    add_count({"trials", tr("Trials"), tr("Number of trials M."), true, {1.0, largest_count}},
              {Method::monte_carlo}, &EvaluationOptions::trials);
    build_variance_reduction();
    add_count({"seed",
               tr("Seed"),
               tr("The same seed gives the same numbers, whatever the number of threads."),
               true,
               {0.0, largest_count}},
              with_trials, &EvaluationOptions::seed);
    add_count({"one_at_a_time_trials",
               tr("Trials one at a time"),
               tr("Trials for each component alone, every other held; 0: none."),
               true,
               {0.0, largest_count}},
              with_trials, &EvaluationOptions::one_at_a_time_trials);
    add_count({"contributor_trials",
               tr("Trials by contributor"),
               tr("Trials with everything of one instrument, artefact or robot held (an ideal one), for "
                  "each; 0: by "
                  "the law of propagation."),
               true,
               {0.0, largest_count}},
              with_trials, &EvaluationOptions::contributor_trials);
    add_count(
        {"sobol_trials",
         tr("Trials for Sobol indices"),
         tr("Pairs of trials for the shares of the variance with all interactions, for each component; 0: "
            "none."),
         true,
         {0.0, largest_count}},
        with_trials, &EvaluationOptions::sobol_trials);
}

void OptionsForm::build_variance_reduction() {
    const auto add_kind = [this](const QString& title, VarianceReduction reduction) {
        variance_reduction_->addItem(title, static_cast<int>(reduction));
    };
    add_kind(tr("None: plain trials"), VarianceReduction::none);
    add_kind(tr("Control variate: the linear part"), VarianceReduction::control_variate);
    add_kind(tr("Sobol points, scrambled"), VarianceReduction::sobol);
    variance_reduction_->setAccessibleName(tr("Variance reduction"));
    variance_reduction_->setObjectName("variance_reduction");
    variance_reduction_->setToolTip(
        tr("Makes each trial tell more. The gain is measured and stated with the result; plain trials are "
           "those of "
           "JCGM 101."));
    layout_->addRow(tr("Variance reduction"), variance_reduction_);
    connect(variance_reduction_, &QComboBox::activated, this, [this](int row) {
        const auto reduction = static_cast<VarianceReduction>(variance_reduction_->itemData(row).toInt());
        change("variance_reduction",
               [&](EvaluationOptions& options) { options.variance_reduction = reduction; });
    });
}

void OptionsForm::build_adaptive() {
    add_quantity(
        {"tolerance",
         tr("Tolerance"),
         tr("With its unit, for the output quantities of that kind (0.005 mm); a bare number is meant in the "
            "SI unit of every output. Empty: from the significant digits."),
         false,
         {0.0, Range::infinity_value, true},
         true},
        {Method::adaptive}, [](const EvaluationOptions& o) { return o.tolerance; },
        [](EvaluationOptions& o, std::optional<Quantity> value) { o.tolerance = value; });
    add_count({"minimum_batches",
               tr("Least number of batches"),
               tr("Before the procedure may stop."),
               true,
               {2.0, largest_count}},
              {Method::adaptive}, &EvaluationOptions::minimum_batches);
    add_count({"maximum_trials",
               tr("Most trials"),
               tr("The procedure stops here and says that it has not stabilised."),
               true,
               {1.0, largest_count}},
              {Method::adaptive}, &EvaluationOptions::maximum_trials);
    forecast_ = new QLabel(this);
    forecast_->setObjectName(QStringLiteral("forecast"));
    forecast_->setWordWrap(true);
    layout_->addRow(tr("Forecast"), forecast_);
}

void OptionsForm::set_forecast(const QString& words) {
    QString sentence = words;
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    forecast_->setText(sentence);
    const EvaluationOptions* shown = options();
    layout_->setRowVisible(forecast_, shown && shown->method == Method::adaptive);
}

void OptionsForm::add_count(const Field& field, std::vector<Method> methods,
                            std::uint64_t EvaluationOptions::*member) {
    add(
        field, std::move(methods),
        [member](const EvaluationOptions& options) { return static_cast<double>(options.*member); },
        [member](EvaluationOptions& options, std::optional<double> value) {
            options.*member = static_cast<std::uint64_t>(value.value_or(0.0));
        });
}

void OptionsForm::add(const Field& field, std::vector<Method> methods, Get get, Set set) {
    add_quantity(
        field, std::move(methods),
        [get = std::move(get)](const EvaluationOptions& options) {
            const std::optional<double> value = get(options);
            return value ? std::optional<Quantity>({*value, Unit()}) : std::nullopt;
        },
        [set = std::move(set)](EvaluationOptions& options, std::optional<Quantity> quantity) {
            set(options, quantity ? std::optional<double>(quantity->value) : std::nullopt);
        });
}

void OptionsForm::add_quantity(const Field& field, std::vector<Method> methods, GetQuantity get,
                               SetQuantity set) {
    auto* edit = new QuantityEdit(this);
    edit->set_integer(field.integer);
    edit->set_range(field.range);
    edit->set_optional(field.optional);
    edit->set_help(field.help);
    edit->setAccessibleName(field.title);
    edit->setObjectName(field.key);
    layout_->addRow(field.title, edit);
    const QString key = field.key;
    edit->set_place(document_.unread(), {{SetupOwner::analysis, analysis_}, place_of_option(key)});
    rows_.push_back({key, edit, std::move(get), std::move(methods)});
    connect(edit, &QuantityEdit::quantity_edited, this,
            [this, key, set = std::move(set)](const std::optional<Quantity>& quantity) {
                change(key, [&](EvaluationOptions& options) { set(options, quantity); });
            });
}

const EvaluationOptions* OptionsForm::options() const {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    return entry ? &entry->options : nullptr;
}

void OptionsForm::change(const QString& key, const std::function<void(EvaluationOptions&)>& edit) {
    document_.apply(
        tr("Change evaluation options"),
        [&](Project& project) {
            if (AnalysisEntry* entry = find_analysis_entry(project, analysis_)) edit(entry->options);
        },
        QStringLiteral("options:%1:%2").arg(to_qt(analysis_), key));
}

void OptionsForm::refresh() {
    const EvaluationOptions* shown = options();
    setEnabled(shown != nullptr);
    if (!shown) return;
    method_->setCurrentIndex(method_->findData(static_cast<int>(shown->method)));
    second_order_->setChecked(shown->second_order);
    variance_reduction_->setCurrentIndex(
        variance_reduction_->findData(static_cast<int>(shown->variance_reduction)));
    layout_->setRowVisible(variance_reduction_, shown->method != Method::first_order);
    for (const Row& row : rows_) {
        const bool used =
            std::find(row.methods.begin(), row.methods.end(), shown->method) != row.methods.end();
        layout_->setRowVisible(row.edit, used);
        if (!used) document_.unread().remove({{SetupOwner::analysis, analysis_}, place_of_option(row.key)});
        row.edit->set_quantity(row.get(*shown));
    }
    set_forecast(shown->method == Method::adaptive ? forecast_->text() : QString());
}

void OptionsForm::refresh_problems() {
    const std::string prefix =
        entry_path(document_.project(), {SetupOwner::analysis, analysis_}) + "/options/";
    for (const Row& row : rows_) {
        QStringList messages;
        for (const Problem& problem : document_.problems().items())
            if (problem.path.starts_with(prefix) && key_of_path(problem.path) == row.key)
                messages << to_qt(problem.message);
        row.edit->set_complaint(messages.join('\n'));
    }
}

bool OptionsForm::focus_field(const std::string& path) {
    const QString key = key_of_path(path);
    if (key == method_->objectName()) method_->setFocus(Qt::OtherFocusReason);
    if (key == variance_reduction_->objectName()) variance_reduction_->setFocus(Qt::OtherFocusReason);
    for (const Row& row : rows_)
        if (row.key == key) row.edit->setFocus(Qt::OtherFocusReason);
    return key == method_->objectName() || key == variance_reduction_->objectName() ||
           std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.key == key; });
}

}  // namespace covaria::ui
