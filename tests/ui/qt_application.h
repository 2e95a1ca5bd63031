// The one QApplication of a test program, and waiting for what happens in the background.
#pragma once

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <ostream>

/// Failures show the text, not its bytes.
inline void PrintTo(const QString& text, std::ostream* out) {
    *out << '"' << text.toStdString() << '"';
}
