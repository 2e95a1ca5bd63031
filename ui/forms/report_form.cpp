#include "ui/forms/report_form.h"

#include <QLabel>
#include <algorithm>

#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

ReportForm::ReportForm(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      column_(new QVBoxLayout(this)),
      analyses_column_(new QVBoxLayout) {
    add_head(tr("Analyses, of report and certificate"));
    column_->addLayout(analyses_column_);
    add_head(tr("Chapters of the report"));
    for (const ReportChapterField& chapter : report_chapters()) {
        QCheckBox* box = make_box(&ReportContents::without_chapters, chapter.key, core_text(chapter.title));
        column_->addWidget(box);
        chapters_.push_back({box, chapter.key});
    }
    add_head(tr("Long tables"));
    annex_ = make_box(QStringLiteral("report:annex"),
                      tr("The report shows what counts most of long tables; the CSV files have them whole. "
                         "Ticked, they stand whole at the end of the report too."));
    annex_->setText(tr("Whole, in an annex"));
    column_->addWidget(annex_);
    add_head(tr("Language"));
    language_ = new QLabel(this);
    language_->setWordWrap(true);
    column_->addWidget(language_);
    column_->addStretch(1);
    connect(annex_, &QCheckBox::clicked, this, [this](bool on) {
        document_.apply(tr("Change the annex of the report"),
                        [on](Project& project) { project.report.annex = on; });
    });
    refresh();
    connect(&document_, &Document::project_changed, this, &ReportForm::refresh);
}

void ReportForm::add_head(const QString& title) {
    auto* label = new QLabel(title, this);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    label->setContentsMargins(0, column_->isEmpty() ? 0 : 10, 0, 0);
    column_->addWidget(label);
}

QCheckBox* ReportForm::make_box(const QString& name, const QString& help) {
    auto* box = new QCheckBox(this);
    box->setObjectName(name);
    box->setToolTip(help);
    return box;
}

QCheckBox* ReportForm::make_box(Keys keys, const std::string& key, const QString& title) {
    QCheckBox* box =
        make_box(QStringLiteral("report:") + to_qt(key), tr("Goes into the report where it is ticked."));
    box->setText(QString(title).replace(QLatin1Char('&'), QStringLiteral("&&")));
    box->setAccessibleName(title);
    connect(box, &QCheckBox::clicked, this, [this, keys, key, title](bool on) {
        document_.apply(
            on ? tr("Put %1 into the report").arg(title) : tr("Leave %1 out of the report").arg(title),
            [&](Project& project) { choose(project.report.*keys, key, on); });
    });
    return box;
}

/// Makes a box for each present analysis, under its present name.
void ReportForm::rebuild_analyses() {
    for (const Box& old : analyses_) delete old.box;
    analyses_.clear();
    for (const AnalysisEntry& analysis : document_.project().analyses) {
        QCheckBox* box = make_box(&ReportContents::without_analyses, analysis.id, to_qt(analysis.name));
        analyses_column_->addWidget(box);
        analyses_.push_back({box, analysis.id});
    }
}

void ReportForm::refresh() {
    const Project& project = document_.project();
    bool same = project.analyses.size() == analyses_.size();
    for (std::size_t i = 0; same && i < analyses_.size(); ++i)
        same = project.analyses[i].id == analyses_[i].key &&
               to_qt(project.analyses[i].name) == analyses_[i].box->accessibleName();
    if (!same) rebuild_analyses();
    for (const Box& box : analyses_) box.box->setChecked(project.report.has_analysis(box.key));
    for (std::size_t i = 0; i < chapters_.size(); ++i)
        chapters_[i].box->setChecked(project.report.has(report_chapters()[i].chapter));
    annex_->setChecked(project.report.annex);
    const auto& languages = certificate_languages();
    const auto chosen = std::find_if(languages.begin(), languages.end(), [&](const CertificateLanguage& one) {
        return project.certificate.language == one.code;
    });
    language_->setText(
        chosen == languages.end()
            ? tr("English: none is chosen on the page Certificate.")
            : tr("%1, as chosen on the page Certificate.").arg(QString::fromUtf8(chosen->name)));
}

}  // namespace covaria::ui
