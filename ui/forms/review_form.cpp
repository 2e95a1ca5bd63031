#include "ui/forms/review_form.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/project/release.h"
#include "ui/document/today.h"
#include "ui/forms/complaint.h"
#include "ui/forms/date_editor.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/simple_editors.h"
#include "ui/theme/core_text.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t shown_digits = 16;  ///< of a digest, in a line that must break

std::string path_of(const ReviewStepField& step, const char* member) {
    return std::string("/review/") + step.key + "/" + member;
}

QString summary_of(ReleaseState state) {
    switch (state) {
        case ReleaseState::unreviewed:
            return {};
        case ReleaseState::draft:
            return ReviewForm::tr("draft");
        case ReleaseState::released:
            return ReviewForm::tr("released");
        case ReleaseState::changed:
            break;
    }
    return ReviewForm::tr("draft again");
}

QString words_of_state(const ReleaseStatus& status, Review review) {
    if (status.state == ReleaseState::unreviewed)
        return ReviewForm::tr(
            "A release states in report and certificate who is responsible, and a digest by "
            "which every later change shows.");
    if (review.digest.size() > shown_digits) review.digest = review.digest.substr(0, shown_digits) + "…";
    QString words = to_qt(words_of(status, review));
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words + QLatin1Char('.');
}

/// Releases what the project is now. After a change the release is of today.
void release_now(Project& project) {
    Review& review = project.review;
    if (release_status(project).state == ReleaseState::changed) review.released.date = today();
    for (const ReviewStepField& step : review_steps())
        if (std::string& date = (review.*step.member).date; date.empty()) date = today();
    // A date that is none is an error of the project, at which nobody can press the button.
    (void)release(project);
}

QLineEdit* make_line(const char* name, const QString& words) {
    auto* line = new QLineEdit;
    line->setObjectName(QLatin1String(name));
    line->setAccessibleName(words);
    line->setPlaceholderText(words);
    return line;
}

}  // namespace

ReviewForm::ReviewForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      state_(new QLabel),
      log_(new QLabel),
      release_(new QPushButton(tr("Release"))),
      who_(make_line("log_who", tr("Who"))),
      what_(make_line("log_what", tr("What was done"))) {
    auto* column = new QVBoxLayout(this);
    state_->setObjectName(QStringLiteral("review_state"));
    state_->setWordWrap(true);
    column->addWidget(state_);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    for (const ReviewStepField& step : review_steps()) add_step(step, *form);
    column->addLayout(form);
    release_->setObjectName(QStringLiteral("release"));
    release_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    column->addWidget(release_);
    column->addWidget(make_log());
    connect(release_, &QPushButton::clicked, this, &ReviewForm::release_project);
    connect(&document_, &Document::project_changed, this, &ReviewForm::refresh);
    connect(&document_, &Document::problems_changed, this, &ReviewForm::refresh_problems);
    refresh();
    refresh_problems();
}

void ReviewForm::add_step(const ReviewStepField& step, QFormLayout& form) {
    FieldSpec name;
    name.key = path_of(step, "name");
    name.title = step.title;
    name.help = step.help;
    add_field(step, &ReviewStep::name, *new TextEditor(name, this), step.title, form);
    FieldSpec date;
    date.key = path_of(step, "date");
    date.title = to_std(tr("Date"));
    date.help = to_std(tr("The day of this step; empty: that of the release."));
    add_field(step, &ReviewStep::date,
              *new DateEditor(date, DateEditor::Days::one, document_, {project_address, date.key}, this),
              date.title, form);
}

void ReviewForm::add_field(const ReviewStepField& step, std::string ReviewStep::*member, FieldEditor& editor,
                           const std::string& title, QFormLayout& form) {
    QLabel* label = make_form_label(title, this);
    label->setBuddy(&editor);
    form.addRow(label, &editor);
    rows_.push_back({&step, member, &editor});
    connect(&editor, &FieldEditor::edited, this, [this, &step, member](const SetupValue& value) {
        const std::string* text = std::get_if<std::string>(&value);
        document_.apply(
            tr("Change %1").arg(core_text(step.title)),
            [&](Project& project) { project.review.*step.member.*member = text ? *text : std::string(); },
            QStringLiteral("review:%1:%2")
                .arg(QLatin1String(step.key),
                     member == &ReviewStep::name ? QStringLiteral("name") : QStringLiteral("date")));
    });
}

QWidget* ReviewForm::make_log() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    log_->setObjectName(QStringLiteral("review_log"));
    log_->setWordWrap(true);
    log_->setTextFormat(Qt::PlainText);
    log_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* add = new QPushButton(tr("Add to the Log"));
    add->setObjectName(QStringLiteral("add_to_log"));
    add->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    column->addWidget(log_);
    column->addWidget(who_);
    column->addWidget(what_);
    column->addWidget(add);
    connect(add, &QPushButton::clicked, this, &ReviewForm::add_entry);
    connect(what_, &QLineEdit::returnPressed, this, &ReviewForm::add_entry);
    return page;
}

void ReviewForm::release_project() {
    document_.apply(tr("Release the project"), release_now);
}

void ReviewForm::add_entry() {
    const ReviewEntry entry{today(), to_std(who_->text().trimmed()), to_std(what_->text().trimmed())};
    if (entry.what.empty()) return what_->setFocus();
    document_.apply(tr("Add to the log"), [&](Project& project) { project.review.log.push_back(entry); });
    what_->clear();
}

void ReviewForm::refresh() {
    const Review& review = document_.project().review;
    for (const Row& row : rows_) {
        const std::string& text = review.*row.step->member.*row.member;
        row.editor->set_value(text.empty() ? SetupValue() : SetupValue(text));
    }
    QStringList lines;
    for (const ReviewEntry& entry : review.log)
        lines << QStringLiteral("%1  %2: %3").arg(to_qt(entry.date), to_qt(entry.who), to_qt(entry.what));
    log_->setText(lines.join(QLatin1Char('\n')));
    log_->setVisible(!lines.isEmpty());
    show_state();
}

void ReviewForm::show_state() {
    const Review& review = document_.project().review;
    const ReleaseStatus status = release_status(document_.project());
    state_->setText(words_of_state(status, review));
    state_->setToolTip(to_qt(review.digest));
    const bool named = std::ranges::none_of(
        review_steps(), [&](const ReviewStepField& step) { return is_blank((review.*step.member).name); });
    const bool errors = document_.problems().has_errors();
    release_->setEnabled(named && !errors && status.state != ReleaseState::released);
    release_->setToolTip(errors   ? tr("A project with errors is not released.")
                         : !named ? tr("All three names are needed.")
                                  : tr("Takes the digest of the project as it is now"));
    emit summary_changed(summary_of(status.state));
}

void ReviewForm::refresh_problems() {
    for (const Row& row : rows_)
        row.editor->set_complaint(problems_at(
            document_.problems(), path_of(*row.step, row.member == &ReviewStep::name ? "name" : "date")));
    show_state();
}

bool ReviewForm::focus_field(const std::string& path) {
    if (!path.starts_with("/review/")) return false;
    FoldGroups::reveal(*this);
    for (const Row& row : rows_)
        if (path == path_of(*row.step, row.member == &ReviewStep::name ? "name" : "date"))
            row.editor->focus_part({});
    return true;
}

}  // namespace covaria::ui
