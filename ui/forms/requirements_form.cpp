#include "ui/forms/requirements_form.h"

#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

#include "core/project/stated_requirements.h"
#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "core/text/symbol.h"
#include "core/views/component_labels.h"
#include "ui/document/component_source.h"
#include "ui/document/requirement_edits.h"
#include "ui/document/setup_address.h"
#include "ui/forms/complaint.h"
#include "ui/forms/finish_typing.h"
#include "ui/forms/form_labels.h"
#include "ui/models/number_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/output_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr std::size_t most_reductions = 8;

QString number(const Unit& unit, double si, int digits = 3) {
    return localized(format_significant(unit.interval_from_si(si), digits)) + to_qt(unit_after_number(unit));
}

/// Texts of both, with as many digits as tell them apart; the second is rounded down, so that it suffices
/// as it stands.
std::pair<QString, QString> told_apart(const Unit& unit, double now, double needed, int fewest = 3) {
    constexpr int most = 8;
    const double value = unit.interval_from_si(needed);
    for (int digits = fewest;; ++digits) {
        const double down = rounded_down(value, digits);
        const std::pair texts(number(unit, now, digits), number(unit, unit.interval_to_si(down), digits));
        if (texts.first != texts.second || digits == most) return texts;
    }
}

QString percent(double p) {
    return to_qt(probability_text(p, user_numbers())).toHtmlEscaped();  // "< 0.01 %"
}

QString target_words(const UncertaintyResult& result, const RequirementResult& r, double target,
                     const DisplayUnits& units) {
    const OutputResult& output = result.outputs[r.output];
    return RequirementsForm::tr("U = %1: the target is %2.")
        .arg(told_apart(units.of(output.quantity.unit), output.expanded_uncertainty, target, 2).first,
             r.meets_target ? RequirementsForm::tr("met") : RequirementsForm::tr("not met"));
}

/// Leads to where the component is stated.
QString linked(const QString& label, const QString& place) {
    return place.isEmpty() ? label
                           : QStringLiteral("<a href=\"%1\">%2</a>").arg(place.toHtmlEscaped(), label);
}

QString reduction_words(const UncertaintyResult& result, const ReverseBudget& budget,
                        const DisplayUnits& units,
                        const std::function<QString(const BudgetComponent&)>& place_of) {
    if (budget.reductions.empty()) return {};
    std::vector<const BudgetComponent*> components;
    std::vector<const ReverseBudget::Reduction*> reductions;
    for (const auto& reduction : budget.reductions) {
        if (!reduction.needed || reductions.size() == most_reductions) continue;
        components.push_back(&result.budget.components[reduction.component]);
        reductions.push_back(&reduction);
    }
    const std::vector<Text> labels = component_labels(components, language_of_window());
    QString list;
    for (std::size_t i = 0; i < reductions.size(); ++i) {
        const auto& reduction = *reductions[i];
        const BudgetComponent& c = *components[i];
        const auto texts = told_apart(units.of(c.unit).interval(), reduction.now, *reduction.needed);
        list +=
            RequirementsForm::tr("<li>u of %1 reduced from %2 to %3: %4 of what is stated</li>")
                .arg(linked(to_qt(to_html(labels[i])), place_of(c)), texts.first, texts.second,
                     to_qt(percent_text(rounded_down(*reduction.needed / reduction.now, 3), user_numbers())));
    }
    if (!list.isEmpty())
        return RequirementsForm::tr("<br>It would be met with one of these alone:<ul>%1</ul>").arg(list);
    QString text = RequirementsForm::tr("<br>No component suffices alone.");
    if (budget.common_factor)
        text += RequirementsForm::tr(" It would be met with all standard uncertainties multiplied by %1.")
                    .arg(localized(format_significant(rounded_down(*budget.common_factor, 3), 3)));
    return text;
}

QString distribution_words(RequirementResult::Distribution by) {
    switch (by) {
        case RequirementResult::Distribution::trials:
            return RequirementsForm::tr("(trials)");
        case RequirementResult::Distribution::student_t:
            return RequirementsForm::tr("(Student t)");
        case RequirementResult::Distribution::normal:
            break;
    }
    return RequirementsForm::tr("(normal)");
}

