// Text between the core (UTF-8 std::string, std::filesystem::path) and Qt.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <filesystem>
#include <string>

#include "core/base/message.h"

namespace covaria::ui {

inline QString to_qt(const std::string& text) {
    return QString::fromStdString(text);
}
inline QString to_qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}
/// The message in the language of the window.
QString to_qt(const Message& message);
inline std::string to_std(const QString& text) {
    return text.toStdString();
}
inline std::filesystem::path to_path(const QString& file) {
    return std::filesystem::path(file.toStdString());
}
inline QString from_path(const std::filesystem::path& file) {
    return QString::fromStdString(file.string());
}

/// Translates texts of functions that belong to no class; classes have a `tr` of their own. The context is
/// that of the catalogues.
inline QString tr(const char* text) {
    return QCoreApplication::translate("covaria::ui", text);
}

}  // namespace covaria::ui
