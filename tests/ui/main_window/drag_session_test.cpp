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
    /// Selects an item of the scene; returns its place in the view.
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

/// A double click leads to the coordinates, or the keyboard alone.
TEST_F(DragSession, CoordinatesAreTyped) {
    open_network();
    QTest::mouseDClick(&view(), Qt::LeftButton, {}, pick("point:B"));
    auto* table = sheet("targets");
    ASSERT_TRUE(table->hasFocus() || table->isAncestorOf(QApplication::focusWidget()));
    EXPECT_EQ(table->currentIndex().row(), 1);
    EXPECT_EQ(table->currentIndex().column(), 1) << "x";
    const auto before = target(1);
    for (const char key : {'1', '2', '3', '4'}) QTest::keyClick(QApplication::focusWidget(), key);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return target(1)[0] == 1234.0; })) << target(1)[0];
    EXPECT_EQ(target(1)[1], before[1]);
    ASSERT_TRUE(wait_for([&] {
        const SceneItem* item = view().scene() ? find_item(*view().scene(), "point:B") : nullptr;
        return item && std::abs(item->position.x() - 1.234) < 1e-9;
    })) << "the scene shows it";
    view().setFocus();
    view().select(QStringLiteral("point:A"));
    QTest::keyClick(&view(), Qt::Key_Return);
    EXPECT_EQ(table->currentIndex().row(), 0);
    EXPECT_EQ(table->currentIndex().column(), 1);
}

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

/// The hand rests: results come, and the point stays under it, also when it is let go.
TEST_F(DragSession, APointStaysWhereTheHandRests) {
    open(project_copy());
    select(SetupOwner::analysis, "printed");
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    scene_picture();
    const auto moved = [this] {
        return std::get<SetupTable>(project().find_analysis("printed")->setup.values.at("base_points"))
            .rows[1];
    };
    const auto before = moved();
    const QPoint from = pick("point:b2");
    scene_picture();
    const int steps = window_->document().undo_stack().count();
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    const QPoint to = from + QPoint(35, 0);
    for (const QPoint at : {from + QPoint(20, 0), to}) {
        QTest::qWait(60);
        QMouseEvent move(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&view(), &move);
    }
    const auto rests = moved();
    EXPECT_NE(rests, before);
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    scene_picture();
    EXPECT_LT((pick("point:b2") - to).manhattanLength(), 4) << "the picture stands still";
    QTest::qWait(2500);  // longer than edits merge by themselves
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    EXPECT_EQ(moved(), rests);
    EXPECT_EQ(window_->document().undo_stack().count(), steps + 1);
}

/// He has turned it: nothing jumps while he drags, nor when results come after it.
TEST_F(DragSession, TheViewStaysAndTheMagnificationIsHeld) {
    open_network();
    QTest::keyClick(&view(), Qt::Key_Left);
    scene_picture();
    const auto camera = [this] { return view().saved("view"); };
    const auto seen = camera();
    std::vector<double> drawn;
    const QPoint from = pick("point:B");
    const double before = view().scene()->magnification;
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) {
        QTest::qWait(60);
        const QPoint to = from + i * QPoint(-16, -4);
        QMouseEvent move(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&view(), &move);
        ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
        scene_picture();
        if (!view().scene()->ellipsoids.empty()) drawn.push_back(view().scene()->magnification);
    }
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + QPoint(-80, -20));
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    scene_picture();
    EXPECT_FALSE(drawn.empty());
    EXPECT_TRUE(std::ranges::all_of(drawn, [&](double m) { return m == before; }))
        << testing::PrintToString(drawn);
    EXPECT_NE(view().scene()->magnification, before) << "of what it has become, when it is let go";
    EXPECT_TRUE(camera() == seen);
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

TEST_F(DragSession, NothingNeedsAClickFirstAndTheCursorSaysSo) {
    open_network();
    const QPoint at = pick("point:B");
    view().select({});
    QTest::mouseMove(&view(), at);
    EXPECT_EQ(view().cursor().shape(), Qt::SizeAllCursor);
    const auto before = target(1);
    drag(at, {90, -40});
    EXPECT_NE(target(1), before);
    EXPECT_EQ(view().selected(), QStringLiteral("point:B"));
    EXPECT_EQ(window_->selection().field(), QStringLiteral("/targets/rows/1")) << "its values can be typed";
    const Project after = project();
    const QPoint beside = at + QPoint(-60, 60);
    QTest::mouseMove(&view(), beside);
    EXPECT_EQ(view().cursor().shape(), Qt::ArrowCursor);
    drag(beside, {40, 10});
    EXPECT_TRUE(project() == after) << "beside the items a drag turns the scene";
}

TEST_F(DragSession, WithCtrlThePlacesAreRound) {
    open_network();
    const auto before = target(1);
    const QPoint at = pick("point:B");
    QTest::mousePress(&view(), Qt::LeftButton, Qt::ControlModifier, at);
    const QPoint to = at + QPoint(73, -31);
    QMouseEvent move(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     Qt::ControlModifier);
    QCoreApplication::sendEvent(&view(), &move);
    QTest::mouseRelease(&view(), Qt::LeftButton, Qt::ControlModifier, to);
    const auto after = target(1);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NE(after[std::size_t(i)], before[std::size_t(i)]);
        EXPECT_EQ(std::remainder(after[std::size_t(i)], 100.0), 0.0) << after[std::size_t(i)] << " mm";
    }
    EXPECT_EQ(after[2], before[2]);
}

TEST_F(DragSession, AnInstrumentIsTurnedByTheTipOfItsAxis) {
    open_network();
    const auto pose = [this] {
        return std::get<PoseValue>(project().find_asset("laser-tracker")->setup.values.at("station"));
    };
    const SceneFrame* axes = nullptr;
    for (const SceneFrame& frame : view().scene()->frames)
        if (frame.item.source.asset == "laser-tracker") axes = &frame;
    ASSERT_NE(axes, nullptr);
    const auto place = [this](const Eigen::Vector3d& p) {
        Pixel at;
        view().service().post([&](SceneRenderer& renderer) { at = renderer.project(p); });
        view().service().wait_until_idle();
        QCoreApplication::processEvents();
        return (QPointF(at.x, at.y) / view().devicePixelRatioF()).toPoint();
    };
    const Eigen::Vector3d origin = axes->item.position, up = axes->R_WF.col(2);
    for (int i = 0; i < 8; ++i) QTest::keyClick(&view(), Qt::Key_Plus);
    view().service().post([&](SceneRenderer& renderer) {
        Camera camera = renderer.camera();
        camera.focal_point = origin;
        renderer.set_camera(camera);
    });
    const QPoint tip = place(origin + axes->length * axes->R_WF.col(0));
    QTest::mouseMove(&view(), tip);
    EXPECT_EQ(view().cursor().shape(), Qt::OpenHandCursor);
    const PoseValue before = pose();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, axes->R_WF.col(2)).toRotationMatrix();
    const int steps = window_->document().undo_stack().count();
    drag(tip, place(origin + turn * axes->length * axes->R_WF.col(0)) - tip);
    const Eigen::Matrix3d turned = pose().si().linear() * before.si().linear().transpose();
    EXPECT_NEAR(Eigen::AngleAxisd(turned).angle(), 0.4, 0.05);
    EXPECT_GT(Eigen::AngleAxisd(turned).axis().dot(up), 0.99);
    EXPECT_EQ(pose().position, before.position);
    EXPECT_EQ(window_->document().undo_stack().count(), steps + 1) << "one drag is one step";
    window_->document().undo_stack().undo();
    EXPECT_EQ(pose(), before);
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
