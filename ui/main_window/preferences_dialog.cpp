// The controls of the preferences.
#include "ui/main_window/preferences_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "core/text/numbers.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/unit_choices.h"
#include "ui/theme/languages.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int title_bar = 40;  // px, of the dialog on the screen

QFormLayout* add_group(QVBoxLayout& column, const QString& title, const QString& note) {
    auto* group = new QGroupBox(title);
    auto* form = new QFormLayout(group);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    if (!note.isEmpty()) {
        auto* words = new QLabel(note);
        words->setWordWrap(true);
        form->addRow(words);
    }
    column.addWidget(group);
    return form;
}

/// "system", "light" ... as they are stored, with their words.
void add_items(QComboBox& box, std::initializer_list<std::pair<QVariant, QString>> items) {
    for (const auto& [data, text] : items) box.addItem(text, data);
}

}  // namespace

PreferencesDialog::PreferencesDialog(PreferenceStore& preferences, QWidget* parent)
    : QDialog(parent), preferences_(preferences), area_(new QScrollArea) {
    setWindowTitle(tr("Preferences"));
    setObjectName(QStringLiteral("preferences"));
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    add_results(*add_group(*column, tr("Results in the window"),
                           tr("Where the project does not state them. Reports and files are the project's "
                              "alone.")));
    add_new_analyses(*add_group(*column, tr("New analyses"),
                                tr("Written into analyses that are added; others stay as they are.")));
    add_window(*add_group(*column, tr("Window"), {}));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults);
    column->addStretch(1);
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area_->setWidget(content);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(area_, 1);
    foot_ = new QHBoxLayout;
    foot_->setContentsMargins(column->contentsMargins());
    foot_->addWidget(buttons);
    whole->addLayout(foot_);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { preferences_.set({}); });
    buttons->button(QDialogButtonBox::RestoreDefaults)->setAutoDefault(false);
    connect(&preferences_, &PreferenceStore::changed, this, &PreferencesDialog::show_preferences);
    show_preferences();
    fit();
}

/// Makes the dialog as high as the notes need when broken into lines, and no higher than the screen.
void PreferencesDialog::fit() {
    const QLayout& content = *area_->widget()->layout();
    const QSize wanted = content.totalSizeHint();
    const int width = wanted.width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    const int height = std::max(wanted.height(), content.totalHeightForWidth(wanted.width())) +
                       foot_->sizeHint().height() + std::max(0, layout()->spacing());
    resize(width, std::min(height, screen()->availableSize().height() - title_bar));
}

void PreferencesDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &PreferencesDialog::fit, Qt::QueuedConnection);  // when all have it
}

QComboBox* PreferencesDialog::add_box(QFormLayout& form, const QString& title, const char* name,
                                      const QString& help) {
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(title);
    box->setToolTip(help);
    form.addRow(title, box);
    connect(box, &QComboBox::activated, this, &PreferencesDialog::take);
    return box;
}

QSpinBox* PreferencesDialog::add_number(QFormLayout& form, const QString& title, const char* name,
                                        const QString& help, std::pair<int, int> range) {
    auto* box = new QSpinBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(title);
    box->setToolTip(help);
    box->setKeyboardTracking(false);
    form.addRow(title, box);
    box->setRange(range.first, range.second);
    connect(box, &QSpinBox::valueChanged, this, &PreferencesDialog::take);
    return box;
}

void PreferencesDialog::add_results(QFormLayout& form) {
    units_ =
        new UnitChoices(form, tr("As the model gives them"), tr("Of tables and charts of results"), this);
    connect(units_, &UnitChoices::edited, this, &PreferencesDialog::take);
    digits_ = add_box(form, tr("Digits of U"), "digits",
                      tr("Significant digits of uncertainties; estimates are rounded to match"));
    for (int digits = fewest_digits; digits <= most_digits; ++digits)
        digits_->addItem(QString::number(digits), digits);
    numbers_ = add_box(form, tr("Numbers"), "numbers", tr("Of all tables, charts and fields of the window"));
    add_items(*numbers_, {{int(NumberForm::system), tr("As the language writes them")},
                          {int(NumberForm::point), tr("1234.5 (point)")},
                          {int(NumberForm::comma), tr("1234,5 (comma)")}});
}

