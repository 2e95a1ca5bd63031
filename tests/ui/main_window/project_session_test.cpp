// The way from an empty project to a report: a new artefact, used in a new analysis.
#include <QProcess>
#include <QSignalSpy>

#include "core/kinds/registries.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"

namespace covaria::ui::project_session_test {
namespace {

class NewProject : public Session {
protected:
    void build_artefact() {
        trigger(QStringLiteral("New Project"));
        EXPECT_TRUE(names_in_tree().isEmpty());
        trigger(QString::fromStdString(find_asset_kind("artefact-points")->title));
        ASSERT_EQ(names_in_tree().size(), 1);
        paste("points", 0, 0,
              QStringLiteral("1\t0\t0\t0\r\n2\t430\t0\t0\r\n3\t0\t425\t0\r\n4\t430\t425\t0\r\n"));
        EXPECT_EQ(sheet("points")->model()->rowCount(), 4);
        choose("evaluation", QStringLiteral("components of uncertainty"));
        for (int i = 0; i < 3; ++i) press_button("components", QStringLiteral("Add row"));
        const char* rows[] = {"x\t0.005\t0.004\t0.03\t0.02\t30", "y\t0.005\t0.004\t0.04\t0.01\t30",
                              "z\t0.005\t0.004\t0.05\t-0.02\t30"};
        for (int row = 0; row < 3; ++row) paste("components", row, 0, QString::fromUtf8(rows[row]));
        EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    }
    void replace_rows(const char* table, const QString& text) {
        go_to_cell(table, 0, 0);
        press(table, QKeySequence::SelectAll);
        press_button(table, QStringLiteral("Delete rows"));
        paste(table, 0, 0, text);
    }
    void build_analysis() {
        const QString artefact = names_in_tree().front();
        trigger(QStringLiteral("Pose from points"));
        EXPECT_TRUE(names_in_tree().contains(artefact));
        const auto has_result = [&] { return status().result != nullptr; };
        EXPECT_TRUE(wait_for(has_result)) << "a new analysis is prefilled with what runs";
        replace_rows("base_points",
                     QStringLiteral("b1\t-300\t200\t0\r\nb2\t300\t200\t0\r\nb3\t0\t-400\t0\r\n"));
        replace_rows("moving_points",
                     QStringLiteral("p1\t-200\t-100\t0\r\np2\t200\t-100\t0\r\np3\t0\t230\t0\r\n"));
        replace_rows("poses",
                     QStringLiteral("home\t0\t0\t1175\t0\t0\t0\r\ntilted\t100\t-50\t1200\t5\t-5\t10\r\n"));
        const QString warning = problems().join(QLatin1Char('\n'));
        EXPECT_TRUE(warning.contains(QStringLiteral("shift of the origin"))) << warning.toStdString();
        choose("base_fit", QStringLiteral("least squares"));
        choose("moving_fit", QStringLiteral("least squares"));
        choose("base_uncertainty", QStringLiteral("artefact or instrument"));
        choose("base_asset", artefact);
        choose("moving_uncertainty", QStringLiteral("typed"));
        type_into("moving_u_x", QStringLiteral("50 um"));
        type_into("moving_u_y", QStringLiteral("0.05"));
        type_into("moving_u_z", QStringLiteral("0.08"));
        show_group(QStringLiteral("Options"));
        type_into("trials", QStringLiteral("20000"));
        EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    }
    QString text_of_pdf(const QString& file) const {
        QProcess process;
        process.start(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), file, QStringLiteral("-")});
        EXPECT_TRUE(process.waitForFinished(60'000)) << "pdftotext (poppler-utils) is needed";
        return QString::fromUtf8(process.readAllStandardOutput());
    }
};

TEST_F(NewProject, FromNothingToAPdf) {
    ASSERT_NO_FATAL_FAILURE(build_artefact());
    ASSERT_NO_FATAL_FAILURE(build_analysis());
    trigger(QStringLiteral("Run This Analysis"));
    wait_until_idle();
    ASSERT_EQ(status().state, RunState::up_to_date) << status().message.toStdString();
    ASSERT_EQ(status().result->trials, 20'000u);

    answer_.file_to_save = folder_.filePath(QStringLiteral("new.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Report as PDF"));
    ASSERT_TRUE(finished.wait(120'000));
    EXPECT_TRUE(answer_.messages.isEmpty()) << answer_.messages.join(QLatin1Char('\n')).toStdString();
    const QString text = text_of_pdf(answer_.file_to_save);
    const AssetEntry& artefact = window_->document().project().assets.front();
    for (const QString& words : {QString::fromStdString(artefact.name), QStringLiteral("home"),
                                 QStringLiteral("tilted"), QStringLiteral("1175.")})
        EXPECT_TRUE(text.contains(words)) << words.toStdString() << " is not in\n" << text.toStdString();

    answer_.file_to_save = folder_.filePath(QStringLiteral("new.covaria"));
    trigger(QStringLiteral("Save"));
    EXPECT_FALSE(window_->document().is_modified());
    const std::string saved = bytes();
    open(answer_.file_to_save);
    EXPECT_EQ(bytes(), saved);
}

}  // namespace
}  // namespace covaria::ui::project_session_test
