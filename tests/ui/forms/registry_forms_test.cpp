// Every registered asset kind and model gets its form from the registry alone.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLineEdit>

#include "core/kinds/registries.h"
#include "tests/ui/qt_application.h"
#include "ui/document/project_edits.h"
#include "ui/forms/setup_form.h"
#include "ui/forms/table_editor.h"

namespace covaria::ui::registry_forms_test {
namespace {

struct RegistryFormsTest : testing::Test {
    Document document;

    void expect_form(const SetupAddress& address, const SetupSchema& schema) {
        SetupForm form(document, address);
        for (const FieldSpec& field : schema.fields()) {
            ASSERT_NE(form.editor(field.key), nullptr) << field.key;
            EXPECT_TRUE(form.focus_field('/' + field.key)) << field.key;
            auto* table = dynamic_cast<TableEditor*>(form.editor(field.key));
            if (!table) continue;
            const QAbstractItemModelTester tester(&table->model(),
                                                  QAbstractItemModelTester::FailureReportingMode::Fatal);
            const int rows = table->model().rowCount();
            EXPECT_TRUE(table->model().insertRows(0, 1));
            EXPECT_EQ(table->model().rowCount(), rows + 1);
        }
    }
};

TEST_F(RegistryFormsTest, AssetsHaveForms) {
    ASSERT_FALSE(asset_registry().empty());
    for (const AssetDescriptor& kind : asset_registry())
        expect_form({SetupOwner::asset, add_asset(document, kind.kind)}, kind.schema);
}

TEST_F(RegistryFormsTest, ModelsHaveForms) {
    ASSERT_FALSE(model_registry().empty());
    for (const ModelDescriptor& model : model_registry())
        expect_form({SetupOwner::analysis, add_analysis(document, model.id)}, model.schema);
}

TEST_F(RegistryFormsTest, WhatIsNewSaysWhatIsMissing) {
    for (const ModelDescriptor& model : model_registry()) add_analysis(document, model.id);
    document.check_now();
    for (const Problem& problem : document.problems().items()) {
        const SetupAddress address = address_of_path(document.project(), problem.path);
        ASSERT_FALSE(address.id.empty()) << problem.path;
        SetupForm form(document, address);
        if (!problem.path.starts_with(setup_path(document.project(), address) + '/')) continue;
        EXPECT_TRUE(form.focus_field(problem.path)) << problem.path << ": " << problem.message.english();
    }
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    EXPECT_EQ(document.project(), Project{});
}

/// The letters are those of the convention that the instrument's set-up chooses.
TEST_F(RegistryFormsTest, AnglesOfAStationAreNamedByItsConvention) {
    const SetupAddress address{SetupOwner::asset, add_asset(document, "spherical-instrument")};
    SetupForm form(document, address);
    const auto angle = [&](int i) {
        return form.editor("station")->findChild<QWidget*>("station_" + QString::number(3 + i));
    };
    ASSERT_NE(angle(0), nullptr);
    EXPECT_TRUE(angle(0)->accessibleName().endsWith(u'α'));
    document.apply("convention", [&](Project& project) {
        find_setup(project, address)->values["station_angles"] = std::string("xyz");
    });
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(angle(i)->accessibleName().endsWith(QStringLiteral("ωφκ")[i])) << i;
}

TEST_F(RegistryFormsTest, AUnitIsReadAsASignAndTypedAsAWord) {
    const SetupAddress address{SetupOwner::analysis, add_analysis(document, "calibration-curve")};
    document.apply("unit", [&](Project& project) {
        find_setup(project, address)->values["x_unit"] = std::string("degC");
    });
    SetupForm form(document, address);
    form.show();
    QApplication::setActiveWindow(&form);
    ASSERT_TRUE(QTest::qWaitForWindowActive(&form));
    auto* unit = form.findChild<QLineEdit*>("x_unit");
    ASSERT_NE(unit, nullptr);
    unit->clearFocus();
    EXPECT_EQ(unit->text(), QStringLiteral("°C"));
    unit->setFocus();
    EXPECT_EQ(unit->text(), QStringLiteral("degC"));
    unit->clearFocus();
    EXPECT_EQ(unit->text(), QStringLiteral("°C"));
}

}  // namespace
}  // namespace covaria::ui::registry_forms_test
