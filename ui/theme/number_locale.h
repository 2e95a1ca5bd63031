// The way in which a locale of Qt writes numbers, in the words of the core.
#pragma once

#include <QLocale>
#include <utility>

#include "core/text/numbers.h"
#include "ui/theme/preferences.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

inline NumberLocale number_locale(const QLocale& locale) {
    NumberLocale written;
    written.decimal = to_std(locale.decimalPoint());
    return written;
}

/// The way in which the user's locale writes numbers.
inline NumberLocale user_numbers() {
    return number_locale(QLocale());
}

/// The locale of a form of numbers. Dates stay as the system has them.
inline QLocale locale_of(NumberForm form) {
    static const QLocale of_system = QLocale();  // before any choice was applied
    if (form == NumberForm::system) return of_system;
    QLocale locale = form == NumberForm::point ? QLocale::c() : QLocale(QLocale::German, QLocale::Germany);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

/// Applies the form to every number that the window shows or reads from now on.
inline void apply_number_form(NumberForm form) {
    static NumberForm applied = NumberForm::system;
    if (form != std::exchange(applied, form) || form != NumberForm::system)
        QLocale::setDefault(locale_of(form));
}

}  // namespace covaria::ui
