// The impact of a certificate against brute force: a folder of invented calibrations, whose values and
// uncertainties follow from those of their standards in closed form.
#include "core/impact/impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/base/sha256.h"
#include "core/impact/impact_document.h"
#include "core/made/applicability.h"
#include "core/project/project_file.h"
#include "core/result_files/csv_writer.h"
#include "tests/fresh_folder.h"

namespace covaria::impact_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t column_of_value = 2, column_of_a = 5;

Project gauge_block() {
    LoadedProject loaded = load_project(data_directory() / "projects/certificate-gauge-block.covaria");
    EXPECT_FALSE(loaded.problems.has_errors());
    loaded.project.analyses.at(0).options.method = Method::first_order;
    return loaded.project;
}

SetupTable& quantities_of(Project& project) {
    return std::get<SetupTable>(project.analyses.at(0).setup.values.at("quantities"));
}

/// Sets the standard: its length in mm and U for k = 2, by a certificate of that number.
void set_standard(Project& project, const std::string& number, double length, double U) {
    auto& row = quantities_of(project).rows.at(0);
    row.at(column_of_value) = length;
    row.at(column_of_a) = U;
    AssetCertificate certificate;
    certificate.number = number;
    certificate.calibrated = "2025-01-10";
    certificate.valid_until = "2027-01-10";
    certificate.quantities = {"l_S"};
    project.analyses.at(0).certificates = {certificate};
}

std::string test_digest(const std::string& file) {
    return sha256_of(read_file(file).value());
}

struct InventedFolder {
    fs::path folder = test::fresh_folder();
    std::set<std::string> users;
    std::map<std::string, double> U_of_standard;

    /// Saves calibrations of many items by the one standard or by another.
    InventedFolder(int count, const std::string& number) {
        std::mt19937 random(48);
        std::uniform_real_distribution<double> length(50.0002, 50.0005);
        for (int i = 0; i < count; ++i) {
            Project project = gauge_block();
            const bool uses = random() % 3 == 0;
            set_standard(project, uses ? number : "NMI-" + std::to_string(random() % 7), length(random),
                         3e-5);
            const fs::path below = folder / std::to_string(i % 5);
            fs::create_directories(below);
            const fs::path file = below / ("item-" + std::to_string(i) + ".covaria");
            EXPECT_TRUE(save_project(project, file));
            if (uses) users.insert(file.string());
        }
    }

    ImpactQuestion question(const std::string& number, const Project& now) const {
        const fs::path file = test::fresh_folder("new") / "new.covaria";
        EXPECT_TRUE(save_project(now, file));
        ImpactQuestion asked;
        asked.old_figures = number;
        auto figures = new_figures(file.string());
        EXPECT_TRUE(figures);
        asked.figures = *std::move(figures);
        auto files = files_below({folder.string()});
        EXPECT_TRUE(files);
        asked.files = *std::move(files);
        return asked;
    }
};

Project recalibrated(double length, double U) {
    Project project = gauge_block();
    set_standard(project, "K-2026-7", length, U);
    return project;
}

TEST(Impact, IsThatOfBruteForceOverAFolder) {
    const InventedFolder invented(300, "K-2025-114");
    const auto impact = impact_of(invented.question("k-2025-114", recalibrated(50.00035, 8e-5)));
    ASSERT_TRUE(impact);
    EXPECT_EQ(impact->looked_at, 300u);
    EXPECT_TRUE(impact->failures.empty());
    EXPECT_EQ(std::set<std::string>(impact->using_it.begin(), impact->using_it.end()), invented.users);
    ASSERT_EQ(impact->rows.size(), invented.users.size());
    std::size_t turned = 0;
    for (const ImpactRow& row : impact->rows) {
        Project typed = load_project(row.file).project;
        const double was = std::get<double>(quantities_of(typed).rows[0][column_of_value]);
        // The result l_X is l_S and the other terms, which stay; u(l_S) is U/2, and no other u depends on it.
        EXPECT_NEAR(row.change(), 1e-3 * (50.00035 - was), 1e-15);
        const double others = std::pow(row.before.standard_uncertainty, 2) - std::pow(1.5e-8, 2);
        EXPECT_NEAR(row.after.standard_uncertainty, std::sqrt(others + std::pow(4e-8, 2)), 1e-17);
        EXPECT_NEAR(row.change_in_u(), row.change() / row.before.standard_uncertainty, 1e-12);
        EXPECT_NEAR(row.change_in_U(), 0.5 * row.change_in_u(), 1e-12);
        const auto met = [](const ImpactLine& line) {
            return line.estimate + line.expanded_uncertainty <= 0.0500004;
        };
        EXPECT_EQ(row.before.met, met(row.before)) << row.before.stated;
        EXPECT_EQ(row.after.met, met(row.after)) << row.after.stated;
        EXPECT_TRUE(row.is_to_amend());
        turned += row.verdict_changes();
    }
    EXPECT_GT(turned, 0u);
    EXPECT_LT(turned, impact->rows.size());
    for (std::size_t i = 0; i < impact->rows.size(); ++i)
        EXPECT_EQ(impact->rows[i].verdict_changes(), i < turned);
    for (std::size_t i = turned + 1; i < impact->rows.size(); ++i)
        EXPECT_GE(std::max(std::abs(impact->rows[i - 1].change_in_U()),
                           std::abs(impact->rows[i - 1].change_of_U())),
                  std::max(std::abs(impact->rows[i].change_in_U()), std::abs(impact->rows[i].change_of_U())));
}

