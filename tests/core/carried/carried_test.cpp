// The project and results that a report carries, taken out of it again: they are the same; others are named.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/carried/carried_check.h"
#include "core/carried/carried_project.h"
#include "core/carried/report_data.h"
#include "core/project/release.h"
#include "tests/core/writers/evaluated.h"
#include "tests/fresh_folder.h"

namespace covaria::carried_test {

namespace {

namespace fs = std::filesystem;
using writers_test::Evaluated;

const AttachedFile* find(const std::vector<AttachedFile>& files, const std::string& name) {
    for (const AttachedFile& file : files)
        if (file.name == name) return &file;
    return nullptr;
}

AttachedFile& file_in(std::vector<AttachedFile>& files, const std::string& name) {
    for (AttachedFile& file : files)
        if (file.name == name) return file;
    throw std::out_of_range(name);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

std::vector<AttachedFile> data_of(const Evaluated& evaluated) {
    return report_data({*evaluated.made, evaluated.analyses, {}});
}

Evaluated shipped(const std::string& name) {
    return writers_test::evaluate(writers_test::loaded(data_directory() / "projects" / name));
}

std::string all_messages(const Problems& problems) {
    std::string all;
    for (const Problem& problem : problems.items())
        all += problem.path + ": " + problem.message.english() + "\n";
    return all;
}

std::string all_of(const Comparison& comparison) {
    std::string all;
    for (const std::string& difference : comparison.differences) all += difference + "\n";
    return all;
}

using test::fresh_folder;

TEST(Carried, ProjectsWithTheirFilesGiveTheSameBits) {
    for (const char* name :
         {"stewart-platform.covaria", "force-moment-sensor.covaria", "lsm-network.covaria"}) {
        const Evaluated evaluated = shipped(name);
        const std::vector<AttachedFile> files = data_of(evaluated);
        ASSERT_TRUE(find(files, carried::project) && find(files, carried::results)) << name;
        EXPECT_FALSE(find(files, carried::certificate)) << name << " has no complete certificate";
        const LoadedProject back = load_carried("report.pdf", files);
        for (const Problem& problem : back.problems.items())
            EXPECT_NE(problem.severity, Severity::error) << problem.message.english();
        ASSERT_TRUE(back.made) << name;
        EXPECT_EQ(fingerprint(back.project), fingerprint(evaluated.made->project())) << name;
        const std::vector<AttachedFile> again = data_of(writers_test::evaluate(back.project));
        const Comparison comparison = compare_carried(files, again);
        EXPECT_TRUE(comparison.same()) << name << "\n" << all_of(comparison);
        EXPECT_EQ(find(files, carried::results)->bytes, find(again, carried::results)->bytes) << name;
    }
    EXPECT_TRUE(find(data_of(shipped("force-moment-sensor.covaria")), "force-moment-sensor.csv"));
}

TEST(Carried, ACsvFileThatHasChangedSinceStandsInTheProject) {
    const fs::path folder = fresh_folder("changed");
    for (const char* name : {"force-moment-sensor.covaria", "force-moment-sensor.csv"})
        fs::copy_file(data_directory() / "projects" / name, folder / name);
    const Evaluated evaluated =
        writers_test::evaluate(writers_test::loaded(folder / "force-moment-sensor.covaria"));
    std::string csv = read_file(folder / "force-moment-sensor.csv").value();
    csv.resize(csv.rfind('\n', csv.size() - 2) + 1);
    ASSERT_TRUE(write_file_atomically(folder / "force-moment-sensor.csv", csv));
    const std::vector<AttachedFile> files = data_of(evaluated);
    EXPECT_FALSE(find(files, "force-moment-sensor.csv"));
    const LoadedProject back = load_carried("report.pdf", files);
    ASSERT_FALSE(back.problems.has_errors());
    EXPECT_EQ(fingerprint(back.project), fingerprint(evaluated.made->project()));
}

TEST(Carried, WhatWasKeptInTheProjectIsNotSentWithIt) {
    Project project = writers_test::loaded(data_directory() / "projects/stewart-platform.covaria");
    const Evaluated plain = writers_test::evaluate(project);
    put_kept(project.kept, state_to_keep(project, project.analyses.front().id, "2026-11-20T09:30:00Z"));
    const Evaluated evaluated = writers_test::evaluate(project);
    EXPECT_EQ(find(data_of(evaluated), carried::project)->bytes,
              find(data_of(plain), carried::project)->bytes);
}

/// The projects have CSV files, meshes, and a logo that is not beside them.
TEST(Carried, WhatWasReleasedIsWhatIsCarried) {
    for (const char* name :
         {"stewart-platform.covaria", "force-moment-sensor.covaria", "certificate-gauge-block.covaria"}) {
        Project project = writers_test::loaded(data_directory() / "projects" / name);
        for (AnalysisEntry& analysis : project.analyses) analysis.options.method = Method::first_order;
        for (AnalysisEntry& analysis : project.analyses) analysis.options.trials = 0;
        project.certificate.logo = "/nowhere/logo.png";
        put_kept(project.kept, state_to_keep(project, project.analyses.front().id, "2026-11-20T09:30:00Z"));
        for (const ReviewStepField& step : review_steps())
            project.review.*step.member = {"A. Ames", "2026-11-28"};
        ASSERT_TRUE(release(project));
        const LoadedProject back = load_carried("report.pdf", data_of(writers_test::evaluate(project)));
        EXPECT_EQ(release_status(back.project).state, ReleaseState::released)
            << name << ": " << list_of_changes(release_status(back.project));
        EXPECT_EQ(back.project.review, project.review);
    }
}

/// Eight bytes say that it is a PNG file; nobody draws it here.
TEST(Carried, TheLogoOfTheCertificateLiesBesideTheProject) {
    const fs::path folder = fresh_folder("logo");
    const std::string png = "\x89PNG\r\n\x1a\n and what follows";
    fs::create_directories(folder / "pictures");
    ASSERT_TRUE(write_file_atomically(folder / "pictures/logo.png", png));
    Project project = writers_test::loaded(data_directory() / "projects/gum/h1-end-gauge.covaria");
    project.directory = folder;
    const auto carried_logo = [&](const std::string& name) {
        project.certificate.logo = name;
        std::vector<AttachedFile> files = data_of(writers_test::evaluate(project));
        const LoadedProject back = load_carried("report.pdf", files);
        EXPECT_FALSE(back.problems.has_errors()) << all_messages(back.problems);
        const AttachedFile* logo = find(files, "pictures/logo.png");
        if (logo) {
            EXPECT_EQ(logo->bytes, png);
        }
        EXPECT_EQ(logo != nullptr, !back.project.certificate.logo.empty()) << name;
        return back.project.certificate.logo;
    };
    EXPECT_EQ(carried_logo("pictures/logo.png"), "pictures/logo.png");
    EXPECT_EQ(carried_logo((folder / "pictures/logo.png").string()), "") << "it lies elsewhere for others";
    EXPECT_EQ(carried_logo("pictures/none.png"), "");
}

TEST(Carried, MeshesOfTheSceneLieBesideTheProject) {
    const fs::path folder = fresh_folder("mesh");
    ASSERT_TRUE(write_file_atomically(folder / "cell.stl", "solid s\nendsolid s"));
    Project project = writers_test::loaded(data_directory() / "projects/gum/h1-end-gauge.covaria");
    project.directory = folder;
    for (const std::string& file : {std::string("cell.stl"), (folder / "cell.stl").string()}) {
        AssetEntry cell{file == "cell.stl" ? "beside" : "elsewhere", "context-mesh", "Cell", {}, {}};
        cell.setup.values["file"] = file;
        project.assets.push_back(cell);
    }
    const std::vector<AttachedFile> files = data_of(writers_test::evaluate(project));
    const AttachedFile* mesh = find(files, "cell.stl");
    ASSERT_NE(mesh, nullptr);
    EXPECT_EQ(mesh->mime, "model/stl");
    EXPECT_EQ(std::ranges::count(files, "model/stl", &AttachedFile::mime), 1);
    EXPECT_FALSE(load_carried("report.pdf", files).problems.has_errors());
}

TEST(Carried, WhatDiffersIsNamed) {
    const Evaluated evaluated = shipped("lsm-network.covaria");
    const std::vector<AttachedFile> files = data_of(evaluated);
    std::vector<AttachedFile> changed = files;
    const std::string id = evaluated.analyses[0].analysis->id;
    std::string& results = file_in(changed, carried::results).bytes;
    replace(results, "\"standardUncertainty\": ", "\"standardUncertainty\": 1");
    Comparison comparison = compare_carried(changed, files);
    ASSERT_EQ(comparison.differences.size(), 1u) << all_of(comparison);
    for (const std::string& part : {"analysis " + id + ", output ", std::string("standardUncertainty: "),
                                    std::string(" is "), std::string(" now")})
        EXPECT_NE(comparison.differences[0].find(part), std::string::npos) << comparison.differences[0];
    changed = files;
    std::string& budget = file_in(changed, id + "-budget.csv").bytes;
    budget.insert(budget.rfind('\n', budget.size() - 2) + 1, "x");
    comparison = compare_carried(changed, files);
    ASSERT_EQ(comparison.differences.size(), 1u) << all_of(comparison);
    EXPECT_NE(comparison.differences[0].find(id + "-budget.csv, line "), std::string::npos);
    EXPECT_NE(comparison.differences[0].find("column group"), std::string::npos) << comparison.differences[0];
    changed = files;
    replace(file_in(changed, carried::results).bytes, "\"covariaVersion\": \"", "\"covariaVersion\": \"9");
    EXPECT_TRUE(compare_carried(changed, files).same()) << "the version is said, not compared";
    EXPECT_EQ(carried_results(changed)->version.front(), '9');
    EXPECT_EQ(carried_results(files)->analyses.size(), evaluated.analyses.size());
    file_in(changed, carried::results).bytes = std::string(1'000'000, '[');
    EXPECT_FALSE(carried_results(changed));
    EXPECT_FALSE(compare_carried(changed, files).same());
    EXPECT_FALSE(compare_carried({}, files).same());
}

TEST(Carried, NamesThatLeaveTheFolderAreRefused) {
    const std::vector<AttachedFile> files = data_of(shipped("lsm-network.covaria"));
    const fs::path beside = fresh_folder("beside") / "covaria-escaped.csv";
    fs::remove(beside);
    for (const std::string& name :
         {std::string("../covaria-escaped.csv"), beside.string(), std::string("a/../../covaria-escaped.csv"),
          std::string("..\\covaria-escaped.csv"), std::string(), std::string(".."), std::string("a/"),
          std::string("a\0b", 3)}) {
        std::vector<AttachedFile> hostile = files;
        hostile.push_back({name, "x", "", "", AttachedAs::data});
        const LoadedProject loaded = load_carried("report.pdf", hostile);
        EXPECT_TRUE(loaded.problems.has_errors()) << name;
        EXPECT_NE(first_error(loaded.problems, "").english().find("would leave its folder"),
                  std::string::npos)
            << name;
        EXPECT_FALSE(loaded.made);
        EXPECT_FALSE(fs::exists(beside)) << name;
    }
    std::vector<AttachedFile> in_the_way = files;
    in_the_way.push_back({"project.covaria/x", "x", "", "", AttachedAs::data});
    EXPECT_TRUE(load_carried("report.pdf", in_the_way).problems.has_errors());
}

TEST(Carried, ReportsWithoutAProjectAreRefusedByName) {
    const fs::path folder = fresh_folder("none");
    ASSERT_TRUE(write_file_atomically(folder / "text.pdf", "no PDF"));
    ASSERT_TRUE(write_file_atomically(folder / "broken.pdf", "%PDF-1.4\n"));
    for (const auto& [name, words] : {std::pair("text.pdf", "it is no PDF"),
                                      {"broken.pdf", "the PDF cannot be read"},
                                      {"none.pdf", ""}}) {
        const auto files = carried_files(folder / name);
        ASSERT_FALSE(files) << name;
        EXPECT_NE(files.error().message.english().find(words), std::string::npos)
            << files.error().message.english();
        EXPECT_TRUE(load_carried(folder / name).problems.has_errors());
    }
}

}  // namespace

}  // namespace covaria::carried_test
