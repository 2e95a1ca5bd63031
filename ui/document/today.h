// The date of today where the program runs.
#pragma once

#include <QDate>
#include <string>

namespace covaria::ui {

/// The local date by ISO 8601: "2026-11-28".
inline std::string today() {
    return QDate::currentDate().toString(Qt::ISODate).toStdString();
}

}  // namespace covaria::ui
