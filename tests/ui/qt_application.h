// The one QApplication of a test program, and waiting for what happens in the background.
#pragma once

#include <QApplication>
#include <QSignalSpy>
#include <QTest>

namespace covaria::ui {

/// Call it first in every test that uses widgets, timers or threads.
inline QApplication& test_application() {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "covaria-test";
    static char* arguments[] = {name, nullptr};
    static QApplication application(count, arguments);
    QLocale::setDefault(QLocale::c());
    return application;
}

}  // namespace covaria::ui
