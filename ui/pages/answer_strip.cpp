#include "ui/pages/answer_strip.h"

#include <QClipboard>
#include <QGraphicsOpacityEffect>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "core/project/stated_requirements.h"
#include "core/report/stated_uncertainty.h"
#include "core/result/representation.h"
#include "core/text/numbers.h"
#include "ui/document/missing_fields.h"
#include "ui/document/setup_address.h"
#include "ui/models/problems_model.h"
#include "ui/pages/entry_delegate.h"
#include "ui/pages/run_status.h"
#include "ui/run/result_words.h"
#include "ui/theme/chip.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui {
namespace {

constexpr int side_room = 16, top_room = 12, part_room = 14;  // px

/// The first error in the analysis, else the first one in the project.
std::optional<Problem> first_error(const Document& document, const std::string& analysis) {
    const SetupAddress entry{SetupOwner::analysis, analysis};
    if (!exists(document.project(), entry)) return std::nullopt;
    const auto& all = document.problems().items();
    const auto in_entry = [inside = entry_path(document.project(), entry) + '/'](const Problem& problem) {
        return problem.severity == Severity::error && problem.path.starts_with(inside);
    };
    auto wrong = std::ranges::find_if(all, in_entry);
    if (wrong == all.end()) wrong = std::ranges::find(all, Severity::error, &Problem::severity);
    return wrong == all.end() ? std::nullopt : std::optional(*wrong);
}

void dim(QWidget& part, bool dimmed) {
    auto* effect = qobject_cast<QGraphicsOpacityEffect*>(part.graphicsEffect());
    if (dimmed == (effect != nullptr)) return;
    if (!dimmed) return part.setGraphicsEffect(nullptr);
    effect = new QGraphicsOpacityEffect(&part);
    effect->setOpacity(opacity_of_last);
    part.setGraphicsEffect(effect);
}

/// `is_live`: every edit is followed by a result.
QString result_state_words(const AnalysisStatus& status, bool is_live) {
    QString words = result_words(status);
    if (status.is_of_present() && !status.is_current())
        words = QStringLiteral("<b>%1</b>").arg(words) + (status.state == RunState::running
                                                              ? AnswerStrip::tr("; running")
                                                              : AnswerStrip::tr("; press F5 for the result"));
    if (status.result->failed_trials > 0)
        words += AnswerStrip::tr("; %1 trials without a value")
                     .arg(to_qt(count_text(status.result->failed_trials)));
    if (!represents_measurand(*status.result))
        words = AnswerStrip::tr(
                    "<b>Does not represent the measurand</b> (more than 1 % of the trials are lost). ") +
                words;
    if (!status.result->stabilised) words += AnswerStrip::tr("; not stabilised");
    // A preview is of a moment ago while something is dragged, and there is a next one at once.
    const bool is_followed = is_live && status.stage != ResultStage::complete && status.prepared;
    if (!status.is_of_present() && !is_followed)
        words = AnswerStrip::tr("<b>Out of date</b>: shown for the project as it was. ") + words;
    return words;
}

/// "; U of L, 31 nm, is below the best capability ..."; empty where the output's U may be stated. `made` is
/// null while another project is opened; output -1: none is selected.
QString capability_words(const MadeProject* made, const UncertaintyResult& result, int output) {
    const auto at = static_cast<std::size_t>(output);
    if (!made || at >= result.outputs.size()) return {};
    const auto finding = capability_finding(*made, result, at);
    return finding ? QStringLiteral("; ") + to_qt(finding->words) : QString();
}

}  // namespace

