// The certificate: result lines of JCGM 100 7.2, what is missing, conformity by its rule, signature and end.
#include <gtest/gtest.h>

#include "core/base/file_io.h"
#include "core/document/document_writers.h"
#include "core/project/release.h"
#include "core/project/stated_requirements.h"
#include "core/report/amendment.h"
#include "core/report/date_words.h"
#include "core/report/report.h"
#include "core/result/result_line.h"
#include "core/views/result_statement.h"
#include "tests/core/report/sample_report.h"
#include "tests/core/report/shown_cells.h"
#include "tests/fresh_folder.h"

namespace covaria::certificate_report_test {
namespace {

const std::string space = "\u202f", hard = "\u00a0";

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// An output with figures in millimetres, by the law of propagation.
OutputResult output_of(double estimate_mm, double U_mm, double nu = infinity, double k = 2.0) {
    OutputResult output;
    output.quantity = {"L", "length of the gauge", test::mm(), "", OutputRole::measurand, false};
    output.estimate = 1e-3 * estimate_mm;
    output.expanded_uncertainty = 1e-3 * U_mm;
    output.standard_uncertainty = output.expanded_uncertainty / k;
    output.coverage_factor = k;
    output.first_order = {
        output.estimate, output.standard_uncertainty, nu, k, output.expanded_uncertainty, {}, {}, {}};
    return output;
}

std::string said(double estimate_mm, double U_mm) {
    return value_statement(output_of(estimate_mm, U_mm));
}

TEST(ResultStatement, HasTwoDigitsOfUAndTheEstimateToMatch) {
    EXPECT_EQ(said(50.000777, 0.000414), "(50.000" + space + "78 ± 0.000" + space + "41)" + hard + "mm");
    EXPECT_EQ(said(-119.0049, 0.73), "(−119.00 ± 0.73)" + hard + "mm");
    EXPECT_EQ(said(1234.4, 9.96), "(1234 ± 10)" + hard + "mm") << "9.96 is 10";
    EXPECT_EQ(said(123456.7, 1.04), "(123" + space + "456.7 ± 1.0)" + hard + "mm");
    EXPECT_EQ(said(0.0, 0.12), "(0.00 ± 0.12)" + hard + "mm");
}

TEST(ResultStatement, PowersOfTenStandOutside) {
    EXPECT_EQ(said(12346.0, 678.0), "(12\u202f350 ± 680)" + hard + "mm");
    EXPECT_EQ(said(1.5e-6, 2e-8), "(1.500 ± 0.020)×10⁻⁶" + hard + "mm");
    OutputResult pure = output_of(0.0, 0.0);
    pure.quantity.unit = Unit{};
    pure.estimate = 0.5;
    pure.expanded_uncertainty = 0.01;
    EXPECT_EQ(value_statement(pure), "0.500 ± 0.010");
    pure.quantity.unit = test::deg();
    pure.estimate = 5.0 * std::acos(-1.0) / 180.0;
    pure.expanded_uncertainty = 0.1 * std::acos(-1.0) / 180.0;
    EXPECT_EQ(value_statement(pure), "(5.00 ± 0.10)°");
}

TEST(ResultStatement, WithoutUncertaintyItSaysSo) {
    EXPECT_EQ(said(50.0, 0.0), "50" + hard + "mm (exact)");
    EXPECT_TRUE(contains(said(50.0, infinity), "U not finite"));
}

TEST(ResultStatement, CoverageIsStated) {
    UncertaintyResult result;
    EXPECT_EQ(coverage_statement(output_of(50, 0.1), result), "k = 2.00, p = 95" + hard + "%");
    EXPECT_EQ(coverage_statement(output_of(50, 0.1, 17.8, 2.11), result),
              "k = 2.11, nu_eff = 17.8, p = 95" + hard + "%");
    result.fixed_coverage_factor = 2.0;
    EXPECT_EQ(coverage_statement(output_of(50, 0.1), result), "k = 2.00, p = 95.45" + hard + "%");
    EXPECT_EQ(coverage_statement(output_of(50, 0.1, 10.0), result), "k = 2.00, p = 92.66" + hard + "%")
        << "of y ± U, for a t distribution";
}

TEST(ResultStatement, AnIntervalThatIsNotSymmetricIsStatedToo) {
    UncertaintyResult result;
    result.trials = 1000;
    OutputResult output = output_of(10.0, 1.0);
    output.monte_carlo = test::sample_monte_carlo(output.estimate, output.standard_uncertainty);
    output.monte_carlo->symmetric = {9.02e-3, 11.02e-3};
    EXPECT_EQ(skewed_interval(output, result), "");
    output.monte_carlo->symmetric = {9.4e-3, 11.4e-3};
    EXPECT_EQ(skewed_interval(output, result), "[9.40, 11.40]" + hard + "mm");
    EXPECT_EQ(result_statement(output, result), "10.00" + hard + "mm, u = 0.50" + hard + "mm, p = 95" + hard +
                                                    "%, coverage interval [9.40, 11.40]" + hard + "mm")
        << "y ± U would cover another part of the distribution";
    const DocumentLanguage comma("de", {.decimal = ","}, {});
    EXPECT_EQ(skewed_interval(output, result, comma), "[9,40; 11,40]" + hard + "mm");
    EXPECT_EQ(value_statement(output, true, comma), "(10,0 ± 1,0)" + hard + "mm");
    EXPECT_FALSE(contains(result_statement(output, result, comma), "."));
    result.fixed_coverage_factor = 2.0;
    EXPECT_TRUE(contains(result_statement(output, result), "(10.0 ± 1.0)" + hard + "mm, k = 2.00, p = "))
        << "k was asked for, p is that of y ± U";
}

TEST(DecisionRule, HasItsName) {
    EXPECT_EQ(decision_rule(0.0), "simple acceptance (w = 0)");
    EXPECT_EQ(decision_rule(1.0), "guard band w = U");
    EXPECT_EQ(decision_rule(0.83), "guard band w = 0.83 U");
    EXPECT_EQ(decision_rule(-1.0), "guarded rejection (w = −U)");
}

/// The sample with a certificate, a tolerance, some poses.
struct Made {
    Project project = test::sample_project();
    std::vector<EvaluatedAnalysis> analyses;

