// The scene and the charts: picking, what the toolbar changes, pictures and data that leave the window.
#include <QLabel>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/scene_view/view_actions.h"

namespace covaria::ui::scene_session_test {
namespace {

class SceneSession : public Session {
protected:
    void SetUp() override {
        open(project_copy());
        wait_until_idle();
        ASSERT_FALSE(scene_picture().isNull());
    }
    SceneView& view() { return window_->scene().view(); }
    const ScenePoint& point(const std::string& source) {
        for (const ScenePoint& point : view().scene()->points)
            if (point.item.source.path == source) return point;
        ADD_FAILURE() << "no point from " << source;
        return view().scene()->points.front();
    }
    QPoint place_of(const Eigen::Vector3d& p) {
        Pixel pixel;
        view().service().post([&](SceneRenderer& renderer) { pixel = renderer.project(p); });
        view().service().wait_until_idle();
        return QPointF(pixel.x / view().devicePixelRatioF(), pixel.y / view().devicePixelRatioF()).toPoint();
    }
    QComboBox& combo(const QString& accessible_name) {
        for (QComboBox* box : window_->scene().findChildren<QComboBox*>())
            if (box->accessibleName() == accessible_name) return *box;
        ADD_FAILURE() << accessible_name.toStdString();
        return *window_->scene().findChild<QComboBox*>();
    }
    /// The picture after `change`, which must differ from the one before.
    void expect_change(const char* what, const std::function<void()>& change) {
        const QImage before = scene_picture();
        change();
        QCoreApplication::processEvents();
        EXPECT_TRUE(wait_for([&] { return scene_picture() != before; }, 10'000)) << what;
    }
    QAction* scene_action(const QString& words) {
        for (QAction* found : window_->scene().findChildren<QAction*>())
            if (plain_words(found->text()) == words) return found;
        ADD_FAILURE() << words.toStdString();
        return nullptr;
    }
};

TEST_F(SceneSession, APickedPointSelectsItsRow) {
    const ScenePoint& b3 = point("/base_points/rows/2");
    select(SetupOwner::asset, window_->document().project().assets.front().id);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, place_of(b3.item.position));
    ASSERT_TRUE(wait_for([this] { return !window_->selection().field().isEmpty(); }, 5'000));
    EXPECT_EQ(window_->selection().field(), QStringLiteral("/base_points/rows/2"));
    EXPECT_EQ(window_->selection().entry().owner, SetupOwner::analysis)
        << "the form of the analysis is shown";
    EXPECT_EQ(sheet("base_points")->currentIndex().row(), 2);
    EXPECT_TRUE(view().hasFocus()) << "the arrow keys still turn the scene";
}

TEST_F(SceneSession, ASelectedRowMarksItsPoint) {
    expect_change("mark", [this] { go_to_cell("base_points", 1, 2); });
    EXPECT_EQ(view().selected(), to_qt(point("/base_points/rows/1").item.id));
    EXPECT_EQ(sheet("base_points")->currentIndex().column(), 2) << "the cell stays where it was";
    go_to_cell("poses", 4, 0);
    EXPECT_EQ(window_->scene().group(), QStringLiteral("pose 5"));
    ASSERT_FALSE(scene_picture().isNull());
    EXPECT_EQ(view().selected(), to_qt(point("/poses/rows/4").item.id));
    EXPECT_EQ(window_->selection().group(), QStringLiteral("pose 5")) << "selected everywhere";
}

TEST_F(SceneSession, ThePickedValuesFollowTheResults) {
    go_to_cell("poses", 0, 0);
    const auto words = [this] {
        QStringList all;
        for (const QLabel* label : window_->scene().findChildren<QLabel*>()) all << label->text();
        return all.join(QLatin1Char('\n'));
    };
    ASSERT_TRUE(wait_for([&] { return words().contains(QStringLiteral("U =")); }, 5'000))
        << words().toStdString();
    const QString before = words();
    type_into("base_u_z", QStringLiteral("1.05 mm"));
    EXPECT_TRUE(
        wait_for([&] { return words().contains(QStringLiteral("U =")) && words() != before; }, 10'000));
}

TEST_F(SceneSession, TheToolbarChangesThePicture) {
    window_->resize(1900, 1000);  // room for the legend
    expect_change("magnification", [this] {
        choose_in(combo(QStringLiteral("Magnification of the uncertainty")), QStringLiteral("× 500"));
    });
    expect_change("probability", [this] {
        QComboBox& box = combo(QStringLiteral("Coverage probability of the ellipsoids"));
        choose_in(box, box.itemText(box.count() - 1));
    });
    expect_change("group", [this] { choose_in(combo(QStringLiteral("Group")), QStringLiteral("pose 13")); });
    for (const char* name : {"Top", "Bottom", "Front", "Back", "Right", "Left"})
        expect_change(name, [&] {
            for (QAction* view : window_->views().menu().actions())
                if (view->text() == QString::fromLatin1(name)) view->trigger();
        });
    expect_change("Iso", [&] { scene_action(QStringLiteral("Iso"))->trigger(); });
    for (const char* layer : {"Frames", "Points", "Bodies", "Ellipsoids", "Clouds", "Histograms on the Walls",
                              "Labels", "Axes", "Legend"}) {
        const bool usual = scene_action(QString::fromLatin1(layer))->isChecked();
        for (const bool shown : {!usual, usual})
            expect_change(layer, [&] {
                scene_action(QString::fromLatin1(layer))->trigger();
                EXPECT_EQ(scene_action(QString::fromLatin1(layer))->isChecked(), shown);
            });
    }
}

TEST_F(SceneSession, MouseAndKeysMoveTheCamera) {
    view().setFocus();
    const QPoint middle = view().rect().center();
    expect_change("orbit by dragging", [&] {
        QTest::mousePress(&view(), Qt::LeftButton, {}, middle);
        QTest::mouseMove(&view(), middle + QPoint(20, 5));
        QTest::mouseMove(&view(), middle + QPoint(60, 15));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle + QPoint(60, 15));
    });
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Plus, Qt::Key_2, Qt::Key_1})
        expect_change("key", [&] { QTest::keyClick(&view(), key); });
}

TEST_F(SceneSession, TheSceneStaysInThePictureWhenThePaneShrinks) {
    const auto all_inside = [this] {
        bool inside = true;
        view().service().post([&](SceneRenderer& renderer) {
            for (const ScenePoint& shown : renderer.scene().points) {
                const Pixel at = renderer.project(shown.item.position);
                inside = inside && at.x > 0 && at.y > 0 && at.x < view().width() && at.y < view().height();
            }
        });
        view().service().wait_until_idle();
        return inside;
    };
    ASSERT_TRUE(all_inside());
    window_->resize(1280, 620);
    QCoreApplication::processEvents();
    EXPECT_TRUE(all_inside());
    expect_change("zoom", [this] { QTest::keyClick(&view(), Qt::Key_Plus); });
    for (int i = 0; i < 20; ++i) QTest::keyClick(&view(), Qt::Key_Plus);
    ASSERT_FALSE(all_inside());
    window_->resize(1280, 640);
    QCoreApplication::processEvents();
    EXPECT_FALSE(all_inside()) << "what the user zoomed to stays";
    QTest::keyClick(&view(), Qt::Key_F);
    EXPECT_TRUE(all_inside());
}

TEST_F(SceneSession, ThePictureIsCopiedAndSaved) {
    QGuiApplication::clipboard()->clear();
    choose_from_context_menu(view(), view().rect().center(), QStringLiteral("Copy Picture"));
    EXPECT_EQ(QGuiApplication::clipboard()->image().size(), view().image().size());
    const QString file = folder_.filePath(QStringLiteral("picture.png"));
    view().save_picture(file, QSize(1600, 1000));  // as "Save Picture" does with the name from Qt's dialog
    ASSERT_TRUE(wait_for([&] { return QImage(file).width() > view().image().width(); }));
}

TEST_F(SceneSession, ChartsAreSavedAsPictureAndData) {
    QTabWidget& tabs = window_->results().tabs();
    for (int i = 0; i < tabs.count(); ++i)
        if (tabs.tabText(i) == QStringLiteral("Charts")) tabs.setCurrentIndex(i);
    ChartView* chart = nullptr;
    ASSERT_TRUE(wait_for([&] {
        for (ChartView* one : tabs.currentWidget()->findChildren<ChartView*>())
            if (one->isVisible()) chart = one;
        return chart != nullptr;
    }));
    const std::pair<const char*, QByteArray> formats[] = {{"PNG", "\x89PNG"}, {"SVG", "<?xml"}, {"CSV", ""}};
    for (const auto& [format, head] : formats) {
        const QString file =
            folder_.filePath(QStringLiteral("chart.") + QString::fromLatin1(format).toLower());
        ASSERT_TRUE(chart->save(file)) << format;  // as "Save as ..." does with the name from Qt's dialog
        QFile saved(file);
        ASSERT_TRUE(saved.open(QIODevice::ReadOnly)) << format;
        const QByteArray bytes = saved.readAll();
        EXPECT_TRUE(bytes.startsWith(head)) << format;
        EXPECT_GT(bytes.size(), 500) << format;
    }
}

}  // namespace
}  // namespace covaria::ui::scene_session_test