AnswerStrip::AnswerStrip(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      value_(new TypesetLabel(TextSize::answer)),
      coverage_(new TypesetLabel(TextSize::title)),
      verdict_(new Chip),
      state_(new ElidedLabel),
      outputs_(new TypesetComboBox),
      copy_(new QToolButton),
      next_(new QPushButton) {
    setObjectName(QStringLiteral("answer"));
    setAccessibleName(tr("Answer"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    coverage_->set_rank(2);
    outputs_->setToolTip(tr("Output quantity of the budget and the charts"));
    outputs_->setAccessibleName(tr("Output quantity"));
    copy_->setObjectName(QStringLiteral("copy_answer"));
    copy_->setIcon(icon(QStringLiteral("copy")));
    copy_->setAutoRaise(true);
    copy_->setFocusPolicy(Qt::TabFocus);
    copy_->setToolTip(tr("Copy the result, as it stands in a certificate"));
    copy_->setAccessibleName(tr("Copy the result"));
    next_->setObjectName(QStringLiteral("next_step"));
    next_->setAccessibleName(tr("Next step"));
    next_->hide();
    lay_out();
    connect(copy_, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(statements()); });
    connect(next_, &QPushButton::clicked, this, [this] { emit place_wanted(next_place_); });
    connect(outputs_, &QComboBox::activated, this,
            [this](int index) { selection_.select_output(outputs_->itemData(index).toInt()); });
    connect(&document_, &Document::problems_changed, this, &AnswerStrip::show_state);
    connect(&runner_, &AnalysisRunner::progress_changed, this, &AnswerStrip::show_progress);
}

void AnswerStrip::lay_out() {
    auto* first = new QHBoxLayout;
    first->setSpacing(part_room);
    for (QWidget* part : {static_cast<QWidget*>(value_), static_cast<QWidget*>(coverage_)})
        first->addWidget(part);
    first->addWidget(verdict_, 0, Qt::AlignVCenter);
    first->addWidget(next_);
    first->addStretch(1);
    first->addWidget(outputs_);
    first->addWidget(copy_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(side_room, top_room, side_room, top_room - 4);
    column->setSpacing(4);
    column->addLayout(first);
    column->addWidget(state_);
    follow_font(*this, [this] {
        const QFont small = sized(font(), TextSize::small);
        state_->setFont(small);
        const int answer = QFontMetrics(sized(font(), TextSize::answer)).height() + 4;
        setFixedHeight(2 * top_room + answer + QFontMetrics(small).height() + 4);
    });
}

void AnswerStrip::set_units(const DisplayUnits& units) {
    units_ = units;
    take_result();
}

void AnswerStrip::set_digits(int digits) {
    digits_ = digits;
    take_result();
}

void AnswerStrip::take_result() {
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    const int output = selection_.output();
    const bool known = status.result && output >= 0 && std::size_t(output) < status.result->outputs.size();
    answer_ = known ? answer_of(*status.result, std::size_t(output), language_of_window(), units_, digits_)
                    : Answer();
    value_->show_text(known ? answer_.value : Text("\u2013"));
    value_->set_rank(known && status.is_of_present() ? 1 : 3);
    coverage_->show_text(answer_.coverage);
    for (QWidget* part : {static_cast<QWidget*>(value_), static_cast<QWidget*>(coverage_)})
        dim(*part, known && is_refused(status));
    copy_->setEnabled(known);
    if (status.state != RunState::running) progress_.clear();
    show_verdict(status);
    show_state();
    give_way();
}

/// A verdict is of the present project; what is not has its state in the same place.
void AnswerStrip::show_verdict(const AnalysisStatus& status) {
    if (selection_.analysis().isEmpty()) return verdict_->show_words(Chip::Kind::neutral, {});
    const auto say = [this](Chip::Kind kind, const QString& words, const QString& sign) {
        verdict_->show_words(kind, Text(to_std(words)), sign);
    };
    if (status.state == RunState::failed) return say(Chip::Kind::not_met, tr("failed"), {});
    if (status.state == RunState::incomplete)
        return say(Chip::Kind::neutral, tr("incomplete"), state_icon(RunState::incomplete));
    if (!status.prepared && status.state != RunState::running)
        return say(Chip::Kind::not_met, tr("has problems"), {});
    if (!status.is_of_present())
        return say(Chip::Kind::neutral, status.result ? tr("out of date") : tr("not evaluated"),
                   state_icon(RunState::out_of_date));
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(selection_.analysis()));
    if (!entry || answer_.outputs.empty()) return verdict_->show_words(Chip::Kind::neutral, {});
    VerdictWords verdict =
        verdict_words(*status.result, answer_, judge(*status.result, *entry), language_of_window(), units_);
    // A sheet of tests decides about itself.
    if (verdict.words.empty() && status.prepared->descriptor->decides)
        verdict = decision_words(decisions_in(status.prepared->model->evaluation()));
    verdict_->show_words(verdict.met       ? Chip::Kind::met
                         : verdict.is_open ? Chip::Kind::neutral
                                           : Chip::Kind::not_met,
                         verdict.words, verdict.is_open ? QStringLiteral("help") : QString(), verdict.detail);
}

void AnswerStrip::show_progress(const QString& id, const RunProgress& progress) {
    if (id != selection_.analysis()) return;
    progress_ = progress_words(progress);
    show_state();
}

void AnswerStrip::show_state() {
    const QString words = state_words();
    state_->setText(progress_.isEmpty() ? words : progress_ + QStringLiteral("; ") + words);
    state_->setToolTip(state_->text());
    show_next_step();
}

QString AnswerStrip::state_words() const {
    if (selection_.analysis().isEmpty()) return tr("Select an analysis to see its results.");
    const AnalysisStatus& status = runner_.status(selection_.analysis());
    if (status.state == RunState::failed) return tr("Failed: %1").arg(status.message);
    if (status.state == RunState::incomplete) {
        const QString missing = ProblemsModel::missing_words(document_, to_std(selection_.analysis()));
        return missing.isEmpty() ? tr("Not complete yet: nothing is wrong.")
                                 : tr("Not complete yet, but not wrong; to give next: %1").arg(missing);
    }
    if (!status.result)
        return status.prepared ? tr("Not evaluated yet: press F5.") : tr("The analysis has problems.");
    return result_state_words(status, runner_.is_live()) +
           capability_words(runner_.made().get(), *status.result, selection_.output());
}

void AnswerStrip::show_next_step() {
    const QString& id = selection_.analysis();
    std::optional<MissingField> missing;
    if (!id.isEmpty() && runner_.status(id).state == RunState::incomplete) {
        const Project& project = document_.project();
        missing = next_missing(project, document_.problems(),
                               entry_path(project, {SetupOwner::analysis, to_std(id)}));
    }
    next_->setVisible(missing.has_value());
    if (!missing) return show_way_to_error();
    next_place_ = to_qt(missing->path);
    next_->setText(tr("Next: %1").arg(core_text(missing->title)));
    next_->setToolTip(tr("Goes to the field that must be given next"));
}

/// The last answer stays while a field is wrong, with the way to that field.
void AnswerStrip::show_way_to_error() {
    const QString& id = selection_.analysis();
    const auto wrong = is_refused(runner_.status(id)) ? first_error(document_, to_std(id)) : std::nullopt;
    if (!wrong) return;
    next_place_ = to_qt(wrong->path);
    next_->setText(tr("Show the Field"));
    next_->setToolTip(to_qt(wrong->message));
    next_->show();
}

QString AnswerStrip::statements() const {
    const QString said = reservation(runner_.status(selection_.analysis()));
    return to_qt(answer_.statements).trimmed() + (said.isEmpty() ? said : QLatin1Char('\n') + said);
}

/// The figures of the verdict are the first to go, then k and p; the value is shortened at last.
void AnswerStrip::give_way() {
    const auto has_room = [this] {
        int wanted = 2 * side_room + 5 * part_room;
        for (const QWidget* part : std::initializer_list<const QWidget*>{value_, coverage_, copy_})
            wanted += part->sizeHint().width();
        for (const QWidget* part : std::initializer_list<const QWidget*>{verdict_, next_, outputs_})
            if (!part->isHidden()) wanted += part->sizeHint().width() + part_room;
        return wanted <= width();
    };
    verdict_->set_brief(false);
    verdict_->set_brief(!has_room());
    coverage_->setVisible(!coverage_->text().empty() && has_room());
}

void AnswerStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    give_way();
}

}  // namespace covaria::ui