void PreferencesDialog::add_new_analyses(QFormLayout& form) {
    factor_ = add_box(form, tr("Coverage factor"), "coverage_factor",
                      tr("Of U = k u, where a new analysis begins with a fixed one"));
    add_items(*factor_,
              {{0.0, tr("k from the degrees of freedom or the coverage interval")}, {2.0, tr("k = 2")}});
    trials_ = new QuantityEdit;  // digits in groups, as in the options of an analysis
    trials_->setObjectName(QStringLiteral("trials"));
    trials_->setAccessibleName(tr("Trials"));
    trials_->set_help(tr("Of Monte Carlo"));
    trials_->set_integer(true);
    trials_->set_optional(false);
    trials_->set_range(Range{.low = double(fewest_trials), .high = double(most_trials)});
    form.addRow(tr("Trials"), trials_);
    connect(trials_, &QuantityEdit::quantity_edited, this, &PreferencesDialog::take);
}

void PreferencesDialog::add_window(QFormLayout& form) {
    language_ = add_box(form, tr("Language"), "language", tr("Of the window, when Covaria starts again"));
    language_->addItem(tr("As the system"), QString());
    for (const Language& language : offered_languages()) language_->addItem(language.name, language.code);
    auto* when = new QLabel(language_->toolTip());
    when->setWordWrap(true);
    when->setEnabled(false);
    form.addRow(QString(), when);
    theme_ = add_box(form, tr("Colours"), "theme", tr("Of the window, its charts and the scene"));
    add_items(*theme_, {{QStringLiteral("system"), tr("As the system")},
                        {QStringLiteral("light"), tr("Light")},
                        {QStringLiteral("dark"), tr("Dark")}});
    family_ = add_box(form, tr("Font"), "font_family", tr("Of the whole window"));
    family_->addItem(tr("Covaria's own"), QString());
    for (const QString& family : QFontDatabase::families(QFontDatabase::Latin))
        if (!QFontDatabase::isPrivateFamily(family) && QFontDatabase::isSmoothlyScalable(family))
            family_->addItem(family, family);
    may_be_narrow(*family_);
    family_->setMaxVisibleItems(20);
    font_ = add_number(form, tr("Font size"), "font_points", tr("Of the whole window"),
                       {smallest_font - 1, largest_font});
    font_->setSpecialValueText(tr("as the system"));
    font_->setSuffix(tr(" pt"));
    autosave_ = add_number(form, tr("Recovery copy"), "autosave",
                           tr("How long an edit may stay without a copy that a crash leaves behind"),
                           {1, longest_autosave});
    autosave_->setPrefix(tr("at most "));
    autosave_->setSuffix(tr(" s after an edit"));
}

void PreferencesDialog::take() {
    Preferences wanted = preferences_.now();
    wanted.units = units_->units();
    wanted.digits = digits_->currentData().toInt();
    wanted.numbers = NumberForm(numbers_->currentData().toInt());
    const double k = factor_->currentData().toDouble();
    wanted.coverage_factor = k > 0.0 ? std::optional(k) : std::nullopt;
    wanted.trials = std::uint64_t(trials_->quantity()->value);
    wanted.language = language_->currentData().toString();
    wanted.theme = theme_->currentData().toString();
    wanted.font.family = family_->currentData().toString();
    wanted.font.points = font_->value() < smallest_font ? 0 : font_->value();
    wanted.autosave_seconds = autosave_->value();
    preferences_.set(wanted);
}

void PreferencesDialog::show_preferences() {
    const Preferences& now = preferences_.now();
    units_->set_units(now.units);
    digits_->setCurrentIndex(digits_->findData(now.digits));
    numbers_->setCurrentIndex(numbers_->findData(int(now.numbers)));
    factor_->setCurrentIndex(now.coverage_factor ? 1 : 0);
    language_->setCurrentIndex(language_->findData(now.language));
    theme_->setCurrentIndex(theme_->findData(now.theme));
    family_->setCurrentIndex(std::max(0, family_->findData(now.font.family)));
    trials_->setLocale(QLocale());
    trials_->set_quantity(Quantity{double(now.trials), Unit{}});
    const std::pair<QSpinBox*, int> numbers[] = {
        {font_, now.font.points > 0 ? now.font.points : smallest_font - 1},
        {autosave_, now.autosave_seconds}};
    for (const auto& [box, value] : numbers) {
        const QSignalBlocker quiet(box);
        box->setLocale(QLocale());
        box->setValue(value);
    }
}

}  // namespace covaria::ui
