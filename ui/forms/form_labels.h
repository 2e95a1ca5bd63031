// Labels of forms: symbols typeset, long titles on several lines, all equally wide; lists that give way.
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <string>

namespace covaria::ui {

/// A title that is a symbol is set as one; a long one is broken into lines.
QLabel* make_form_label(const std::string& title, QWidget* parent);
/// Gives it the width of all labels of the inspector, or of a wider word; a longer text takes a second line.
void wrap_label(QLabel& label);
/// Wraps all labels beside fields on the page.
void wrap_labels(const QWidget& page);

/// A list or a line that shows more than has room beside its label stands below it.
void put_long_fields_below(const QWidget& page);

/// The words with a first letter as at the beginning of a sentence; they come in lower case.
QString as_label(const QString& words);

/// A list in a form is as narrow as the form must be; opened it shows its entries whole.
void may_be_narrow(QComboBox& box);
/// A list in a bar is as wide as its entries where there is room, and else narrower than in a form.
void narrow_if_need_be(QComboBox& box);

/// Keeps room for so many letters at least: a form that has less puts the field under its label.
void keep_letters(QLineEdit& edit, int letters = 12);
/// Keeps room for so many letters, and for the whole text: cut off, a number hides its sign or its size.
void keep_whole_text(QLineEdit& edit, int letters);
/// Keeps room for the text that it shows while it is empty.
void keep_placeholder(QLineEdit& edit);

/// Gives all labels of the form the same least width, so that forms under each other line up.
void align_labels(QFormLayout& form, int width);

/// The width that `align_labels` needs for the forms of a component of uncertainty.
int component_label_width(const QWidget& widget);

}  // namespace covaria::ui
