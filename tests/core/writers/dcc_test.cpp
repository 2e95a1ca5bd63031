// Digital Calibration Certificates: valid by their schema, read in again to the same numbers, and nothing is
// made up for what is missing.
#include <array>
#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/project/stated_requirements.h"
#include "core/readers/dsi_unit.h"
#include "core/readers/readers.h"
#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "core/views/result_statement.h"
#include "tests/core/shipped_projects.h"
#include "tests/core/writers/evaluated.h"
#include "tests/fresh_folder.h"

namespace covaria::writers_test {

namespace {

namespace fs = std::filesystem;

Certificate full_certificate() {
    Certificate certificate;
    for (const CertificateField& field : certificate_fields())
        certificate.*field.member = std::string(field.title) + " <&\"' Ä\n second\x01 line";
    certificate.country = "DE";
    certificate.site = "customer";
    certificate.received = "2026-04-16";
    certificate.calibrated = "2026-04-17/2026-04-18";
    certificate.issued = "2026-04-20";
    certificate.replaced_issued = "2026-04-18";
    return certificate;
}

Evaluated certified(const std::string& name, std::uint64_t trials = 0) {
    Project project = loaded(data_directory() / "projects" / (name + ".covaria"));
    project.certificate = full_certificate();
    return evaluate(std::move(project), trials);
}

/// The schemas with their imports beside them; what they import of others is a stub.
fs::path schema_folder() {
    const fs::path folder = test::fresh_folder("schema");
    const auto copy = [&](const char* from, const char* to) {
        std::string text = read_file(fs::path(COVARIA_SOURCE_DIR) / "tests/data/dcc" / from).value();
        for (const auto& [address, file] :
             {std::pair("https://ptb.de/si/v2.1.0/SI_Format.xsd", "si.xsd"),
              {"https://www.ptb.de/dcc/d-sig/xmldsig-core-schema.xsd", "xmldsig.xsd"},
              {"https://www.ptb.de/si/v2.2.0/qudt/quantitykind.xsd", "qudt.xsd"}})
            if (const std::size_t at = text.find(address); at != std::string::npos)
                text.replace(at, std::string_view(address).size(), file);
        EXPECT_TRUE(write_file_atomically(folder / to, text));
    };
    copy("dcc-3.2.1.xsd", "dcc.xsd");
    copy("SI_Format-2.2.0.xsd", "si.xsd");
    const std::string head = "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" targetNamespace=";
    EXPECT_TRUE(write_file_atomically(folder / "xmldsig.xsd",
                                      head + "\"http://www.w3.org/2000/09/xmldsig#\"><xs:element "
                                             "name=\"Signature\"/></xs:schema>"));
    EXPECT_TRUE(write_file_atomically(folder / "qudt.xsd",
                                      head + "\"http://qudt.org/vocab/\"><xs:simpleType "
                                             "name=\"quantitykind\"><xs:restriction base=\"xs:string\"/>"
                                             "</xs:simpleType></xs:schema>"));
    return folder;
}

bool has_xmllint() {
    return std::system("xmllint --version > /dev/null 2>&1") == 0;
}

/// Complaints of xmllint; empty if it is valid.
std::string invalid_because(const std::string& xml) {
    const fs::path folder = schema_folder(), file = folder / "certificate.xml", said = folder / "said.txt";
    EXPECT_TRUE(write_file_atomically(file, xml));
    const std::string command = "xmllint --nonet --noout --schema '" + (folder / "dcc.xsd").string() + "' '" +
                                file.string() + "' > '" + said.string() + "' 2>&1";
    return std::system(command.c_str()) == 0 ? "" : read_file(said).value_or("nothing was said");
}

TEST(WriteCertificate, IsValidByItsSchema) {
    if (!has_xmllint()) GTEST_SKIP() << "xmllint is not installed";
    EXPECT_NE(invalid_because("<x/>"), "") << "the check checks nothing";
    for (const fs::path& file : shipped_projects()) {
        Project project = loaded(file);
        project.certificate = full_certificate();
        const Evaluated evaluated = evaluate(std::move(project));
        const auto written = write_as("dcc", evaluated.source());
        ASSERT_TRUE(written) << file << ": " << written.error().message.english();
        EXPECT_EQ(invalid_because(written->bytes), "") << file;
        EXPECT_EQ(written->bytes, write_as("dcc", evaluated.source())->bytes);
    }
    const auto trials = write_as("dcc", certified("stewart-platform", 20'000).source());
    ASSERT_TRUE(trials) << trials.error().message.english();
    EXPECT_EQ(invalid_because(trials->bytes), "");
}

TEST(WriteCertificate, SaysWhereItWasPerformedAndNothingAboutASignThatIsNotThere) {
    for (const auto& [site, place, stated] : {std::array{"customer", "hall 3", "customer"},
                                              {"customerBranch", "", "customerBranch"},
                                              {"", "", "laboratory"},
                                              {"", "hall 3", "other"}}) {
        for (const bool fixed : {false, true})
            for (const std::uint64_t trials : {0, 2'000}) {
                Project project = loaded(data_directory() / "projects/gum/h1-end-gauge.covaria");
                project.certificate = full_certificate();
                // The other one has a component of two degrees of freedom: u by Monte Carlo does not exist.
                std::erase_if(project.analyses,
                              [](const AnalysisEntry& analysis) { return analysis.requirements.empty(); });
                project.certificate.site = site;
                project.certificate.place = place;
                if (fixed) project.results.coverage_factor = 2.0;
                const Evaluated evaluated = evaluate(std::move(project), trials);
                const auto written = write_as("dcc", evaluated.source());
                ASSERT_TRUE(written) << written.error().message.english();
                pugi::xml_document document;
                ASSERT_TRUE(document.load_string(written->bytes.c_str()));
                EXPECT_STREQ(document.select_node("//dcc:performanceLocation").node().text().get(), stated);
                EXPECT_EQ(written->bytes.find("±"), std::string::npos) << "data have no such sign";
                const std::string method =
                    document.select_node("//dcc:usedMethod[2]/dcc:description/dcc:content")
                        .node()
                        .text()
                        .get();
                EXPECT_EQ(method.find("fixed coverage factor") != std::string::npos, fixed) << method;
            }
    }
}

/// Rows of the analysis that the reader proposes, by name.
struct ReadQuantities {
    AnalysisEntry analysis;
    SetupCell cell(std::size_t row, const char* column) const {
        const FieldSpec& field = *find_model(analysis.model)->schema.find("quantities");
        return std::get<SetupTable>(analysis.setup.values.at("quantities"))
            .rows.at(row)
            .at(SetupSchema::column(field, column));
    }
    std::size_t count() const {
        return std::get<SetupTable>(analysis.setup.values.at("quantities")).rows.size();
    }
};

ReadQuantities read_back(const std::string& xml, std::string* left_out = nullptr) {
    const auto read = find_reader("dcc")->read(xml, {.file_name = "c.xml"});
    EXPECT_TRUE(read) << read.error().message.english();
    if (read && left_out)
        for (const LeftOut& left : read->left_out) *left_out += left.what.english() + "\n";
    return read ? ReadQuantities{read->analyses.at(0)} : ReadQuantities{};
}

/// Elements called `name`, wherever they are.
std::vector<pugi::xml_node> elements(const pugi::xml_node& root, const char* name) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xpath_node& node : root.select_nodes((std::string("//") + name).c_str()))
        found.push_back(node.node());
    return found;
}

/// The figure of the quantity called so in the data of metadata.
double figure_of(const pugi::xml_node& meta, const char* name) {
    for (const pugi::xml_node& quantity : meta.child("dcc:data").children("dcc:quantity"))
        if (std::string_view(quantity.child("dcc:name").child("dcc:content").text().get()) == name)
            return quantity.child("si:real").child("si:value").text().as_double();
    ADD_FAILURE() << name << " is not there";
    return 0.0;
}

TEST(WriteCertificate, StatesConformityByItsRule) {
    for (const bool conforming : {true, false}) {
        Project project = loaded(data_directory() / "projects/gum/h1-end-gauge.covaria");
        project.certificate = full_certificate();
        std::erase_if(project.analyses,
                      [](const AnalysisEntry& analysis) { return analysis.requirements.empty(); });
        auto& entry = project.analyses.at(0);
        entry.requirements.at(0).guard_factor = 1.0;
        if (!conforming)
            entry.requirements[0].upper_limit->value = 50000850;  // accepted without guard band only
        const Evaluated evaluated = evaluate(std::move(project));
        const auto written = write_as("dcc", evaluated.source());
        ASSERT_TRUE(written) << written.error().message.english();
        if (has_xmllint()) {
            EXPECT_EQ(invalid_because(written->bytes), "");
        }
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(written->bytes.c_str()));
        const auto stated = elements(document, "dcc:conformity");
        ASSERT_EQ(stated.size(), 1u);
        EXPECT_EQ(std::string(stated[0].text().get()), conforming ? "pass" : "fail");
        const pugi::xml_node meta = stated[0].parent();
        EXPECT_EQ(std::string(meta.child("dcc:convention").text().get()), "guard band w = U");
        EXPECT_EQ(std::string(meta.child("dcc:norm").text().get()).find("Specification <&"), 0u)
            << "to which it refers";
        const auto verdict =
            judge(*evaluated.analyses[0].result, evaluated.made->project().analyses.at(0)).at(0);
        const std::string unit = meta.select_node(".//si:unit").node().text().get();
        const Unit read = *unit_of_dsi(unit);
        EXPECT_DOUBLE_EQ(read.to_si(figure_of(meta, "lower limit")), *verdict.lower_limit);
        EXPECT_DOUBLE_EQ(read.to_si(figure_of(meta, "upper limit")), *verdict.upper_limit);
        EXPECT_DOUBLE_EQ(read.interval_to_si(figure_of(meta, "guard band")), verdict.guard_band);
        EXPECT_DOUBLE_EQ(figure_of(meta, "probability of conformance"), verdict.conformance);
        std::size_t degrees = 0;
        for (const pugi::xml_node& other : elements(document, "dcc:metaData"))
            if (std::string_view(other.child("dcc:name").child("dcc:content").text().get())
                    .starts_with("Effective degrees of freedom")) {
                EXPECT_DOUBLE_EQ(
                    figure_of(other, "nu_eff"),
                    stated_degrees_of_freedom(evaluated.analyses[0].result->outputs[verdict.output],
                                              *evaluated.analyses[0].result));
                ++degrees;
            }
        EXPECT_EQ(degrees, 1u);
    }
}

TEST(WriteCertificate, ScalarsComeBackWithUAndK) {
    for (const fs::path& file : shipped_projects()) {
        if (file.parent_path().filename() != "gum") continue;
        Project project = loaded(file);
        project.certificate = full_certificate();
        const Evaluated evaluated = evaluate(std::move(project));
        const auto written = write_as("dcc", evaluated.source());
        ASSERT_TRUE(written) << file;
        const ReadQuantities read = read_back(written->bytes);
        std::size_t row = 0;
        for (const EvaluatedAnalysis& one : evaluated.analyses)
            for (const OutputResult& output : one.result->outputs) {
                if (output.quantity.role != OutputRole::measurand) continue;
                ASSERT_LT(row, read.count()) << file;
                const Unit unit = Unit::of(std::get<std::string>(read.cell(row, "unit")));
                EXPECT_EQ(unit.dimension(), output.quantity.unit.dimension()) << file;
                EXPECT_EQ(read.cell(row, "value"), SetupCell(unit.from_si(output.estimate)))
                    << file << " " << output.quantity.symbol;
                if (output.standard_uncertainty > 0.0 &&
                    read.cell(row, "statement") == SetupCell(std::string("certificate-k"))) {
                    EXPECT_EQ(read.cell(row, "a"),
                              SetupCell(unit.interval_from_si(output.expanded_uncertainty)));
                    EXPECT_EQ(read.cell(row, "b"), SetupCell(output.coverage_factor));
                }
                ++row;
            }
        EXPECT_EQ(row, read.count()) << file;
    }
}

TEST(WriteCertificate, PosesComeBackWithTheirCovariance) {
    const Evaluated evaluated = certified("stewart-platform");
    const auto written = write_as("dcc", {*evaluated.made, {evaluated.analyses.front()}});
    ASSERT_TRUE(written) << written.error().message.english();
    const UncertaintyResult& result = *evaluated.analyses.front().result;
    std::vector<CoverageRegion> poses;  // positions alone have regions, too
    for (const CoverageRegion& region : result.regions)
        if (region.outputs.size() == 6) poses.push_back(region);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(written->bytes.c_str()));
    const auto matrices = document.select_nodes("//si:covarianceMatrix");
    ASSERT_EQ(matrices.size(), poses.size());
    ASSERT_GT(matrices.size(), 1u);
    std::size_t m = 0, checked = 0;
    for (const CoverageRegion& region : poses) {
        std::size_t j = 0;
        for (const pugi::xml_node column : matrices[m++].node().children("si:column")) {
            std::size_t i = 0;
            for (const pugi::xml_node cell : column.children("si:covariance")) {
                const Unit unit = unit_of_dsi(cell.child_value("si:unit")).value();
                const double si = unit.interval_to_si(std::strtod(cell.child_value("si:value"), nullptr));
                const double expected = result.covariance(static_cast<Eigen::Index>(region.outputs[i]),
                                                          static_cast<Eigen::Index>(region.outputs[j]));
                EXPECT_NEAR(si, expected, 1e-14 * std::abs(expected));
                ++i, ++checked;
            }
            EXPECT_EQ(i, region.outputs.size());
            ++j;
        }
        EXPECT_EQ(j, region.outputs.size());
    }
    EXPECT_EQ(checked, 36u * poses.size());
    const ReadQuantities read = read_back(written->bytes);
    ASSERT_EQ(read.count(), 6u * poses.size());
    for (std::size_t row = 0; row < read.count(); ++row) {
        const OutputResult& output = result.outputs[poses[row / 6].outputs[row % 6]];
        const Unit unit = Unit::of(std::get<std::string>(read.cell(row, "unit")));
        EXPECT_EQ(read.cell(row, "value"), SetupCell(unit.from_si(output.estimate)));
        EXPECT_EQ(read.cell(row, "statement"), SetupCell(std::string("standard")));
        EXPECT_NEAR(std::get<double>(read.cell(row, "a")), unit.interval_from_si(output.standard_uncertainty),
                    1e-13 * unit.interval_from_si(output.standard_uncertainty));
    }
    const auto k = document.select_nodes("//si:realList/si:real/si:expandedUnc/si:coverageFactor");
    ASSERT_EQ(k.size(), read.count());
    EXPECT_EQ(std::strtod(k.first().node().child_value(), nullptr), result.outputs[0].coverage_factor);
}

TEST(WriteCertificate, ASkewedResultStatesItsInterval) {
    Project project;
    project.certificate = full_certificate();
    const LoadedProject made = parse_project(
        R"({"format": "covaria", "schemaVersion": )" + std::to_string(project_schema_version) +
            R"(, "title": "t", "analyses": [{"id": "a", "model": "measurement-equation", "setup": {
            "equations": ["y = x^2"],
            "outputs": {"columns": ["symbol", "unit"], "rows": [["y", "mm^2"]]},
            "quantities": {"columns": ["symbol", "value", "unit", "statement", "a"],
                           "rows": [["x", 0.1, "mm", "standard", 1]]}}}]})",
        ".", "t");
    for (const Problem& problem : made.problems.items()) EXPECT_EQ(problem.message.english(), "");
    Project skewed = made.project;
    skewed.certificate = full_certificate();
    const Evaluated evaluated = evaluate(skewed, 50'000);
    const auto written = write_as("dcc", evaluated.source());
    ASSERT_TRUE(written) << written.error().message.english();
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(written->bytes.c_str()));
    const auto interval = document.select_node("//si:coverageInterval").node();
    ASSERT_TRUE(interval) << written->bytes;
    const OutputResult& output = evaluated.analyses[0].result->outputs[0];
    EXPECT_EQ(interval.child_value("si:intervalMax"),
              format_exact(output.quantity.unit.from_si(output.monte_carlo->symmetric.high)));
    EXPECT_FALSE(document.select_node("//si:expandedUnc"));
    if (has_xmllint()) {
        EXPECT_EQ(invalid_because(written->bytes), "");
    }
}

