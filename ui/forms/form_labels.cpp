#include "ui/forms/form_labels.h"

#include <QAbstractItemView>
#include <QTimer>
#include <algorithm>

#include "core/text/symbol.h"
#include "ui/theme/core_text.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int narrowest_list = 10;  // letters
constexpr int widest_field = 240;   // px: the room of the narrowest inspector, whatever the font
constexpr int widest_label = 12;    // digits, 96 px at the usual size: longer titles take a second line

QString label_of(const std::string& title) {
    const Text text = title_text(core_words(title));
    return to_qt(text.has_scripts() ? to_html(text) : to_unicode(text));
}

/// The line or the list that is all that there is in the field; null: there is more, or something else.
QWidget* only_editor(QWidget& field) {
    QList<QWidget*> all = field.findChildren<QWidget*>(Qt::FindChildrenRecursively);
    all.prepend(&field);
    QWidget* only = nullptr;
    for (QWidget* each : all) {
        const bool is_part = qobject_cast<QComboBox*>(each->parentWidget()) != nullptr;
        if (is_part || (!qobject_cast<QComboBox*>(each) && !qobject_cast<QLineEdit*>(each))) continue;
        if (only) return nullptr;
        only = each;
    }
    return only;
}

/// Of what it shows, as far as an inspector has it.
int wanted_width(const QWidget& editor) {
    const QFontMetrics metrics = editor.fontMetrics();
    int text = 0, beside = 0;
    if (const auto* box = qobject_cast<const QComboBox*>(&editor)) {
        for (int i = 0; i < box->count(); ++i)
            text = std::max(text, metrics.horizontalAdvance(box->itemText(i)));
        beside = box->minimumSizeHint().width() -
                 box->minimumContentsLength() * metrics.horizontalAdvance(QLatin1Char('X'));
    } else if (const auto* line = qobject_cast<const QLineEdit*>(&editor)) {
        text = metrics.horizontalAdvance(line->text().isEmpty() ? line->placeholderText() : line->text());
        beside = 2 * metrics.horizontalAdvance(QLatin1Char('0'));
    }
    return std::min(text + beside, widest_field);
}

/// At least as wide as what it shows. A line that is being typed into stays where it is.
void keep_contents(QWidget& editor) {
    const auto fit = [&editor, least = editor.minimumWidth()] {
        if (!editor.hasFocus()) editor.setMinimumWidth(std::max(least, wanted_width(editor)));
    };
    fit();
    if (auto* line = qobject_cast<QLineEdit*>(&editor))
        QObject::connect(line, &QLineEdit::textChanged, line, fit);
}

}  // namespace

QLabel* make_form_label(const std::string& title, QWidget* parent) {
    auto* label = new QLabel(label_of(title), parent);
    wrap_label(*label);
    return label;
}

void wrap_label(QLabel& label) {
    const int most = widest_label * label.fontMetrics().horizontalAdvance(QLatin1Char('0'));
    if (!label.wordWrap() && label.sizeHint().width() <= most) return label.setFixedWidth(most);
    label.setWordWrap(true);
    const int width = std::max(most, label.minimumSizeHint().width());
    label.setFixedWidth(width);
    label.setMinimumHeight(label.heightForWidth(width));  // a form gives a row the height of its field
}

void wrap_labels(const QWidget& page) {
    for (const QFormLayout* form : page.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            if (auto* label = qobject_cast<QLabel*>(item ? item->widget() : nullptr)) wrap_label(*label);
        }
}

void put_long_fields_below(const QWidget& page) {
    for (const QFormLayout* form : page.findChildren<QFormLayout*>())
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::FieldRole);
            QWidget* field = item ? item->widget() : nullptr;
            if (QWidget* only = field ? only_editor(*field) : nullptr) keep_contents(*only);
        }
}

QString as_label(const QString& words) {
    return words.isEmpty() ? words : words.front().toUpper() + words.mid(1);
}

void may_be_narrow(QComboBox& box) {
    box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box.setMinimumContentsLength(narrowest_list);
    box.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto widen = [&box] { box.view()->setMinimumWidth(box.view()->sizeHintForColumn(0) + 8); };
    // The timer measures once for all entries that are added together: each time all are measured.
    auto* when_added = new QTimer(&box);
    when_added->setSingleShot(true);
    QObject::connect(when_added, &QTimer::timeout, &box, widen);
    const auto later = [when_added] {
        if (!when_added->isActive()) when_added->start(0);
    };
    const QAbstractItemModel* entries = box.model();
    QObject::connect(entries, &QAbstractItemModel::rowsInserted, &box, later);
    QObject::connect(entries, &QAbstractItemModel::dataChanged, &box, later);
    widen();
}

void narrow_if_need_be(QComboBox& box) {
    constexpr int few_letters = 4;
    may_be_narrow(box);
    box.setMinimumContentsLength(few_letters);
    box.setMinimumWidth(box.minimumSizeHint().width());  // before what is longer counts
    box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void keep_letters(QLineEdit& edit, int letters) {
    follow_font(edit, [&edit, letters] {
        edit.setMinimumWidth(letters * edit.fontMetrics().horizontalAdvance(QLatin1Char('0')) + 12);
    });
}

void keep_whole_text(QLineEdit& edit, int letters) {
    constexpr int frame = 16;  // the frame, and room for the cursor
    const auto widen = [&edit, letters] {
        const QFontMetrics metrics = edit.fontMetrics();
        edit.setMinimumWidth(std::max(letters * metrics.horizontalAdvance(QLatin1Char('0')),
                                      metrics.horizontalAdvance(edit.text())) +
                             frame);
    };
    follow_font(edit, widen);
    QObject::connect(&edit, &QLineEdit::textChanged, &edit, widen);
}

void keep_placeholder(QLineEdit& edit) {
    follow_font(edit, [&edit] {
        const int beside =
            4 * edit.fontMetrics().horizontalAdvance(QLatin1Char('0'));  // a button that clears
        edit.setMinimumWidth(edit.fontMetrics().horizontalAdvance(edit.placeholderText()) + beside);
    });
}

void align_labels(QFormLayout& form, int width) {
    for (int row = 0; row < form.rowCount(); ++row)
        if (const QLayoutItem* item = form.itemAt(row, QFormLayout::LabelRole); item && item->widget())
            item->widget()->setMinimumWidth(width);
}

int component_label_width(const QWidget& widget) {
    return widget.fontMetrics().horizontalAdvance(tr("Degrees of freedom")) + 6;
}

}  // namespace covaria::ui
