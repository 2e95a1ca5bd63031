// A user drags a target and an instrument in the scene, and takes instruments from the library.
#include <QMenu>
#include <QTextBrowser>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/pages/library_menu.h"
#include "ui/scene_view/scene_view.h"

namespace covaria::ui::drag_session_test {
namespace {

class DragSession : public Session {
protected:
    SceneView& view() { return window_->scene().view(); }
    const Project& project() const { return window_->document().project(); }

    void open_network() {
        open(project_copy(QStringLiteral("lsm-network")));
        select(SetupOwner::analysis, "recommended");
        ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
        view().set_view(StandardView::top);
        scene_picture();
    }
    /// Where an item of the scene is in the view, after selecting it.
    QPoint pick(const char* id) {
        const SceneItem* item = find_item(*view().scene(), id);
        if (!item) {
            ADD_FAILURE() << "no " << id << " in the scene";
            return {};
        }
        Pixel at;
        const double ratio = view().devicePixelRatioF();
        view().service().post([&](SceneRenderer& renderer) { at = renderer.project(item->position); });
        view().service().wait_until_idle();
        view().select(QString::fromLatin1(id));
        return QPointF(at.x / ratio, at.y / ratio).toPoint();
    }
    void drag(QPoint from, QPoint by, int steps = 5) {
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        for (int i = 1; i <= steps; ++i) {
            const QPoint to = from + i * by / steps;
            QMouseEvent move(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&view(), &move);
        }
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + by);
    }
    std::array<double, 3> target(std::size_t row) const {
        const auto& table =
            std::get<SetupTable>(project().find_analysis("recommended")->setup.values.at("targets"));
        std::array<double, 3> p{};
        for (std::size_t c = 0; c < 3; ++c) p[c] = std::get<double>(table.rows[row][c + 1]);
        return p;
    }
    std::array<double, 3> station(const char* id) const {
        return std::get<PoseValue>(project().find_asset(id)->setup.values.at("station")).position;
    }
};

TEST_F(DragSession, ATargetFollowsThePointerAndItsEllipsoidToo) {
    open_network();
    const auto before = target(1);
    const double u = expanded_uncertainty(3);
    const int steps = window_->document().undo_stack().count();
    drag(pick("point:B"), {90, -40});
    const auto after = target(1);
    EXPECT_GT(after[0], before[0] + 1.0) << "to the right is +x in a view from above";
    EXPECT_GT(after[1], before[1] + 1.0);
    EXPECT_EQ(after[2], before[2]) << "seen from above the height stays";
    EXPECT_EQ(window_->document().undo_stack().count(), steps + 1) << "one drag is one step";
    EXPECT_TRUE(wait_for([&] { return status().is_current() && expanded_uncertainty(3) != u; }))
        << "the uncertainty follows";
    ASSERT_TRUE(wait_for([&] {
        const SceneItem* item = view().scene() ? find_item(*view().scene(), "point:B") : nullptr;
        return item && std::abs(1e3 * item->position.x() - after[0]) < 1e-6;
    })) << "the scene shows the new place";
    window_->document().undo_stack().undo();
    EXPECT_EQ(target(1), before);
}

TEST_F(DragSession, AnInstrumentIsMovedInItsOwnSetUp) {
    open_network();
    const auto before = station("camera-2");
    const QPoint at = pick("body:C2");
    drag(at, {0, 60});
    const auto after = station("camera-2");
    EXPECT_NEAR(after[0], before[0], 1.0);
    EXPECT_LT(after[1], before[1] - 1.0);
    EXPECT_EQ(after[2], before[2]);
}

TEST_F(DragSession, TheEvaluationIsATabOfModelsThatHaveOne) {
    open_network();
    QTabWidget& tabs = window_->results().tabs();
    int evaluation = 0;
    while (tabs.tabText(evaluation) != QStringLiteral("Evaluation")) ++evaluation;
    ASSERT_TRUE(wait_for([&] { return tabs.isTabVisible(evaluation); }));
    const auto* text = tabs.widget(evaluation)->findChild<QTextBrowser*>();
    ASSERT_NE(text, nullptr);
    EXPECT_TRUE(text->toPlainText().contains(QStringLiteral("readings alone (Eq 5)")));
    open(project_copy());
    EXPECT_TRUE(wait_for([&] { return !tabs.isTabVisible(evaluation); })) << "a pose has no such tables";
}

TEST_F(DragSession, WhatIsNotSelectedIsNotMoved) {
    open_network();
    const QPoint at = pick("point:B");
    view().select({});
    const Project before = project();
    drag(at, {90, -40});
    EXPECT_TRUE(project() == before) << "the drag turned the scene";
}

TEST_F(DragSession, AnInstrumentComesFromTheLibrary) {
    open_network();
    const std::size_t assets = project().assets.size();
    LibraryMenu menu(window_->document(), window_->selection(), window_.get());
    emit menu.aboutToShow();
    QAction* found = nullptr;
    for (QMenu* collection : menu.findChildren<QMenu*>())
        for (QAction* action : collection->actions())
            if (action->text() == QStringLiteral("Leica AT500")) found = action;
    ASSERT_NE(found, nullptr);
    EXPECT_TRUE(found->toolTip().contains(QStringLiteral("ISO 10360-10")));
    found->trigger();
    ASSERT_EQ(project().assets.size(), assets + 1);
    EXPECT_EQ(project().assets.back().name, "Leica AT500");
    EXPECT_EQ(window_->selection().entry().id, project().assets.back().id);
    EXPECT_FALSE(project().assets.back().notes.empty());
    found->trigger();
    EXPECT_EQ(project().assets.back().name, "Leica AT500 (2)");
    window_->document().undo_stack().undo();
    window_->document().undo_stack().undo();
    EXPECT_EQ(project().assets.size(), assets);
}

}  // namespace
}  // namespace covaria::ui::drag_session_test