TEST(WriteCertificate, WhatIsMissingIsSaidByItsField) {
    const Evaluated full = certified("lsm-network");
    for (const CertificateField& field : certificate_fields()) {
        if (!field.required && field.member != &Certificate::country) continue;
        Project project = full.made->project();
        project.certificate.*field.member = " ";
        if (field.or_else) project.certificate.*field.or_else = "";
        const auto made = MadeProject::make(project);
        const auto written = write_as("dcc", {*made, full.analyses});
        ASSERT_FALSE(written) << field.title;
        EXPECT_EQ(written.error().path, pointer_of(field));
        EXPECT_NE(written.error().message.english().find("'" + std::string(field.title) + "'"),
                  std::string::npos);
        EXPECT_TRUE(find_writer("dcc")->missing(project).has_errors());
    }
    EXPECT_TRUE(find_writer("dcc")->missing(full.made->project()).empty());
}

TEST(WriteCertificate, AnInfiniteUncertaintyHasNoPlace) {
    const Evaluated full = certified("lsm-network");
    UncertaintyResult result = *full.analyses[0].result;
    result.outputs[0].standard_uncertainty = infinity;
    result.outputs[0].coverage_factor = std::nan("");
    EvaluatedAnalysis changed = full.analyses[0];
    changed.result = std::make_shared<const UncertaintyResult>(result);
    const auto written = write_as("dcc", {*full.made, {changed}});
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.english().find("is not finite"), std::string::npos)
        << written.error().message.english();
}

