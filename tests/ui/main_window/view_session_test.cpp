// A user hides and isolates bodies, clicks the cube, switches the projection, and saves views.
#include "tests/ui/main_window/session_fixture.h"
#include "ui/scene_view/view_actions.h"
#include "viz/scene/pick.h"

namespace covaria::ui::view_session_test {
namespace {

class ViewSession : public Session {
protected:
    void SetUp() override {
        open(project_copy());
        ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
        ASSERT_FALSE(scene_picture().isNull());
    }
    SceneView& view() { return window_->scene().view(); }
    bool shows(const char* id) { return find_item(*view().scene(), id) != nullptr; }
    Camera camera() {
        Camera camera;
        view().service().post([&](SceneRenderer& renderer) { camera = renderer.camera(); });
        view().service().wait_until_idle();
        QCoreApplication::processEvents();
        return camera;
    }
    /// A place in the view where nothing lies before the body.
    QPoint place_of_body(const std::string& id) {
        const Camera from = camera();
        const PictureSize size{view().image().width(), view().image().height()};
        for (int y = 0; y < size.height; y += 4)
            for (int x = 0; x < size.width; x += 4)
                if (pick_item(
                        *view().scene(), from, size, {double(x), double(y)}, [](Layer) { return true; },
                        6.0 * view().devicePixelRatioF()) == id)
                    return (QPointF(x, y) / view().devicePixelRatioF()).toPoint();
        ADD_FAILURE() << id << " cannot be picked";
        return {};
    }
    void click_face(StandardView wanted) {
        camera();
        for (const CubeFace& face : view().cube())
            if (face.view == wanted) {
                const Pixel a = face.corners[0], b = face.corners[2];
                return QTest::mouseClick(&view(), Qt::LeftButton, {},
                                         QPointF((a.x + b.x) / 2, (a.y + b.y) / 2).toPoint());
            }
        ADD_FAILURE() << "the face is not seen";
    }
    /// Chooses an entry of the menu of views.
    void choose_view(const QString& words) {
        for (QAction* each : window_->views().menu().actions())
            if (plain_words(each->text()) == words) return each->trigger();
        ADD_FAILURE() << "no entry " << words.toStdString();
    }
    const std::vector<SavedView>& saved() const {
        return window_->document().project().analyses.front().views;
    }
};

TEST_F(ViewSession, BodiesAreHiddenAndShownAlone) {
    const char* platform = "body:moving platform";
    ASSERT_TRUE(shows(platform));
    choose_from_context_menu(view(), place_of_body(platform), QStringLiteral("Hide"));
    EXPECT_FALSE(shows(platform));
    EXPECT_TRUE(shows("body:base") && shows("point:p1"));
    choose_from_context_menu(view(), view().rect().center(), QStringLiteral("Show All"));
    EXPECT_TRUE(shows(platform));
    choose_from_context_menu(view(), place_of_body(platform), QStringLiteral("Show Only This"));
    EXPECT_TRUE(shows(platform));
    EXPECT_FALSE(shows("body:base"));
    const QImage alone = scene_picture();
    alone.save(QStringLiteral(COVARIA_BINARY_DIR "/test-output/platform-alone.png"));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_H, Qt::ShiftModifier);
    EXPECT_TRUE(shows("body:base"));
}

TEST_F(ViewSession, TheTreeHidesAndShowsWhatAnAssetHasInTheScene) {
    open(project_copy(QStringLiteral("lsm-network")));
    ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
    ASSERT_FALSE(scene_picture().isNull());
    ProjectPane& tree = window_->project_pane();
    const auto show_in_scene = [&tree](const QString& name) {
        const auto found = tree.model()->match(tree.model()->index(0, 0), Qt::DisplayRole, name, 1,
                                               Qt::MatchStartsWith | Qt::MatchRecursive);
        ASSERT_FALSE(found.isEmpty()) << name.toStdString();
        tree.scrollTo(found.first());
        choose_from_context_menu(*tree.viewport(), tree.visualRect(found.first()).center(),
                                 QStringLiteral("Show in the Scene"));
    };
    const AssetEntry* tracker = window_->document().project().find_asset("laser-tracker");
    ASSERT_NE(tracker, nullptr);
    const std::set<std::string> items = items_of_asset(*view().scene(), tracker->id);
    ASSERT_FALSE(items.empty());
    const auto shown = [&] {
        return std::ranges::count_if(items, [this](const std::string& id) { return shows(id.c_str()); });
    };
    const QString name = to_qt(tracker->name);
    show_in_scene(name);
    EXPECT_EQ(shown(), 0);
    EXPECT_EQ(view().shows_asset(to_qt(tracker->id)), false);
    show_in_scene(name);
    EXPECT_EQ(shown(), static_cast<long>(items.size()));
    EXPECT_EQ(view().shows_asset(QStringLiteral("gone")), std::nullopt);
}

TEST_F(ViewSession, KeysHideWhatIsSelected) {
    view().select(QStringLiteral("body:base"));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_I);
    EXPECT_TRUE(shows("body:base") && !shows("body:moving platform"));
    QTest::keyClick(&view(), Qt::Key_H);
    EXPECT_TRUE(!shows("body:base") && shows("body:moving platform"));
    type_into("base_u_z", QStringLiteral("0.2 mm"));
    ASSERT_FALSE(scene_picture().isNull());
    EXPECT_FALSE(shows("body:base")) << "hidden in the next results, too";
}

