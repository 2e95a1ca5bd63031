// Names of quantities in the tables of a set-up are symbols in the report, as they are in its other tables.
#include <gtest/gtest.h>

#include "core/made/load_project.h"
#include "core/made/made_project.h"
#include "core/report/report.h"
#include "core/report/table_text.h"

namespace covaria::setup_symbols_test {
namespace {

TEST(SetupSymbols, AreSetHoweverShort) {
    Project project = load_project(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria").project;
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    const auto made = MadeProject::make(project);
    const auto prepared = made->analysis(project.analyses[0].id);
    const auto result = std::make_shared<const UncertaintyResult>(*run_analysis(*prepared));
    const ReportDocument report = build_report(*made, {{prepared, result}});
    for (const ReportBlock& block : report.blocks) {
        const auto* table = std::get_if<TableBlock>(&block);
        if (!table || table->table.id != "setup-quantities") continue;
        for (std::size_t row = 0; row < table->table.rows.size(); ++row)
            if (table->table.rows[row][0] == TableCell(std::string("theta"))) {
                EXPECT_EQ(to_unicode(cell_typeset(*table, row, 0)), "θ");
                EXPECT_EQ(to_unicode(cell_typeset(*table, row, 1)),
                          "deviation of the bed's temperature from 20 °C");
                return;
            }
    }
    FAIL() << "there is no quantity theta";
}

}  // namespace
}  // namespace covaria::setup_symbols_test