QString not_judged_words(const RequirementResult& r) {
    return RequirementsForm::tr("Not judged: %1.").arg(to_qt(r.not_judged));
}

QString conformity_words(const UncertaintyResult& result, const RequirementResult& r,
                         const DisplayUnits& units) {
    const Unit& unit = units.of(result.outputs[r.output].quantity.unit);
    const bool accepted = r.decision == RequirementResult::Decision::accept;
    QString text = RequirementsForm::tr(
                       "By %5, guard band %1: the result is <b>%2</b>. Probability of conformance %3 %4.")
                       .arg(std::isfinite(r.guard_band) ? number(unit, r.guard_band) : QStringLiteral("∞"),
                            accepted ? RequirementsForm::tr("accepted") : RequirementsForm::tr("rejected"),
                            percent(r.conformance), distribution_words(r.conformance_by),
                            to_qt(decision_rule(r, language_of_window())));
    if (r.uncertainty_ratio && r.capability_index)
        text += RequirementsForm::tr("<br>TUR %1, C<sub>m</sub> %2.")
                    .arg(localized(format_significant(*r.uncertainty_ratio, 3)),
                         localized(format_significant(*r.capability_index, 3)));
    if (r.global_risks)
        text += RequirementsForm::tr("<br>Global risks of the rule: consumer's %1, producer's %2.")
                    .arg(percent(r.global_risks->consumer), percent(r.global_risks->producer)) +
                RequirementsForm::tr(
                    "<br>Of what the rule accepts %1 does not conform, of what it rejects %2 "
                    "does.")
                    .arg(percent(r.global_risks->consumer_if_accepted),
                         percent(r.global_risks->producer_if_rejected));
    return text;
}

}  // namespace

RequirementsForm::RequirementsForm(Document& document, AnalysisRunner& runner, std::string analysis,
                                   QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      analysis_(std::move(analysis)),
      layout_(new QFormLayout(this)),
      outputs_(new TypesetComboBox(this)),
      verdict_(new QLabel(this)),
      jobs_(Execution::threads) {
    outputs_->setAccessibleName(tr("Result"));
    outputs_->setObjectName("requirement_of");
    may_be_narrow(*outputs_);
    layout_->addRow(tr("Result"), outputs_);
    for (const RequirementField& field : requirement_fields()) add_row(field);
    verdict_->setWordWrap(true);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                      Qt::LinksAccessibleByKeyboard);
    connect(verdict_, &QLabel::linkActivated, this, &RequirementsForm::place_wanted);
    verdict_->setContentsMargins(0, 10, 0, 0);
    layout_->addRow(verdict_);
    connect(outputs_, &QComboBox::currentIndexChanged, this, [this] {
        refresh_values();
        refresh_problems();
        refresh_verdict();
    });
    connect(&document_, &Document::project_changed, this, &RequirementsForm::refresh);
    connect(&document_, &Document::problems_changed, this, &RequirementsForm::refresh_problems);
    const auto follow = [this](const QString& id) {
        if (to_std(id) == analysis_) refresh();
    };
    connect(&runner_, &AnalysisRunner::result_changed, this, follow);
    connect(&runner_, &AnalysisRunner::state_changed, this, follow);
    refresh();
}

void RequirementsForm::add_choice(const RequirementField& field) {
    rules_ = new QComboBox(this);
    may_be_narrow(*rules_);
    const QString title = core_text(field.title);
    rules_->setObjectName(field.key);
    rules_->setAccessibleName(title);
    rules_->setToolTip(core_text(field.help));
    for (const GuardRuleChoice& known : guard_rules()) rules_->addItem(core_text(known.choice.title));
    layout_->addRow(title, rules_);
    connect(rules_, &QComboBox::activated, this, [this, key = std::string(field.key)](int index) {
        const GuardRule rule = guard_rules()[static_cast<std::size_t>(index)].rule;
        change(key, [rule](Requirement& r) { r.guard_rule = rule; });
    });
}

