// Tabs in bars that are wide, narrow and too narrow.
#include "ui/theme/tabs.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QToolButton>

#include "tests/ui/qt_application.h"
#include "ui/theme/theme.h"

namespace covaria::ui::tabs_test {
namespace {

/// Titles of the properties of an analysis, in German.
const QStringList names{QStringLiteral("Aufbau"),      QStringLiteral("Eingaben"),
                        QStringLiteral("Optionen"),    QStringLiteral("Studien"),
                        QString::fromUtf8("Entwürfe"), QStringLiteral("Anforderungen"),
                        QStringLiteral("Notizen")};

class TabBarTest : public testing::Test {
protected:
    TabBarTest() {
        apply_theme(*qApp, Theme::light());
        for (const QString& name : names) bar_.addTab(name);
        bar_.show();
    }
    void make_wide(int width) {
        bar_.resize(width, bar_.sizeHint().height());
        for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    }
    int text_width() const {
        int all = 0;
        for (const QString& name : names) all += bar_.fontMetrics().horizontalAdvance(name);
        return all;
    }
    int count_in_menu() const {
        int found = 0;
        for (int i = 0; i < bar_.count(); ++i) found += int(bar_.is_in_menu(i));
        return found;
    }
    int last_pixel() const { return bar_.tabRect(bar_.count() - 1).right(); }
    TabBar bar_;
};

TEST_F(TabBarTest, NamesAreWholeWhereThereIsRoom) {
    make_wide(text_width() + 7 * 30);
    EXPECT_EQ(bar_.closer(), 0);
    make_wide(text_width() + 7 * 10);
    EXPECT_GT(bar_.closer(), 0);
    EXPECT_EQ(count_in_menu(), 0);
}

TEST_F(TabBarTest, WhatHasNoRoomIsInTheMenu) {
    make_wide(text_width() / 2);
    EXPECT_GT(count_in_menu(), 0);
    EXPECT_FALSE(bar_.is_in_menu(bar_.currentIndex()));
    make_wide(text_width() + 7 * 30);
    EXPECT_EQ(count_in_menu(), 0);
}

}  // namespace
}  // namespace covaria::ui::tabs_test