TEST(DsiUnits, AreReadBackOrStatedInSi) {
    for (const auto& [typed, dsi] : {std::pair("mm", "\\milli\\metre"),
                                     {"um/m", "\\micro\\metre\\metre\\tothe{-1}"},
                                     {"1/K", "\\kelvin\\tothe{-1}"},
                                     {"N*m", "\\newton\\metre"},
                                     {"degC", "\\degreecelsius"},
                                     {"m/s^2", "\\metre\\second\\tothe{-2}"},
                                     {"W/(m*K)", "\\watt\\metre\\tothe{-1}\\kelvin\\tothe{-1}"},
                                     {"in", "\\metre"},
                                     {"1", "\\one"},
                                     {"%", "\\percent"},
                                     {"deg", "\\degree"},
                                     {"arcsec", "\\arcsecond"},
                                     {"rpm", "\\second\\tothe{-1}\\radian"},
                                     {"min", "\\minute"},
                                     {"kg", "\\kilogram"}}) {
        const Unit unit = Unit::of(typed);
        const DsiUnit made = dsi_unit_for(unit);
        EXPECT_EQ(made.text, dsi) << typed;
        const auto back = unit_of_dsi(made.text);
        ASSERT_TRUE(back) << typed;
        EXPECT_EQ(back->dimension(), unit.dimension()) << typed;
        EXPECT_EQ(back->to_si(1.0), made.unit.to_si(1.0)) << typed;
    }
    const DsiUnit mm = dsi_unit_for(Unit::of("mm")), degree = dsi_unit_for(Unit::of("deg")),
                  celsius = dsi_unit_for(Unit::of("degC")), one = dsi_unit_for(Unit());
    EXPECT_EQ(dsi_product(mm, mm), "\\milli\\metre\\tothe{2}");
    EXPECT_EQ(dsi_product(mm, degree), "\\milli\\metre\\degree");
    EXPECT_EQ(dsi_product(celsius, celsius), "\\kelvin\\tothe{2}");
    EXPECT_EQ(dsi_product(one, mm), "\\milli\\metre");
}

}  // namespace

}  // namespace covaria::writers_test