void RequirementsForm::add_row(const RequirementField& field) {
    if (is_choice(field)) return add_choice(field);
    auto* edit = new QuantityEdit(this);
    keep_letters(*edit);
    const QString title = core_text(field.title);
    edit->setObjectName(field.key);
    edit->setAccessibleName(title);
    edit->set_help(core_text(field.help));
    layout_->addRow(title, edit);
    rows_.push_back({field, edit});
    if (is_number(field))
        edit->set_range(std::string_view(field.key) == "targetRisk" ? Range{.low = 0.0, .high = 0.5}
                                                                    : Range{.low = -10.0, .high = 10.0});
    connect(edit, &QuantityEdit::quantity_edited, this, [this, &field](const std::optional<Quantity>& value) {
        change(field.key, [&](Requirement& r) { set_value(r, field, value); });
    });
}

const OutputQuantity* RequirementsForm::output() const {
    const int i = outputs_->currentIndex();
    return i < 0 || i >= int(known_.size()) ? nullptr : &known_[std::size_t(i)];
}

const Requirement* RequirementsForm::requirement() const {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    if (!entry || !output()) return nullptr;
    return find_requirement(*entry, *output());
}

void RequirementsForm::change(const std::string& key, const std::function<void(Requirement&)>& edit) {
    const OutputQuantity* of = output();
    if (!of) return;
    change_requirements(document_, analysis_, {*of}, edit,
                        QStringLiteral("requirement:%1:%2:%3")
                            .arg(to_qt(analysis_), to_qt(of->group + "/" + of->symbol), to_qt(key)));
}

void RequirementsForm::set_units(const DisplayUnits& units) {
    if (units.chosen() == units_.chosen()) return;
    finish_typing();  // a number that is being typed is in the unit that the field shows
    units_ = units;
    refresh_values();
    refresh_verdict();
}

void RequirementsForm::refresh() {
    refresh_outputs();
    refresh_values();
    refresh_problems();
    refresh_verdict();
}

void RequirementsForm::refresh_outputs() {
    const auto& prepared = runner_.status(to_qt(analysis_)).prepared;
    if (!prepared) return;
    std::vector<OutputQuantity> outputs;
    for (const OutputQuantity& o : prepared->model->outputs())
        if (o.role == OutputRole::measurand) outputs.push_back(o);
    const auto same = [](const OutputQuantity& a, const OutputQuantity& b) {
        return a.symbol == b.symbol && a.group == b.group && a.unit == b.unit;
    };
    if (std::equal(outputs.begin(), outputs.end(), known_.begin(), known_.end(), same)) return;
    const QSignalBlocker quiet(outputs_);
    const QString before = outputs_->currentText();
    known_ = std::move(outputs);
    outputs_->clear();
    for (const OutputQuantity& o : known_) outputs_->add_item(output_words(o.symbol, o.group));
    outputs_->setCurrentIndex(std::max(0, outputs_->findText(before)));
}

void RequirementsForm::refresh_values() {
    const Requirement* given = requirement();
    const OutputQuantity* of = output();
    const GuardRule rule = given ? given->guard_rule : GuardRule::factor;
    rules_->setEnabled(of != nullptr);
    for (std::size_t i = 0; i < guard_rules().size(); ++i)
        if (guard_rules()[i].rule == rule) rules_->setCurrentIndex(static_cast<int>(i));
    for (const Row& row : rows_) {
        row.edit->setEnabled(of != nullptr);
        if (!of) continue;
        row.edit->set_place(document_.unread(),
                            {{SetupOwner::analysis, analysis_},
                             "/requirements/" + of->group + "|" + of->symbol + "/" + row.field.key});
        const Unit& unit = units_.of(of->unit);
        if (!is_number(row.field)) row.edit->set_unit(row.field.is_interval ? unit.interval() : unit);
        row.edit->set_quantity(value_of(given ? *given : Requirement{}, row.field));
    }
}