    explicit Made(int poses, bool filled = true) {
        if (filled)
            for (const CertificateField& field : certificate_fields())
                project.certificate.*field.member =
                    field.kind == CertificateText::line || field.kind == CertificateText::lines
                        ? std::string("given A_7 <") + field.key + ">"
                    : field.kind == CertificateText::picture || field.kind == CertificateText::language ? ""
                    : field.kind == CertificateText::site ? "customer"
                                                          : "2026-04-17";
        project.analyses[0].requirements = {
            {"pose 1", "x", {}, Quantity{-121.0, test::mm()}, Quantity{-117.0, test::mm()}, 0.83}};
        analyses = {test::sample_analysis(test::sample_result({poses, 3, 3, false, "pose"}))};
    }
    ReportDocument document(CertifiedResults which = CertifiedResults::that_fit) const {
        return build_certificate(*MadeProject::make(project), analyses, {}, which);
    }
};

template <class Block>
std::vector<const Block*> blocks_of(const ReportDocument& document) {
    std::vector<const Block*> found;
    for (const ReportBlock& block : document.blocks)
        if (const auto* one = std::get_if<Block>(&block)) found.push_back(one);
    return found;
}

TEST(CertificateReport, SaysEverythingThatIsGivenAsItWasTyped) {
    const Made made(1);
    const ReportDocument document = made.document();
    const std::string text = to_html(document);
    for (const CertificateField& field : certificate_fields())
        EXPECT_TRUE(contains(text, field.kind == CertificateText::line || field.kind == CertificateText::lines
                                       ? std::string("given A_7 &lt;") + field.key + "&gt;"
                                   : field.kind == CertificateText::site ? "at the customer: given A_7"
                                                                         : "17 April 2026"))
            << field.key;
    EXPECT_FALSE(contains(text, "2026-04-17")) << "dates are words";
    EXPECT_EQ(document.author, made.project.certificate.authorised_by);
    EXPECT_FALSE(contains(text, "not stated"));
    EXPECT_TRUE(document.head_on_every_page);
    EXPECT_TRUE(contains(document.running_head, made.project.certificate.number));
    EXPECT_TRUE(contains(text, "counter(pages)"));
    const auto& last = std::get<SignatureBlock>(document.blocks.back());
    EXPECT_EQ(last.end_mark, "End of certificate " + made.project.certificate.number);
    EXPECT_TRUE(contains(to_markdown(document), "End of certificate"));
}

TEST(CertificateReport, TheLogoIsInTheDocument) {
    Made made(1);
    const auto folder = test::fresh_folder();
    made.project.directory = folder;
    made.project.certificate.logo = "logo.png";
    EXPECT_TRUE(made.document().logo.empty()) << "there is no such file";
    const std::string png = "\x89PNG\r\n\x1a\n and what follows";
    ASSERT_TRUE(write_file_atomically(folder / "logo.png", png));
    const ReportDocument document = made.document();
    EXPECT_EQ(document.logo.bytes, png);
    EXPECT_EQ(document.logo.media_type, "image/png");
    EXPECT_TRUE(contains(to_html(document), "<img class=\"logo\""));
    EXPECT_TRUE(contains(to_html(document), "src=\"data:image/png;base64,iVBORw0KGgo")) << "the file itself";
    made.project.certificate.logo.clear();
    EXPECT_FALSE(contains(to_html(made.document()), "class=\"logo\""));
}

TEST(CertificateReport, WhatIsRequiredAndMissingIsAGap) {
    const ReportDocument document = Made(1, false).document();
    const std::string text = to_html(document);
    for (const CertificateField& field : certificate_fields()) {
        const std::string gap = std::string("<dt>") + field.title + "</dt><dd>— not stated —</dd>";
        const bool elsewhere = field.member == &Certificate::authorised_by;
        EXPECT_EQ(contains(text, gap), (field.required && !elsewhere) || field.required_for_conformity)
            << field.title;
    }
    EXPECT_EQ(document.title, "Calibration certificate") << "a gap is a fact, not a title";
    EXPECT_TRUE(document.over.empty());
    EXPECT_EQ(std::get<SignatureBlock>(document.blocks.back()).name, "— not stated —");
}

TEST(CertificateReport, FewResultsAreLinesAndManyACompactTable) {
    const ReportDocument few = Made(1).document();
    const auto lines = blocks_of<FactsBlock>(few);
    const auto with_x = std::find_if(lines.begin(), lines.end(), [](const FactsBlock* facts) {
        return facts->facts.front().first == "x of the platform (pose 1)";
    });
    ASSERT_NE(with_x, lines.end());
    EXPECT_EQ((*with_x)->facts[0].second,
              "x = (−119.00 ± 0.74)" + hard + "mm, k = 2.00, p = 95" + hard + "%");
    const auto tables = blocks_of<TableBlock>(few);
    ASSERT_EQ(tables.size(), 1u) << "conformity";

    const ReportDocument many = Made(10).document();
    std::size_t cells = 0;
    for (const TableBlock* table : blocks_of<TableBlock>(many)) {
        if (!table->table.id.starts_with("certified-")) continue;
        EXPECT_EQ(table->table.rows, 10u);
        EXPECT_EQ(table->table.columns.size(), 4u) << "three symbols; k is the same";
        EXPECT_EQ(table->table.notes.front(), "k = 2.00, p = 95" + hard + "%.");
        for (std::size_t row = 0; row < table->table.rows; ++row)
            for (std::size_t c = 0; c < 4; ++c) cells += contains(test::plain_cell(*table, row, c), " ± ");
    }
    EXPECT_EQ(cells, 60u) << "every result is stated";
    EXPECT_FALSE(contains(to_markdown(many), "Not stated:"));
}

TEST(CertificateReport, OfManyResultsItSaysWhichAreThere) {
    Made made(9);
    for (const int poses : {9, 2}) {
        EvaluatedAnalysis more = test::sample_analysis(test::sample_result({poses, 3, 3, false, "pose"}));
        auto renamed = std::make_shared<PreparedAnalysis>(*more.analysis);
        renamed->id += std::to_string(poses);
        more.analysis = renamed;
        made.analyses.push_back(more);
    }
    made.project.certificate.country.clear();
    const std::string fitting = to_html(made.document());
    EXPECT_TRUE(contains(fitting, "states 54 of 120 results")) << "the first is there, the last too many";
    EXPECT_FALSE(contains(to_html(made.document(CertifiedResults::all)), "results. Not stated"));
    // The PDF carries a digital certificate only where that is complete.
    EXPECT_FALSE(contains(fitting, "digital certificate"));
    made.project.certificate.country = "DE";
    const std::string sentence = "66 further results are in the digital certificate that is attached";
    EXPECT_TRUE(contains(to_html(made.document()), sentence));
    EXPECT_FALSE(contains(to_html(made.document(CertifiedResults::all)), "digital certificate"));
    auto unknown = std::make_shared<UncertaintyResult>(*made.analyses.back().result);
    unknown->outputs[0].standard_uncertainty = unknown->outputs[0].expanded_uncertainty = infinity;
    made.analyses.back().result = unknown;
    EXPECT_FALSE(contains(to_html(made.document()), sentence)) << "it has no place for what is not finite";
}

TEST(CertificateReport, WhatDoesNotRepresentTheMeasurandIsNoResult) {
    Made made(1);
    auto result = test::sample_result({1, 3, 3, true, "pose"});
    result.failed_trials = result.trials / 2;
    made.analyses = {test::sample_analysis(std::move(result))};
    const std::string text = to_html(made.document());
    EXPECT_TRUE(contains(text, "No result is stated"));
    EXPECT_FALSE(contains(text, " ± 0.74"));
}

TEST(CertificateReport, ConformityNamesItsRuleAndRatios) {
    const ReportDocument document = Made(1).document();
    const TableBlock* table = blocks_of<TableBlock>(document).back();
    ASSERT_EQ(table->table.rows, 1u);
    std::string row;
    for (std::size_t c = 0; c < table->table.columns.size(); ++c) row += test::plain_cell(*table, 0, c) + "|";
    EXPECT_TRUE(contains(row, "guard band w = 0.83 U|pass (accepted)|")) << row;
    EXPECT_TRUE(contains(row, "|2.70|2.70|")) << row << ": U = 2u, 2 mm over 0.741 mm";
    EXPECT_TRUE(contains(to_html(document), "ILAC-G8:09/2019"));
    Made failing(1);
    failing.project.analyses[0].requirements[0].upper_limit = Quantity{-118.9, test::mm()};
    EXPECT_TRUE(contains(to_html(failing.document()), "fail (rejected)"));
}

TEST(CertificateReport, ConformitySaysToWhichSpecificationItRefers) {
    Made made(1);
    made.project.certificate.specification = "ISO 3650:1998, grade 1";
    const auto place_of = [&](const std::string& words) { return to_html(made.document()).find(words); };
    EXPECT_GT(place_of("ISO 3650:1998, grade 1"), place_of("Statement of conformity"));
    made.project.certificate.specification.clear();
    EXPECT_TRUE(contains(to_html(made.document()), "<dt>Specification</dt><dd>— not stated —</dd>"));
    made.project.analyses[0].requirements.clear();
    EXPECT_FALSE(contains(to_html(made.document()), "<dt>Specification</dt>")) << "nothing refers to one";
    made.project.certificate.specification = "MPE of the maker";
    EXPECT_TRUE(contains(to_html(made.document()), "MPE of the maker")) << "what was typed is not dropped";
}

TEST(DateWords, AreThoseOfTheLanguageAndWhatIsNoDateStays) {
    EXPECT_EQ(date_words("2026-11-27", {}), "27 November 2026");
    EXPECT_EQ(date_words("2026-04-07/2026-05-18", {}), "7 April 2026 to 18 May 2026");
    const DocumentLanguage german("de", {.decimal = ","}, [](const std::string& english) {
        return english == "%1 %2 %3" ? "%1. %2 %3" : english == "May" ? "Mai" : english;
    });
    EXPECT_EQ(date_words("2026-05-07", german), "7. Mai 2026");
    const DocumentLanguage chinese("zh_CN", {}, [](const std::string& english) {
        return english == "%1 %2 %3" ? "%3年%2%1日" : english == "May" ? "5月" : english;
    });
    EXPECT_EQ(date_words("2026-05-07", chinese), "2026年5月7日");
    for (const char* other : {"", "soon", "2026-13-01", "2026-00-01", "2026-4-7", "— not stated —"})
        EXPECT_EQ(date_words(other, german), other);
}

TEST(CertificateReport, SaysWhoReleasedItAndOfADraftThatItIsOne) {
    Made made(1);
    EXPECT_FALSE(contains(to_html(made.document()), "Prepared by")) << "no review is stated";
    made.project.review.prepared = {"A. Ames", "2026-11-26"};
    made.project.review.checked = {"B. Bell", "2026-11-27"};
    const ReportDocument draft = made.document();
    EXPECT_EQ(std::get<FactsBlock>(draft.blocks.front()).facts.front().first, "Draft") << "at its head";
    made.project.review.released = {"C. Cole", "2026-11-28"};
    ASSERT_TRUE(release(made.project));
    const std::string text = to_html(made.document());
    EXPECT_TRUE(contains(text, "C. Cole, 28 November 2026"));
    EXPECT_TRUE(contains(text, made.project.review.digest));
    EXPECT_FALSE(contains(text, "Draft"));
    made.project.certificate.customer += ".";
    EXPECT_TRUE(contains(to_html(made.document()),
                         "changed since the release by C. Cole, 28 November 2026: "
                         "the texts of the certificate"));
    EXPECT_FALSE(contains(to_html(made.document()), made.project.review.digest));
}

/// A result that moves, one that is gone, one that is new, a decision, a text; what stays is not there.
TEST(CertificateReport, AnAmendedOneStatesWhatHasChanged) {
    Made made(1);
    const auto source = [&](const MadeProject& project) {
        static const std::vector<FailedAnalysis> none;
        return ReportSource{project, made.analyses, none};
    };
    const auto before = MadeProject::make(made.project);
    Amendment amendment = statements_of(source(*before));
    ASSERT_EQ(amendment.results.size(), 6u) << "three coordinates and three angles";
    EXPECT_EQ(amendment.results[0].decision, ReplacedDecision::pass);
    made.project.certificate.replaces = "K-1";
    made.project.amendment = amendment;
    made.project.certificate.customer = "Customer B";
    const auto tables = [&] { return blocks_of<TableBlock>(made.document()).size(); };
    const std::size_t unchanged = tables();
    EXPECT_TRUE(contains(to_html(made.document()), "No result has changed."));
    const auto in_other_unit = [](ReplacedResult& result, double factor) {
        result.estimate /= factor;
        result.expanded_uncertainty /= factor;
    };
    made.project.amendment.results[1].unit = Unit::of("m");
    in_other_unit(made.project.amendment.results[1], 1000.0);
    EXPECT_EQ(tables(), unchanged) << "the unit is no change";
    made.project.amendment.results[0].decision = ReplacedDecision::fail;
    made.project.amendment.results[2].estimate += 100.0;
    made.project.amendment.results.erase(made.project.amendment.results.begin() + 4);
    made.project.amendment.results.push_back(
        {"typed", "pose 9", "x", 1.0, 0.1, test::mm(), ReplacedDecision::none});
    EXPECT_EQ(tables(), unchanged + 1);
    const std::string text = to_html(made.document());
    const std::string changes = text.substr(text.find("Changes to certificate K-1"));
    for (const char* words : {"fail (rejected)", "pass (accepted)", "(1.00 ± 0.10)", "pose 9", "Customer B"})
        EXPECT_TRUE(contains(changes, words)) << words;
    const auto rows = [&](const std::string& id) {
        for (const ReportBlock& block : made.document().blocks)
            if (const auto* table = std::get_if<TableBlock>(&block); table && table->table.id == id)
                return table->table.rows;
        return std::size_t{0};
    };
    EXPECT_EQ(rows("amended-results"), 4u);
    EXPECT_EQ(rows("amended-texts"), 1u);
    made.project.certificate.replaces.clear();
    EXPECT_FALSE(contains(to_html(made.document()), "Customer B</td>")) << "it replaces none";
}

}  // namespace
}  // namespace covaria::certificate_report_test
