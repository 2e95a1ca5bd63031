// Distributions, components, correlations, evaluation options, CSV import.
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>

#include "core/project/component_edit.h"
#include "tests/core/made.h"
#include "tests/ui/qt_application.h"
#include "tests/ui/sample_schema.h"
#include "ui/document/quantity_edits.h"
#include "ui/forms/complaint.h"
#include "ui/forms/components_edit.h"
#include "ui/forms/correlation_edit.h"
#include "ui/forms/csv_import_dialog.h"
#include "ui/forms/distribution_edit.h"
#include "ui/forms/options_form.h"

namespace covaria::ui::uncertainty_forms_test {
namespace {

void type(QWidget& parent, const char* name, const QString& text) {
    auto* edit = parent.findChild<QLineEdit*>(name);
    ASSERT_NE(edit, nullptr) << name;
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

/// Chooses an entry as a user does: the popup is not needed to activate a row by the keyboard.
void choose(QWidget& parent, const char* name, const QString& data) {
    auto* box = parent.findChild<QComboBox*>(name);
    ASSERT_NE(box, nullptr) << name;
    const int row = box->findData(data);
    ASSERT_GE(row, 0) << data.toStdString();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < row; ++i) QTest::keyClick(box, Qt::Key_Down);
    ASSERT_EQ(box->currentIndex(), row);
}

ComponentEdit rectangular() {
    return {.name = "certificate",
            .distribution = "rectangular",
            .parameters = {-2.0, 2.0},
            .unit = Unit::of("um")};
}

TEST(DistributionEdit, EditsParametersAndSaysU) {
    DistributionEdit edit;
    edit.set_component(rectangular());
    EXPECT_EQ(edit.summary(), QString::fromUtf8("u = 1.15 µm"));
    QSignalSpy edited(&edit, &DistributionEdit::component_edited);
    type(edit, "high", "0.004 mm");
    EXPECT_EQ(edit.component().parameters, (std::vector<double>{-2.0, 4.0})) << "in the component's unit";
    EXPECT_EQ(edited.count(), 1);
    type(edit, "high", "-3");
    EXPECT_FALSE(edit.summary().startsWith("u =")) << "low above high: " << edit.summary().toStdString();
}

/// The words are those of the budget's column.
TEST(DistributionEdit, SaysWhatIsDrawnWhereThatIsAnotherDistribution) {
    ComponentEdit normal{.name = "mean", .distribution = "normal", .parameters = {0.0, 2.0}};
    normal.unit = Unit::of("um");
    DistributionEdit edit;
    edit.set_component(normal);
    EXPECT_EQ(edit.summary(), QString::fromUtf8("u = 2.00 µm"));
    normal.degrees_of_freedom = 4.0;
    edit.set_component(normal);
    EXPECT_EQ(edit.summary(), QString::fromUtf8("u = 2.00 µm\nMonte Carlo draws: Student t, ν = 4"));
    choose(edit, "unit", "mm");
    EXPECT_TRUE(edit.summary().contains(QStringLiteral("Student t"))) << edit.summary().toStdString();
    edit.set_component(normal, true);
    EXPECT_EQ(edit.summary(), QString::fromUtf8("u = 2.00 µm")) << "the set-up asks for normal draws";
}

TEST(DistributionEdit, AnotherKindKeepsTheStandardUncertainty) {
    for (const DistributionKindInfo& kind : distribution_kinds()) {
        DistributionEdit edit;
        edit.set_component(rectangular());
        choose(edit, "distribution", QString::fromUtf8(kind.key.data(), static_cast<int>(kind.key.size())));
        EXPECT_EQ(edit.component().distribution, kind.key);
        const auto distribution = distribution_of(edit.component());
        ASSERT_TRUE(distribution) << kind.key << ": " << distribution.error().message.english();
        EXPECT_NEAR(distribution->standard_uncertainty(), 2e-6 / std::sqrt(3.0), 1e-10) << kind.key;
    }
}

TEST(DistributionEdit, AnotherUnitKeepsTheQuantity) {
    DistributionEdit edit;
    edit.set_component(rectangular());
    choose(edit, "unit", "mm");
    EXPECT_EQ(edit.component().unit, Unit::of("mm"));
    EXPECT_EQ(edit.component().parameters, (std::vector<double>{-0.002, 0.002}));
}

TEST(DensityPicture, PaintsEveryKind) {
    DensityPicture picture;
    picture.resize(120, 60);
    picture.set_distribution(std::nullopt);
    const QImage empty = picture.grab().toImage();
    for (const DistributionKindInfo& kind : distribution_kinds()) {
        DistributionEdit edit;
        edit.set_component(rectangular());
        choose(edit, "distribution", QString::fromUtf8(kind.key.data(), static_cast<int>(kind.key.size())));
        picture.set_distribution(*distribution_of(edit.component()));
        EXPECT_NE(picture.grab().toImage(), empty) << kind.key;
    }
    picture.set_distribution(Distribution::normal(0.0));
    EXPECT_NE(picture.grab().toImage(), empty) << "a constant";
}

struct AnalysisFormsTest : testing::Test {
    AnalysisFormsTest() {
        Project project;
        project.analyses.push_back({"a", "model", "Analysis", {}, {}, {}, {}, {}, {}});
        document.replace(project);
        InputSet inputs;
        for (const char* symbol : {"x", "y", "z"}) {
            UncertaintyComponent component;
            component.id = std::string(symbol) + ".reading";
            component.name = "reading";
            component.unit = Unit::of("um");
            component.distribution = Distribution::normal(1e-6);
            InputQuantity quantity;
            quantity.symbol = symbol;
            quantity.unit = Unit::of("mm");
            inputs.add(quantity, {component});
        }
        analysis = analysis_with("a", std::move(inputs));
    }
    const AnalysisEntry& entry() const { return document.project().analyses[0]; }
    Problems found;
    Document document{[this](const MadeProject&) { return found; }, nullptr};
    std::shared_ptr<const PreparedAnalysis> analysis;
};

TEST_F(AnalysisFormsTest, ComponentsAreEditedAddedRemovedAndReset) {
    const Project before = document.project();
    ComponentsEdit edit(document);
    edit.set_quantity(analysis, "x");
    type(edit, "standard_deviation", "3");
    ASSERT_EQ(entry().inputs.size(), 1u);
    const auto& components = entry().inputs[0].components;
    ASSERT_TRUE(components);
    EXPECT_EQ(components->at(0).parameters, (std::vector<double>{0.0, 3.0}));
    EXPECT_EQ(components->at(0).name, "reading");
    edit.add_component();
    EXPECT_EQ(entry().inputs[0].components->size(), 2u);
    edit.remove_component();
    EXPECT_EQ(entry().inputs[0].components->size(), 1u);
    edit.reset();
    EXPECT_EQ(document.project(), before);
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(document.project(), before);
}

TEST_F(AnalysisFormsTest, OptionsShowWhatTheMethodUses) {
    OptionsForm form(document, "a");
    form.show();
    type(form, "trials", "50000");
    EXPECT_EQ(entry().options.trials, 50000u);
    type(form, "trials", "0");
    EXPECT_EQ(entry().options.trials, 50000u) << "out of range";
    type(form, "coverageFactor", "2");
    EXPECT_EQ(entry().options.coverage_factor, 2.0);
    type(form, "seed", "7");
    EXPECT_EQ(entry().options.seed, 7u);
    EXPECT_FALSE(form.findChild<QWidget*>("maximumTrials")->isVisible());
    choose(form, "method", "adaptive");
    EXPECT_EQ(entry().options.method, Method::adaptive);
    EXPECT_TRUE(form.findChild<QWidget*>("maximumTrials")->isVisible());
    EXPECT_FALSE(form.findChild<QWidget*>("trials")->isVisible());
    found.error("/analyses/0/options/minimumBatches", "too few");
    document.check_now();
    EXPECT_EQ(complaint_of(*form.findChild<QWidget*>("minimumBatches")), "too few");
    EXPECT_TRUE(form.focus_field("/analyses/0/options/minimumBatches"));
    EXPECT_FALSE(form.focus_field("/analyses/0/options/nothing"));
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(entry().options, EvaluationOptions{});
}

TEST_F(AnalysisFormsTest, ImpossibleCorrelationsAreSaidAtOnce) {
    CorrelationEdit edit(document);
    edit.set_analysis(analysis);
    for (const char* id : {"x.reading", "y.reading", "z.reading"}) edit.model().add_component(id);
    edit.model().setData(edit.model().index(0, 1), "0.9");
    EXPECT_TRUE(complaint_of(edit.view()).isEmpty());
    edit.model().setData(edit.model().index(1, 2), "0.9");
    EXPECT_FALSE(complaint_of(edit.view()).isEmpty());
    document.undo_stack().undo();
    EXPECT_TRUE(complaint_of(edit.view()).isEmpty());
}

struct CsvImportTest : testing::Test {
    QString file(const QByteArray& content) {
        QFile csv(folder.filePath("points.csv"));
        EXPECT_TRUE(csv.open(QIODevice::WriteOnly));
        csv.write(content);
        return csv.fileName();
    }
    const FieldSpec& field = *sample_schema().find("points");
    std::vector<Unit> units{Unit(), Unit::of("mm"), Unit::of("um"), Unit()};
    QTemporaryDir folder;
};

TEST_F(CsvImportTest, PreviewsWhatWillBeImported) {
    const CsvImportDialog dialog(field, units, file("Name,x [m],u_x [um],Kind\nb1,0.5,2,Nest\nb2,1.5,3,b\n"));
    EXPECT_FALSE(dialog.problems().has_errors());
    ASSERT_EQ(dialog.table().rows.size(), 2u);
    EXPECT_EQ(dialog.table().units[1], Unit::of("m"));
    const auto* preview = dialog.findChild<QTableWidget*>("preview");
    EXPECT_EQ(preview->item(1, 1)->text(), "1.5");
    EXPECT_EQ(preview->horizontalHeaderItem(1)->text(), "x / m");
}

TEST_F(CsvImportTest, AColumnOfTheFileMayStandForAnyColumn) {
    const CsvImportDialog dialog(
        field, units, file("Name,pos,u_x [um],Kind,operator\nb1,0.5,2,Nest,Anna\nb2,1.5,3,b,Ben\n"));
    EXPECT_TRUE(dialog.problems().has_errors());
    const auto* columns = dialog.findChild<QTableWidget*>("columns");
    ASSERT_EQ(columns->rowCount(), 5);
    const auto choose = [&](int row, const QString& text) {
        auto* choice = qobject_cast<QComboBox*>(columns->cellWidget(row, 1));
        const int index = choice->findText(text);
        ASSERT_GE(index, 0) << text.toStdString();
        choice->setCurrentIndex(index);
    };
    choose(4, "not read");
    choose(1, "x / mm");
    EXPECT_FALSE(dialog.problems().has_errors()) << dialog.problems().items()[0].message.english();
    ASSERT_EQ(dialog.table().rows.size(), 2u);
    EXPECT_EQ(std::get<double>(dialog.table().rows[1][1]), 1.5);
    EXPECT_EQ(dialog.table().units[1], Unit::of("mm"));
    choose(2, "x / mm");
    EXPECT_TRUE(dialog.problems().has_errors()) << "one column for two";
}

TEST_F(CsvImportTest, WithoutHeadsTheTablesUnitsAreUsed) {
    const CsvImportDialog dialog(field, units, file("b1;0.5;2;a\n"));
    EXPECT_FALSE(dialog.problems().has_errors());
    ASSERT_EQ(dialog.table().rows.size(), 1u);
    EXPECT_EQ(dialog.table().units[1], Unit::of("mm"));
}

TEST_F(CsvImportTest, WrongCellsAndMissingFilesAreSaidAndNotImported) {
    const auto accept_is_enabled = [](const QDialog& dialog) {
        for (const auto* button : dialog.findChildren<QPushButton*>())
            if (button->text() == "Import") return button->isEnabled();
        return false;
    };
    const CsvImportDialog good(field, units, file("b1;0.5;2;a\n"));
    EXPECT_TRUE(accept_is_enabled(good));
    const CsvImportDialog wrong(field, units, file("b1;abc;2;a\n"));
    EXPECT_TRUE(wrong.problems().has_errors());
    EXPECT_FALSE(accept_is_enabled(wrong));
    const CsvImportDialog missing(field, units, folder.filePath("missing.csv"));
    EXPECT_FALSE(accept_is_enabled(missing));
}

}  // namespace
}  // namespace covaria::ui::uncertainty_forms_test