void RequirementsForm::refresh_problems() {
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    const Requirement* given = requirement();
    const std::string prefix =
        given && entry ? entry_path(document_.project(), {SetupOwner::analysis, analysis_}) +
                             "/requirements/" + std::to_string(given - entry->requirements.data()) + "/"
                       : std::string();
    const auto complaints = [&](const std::string& key) {
        return prefix.empty() ? QString() : problems_at(document_.problems(), prefix + key);
    };
    for (const RequirementField& field : requirement_fields())
        if (is_choice(field)) mark(*rules_, complaints(field.key), core_text(field.help));
    for (const Row& row : rows_) row.edit->set_complaint(complaints(row.field.key));
}

void RequirementsForm::refresh_verdict() {
    const AnalysisStatus& status = runner_.status(to_qt(analysis_));
    const Requirement* given = requirement();
    AnalysisEntry judged;
    if (given) judged.requirements = {*given};
    QStringList words;
    if (status.is_of_present())
        for (const RequirementResult& r : judge(*status.result, judged)) {
            if (!r.not_judged.empty()) {
                words << not_judged_words(r);
                continue;
            }
            if (r.target_uncertainty)
                words << target_words(*status.result, r, *r.target_uncertainty, units_) +
                             reductions(status, r);
            if (r.lower_limit || r.upper_limit) words << conformity_words(*status.result, r, units_);
        }
    if (!words.isEmpty() && status.stage == ResultStage::first_order &&
        status.prepared->options.method != Method::first_order)
        words << tr("By the law of propagation; Monte Carlo is to follow.");
    if (!words.isEmpty() && status.stage == ResultStage::preview)
        words << tr("By the trials of a preview; the whole run is to follow.");
    if (words.isEmpty() && given) words << tr("Run the analysis to see whether the requirement is met.");
    verdict_->setText(words.join(QStringLiteral("<br>")));
}

// The reductions that would meet the target. They take trials: a worker finds them, and they are shown then.
QString RequirementsForm::reductions(const AnalysisStatus& status, const RequirementResult& r) {
    if (r.meets_target) return {};
    const Sought sought{status.result, r.output, *r.target_uncertainty};
    const auto place_of = [&](const BudgetComponent& component) {
        return place_of_component(document_.project(), *status.prepared, component);
    };
    if (sought == sought_)
        return found_ ? reduction_words(*status.result, *found_, units_, place_of) : QString();
    sought_ = sought;
    found_.reset();
    search_.request_stop();
    search_ = std::stop_source();
    jobs_.push(
        [this, sought, analysis = status.result_of, stop = search_.get_token()]() -> JobQueue::Delivery {
            if (stop.stop_requested()) return {};
            auto budget = reverse_budget(analysis->model.get(), *sought.result, sought.output, sought.target,
                                         {stop, {}, 0});
            if (!budget) return {};
            return [this, sought, budget = std::move(*budget)] {
                if (!(sought == sought_)) return;
                found_ = budget;
                refresh_verdict();
            };
        },
        [](const Error&) {});  // the verdict stands without it
    return {};
}

RequirementsForm::~RequirementsForm() {
    search_.request_stop();
    jobs_.wait();
}

bool RequirementsForm::focus_field(const std::string& path) {
    const std::string prefix =
        entry_path(document_.project(), {SetupOwner::analysis, analysis_}) + "/requirements/";
    const AnalysisEntry* entry = document_.project().find_analysis(analysis_);
    if (!path.starts_with(prefix) || !entry) return false;
    // A requirement by its number, or a result by its group and symbol.
    const std::size_t index = std::strtoul(path.c_str() + prefix.size(), nullptr, 10);
    for (std::size_t i = 0; i < known_.size(); ++i) {
        const bool named = path.starts_with(prefix + known_[i].group + "|" + known_[i].symbol + "/");
        const bool numbered =
            index < entry->requirements.size() && is_about(entry->requirements[index], known_[i]);
        if (named || (numbered && path.find('|') == std::string::npos)) outputs_->setCurrentIndex(int(i));
    }
    if (path.ends_with("/guardRule")) rules_->setFocus(Qt::OtherFocusReason);
    for (const Row& row : rows_)
        if (path.ends_with(std::string("/") + row.field.key)) row.edit->setFocus(Qt::OtherFocusReason);
    return true;
}

}  // namespace covaria::ui