TEST(Impact, ANewCertificateKnowsNotWhereTheInstrumentStands) {
    Project project = load_project(data_directory() / "projects/tracker-pose.covaria").project;
    const auto tracker = std::ranges::find(project.assets, "spherical-instrument", &AssetEntry::kind);
    ASSERT_NE(tracker, project.assets.end());
    ASSERT_TRUE(tracker->setup.values.contains("station")) << "it stands somewhere";
    AssetCertificate certificate;
    certificate.number = "T-1";
    tracker->certificates = {certificate};
    for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
    InventedFolder nothing(0, "T-1");
    fs::create_directories(nothing.folder);
    ASSERT_TRUE(save_project(project, nothing.folder / "pose.covaria"));
    Project anew = project;
    AssetEntry& other = anew.assets[std::size_t(tracker - project.assets.begin())];
    other.certificates[0].number = "T-2";
    for (const bool elsewhere : {true, false}) {
        if (elsewhere)
            other.setup.values["station"] = PoseValue{.position = {7000.0, -2000.0, 900.0}};
        else
            other.setup.values.erase("station");
        const auto impact = impact_of(nothing.question("T-1", anew));
        ASSERT_TRUE(impact);
        ASSERT_FALSE(impact->rows.empty());
        for (const ImpactRow& row : impact->rows) {
            EXPECT_EQ(row.change(), 0.0) << row.before.stated;
            EXPECT_EQ(row.change_of_U(), 0.0) << row.before.stated;
        }
    }
}

TEST(Impact, IsTheSameForAnyNumberOfThreads) {
    const InventedFolder invented(40, "K-1");
    const ImpactQuestion question = invented.question("K-1", recalibrated(50.0003, 5e-5));
    const auto one = impact_of(question, {.threads = 1}), four = impact_of(question, {.threads = 4});
    ASSERT_TRUE(one && four);
    EXPECT_EQ(to_csv(impact_table(*one)), to_csv(impact_table(*four)));
    EXPECT_FALSE(one->rows.empty());
}

TEST(Impact, TheSameFiguresChangeNothing) {
    const InventedFolder invented(1, "none");
    Project project = gauge_block();
    set_standard(project, "K-1", 50.0003, 3e-5);
    ASSERT_TRUE(save_project(project, invented.folder / "one.covaria"));
    const auto impact = impact_of(invented.question("K-1", recalibrated(50.0003, 3e-5)));
    ASSERT_TRUE(impact);
    ASSERT_EQ(impact->rows.size(), 1u);
    EXPECT_EQ(impact->rows[0].change(), 0.0);
    EXPECT_EQ(impact->rows[0].change_of_U(), 0.0);
    EXPECT_FALSE(impact->rows[0].is_to_amend());
    EXPECT_TRUE(impact->to_amend().empty());
}

TEST(Impact, NamesWhatCannotBeEvaluated) {
    InventedFolder invented(3, "none");
    ASSERT_TRUE(write_file_atomically(invented.folder / "broken.covaria", "{ no project"));
    ASSERT_TRUE(write_file_atomically(invented.folder / "other.pdf", "%PDF-1.4\nbroken"));
    Project other = gauge_block();
    set_standard(other, "K-1", 50.0003, 3e-5);
    quantities_of(other).rows[0][0] = std::string("l_T");
    other.analyses[0].certificates[0].quantities = {"l_T"};
    ASSERT_TRUE(save_project(other, invented.folder / "symbols.covaria"));
    const auto impact = impact_of(invented.question("K-1", recalibrated(50.0003, 3e-5)));
    ASSERT_TRUE(impact);
    std::set<std::string> named;
    for (const ImpactFailure& failure : impact->failures) {
        named.insert(fs::path(failure.file).filename().string());
        EXPECT_FALSE(failure.cause.empty());
    }
    EXPECT_EQ(named, (std::set<std::string>{"broken.covaria", "other.pdf", "symbols.covaria"}));
    EXPECT_TRUE(impact->rows.empty());
    const ReportDocument document = build_impact({"K-1", "new.covaria", {"archive"}}, *impact);
    EXPECT_FALSE(document.blocks.empty());
    EXPECT_FALSE(files_below({(invented.folder / "nowhere").string()}));
}

