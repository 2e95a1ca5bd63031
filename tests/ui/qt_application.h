// The one QApplication of a test program, and waiting for what happens in the background.
#pragma once

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