TEST_F(ViewSession, AFaceOfTheCubeTurnsTheScene) {
    const std::pair<StandardView, StandardView> clicks[] = {{StandardView::iso, StandardView::top},
                                                            {StandardView::iso, StandardView::front},
                                                            {StandardView::iso, StandardView::right}};
    for (const auto& [from, to] : clicks) {
        view().set_view(from);
        click_face(to);
        EXPECT_TRUE(camera().direction.isApprox(directions_of(to).direction));
    }
    QTest::mouseMove(&view(), view().rect().center());
    view().set_view(StandardView::iso);
    scene_picture();
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/test-output/view-cube.png"));
    EXPECT_EQ(window_->selection().field(), QString()) << "nothing was picked behind it";
}

TEST_F(ViewSession, KeysAndTheMenuHaveAllSevenViews) {
    view().setFocus();
    for (std::size_t i = 0; i < standard_view_count; ++i) {
        QTest::keyClick(&view(), Qt::Key(Qt::Key_1 + int(i)));
        const Eigen::Vector3d expected = directions_of(static_cast<StandardView>(i)).direction.normalized();
        EXPECT_TRUE(camera().direction.isApprox(expected)) << i;
    }
    choose_view(QStringLiteral("Back"));
    EXPECT_TRUE(camera().direction.isApprox(-Eigen::Vector3d::UnitY()));
}

TEST_F(ViewSession, TheProjectionIsSwitched) {
    EXPECT_FALSE(camera().perspective);
    const QImage before = scene_picture();
    choose_view(QStringLiteral("Orthographic"));
    EXPECT_TRUE(camera().perspective);
    const QImage perspective = scene_picture();
    EXPECT_NE(perspective, before);
    perspective.save(QStringLiteral(COVARIA_BINARY_DIR "/test-output/perspective.png"));
    choose_view(QStringLiteral("Orthographic"));
    EXPECT_FALSE(camera().perspective);
}

TEST_F(ViewSession, AFramedSceneIsFramedAgainWhenResultsLengthenItsLegend) {
    view().setFixedSize(700, 420);
    QCoreApplication::processEvents();
    auto without = std::make_shared<Scene>(*view().scene()), with = std::make_shared<Scene>(*without);
    without->legend.clear();
    with->legend.assign(8, LegendLine{LegendMark::ellipsoid, covaria::Role::output,
                                      "outputs: coverage ellipsoids, p = 95 %"});
    view().show_scene(without);
    view().fit();
    const Camera before = camera();
    view().show_scene(with);
    const Camera after = camera();
    EXPECT_NE(after, before) << "beside the legend";
    view().fit();
    EXPECT_EQ(camera(), after);
    QTest::keyClick(&view(), Qt::Key_Plus);
    const Camera nearer = camera();
    with = std::make_shared<Scene>(*with);
    with->legend.resize(9, with->legend.front());
    view().show_scene(with);
    EXPECT_EQ(camera(), nearer) << "the user has chosen this view";
}

TEST_F(ViewSession, AViewIsSavedUndoneAndShownAgain) {
    view().setFixedSize(540, 320);  // whatever room the panes beside it take
    QCoreApplication::processEvents();
    const auto result = status().result;
    const std::string before = fingerprint(window_->document().project());
    view().select(QStringLiteral("body:base"));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_H);
    QTest::keyClick(&view(), Qt::Key_Left);
    QTest::keyClick(&view(), Qt::Key_Plus);
    choose_view(QStringLiteral("Orthographic"));
    const Camera seen = camera();
    window_->views().ask_name = [](const QString&) { return QStringLiteral("from the door"); };
    choose_view(QStringLiteral("Save View"));
    ASSERT_EQ(saved().size(), 1U);
    EXPECT_EQ(saved()[0].hidden, std::vector<std::string>{"body:base"});
    EXPECT_EQ(fingerprint(window_->document().project()), before);
    QTest::keyClick(&view(), Qt::Key_2);
    QTest::keyClick(&view(), Qt::Key_H, Qt::ShiftModifier);
    choose_view(QStringLiteral("Orthographic"));
    EXPECT_TRUE(shows("body:base") && !camera().perspective);
    choose_view(QStringLiteral("from the door"));
    EXPECT_FALSE(shows("body:base"));
    EXPECT_TRUE(camera().direction.isApprox(seen.direction));
    EXPECT_DOUBLE_EQ(saved()[0].height, 2 * seen.half_height);
    EXPECT_NEAR(camera().half_height, seen.half_height, 1e-9) << "in a picture of the same form";
    EXPECT_TRUE(camera().perspective);
    EXPECT_TRUE(status().is_current());
    EXPECT_EQ(status().result, result) << "nothing is evaluated again";
    window_->document().undo_stack().undo();
    EXPECT_TRUE(saved().empty());
    window_->document().undo_stack().redo();
    ASSERT_EQ(saved().size(), 1U);
    for (QAction* each : window_->views().menu().actions())
        if (each->menu()) each->menu()->actions().front()->trigger();
    EXPECT_TRUE(saved().empty()) << "removed by the menu";
}

}  // namespace
}  // namespace covaria::ui::view_session_test
