#include "ui/forms/figure_sources_form.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdlib>

#include "core/base/file_io.h"
#include "core/base/sha256.h"
#include "core/made/applicability.h"
#include "ui/forms/complaint.h"
#include "ui/forms/date_editor.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/simple_editors.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

template <class P>
auto find_certificates(P& project, const SetupAddress& entry)
    -> decltype(&project.assets.front().certificates) {
    if (entry.owner == SetupOwner::asset) {
        const auto asset = std::ranges::find(project.assets, entry.id, &AssetEntry::id);
        return asset == project.assets.end() ? nullptr : &asset->certificates;
    }
    const auto analysis = std::ranges::find(project.analyses, entry.id, &AnalysisEntry::id);
    return analysis == project.analyses.end() ? nullptr : &analysis->certificates;
}

FieldSpec spec_of(const AssetCertificateText& text) {
    FieldSpec spec;
    spec.key = text.key;
    spec.title = text.title;
    spec.help = text.help;
    return spec;
}

FieldSpec spec_of_measured() {
    FieldSpec spec;
    spec.key = "measured";
    spec.title = to_std(FigureSourcesForm::tr("Date of the measurement"));
    spec.help = to_std(
        FigureSourcesForm::tr("A date, or two of an interval; empty: that of the project's certificate."));
    return spec;
}

QToolButton* small_button(const char* picture, const QString& words, const char* name) {
    auto* button = new QToolButton;
    button->setIcon(icon(QLatin1String(picture)));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(words);
    button->setAccessibleName(words);
    button->setObjectName(QLatin1String(name));
    return button;
}

/// Name of a certificate in the list, by its number there.
QString list_words(const AssetCertificate& c, std::size_t number) {
    return c.number.empty() && c.issuer.empty()
               ? FigureSourcesForm::tr("certificate %1, not named yet").arg(number)
               : to_qt(name_of(c));
}

int place_of(FiguresFrom kind) {
    const auto found = std::ranges::find(figures_from_words(), kind, &FiguresFromWord::value);
    return static_cast<int>(found - figures_from_words().begin());
}

FieldEditor* make_editor(const AssetCertificateText& text, Document& document, const SetupAddress& entry,
                         QWidget* page) {
    const FieldSpec spec = spec_of(text);
    if (text.kind == AssetCertificateText::Kind::line) return new TextEditor(spec, page);
    const auto days =
        text.kind == AssetCertificateText::Kind::dates ? DateEditor::Days::interval : DateEditor::Days::one;
    return new DateEditor(spec, days, document, {entry, std::string("/certificates/") + text.key}, page);
}

/// Verdict of every analysis that uses the certificate at `place`, with its reasons.
QString verdict_words(const MadeProject& made, const std::string& place) {
    QStringList words;
    std::size_t applicable = 0;
    for (const AnalysisEntry& analysis : made.project().analyses)
        for (const CertificateUse& use : figures_used(made, analysis.id).certificates) {
            if (use.path != place || use.analysis != analysis.id) continue;
            if (use.verdict.verdict == Applicability::applicable)
                ++applicable;
            else
                words << QStringLiteral("%1: %2").arg(to_qt(analysis.name), to_qt(sentence_of(use)));
        }
    if (applicable > 0)
        words.prepend(FigureSourcesForm::tr("Analyses in which it is applicable: %1.").arg(applicable));
    return words.isEmpty() ? FigureSourcesForm::tr("No analysis uses these figures.")
                           : words.join(QLatin1Char('\n'));
}

}  // namespace

/// Date of the measurement of an analysis.
class MeasuredDate : public QWidget {
public:
    MeasuredDate(Document& document, const SetupAddress& analysis, QWidget* parent)
        : QWidget(parent), document_(document), analysis_(analysis) {
        const FieldSpec spec = spec_of_measured();
        date_ = new DateEditor(spec, DateEditor::Days::interval, document, {analysis, "/measured"}, this);
        auto* form = new QFormLayout(this);
        form->setContentsMargins(0, 0, 0, 0);
        form->addRow(make_form_label(spec.title, this), date_);
        connect(date_, &FieldEditor::edited, this, [this](const SetupValue& value) {
            const std::string* text = std::get_if<std::string>(&value);
            document_.apply(
                FigureSourcesForm::tr("Change the date of the measurement"),
                [&](Project& project) {
                    if (AnalysisEntry* entry = find_analysis_entry(project, analysis_.id))
                        entry->measured = text ? *text : std::string();
                },
                QStringLiteral("measured:%1").arg(to_qt(analysis_.id)));
        });
    }
    void refresh() {
        const AnalysisEntry* entry = document_.project().find_analysis(analysis_.id);
        if (entry) date_->set_value(entry->measured.empty() ? SetupValue() : SetupValue(entry->measured));
    }
    std::string path() const { return entry_path(document_.project(), analysis_) + "/measured"; }
    FieldEditor& editor() { return *date_; }

private:
    Document& document_;
    SetupAddress analysis_;
    FieldEditor* date_;
};

