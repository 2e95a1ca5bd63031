// How a locale of Qt writes numbers, in the words of the core.
#pragma once

#include <QLocale>

#include "core/text/numbers.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

inline NumberLocale number_locale(const QLocale& locale) {
    NumberLocale written;
    written.decimal = to_std(locale.decimalPoint());
    return written;
}

}  // namespace covaria::ui
