// The dossier: PDF/A with its figures attached, the same for programs, and of which program they are.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/sha256.h"
#include "core/pdf/pdf_archive.h"
#include "tests/app/program.h"

namespace covaria::dossier_command_test {

using json = nlohmann::json;
namespace fs = std::filesystem;

TEST(VerifyDossier, WritesPdfAndJsonOfTheSameFigures) {
    const fs::path folder = fresh_folder("dossier"), pdf = folder / "dossier.pdf";
    const Outcome made = run_program({"verify", "--dossier", pdf.string(), "--first-order"});
    ASSERT_EQ(made.status, 0) << made.out << made.err;
    EXPECT_TRUE(made.out.starts_with("0 of ")) << made.out;
    const std::string beside = read_text(folder / "dossier.json");
    const json dossier = json::parse(beside);
    EXPECT_EQ(dossier.at("format"), "covaria-dossier");
    EXPECT_EQ(dossier.at("figures"), dossier.at("passed"));
    EXPECT_GT(dossier.at("figures"), 5000);
    EXPECT_TRUE(is_sha256(dossier.at("program").at("SHA-256 of the program").get<std::string>()));
    for (const char* key : {"Compiler", "Eigen", "Qt", "VTK", "Date"})
        EXPECT_FALSE(dossier.at("program").at(key).get<std::string>().empty()) << key;
    for (const json& clause : dossier.at("clauses"))
        EXPECT_EQ(clause.at("figures"), clause.at("passed")) << clause;
    const std::string bytes = read_text(pdf);
    EXPECT_NE(bytes.find("<pdfaid:part>3</pdfaid:part>"), std::string::npos);
    const auto attached = files_in_pdf(bytes);
    ASSERT_TRUE(attached);
    ASSERT_EQ(attached->size(), 1u);
    EXPECT_EQ(attached->front().bytes, beside);
}

TEST(VerifyDossier, RefusesAnotherEnding) {
    const Outcome refused = run_program({"verify", "--dossier", "dossier.html"});
    EXPECT_NE(refused.status, 0);
    EXPECT_NE(refused.err.find("the dossier is a PDF"), std::string::npos) << refused.err;
}

}  // namespace covaria::dossier_command_test