FigureSourcesForm::FigureSourcesForm(Document& document, const SetupAddress& entry, QWidget* parent)
    : QWidget(parent),
      document_(document),
      entry_(entry),
      list_(new QComboBox),
      kinds_(new QComboBox),
      fields_(new QWidget),
      verdict_(new QLabel) {
    auto* column = new QVBoxLayout(this);
    if (entry_.owner == SetupOwner::analysis)
        column->addWidget(measured_ = new MeasuredDate(document_, entry_, this));
    column->addWidget(make_head());
    column->addWidget(make_fields());
    verdict_->setObjectName(QStringLiteral("figures_verdict"));
    verdict_->setWordWrap(true);
    column->addWidget(verdict_);
    connect(list_, &QComboBox::activated, this, &FigureSourcesForm::show_chosen);
    connect(&document_, &Document::project_changed, this, &FigureSourcesForm::refresh);
    connect(&document_.maker(), &ProjectMaker::made_changed, this, &FigureSourcesForm::refresh_verdict);
    connect(&document_, &Document::problems_changed, this, &FigureSourcesForm::refresh_problems);
    show_chosen();
}

QWidget* FigureSourcesForm::make_head() {
    auto* head = new QWidget;
    list_->setObjectName(QStringLiteral("figure_sources"));
    list_->setAccessibleName(tr("Certificate of the figures"));
    may_be_narrow(*list_);
    auto* add = small_button("add", tr("Adds a certificate that figures come from"), "add_source");
    remove_ = small_button("remove", tr("Removes this certificate"), "remove_source");
    file_ = small_button("open", tr("Takes name and digest of the certificate's file"), "source_file");
    impact_ = small_button("impact", tr("Shows what hangs on this certificate"), "source_impact");
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(list_, 1);
    for (QToolButton* button : {add, remove_, file_, impact_}) row->addWidget(button);
    row->addStretch(0);  // where there is no list
    connect(add, &QToolButton::clicked, this, &FigureSourcesForm::add_certificate);
    connect(remove_, &QToolButton::clicked, this, &FigureSourcesForm::remove_certificate);
    connect(file_, &QToolButton::clicked, this, &FigureSourcesForm::read_file);
    connect(impact_, &QToolButton::clicked, this, [this] {
        if (const AssetCertificate* now = shown())
            emit impact_wanted(to_qt(now->number.empty() ? now->digest : now->number));
    });
    return head;
}

QWidget* FigureSourcesForm::make_fields() {
    auto* form = new QFormLayout(fields_);
    form->setContentsMargins(0, 0, 0, 0);
    kinds_->setObjectName(QStringLiteral("source_kind"));
    kinds_->setAccessibleName(tr("Kind"));
    for (const FiguresFromWord& word : figures_from_words()) kinds_->addItem(core_text(word.title));
    form->addRow(tr("Kind"), kinds_);
    connect(kinds_, &QComboBox::activated, this, [this](int index) {
        const FiguresFrom kind = figures_from_words()[static_cast<std::size_t>(index)].value;
        change(tr("Change the kind of a certificate"), [kind](AssetCertificate& c) { c.kind = kind; }, {});
    });
    for (const AssetCertificateText& text : asset_certificate_texts()) add_field(text, fields_);
    return fields_;
}

void FigureSourcesForm::add_field(const AssetCertificateText& text, QWidget* page) {
    FieldEditor* editor = make_editor(text, document_, entry_, page);
    editor->setObjectName(QLatin1String(text.key));
    QLabel* title = make_form_label(text.title, page);
    title->setToolTip(help_text(spec_of(text)));
    title->setBuddy(editor);
    static_cast<QFormLayout*>(page->layout())->addRow(title, editor);
    rows_.push_back({&text, editor});
    connect(editor, &FieldEditor::edited, this, [this, &text](const SetupValue& value) {
        const std::string* typed = std::get_if<std::string>(&value);
        change(
            tr("Change %1").arg(core_text(text.title)),
            [&](AssetCertificate& c) { c.*text.member = typed ? *typed : std::string(); },
            QStringLiteral("source:%1:%2:%3")
                .arg(to_qt(entry_.id), QLatin1String(text.key))
                .arg(list_->currentIndex()));
    });
}

