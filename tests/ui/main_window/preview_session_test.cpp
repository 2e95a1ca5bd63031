// The report is read on the screen: sizes, the list of pages, "3 of 17", by wheel and keys.
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/pages/page_view.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/stage.h"

namespace covaria::ui::preview_session_test {
namespace {

class PreviewSession : public Session {
protected:
    void open_report() {
        open(project_copy(QStringLiteral("stewart-platform")));
        wait_until_idle();
        preview_ = window_->results().findChild<ReportPreview*>();
        window_->results().stage().show_view(preview_);
        ASSERT_TRUE(wait_for([this] { return preview_->page_count() > 5; }, 120'000));
        QApplication::setActiveWindow(window_.get());
        view().setFocus();
        ASSERT_TRUE(wait_for([this] { return view().hasFocus(); }));
    }
    PageView& view() const { return preview_->view(); }
    template <class Widget>
    Widget& control(const char* name) const {
        auto* found = preview_->findChild<Widget*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    QString zoom() const { return control<QComboBox>("report_zoom").currentText(); }
    void turn_wheel(int notches) {
        const QPointF at = view().viewport()->rect().center();
        QWheelEvent event(at, view().viewport()->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches),
                          Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(view().viewport(), &event);
    }
    QString state() const { return preview_->findChild<QLabel*>(QStringLiteral("report_state"))->text(); }
    ReportPreview* preview_ = nullptr;
};

TEST_F(PreviewSession, PagesAreFittedOrAsLargeAsAsked) {
    open_report();
    const auto width = [this] { return view().page_rect(view().current_page()).width(); };
    const int room = view().viewport()->width();
    EXPECT_EQ(zoom(), QStringLiteral("Fit Width"));
    EXPECT_LT(width(), room);
    EXPECT_GT(width(), room - 40);
    EXPECT_EQ(view().horizontalScrollBar()->maximum(), 0);
    choose_in(control<QComboBox>("report_zoom"), QStringLiteral("Fit Page"));
    EXPECT_LE(view().page_rect(view().current_page()).height(), view().viewport()->height());
    const QRect page = view().page_rect(view().current_page());
    EXPECT_TRUE(page.height() > view().viewport()->height() - 40 || page.width() > room - 40)
        << "as large as the page can be whole";
    keep_picture(QStringLiteral("preview-fit-page"));
    choose_in(control<QComboBox>("report_zoom"), QString::fromUtf8("400 %"));
    EXPECT_NEAR(width(), 4.0 * 210.0 / 25.4 * 96.0, 2.0);
    EXPECT_GT(view().horizontalScrollBar()->maximum(), 1000);
    keep_picture(QStringLiteral("preview-400"));
    QLineEdit& typed = *control<QComboBox>("report_zoom").lineEdit();
    typed.setFocus();
    typed.selectAll();
    QTest::keyClicks(&typed, QStringLiteral("130"));
    QTest::keyClick(&typed, Qt::Key_Return);
    EXPECT_NEAR(view().scale(), 1.3, 1e-9);
    EXPECT_EQ(zoom(), QString::fromUtf8("130 %"));
    typed.selectAll();
    QTest::keyClicks(&typed, QStringLiteral("large"));
    QTest::keyClick(&typed, Qt::Key_Return);
    EXPECT_EQ(zoom(), QString::fromUtf8("130 %")) << "what is no size changes nothing";
}

TEST_F(PreviewSession, WheelAndKeysGoThroughTheSizes) {
    open_report();
    choose_in(control<QComboBox>("report_zoom"), QString::fromUtf8("100 %"));
    view().go_to_page(3);
    const double before = view().page_rect(3).top() / double(view().page_rect(3).height());
    turn_wheel(1);
    EXPECT_EQ(zoom(), QString::fromUtf8("125 %"));
    turn_wheel(-2);
    EXPECT_EQ(zoom(), QString::fromUtf8("75 %"));
    EXPECT_EQ(view().current_page(), 3) << "the place stays";
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Plus);
    EXPECT_EQ(zoom(), QString::fromUtf8("100 %"));
    EXPECT_NEAR(view().page_rect(3).top() / double(view().page_rect(3).height()), before, 0.02);
    QTest::keyClick(&view(), Qt::Key_Minus);
    QTest::keyClick(&view(), Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_EQ(zoom(), QString::fromUtf8("50 %"));
    EXPECT_FALSE(control<QToolButton>("smaller_pages").isEnabled()) << "nothing smaller is offered";
    turn_wheel(-1);
    EXPECT_EQ(zoom(), QString::fromUtf8("50 %"));
    window_->properties().setFocus();
    QTest::keyClick(&window_->properties(), Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_EQ(zoom(), QString::fromUtf8("50 %")) << "the keys are those of the preview";
}

TEST_F(PreviewSession, PagesAreReachedByNumberListAndKeys) {
    open_report();
    auto& list = control<QListView>("report_page_list");
    auto& page = control<QSpinBox>("report_page");
    const int pages = int(preview_->page_count());
    ASSERT_EQ(list.model()->rowCount(), pages);
    EXPECT_EQ(page.text(), QStringLiteral("1 of %1").arg(pages));
    EXPECT_FALSE(control<QToolButton>("previous_page").isEnabled());
    EXPECT_TRUE(list.model()->index(1, 0).data().toString().startsWith(QStringLiteral("Page 2\n")))
        << "behind summary and contents the first section begins";
    int with_headings = 0;
    for (int row = 0; row < pages; ++row)
        with_headings += list.model()->index(row, 0).data().toString().contains(QLatin1Char('\n'));
    EXPECT_GT(with_headings, 3);
    EXPECT_LT(with_headings, pages) << "only where one begins";

    list.scrollTo(list.model()->index(4, 0));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualRect(list.model()->index(4, 0)).center());
    EXPECT_EQ(view().current_page(), 4);
    EXPECT_EQ(page.value(), 5);
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Down);
    EXPECT_EQ(page.value(), 6);
    EXPECT_EQ(list.currentIndex().row(), 5);
    keep_picture(QStringLiteral("preview"));

    page.setFocus();
    page.selectAll();
    QTest::keyClicks(&page, QStringLiteral("3"));
    QTest::keyClick(&page, Qt::Key_Return);
    EXPECT_EQ(list.currentIndex().row(), 2);
    QTest::mouseClick(&control<QToolButton>("next_page"), Qt::LeftButton);
    EXPECT_EQ(list.currentIndex().row(), 3);
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(page.value(), 3);
    QTest::keyClick(&view(), Qt::Key_End);
    EXPECT_EQ(list.currentIndex().row(), pages - 1) << "the list follows";
    EXPECT_FALSE(control<QToolButton>("next_page").isEnabled());
    QTest::keyClick(&view(), Qt::Key_Home);
    EXPECT_EQ(page.value(), 1);
}

TEST_F(PreviewSession, TabGoesThroughEverything) {
    open_report();
    QStringList left{
        QStringLiteral("document_kind"), QStringLiteral("report_page"),      QStringLiteral("next_page"),
        QStringLiteral("smaller_pages"), QStringLiteral("report_zoom"),      QStringLiteral("larger_pages"),
        QStringLiteral("update_report"), QStringLiteral("report_page_list"), QStringLiteral("report_pages")};
    control<QComboBox>("document_kind").setFocus();
    for (int i = 0; i < 20 && !left.isEmpty(); ++i) {
        left.removeAll(QApplication::focusWidget()->objectName());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    EXPECT_TRUE(left.isEmpty()) << left.join(QStringLiteral(", ")).toStdString();
}

// An edit makes it old; undone, and saved under another name, it is what it was made of.
TEST_F(PreviewSession, OnlyWhatIsOldIsCalledOutOfDate) {
    open_report();
    ASSERT_TRUE(wait_for([&] { return state().contains(QStringLiteral("as printed")); }, 60'000));
    ASSERT_TRUE(window_->document().save_as(folder_.filePath(QStringLiteral("other/again.covaria"))));
    wait_until_idle();
    EXPECT_TRUE(state().contains(QStringLiteral("as printed"))) << state().toStdString();
    window_->document().apply(QStringLiteral("a title"), [](Project& project) { project.title = "other"; });
    EXPECT_TRUE(state().contains(QStringLiteral("Out of date"))) << state().toStdString();
    window_->document().undo();
    EXPECT_TRUE(wait_for([&] { return state().contains(QStringLiteral("as printed")); }, 60'000))
        << state().toStdString();
}

TEST_F(PreviewSession, AnUpdateStaysWhereOneWas) {
    open_report();
    choose_in(control<QComboBox>("report_zoom"), QString::fromUtf8("75 %"));
    view().go_to_page(4);
    const qint64 before = preview_->pages().front().cacheKey();
    QTest::mouseClick(&control<QPushButton>("update_report"), Qt::LeftButton);
    ASSERT_TRUE(wait_for(
        [&] { return !preview_->is_busy() && preview_->pages().front().cacheKey() != before; }, 120'000));
    EXPECT_EQ(view().current_page(), 4);
    EXPECT_EQ(zoom(), QString::fromUtf8("75 %"));
    EXPECT_EQ(control<QSpinBox>("report_page").value(), 5);
}

}  // namespace
}  // namespace covaria::ui::preview_session_test
