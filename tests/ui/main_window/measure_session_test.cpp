// A user measures in the scene: a distance and an angle with their u, and what has none.
#include <QLabel>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/pages/unit_button.h"

namespace covaria::ui::measure_session_test {
namespace {

class MeasureSession : public Session {
protected:
    SceneView& view() { return window_->scene().view(); }
    void open_current(const QString& example, const char* analysis) {
        open(project_copy(example));
        select(SetupOwner::analysis, analysis);
        ASSERT_TRUE(wait_for([this] { return status().result != nullptr && status().is_current(); }));
        ASSERT_FALSE(scene_picture().isNull());
    }
    void open_network() { open_current(QStringLiteral("lsm-network"), "recommended"); }
    void open_platform() { open_current(QStringLiteral("stewart-platform"), "printed"); }
    QPoint place_of(const char* id) {
        const SceneItem* item = find_item(*view().scene(), id);
        if (!item) {
            ADD_FAILURE() << "no " << id;
            return {};
        }
        Pixel at;
        view().service().post([&](SceneRenderer& renderer) { at = renderer.project(item->position); });
        view().service().wait_until_idle();
        QCoreApplication::processEvents();
        const double ratio = view().devicePixelRatioF();
        return QPointF(at.x / ratio, at.y / ratio).toPoint();
    }
    void click(const char* id) { QTest::mouseClick(&view(), Qt::LeftButton, {}, place_of(id)); }
    QAction* tool(const QString& words) {
        for (QAction* found : window_->scene().findChildren<QAction*>())
            if (found->text() == words) return found;
        ADD_FAILURE() << words.toStdString();
        return nullptr;
    }
    QString words() { return window_->scene().measuring().words(); }
    QString shown_words() {
        QStringList all;
        for (const QLabel* label : window_->scene().findChildren<QLabel*>())
            if (label->isVisible()) all << label->text();
        return all.join(QLatin1Char('\n'));
    }
    MeasureMark drawn() {
        MeasureMark mark;
        view().service().post([&](SceneRenderer& renderer) { mark = renderer.measure(); });
        view().service().wait_until_idle();
        return mark;
    }
};

TEST_F(MeasureSession, ADistanceHasTheJointUncertainty) {
    open_network();
    tool(QStringLiteral("Measure Distance"))->trigger();
    EXPECT_TRUE(words().contains(QStringLiteral("first point")));
    const QString field = window_->selection().field();
    click("point:A");
    EXPECT_TRUE(words().contains(QStringLiteral("second point"))) << words().toStdString();
    click("point:B");
    const auto& result = *status().result;
    const auto made = measure(*view().scene(), &result, {"point:A", "point:B"});
    ASSERT_TRUE(made && made->u);
    EXPECT_EQ(drawn().text,
              to_std(measured_value(*made, window_->scene().measuring().style(), view().scene()->unit)));
    EXPECT_TRUE(to_qt(drawn().text).contains(QStringLiteral("mm, u = "))) << drawn().text;
    EXPECT_TRUE(shown_words().contains(to_qt(drawn().text))) << shown_words().toStdString();
    EXPECT_EQ(window_->selection().field(), field) << "the forms stay where they were";
    const std::string before = drawn().text;
    window_->results().units().choose(Unit::of("m"));
    EXPECT_TRUE(wait_for([&] { return drawn().text != before; }, 5'000));
    EXPECT_TRUE(to_qt(drawn().text).contains(QStringLiteral("\u00a0m, u = "))) << drawn().text;
}

TEST_F(MeasureSession, AnAngleAndTheKeyboard) {
    open_network();
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_A);
    ASSERT_TRUE(window_->scene().measuring().is_active());
    go_to_cell("targets", 0, 1);  // a row of the table picks its point as well
    EXPECT_TRUE(words().contains(QStringLiteral("apex"))) << words().toStdString();
    go_to_cell("targets", 1, 1);
    click("point:C");
    EXPECT_EQ(drawn().at.size(), 3u);
    EXPECT_TRUE(to_qt(drawn().text).contains(QStringLiteral("°, u = "))) << drawn().text;
    EXPECT_TRUE(words().startsWith(QStringLiteral("Angle at <b>B</b>"))) << words().toStdString();
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_FALSE(window_->scene().measuring().is_active());
    EXPECT_TRUE(drawn().at.empty());
}

TEST_F(MeasureSession, WhatHasNoUncertaintySaysWhy) {
    open_platform();
    tool(QStringLiteral("Measure Distance"))->trigger();
    click("point:b1");
    click(view().scene()->frames.front().item.id.c_str());
    EXPECT_TRUE(words().contains(QStringLiteral("u not stated, because the coordinates of ")))
        << words().toStdString();
    EXPECT_FALSE(to_qt(drawn().text).contains(QStringLiteral("u =")));
}

TEST_F(MeasureSession, TheMeasurementFollowsTheResults) {
    open_platform();
    tool(QStringLiteral("Measure Distance"))->trigger();
    click("point:b1");
    click("point:b2");
    const std::string before = drawn().text;
    ASSERT_TRUE(to_qt(before).contains(QStringLiteral("u = "))) << words().toStdString();
    type_into("base_u_x", QStringLiteral("1.5 mm"));
    EXPECT_TRUE(wait_for([&] { return drawn().text != before; }, 10'000)) << drawn().text;
}

TEST_F(MeasureSession, ThePictureShowsIt) {
    open_network();
    tool(QStringLiteral("Measure Angle"))->trigger();
    click("point:A");
    click("point:B");
    const QImage two = scene_picture();
    click("point:C");
    QImage three;
    ASSERT_TRUE(wait_for([&] { return (three = scene_picture()) != two; }, 5'000));
    three.save(QStringLiteral(COVARIA_BINARY_DIR "/test-output/measure-angle.png"));
}

}  // namespace
}  // namespace covaria::ui::measure_session_test