const std::vector<AssetCertificate>* FigureSourcesForm::certificates() const {
    return find_certificates(document_.project(), entry_);
}

const AssetCertificate* FigureSourcesForm::shown() const {
    const auto* all = certificates();
    const int index = list_->currentIndex();
    return all && index >= 0 && static_cast<std::size_t>(index) < all->size()
               ? &(*all)[static_cast<std::size_t>(index)]
               : nullptr;
}

std::string FigureSourcesForm::list_path() const {
    return entry_path(document_.project(), entry_) + "/certificates";
}

void FigureSourcesForm::change(const QString& words, const std::function<void(AssetCertificate&)>& edit,
                               const QString& key) {
    document_.apply(
        words,
        [&, index = static_cast<std::size_t>(list_->currentIndex())](Project& project) {
            auto* all = find_certificates(project, entry_);
            if (all && index < all->size()) edit((*all)[index]);
        },
        key);
}

void FigureSourcesForm::add_certificate() {
    document_.apply(tr("Add a certificate"), [this](Project& project) {
        if (auto* all = find_certificates(project, entry_)) all->emplace_back();
    });
    list_->setCurrentIndex(list_->count() - 1);
    show_chosen();
    if (!rows_.empty()) rows_.front().editor->focus_part({});
}

void FigureSourcesForm::remove_certificate() {
    document_.apply(tr("Remove a certificate"), [this, index = list_->currentIndex()](Project& project) {
        auto* all = find_certificates(project, entry_);
        if (all && index >= 0 && static_cast<std::size_t>(index) < all->size())
            all->erase(all->begin() + index);
    });
}

/// The file stays where it is: the project keeps its name, and the digest by which it is known again.
void FigureSourcesForm::read_file() {
    const QString file = QFileDialog::getOpenFileName(this, tr("File of the Certificate"));
    if (file.isEmpty()) return;
    const auto bytes = covaria::read_file(to_path(file));
    if (!bytes) return verdict_->setText(to_qt(bytes.error().message));
    change(tr("Take the file of a certificate"),
           [&](AssetCertificate& c) {
               c.file = to_std(QFileInfo(file).fileName());
               c.digest = sha256_of(*bytes);
           },
           {});
}

void FigureSourcesForm::refresh() {
    const auto* all = certificates();
    const QSignalBlocker quiet(list_);
    const int before = list_->currentIndex();
    list_->clear();
    for (std::size_t i = 0; all && i < all->size(); ++i) list_->addItem(list_words((*all)[i], i + 1));
    list_->setCurrentIndex(std::clamp(before, list_->count() > 0 ? 0 : -1, list_->count() - 1));
    const AssetCertificate* now = shown();
    for (QWidget* part : std::initializer_list<QWidget*>{list_, fields_}) part->setVisible(now != nullptr);
    for (QToolButton* button : {remove_, file_, impact_}) button->setEnabled(now != nullptr);
    if (measured_) measured_->refresh();
    if (now) {
        kinds_->setCurrentIndex(place_of(now->kind));
        for (const Row& row : rows_) {
            const std::string& text = now->*row.text->member;
            row.editor->set_value(text.empty() ? SetupValue() : SetupValue(text));
        }
    }
}

void FigureSourcesForm::show_chosen() {
    refresh();
    refresh_verdict();
    refresh_problems();
}

void FigureSourcesForm::refresh_verdict() {
    const auto& made = document_.maker().made();
    if (!shown())
        verdict_->setText(entry_.owner == SetupOwner::asset
                              ? tr("These figures are assumed: no certificate states them.")
                              : tr("No certificate states the figures of this set-up."));
    else if (made)
        verdict_->setText(verdict_words(*made, list_path() + "/" + std::to_string(list_->currentIndex())));
}

void FigureSourcesForm::refresh_problems() {
    const std::string here = list_path() + "/" + std::to_string(std::max(0, list_->currentIndex())) + "/";
    for (const Row& row : rows_)
        row.editor->set_complaint(problems_at(document_.problems(), here + row.text->key));
    if (measured_) measured_->editor().set_complaint(problems_at(document_.problems(), measured_->path()));
}

bool FigureSourcesForm::focus_field(const std::string& path) {
    if (measured_ && path == measured_->path()) {
        measured_->editor().focus_part({});
        return true;
    }
    const std::string prefix = list_path() + "/";
    if (!path.starts_with(prefix)) return false;
    list_->setCurrentIndex(static_cast<int>(std::strtoul(path.c_str() + prefix.size(), nullptr, 10)));
    show_chosen();
    for (const Row& row : rows_)
        if (path.ends_with(std::string("/") + row.text->key)) row.editor->focus_part({});
    return true;
}

}  // namespace covaria::ui