/// An asset stands for the certificate where none has that number; analyses that do not use it stay out.
TEST(Impact, ReachesTheAnalysesThatUseTheAsset) {
    LoadedProject loaded = load_project(data_directory() / "projects/stewart-platform.covaria");
    Project project = loaded.project;
    for (AnalysisEntry& analysis : project.analyses) {
        analysis.options.method = Method::first_order;
        analysis.studies.clear();
    }
    const fs::path folder = test::fresh_folder(), file = folder / "platform.covaria";
    project.assets[1].certificates = {{.number = "CMM 7"}};
    for (AssetEntry& asset : project.assets)
        for (auto& [key, value] : asset.setup.values)
            if (auto* table = std::get_if<SetupTable>(&value)) table->csv_file.clear();
    ASSERT_TRUE(save_project(project, file));
    ImpactQuestion question;
    question.old_figures = "CMM 7";
    question.files = {file};
    NewFigures figures{"new", {project.assets[1]}, {}};
    figures.assets[0].setup.values["u_cal"] = Quantity{1.0, Unit::of("mm")};
    figures.assets[0].certificates = {{.number = "CMM 8"}};
    question.figures = figures;
    const auto impact = impact_of(question);
    ASSERT_TRUE(impact);
    for (const ImpactFailure& failure : impact->failures) ADD_FAILURE() << failure.cause.english();
    ASSERT_FALSE(impact->rows.empty());
    for (const ImpactRow& row : impact->rows) {
        EXPECT_EQ(row.analysis, "from-artefacts");
        EXPECT_EQ(row.change(), 0.0);
        EXPECT_GT(row.change_of_U(), 0.0);
    }
    const auto changed = with_new_figures(project, holders_of(project, "length-standard"), figures);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->assets[1].certificates.at(0).number, "CMM 8");
    EXPECT_EQ(changed->assets[0], project.assets[0]);
}

TEST(Impact, NamesTheDocumentsThatFollowFromThoseThatChange) {
    const fs::path folder = test::fresh_folder("followers");
    const auto save = [&](const char* name, const std::string& own, const std::string& standard) {
        Project project = gauge_block();
        project.certificate.number = own;
        set_standard(project, standard, 50.0003, 3e-5);
        EXPECT_TRUE(save_project(project, folder / name));
        return (folder / name).string();
    };
    const std::string first = save("a.covaria", "LAB-1", "NMI-1"),
                      second = save("b.covaria", "LAB-2", "lab-1"),
                      third = save("c.covaria", "LAB-3", "LAB-2"),
                      by_file = save("d.covaria", "", test_digest(first)),
                      other = save("e.covaria", "LAB-1b", "NMI-2"),
                      circle = save("f.covaria", "NMI-1", "LAB-3");
    ImpactQuestion question;
    question.old_figures = "NMI-1";
    question.files = files_below({folder.string()}).value();
    const Impact used = impact_of(question).value();
    EXPECT_EQ(used.using_it, std::vector{first});
    const auto files = [](const Impact& impact) {
        std::set<std::string> names;
        for (const ImpactFollower& one : impact.followers) names.insert(one.file);
        return names;
    };
    EXPECT_EQ(files(used), (std::set{second, third, by_file, circle}));
    EXPECT_EQ(used.followers.size(), 4u) << "each once";
    EXPECT_EQ(used.followers.front().of, first);
    EXPECT_EQ(impact_sentences(used).at(1).english(),
              "4 more have figures of a document among these: they follow when it is amended.");

    Project now = gauge_block();
    set_standard(now, "NMI-1b", 50.0003, 3e-5);
    const fs::path file = test::fresh_folder("now") / "now.covaria";
    ASSERT_TRUE(save_project(now, file));
    question.figures = new_figures(file.string()).value();
    EXPECT_TRUE(impact_of(question).value().followers.empty()) << "the figures are those of before";
    set_standard(now, "NMI-1b", 50.0009, 3e-5);
    ASSERT_TRUE(save_project(now, file));
    question.figures = new_figures(file.string()).value();
    EXPECT_EQ(files(impact_of(question).value()), (std::set{second, third, by_file, circle}));
}

}  // namespace
}  // namespace covaria::impact_test
