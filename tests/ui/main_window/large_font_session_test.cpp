// Forms fit into their pane with a large font: nothing of them is reached by scrolling sideways only.
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>

#include "tests/ui/main_window/session_fixture.h"

namespace covaria::ui::large_font_session_test {
namespace {

class LargeFontSession : public Session {
protected:
    /// The font is the application's: other tests have the usual one.
    void TearDown() override { choose_font(Preferences().font.points); }
    void choose_font(int points) {
        Preferences wanted = window_->preferences().now();
        wanted.font.points = points;
        window_->preferences().set(wanted);
    }
    /// The forms of the selected entry that scroll sideways.
    QStringList too_wide() {
        QStringList found;
        FoldGroups& groups = window_->properties().groups();
        for (int group = 0; group < groups.count(); ++group) {
            window_->properties().show_group(group);
            const auto areas = window_->properties().findChildren<QScrollArea*>();
            const auto scrolls = [](const QScrollArea* area) {
                return area->isVisible() && area->horizontalScrollBar()->maximum() > 0;
            };
            // A bar that appears makes the page narrower, and the form breaks its rows anew.
            (void)QTest::qWaitFor([&] { return std::none_of(areas.begin(), areas.end(), scrolls); }, 300);
            for (const QScrollArea* area : areas)
                if (scrolls(area))
                    found << QStringLiteral("%1: %2 px")
                                     .arg(groups.title(group))
                                     .arg(area->horizontalScrollBar()->maximum()) +
                                 widest(*area->widget(), area->viewport()->width());
        }
        return found;
    }
    /// The widgets that make a form wide.
    static QString widest(const QWidget& form, int room) {
        QString words;
        for (const QWidget* child : form.findChildren<QWidget*>())
            if (child->isVisible() && child->minimumSizeHint().width() > room / 2)
                words += QStringLiteral("\n    %1 %2 %3 %4")
                             .arg(QLatin1String(child->metaObject()->className()), child->objectName(),
                                  child->accessibleName())
                             .arg(child->minimumSizeHint().width());
        return words;
    }
    void expect_all_fit(const QString& folder) {
        const QDir projects(QStringLiteral(COVARIA_SOURCE_DIR "/") + folder);
        const QFileInfoList files = projects.entryInfoList({QStringLiteral("*.covaria")}, QDir::Files);
        ASSERT_GT(files.size(), 3);
        for (const QFileInfo& file : files) {
            open(file.absoluteFilePath());
            trigger(QStringLiteral("Reset Layout"));
            for (const AnalysisEntry& analysis : window_->document().project().analyses) {
                select(SetupOwner::analysis, analysis.id);
                const QStringList wide = too_wide();
                EXPECT_TRUE(wide.isEmpty()) << file.fileName().toStdString() << ", " << analysis.id << '\n'
                                            << wide.join(QLatin1Char('\n')).toStdString();
            }
            window_->runner().stop_all();
        }
    }
};

TEST_F(LargeFontSession, NoFormOfAnExampleScrollsSideways) {
    choose_font(18);
    expect_all_fit(QStringLiteral("projects"));
    expect_all_fit(QStringLiteral("projects/gum"));
    EXPECT_EQ(window_->width(), 1280);
}

TEST_F(LargeFontSession, ALongLabelTakesASecondLineBesideItsField) {
    open(project_copy());
    wait_until_idle();
    const auto* box = field<QComboBox>("base_fit");
    const auto label_is_over = [&] {
        for (const QLabel* label : window_->properties().findChildren<QLabel*>())
            if (label->buddy() && label->buddy()->isAncestorOf(box))
                return label->mapTo(window_.get(), QPoint(0, label->height())).y() <=
                       box->mapTo(window_.get(), QPoint()).y();
        return false;
    };
    EXPECT_FALSE(label_is_over());
    keep_picture(QStringLiteral("forms-usual-font"));
    choose_font(18);
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    box = field<QComboBox>("base_fit");
    for (const QLabel* label : window_->properties().findChildren<QLabel*>())
        if (label->buddy() && label->buddy()->isAncestorOf(box)) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << "no line of it is cut";
        }
    keep_picture(QStringLiteral("forms-18pt-set-up"));
    show_group(QStringLiteral("Options"));
    const auto* trials = field<QLineEdit>("trials");
    EXPECT_TRUE(wait_for(
        [&] { return trials->width() > trials->fontMetrics().horizontalAdvance(trials->text()) + 8; }, 5000))
        << "cut to " << trials->width();
    for (const char* tab : {"Inputs", "Options", "Studies", "Designs", "Requirements"}) {
        show_group(QLatin1String(tab));
        keep_picture(QStringLiteral("forms-18pt-%1").arg(QString::fromLatin1(tab).toLower()));
    }
}

TEST_F(LargeFontSession, NorWithTheUsualFont) {
    expect_all_fit(QStringLiteral("projects"));
    expect_all_fit(QStringLiteral("projects/gum"));
}

// The column of what is constant is in view too.
TEST_F(LargeFontSession, NorDoTheInputsWithTheUsualFont) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/ballbar-tcp.covaria"));
    select(SetupOwner::analysis, window_->document().project().analyses.front().id);
    show_group(QStringLiteral("Inputs"));
    const QTableView* table = nullptr;
    for (const auto* each : window_->properties().findChildren<QTableView*>())
        if (each->accessibleName() == QStringLiteral("Input quantities")) table = each;
    ASSERT_NE(table, nullptr);
    ASSERT_TRUE(wait_for([&] { return table->model()->rowCount() > 20; }));
    EXPECT_TRUE(wait_for([&] { return table->horizontalScrollBar()->maximum() == 0; }, 3000))
        << table->horizontalHeader()->length() << " px in " << table->viewport()->width();
    window_->runner().stop_all();
}

}  // namespace
}  // namespace covaria::ui::large_font_session_test
