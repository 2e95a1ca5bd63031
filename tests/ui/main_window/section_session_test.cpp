// A user cuts the scene open: with the button, the slider, a typed position, the wheel and keys.
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/scene_view/section_tool.h"
#include "viz/scene/pick.h"

namespace covaria::ui::section_session_test {
namespace {

class SectionSession : public Session {
protected:
    void SetUp() override {
        open(project_copy());
        ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
        ASSERT_FALSE(scene_picture().isNull());
    }
    SceneView& view() { return window_->scene().view(); }
    const std::optional<SectionPlane>& section() { return window_->scene().section().section(); }
    QWidget& bar() { return *window_->scene().section().bar(); }
    template <class Widget>
    Widget& in_bar(const QString& name) {
        for (auto* each : bar().findChildren<Widget*>())
            if (each->accessibleName() == name) return *each;
        ADD_FAILURE() << "no " << name.toStdString();
        static Widget none;
        return none;
    }
    QLineEdit& position() { return in_bar<QLineEdit>(QStringLiteral("Position of the section")); }
    void choose(const QString& words) {
        for (QToolButton* button : window_->scene().findChildren<QToolButton*>()) {
            if (!button->menu() || button->accessibleName() != QStringLiteral("Section")) continue;
            for (QAction* each : button->menu()->actions())
                if (each->text() == words) return each->trigger();
        }
        ADD_FAILURE() << "no entry " << words.toStdString();
    }
    void turn_wheel(int notches, Qt::KeyboardModifiers keys) {
        const QPoint at = view().rect().center();
        QWheelEvent event(at, view().mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view(), &event);
    }
    QPoint place_of(const char* id) {
        Pixel at;
        view().service().post([&, p = find_item(*view().scene(), id)->position](SceneRenderer& renderer) {
            at = renderer.project(p);
        });
        view().service().wait_until_idle();
        QCoreApplication::processEvents();
        return (QPointF(at.x, at.y) / view().devicePixelRatioF()).toPoint();
    }
};

TEST_F(SectionSession, TheMouseCutsTheSceneOpenAndMakesItWhole) {
    const QImage whole = scene_picture();
    choose(QStringLiteral("Across z"));
    ASSERT_TRUE(section());
    EXPECT_EQ(section()->axis, 2);
    EXPECT_TRUE(section()->hides_high) << "one looks from above";
    EXPECT_TRUE(bar().isVisible());
    EXPECT_NE(scene_picture(), whole);
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/test-output"));
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/test-output/section-across-z.png"));
    QTest::mouseClick(&view(), Qt::LeftButton, {}, place_of("point:p1"));
    scene_picture();
    EXPECT_NE(view().selected(), QStringLiteral("point:p1")) << "it is cut away";
    QTest::mouseClick(&in_bar<QToolButton>(QStringLiteral("Flip Side")), Qt::LeftButton);
    EXPECT_FALSE(section()->hides_high);
    QTest::mouseClick(&view(), Qt::LeftButton, {}, place_of("point:p1"));
    scene_picture();
    EXPECT_EQ(view().selected(), QStringLiteral("point:p1"));
    const double before = section()->at;
    auto& slider = in_bar<QSlider>(QStringLiteral("Section"));
    slider.setValue(slider.value() + 7);
    EXPECT_GT(section()->at, before);
    const double slid = section()->at;
    turn_wheel(-2, Qt::ShiftModifier);
    EXPECT_LT(section()->at, slid);
    QTest::mouseClick(&in_bar<QToolButton>(QStringLiteral("Off")), Qt::LeftButton);
    EXPECT_FALSE(section());
    EXPECT_FALSE(bar().isVisible());
    turn_wheel(1, Qt::ShiftModifier);
    EXPECT_FALSE(section()) << "the wheel zooms again";
}

TEST_F(SectionSession, TheKeyboardDoesTheSame) {
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_S);
    ASSERT_TRUE(section());
    const SectionPlane begun = *section();
    QTest::keyClick(&view(), Qt::Key_S, Qt::ShiftModifier);
    EXPECT_NE(section()->hides_high, begun.hides_high);
    QTest::keyClick(&view(), Qt::Key_PageUp);
    const double page = section()->at - begun.at;
    EXPECT_GT(page, 0.0);
    QTest::keyClick(&view(), Qt::Key_PageDown, Qt::ShiftModifier);
    EXPECT_NEAR(section()->at - begun.at, 0.9 * page, 1e-9);
    position().setFocus();
    position().selectAll();
    type_keys(QStringLiteral("0.125 m"));
    QTest::keyClick(&position(), Qt::Key_Return);
    EXPECT_DOUBLE_EQ(section()->at, 0.125);
    EXPECT_EQ(position().text(), QStringLiteral("125 mm"));
    position().selectAll();
    type_keys(QStringLiteral("12 kg"));
    QTest::keyClick(&position(), Qt::Key_Return);
    EXPECT_DOUBLE_EQ(section()->at, 0.125);
    EXPECT_EQ(position().text(), QStringLiteral("125 mm")) << "no length: it is taken back";
    QTest::keyClick(&position(), Qt::Key_Escape);
    EXPECT_FALSE(section());
    EXPECT_TRUE(view().hasFocus());
    QTest::keyClick(&view(), Qt::Key_S);
    ASSERT_TRUE(section());
    QTest::keyClick(&view(), Qt::Key_D);
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_FALSE(window_->scene().measuring().is_active());
    EXPECT_TRUE(section()) << "Escape puts away the tool in use first";
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_FALSE(section());
}

TEST_F(SectionSession, NewResultsKeepItAndPicturesHaveIt) {
    choose(QStringLiteral("Across x"));
    ASSERT_TRUE(section());
    const SectionPlane begun = *section();
    type_into("base_u_z", QStringLiteral("0.2 mm"));
    ASSERT_FALSE(scene_picture().isNull());
    EXPECT_EQ(section(), begun);
    ASSERT_TRUE(view().scene()->section);
    EXPECT_EQ(*view().scene()->section, begun);
    const auto saved_picture = [this] {
        const QString file = folder_.filePath(QStringLiteral("scene.png"));
        bool done = false;
        const auto told = QObject::connect(&view(), &SceneView::picture_saved, &view(), [&] { done = true; });
        view().save_picture(file, view().image().size());
        EXPECT_TRUE(wait_for([&] { return done; }));
        QObject::disconnect(told);
        return QImage(file);
    };
    const QImage cut = saved_picture();
    choose(QStringLiteral("Off"));
    EXPECT_NE(saved_picture(), cut);
}

}  // namespace
}  // namespace covaria::ui::section_session_test
