// A released project is what was released until something of it changes: any digit makes it a draft, and the
// change is named.
#include "core/project/release.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/base/file_io.h"
#include "core/project/linked_files.h"
#include "core/project/object_reader.h"
#include "core/project/project_file.h"
#include "tests/core/shipped_projects.h"

namespace covaria::release_test {
namespace {

using Pointer = Json::json_pointer;

void release_by(Project& project) {
    project.review.prepared = {"A. Ames", "2026-11-26"};
    project.review.checked = {"B. Bell", "2026-11-27"};
    project.review.released = {"C. Cole", "2026-11-28"};
    const auto done = release(project);
    EXPECT_TRUE(done) << done.error().message.english();
}

/// A project that lies in itself, as a report carries it.
Project shipped(const std::filesystem::path& file) {
    const auto text = read_file(file);
    EXPECT_TRUE(text) << file;
    Project project = read_project(*text, file.parent_path(), file.string()).project;
    unlink_tables(project);
    return project;
}

Project gauge() {
    return shipped(data_directory() / "projects/conformity-micrometer.covaria");
}

std::string changes_of(const Project& project) {
    return list_of_changes(release_status(project)).english();
}

void find_numbers(const Json& json, const Pointer& at, std::vector<Pointer>& found) {
    if (json.is_number()) found.push_back(at);
    if (json.is_object())
        for (const auto& [key, value] : json.items())
            if (key != "views") find_numbers(value, at / key, found);
    if (json.is_array())
        for (std::size_t i = 0; i < json.size(); ++i) find_numbers(json[i], at / i, found);
}

/// Another number that differs in one of its last digits.
Json another(const Json& number) {
    if (number.is_number_integer()) return number.get<std::int64_t>() + 1;
    return number.get<double>() * (1.0 + 1e-9);
}

/// Changes every number of a project, or a thousand of many, one by one.
class EveryNumber : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(EveryNumber, ChangedInOneDigitMakesADraftOfAReleasedProject) {
    Project project = shipped(GetParam());
    release_by(project);
    const std::string text = project_text(project);
    EXPECT_EQ(release_status(read_project(text, {}, "again").project).state, ReleaseState::released);
    const Json whole = Json::parse(text);
    std::vector<Pointer> numbers;
    for (const char* list : {"/assets", "/analyses"})
        if (const Pointer at(list); whole.contains(at)) find_numbers(whole[at], at, numbers);
    std::mt19937_64 order(17);
    std::shuffle(numbers.begin(), numbers.end(), order);
    const std::size_t most = text.size() > 100'000 ? 5 : 25;
    if (numbers.size() > most) numbers.resize(most);
    for (const Pointer& at : numbers) {
        Json changed = whole;
        changed[at] = another(changed[at]);
        const ReadProject read = read_project(changed.dump(), {}, "changed");
        if (project_text(read.project) == text) continue;  // a number that cannot be read leaves a default
        const ReleaseStatus status = release_status(read.project);
        EXPECT_EQ(status.state, ReleaseState::changed) << at.to_string();
        EXPECT_EQ(status.changes.size(), 1u) << at.to_string() << ": " << list_of_changes(status).english();
    }
}
INSTANTIATE_TEST_SUITE_P(Release, EveryNumber, testing::ValuesIn(shipped_projects()), test_name_of);

TEST(Release, NamesWhatChanged) {
    Project released = gauge();
    released.certificate.logo = "logo.png";
    release_by(released);
    ASSERT_EQ(release_status(released).state, ReleaseState::released);
    const std::string analysis = "analysis '" + released.analyses[0].name + "'";
    const auto after = [&](const auto& edit) {
        Project project = released;
        edit(project);
        return changes_of(project);
    };
    EXPECT_EQ(after([](Project& p) { p.title += "."; }), "the title");
    EXPECT_EQ(after([](Project& p) { p.author += "."; }), "the author");
    EXPECT_EQ(after([](Project& p) { p.certificate.customer += "."; }), "the texts of the certificate");
    EXPECT_EQ(after([](Project& p) { p.certificate.logo = "other.png"; }), "the texts of the certificate");
    EXPECT_EQ(after([](Project& p) { p.report.annex = !p.report.annex; }), "what goes into the report");
    EXPECT_EQ(after([](Project& p) { p.results.style.digits = 5; }), "how results are stated");
    EXPECT_EQ(after([](Project& p) { p.review.checked.name = "D. Dale"; }),
              "the names and dates of the review");
    EXPECT_EQ(after([](Project& p) { p.analyses[0].options.seed += 1; }), analysis);
    EXPECT_EQ(after([](Project& p) { p.analyses[0].requirements.clear(); }),
              "texts, requirements or designs of " + analysis);
    EXPECT_EQ(after([](Project& p) {
                  p.title = "x";
                  p.analyses[0].options.trials += 1;
              }),
              "the title, " + analysis);
    EXPECT_EQ(after([](Project& p) { p.review.digest[3] = p.review.digest[3] == '0' ? '1' : '0'; }),
              "the record of the release");
    const std::string moved = "which assets and analyses there are, or their order";
    EXPECT_EQ(after([](Project& p) {
                  AnalysisEntry copy = p.analyses[0];
                  copy.id = "copy";
                  copy.name = "Copy";
                  p.analyses.push_back(copy);
              }),
              moved + ", analysis 'Copy', which is new");
    EXPECT_EQ(after([](Project& p) { p.analyses.clear(); }),
              moved + ", " + analysis + ", which is no longer there");
}

TEST(Release, WhatNobodyReadsInADocumentLeavesItReleased) {
    Project project = gauge();
    project.certificate.logo = "../elsewhere.png";  // which no report carries
    release_by(project);
    const std::string digest = release_digest(project);
    put_kept(project.kept, state_to_keep(project, project.analyses[0].id, "2026-11-28T10:00:00Z"));
    project.analyses[0].views.push_back({"front", {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, 1, 1, false, {}, {}});
    project.review.log.push_back({"2026-11-29", "A. Ames", "Sent to the customer"});
    project.certificate.logo.clear();
    EXPECT_EQ(release_status(project).state, ReleaseState::released) << changes_of(project);
    EXPECT_EQ(release_digest(project), digest);
    EXPECT_EQ(fingerprint(project), fingerprint(gauge())) << "no number depends on a review";
}

TEST(Release, AsksForAllNamesAndDates) {
    Project project = gauge();
    EXPECT_EQ(release_status(project).state, ReleaseState::unreviewed);
    project.review.prepared = {"A. Ames", "2026-11-26"};
    EXPECT_EQ(release_status(project).state, ReleaseState::draft);
    project.review.released = {"C. Cole", "2026-11-28"};
    EXPECT_FALSE(release(project)) << "nobody checked it";
    project.review.checked = {"B. Bell", "yesterday"};
    EXPECT_FALSE(release(project)) << "nobody knows when";
    EXPECT_TRUE(project.review.digest.empty());
    project.review.checked.date = "2026-11-27";
    ASSERT_TRUE(release(project));
    EXPECT_EQ(project.review.digest.size(), 64u);
    ASSERT_EQ(project.review.log.size(), 1u);
    EXPECT_EQ(project.review.log[0].who, "C. Cole");
    project.title += ".";
    EXPECT_EQ(release_status(project).state, ReleaseState::changed);
    ASSERT_TRUE(release(project)) << "anew";
    EXPECT_EQ(release_status(project).state, ReleaseState::released);
    EXPECT_EQ(project.review.log.size(), 2u);
}

TEST(Review, DatesAreDatesAndInTheirOrder) {
    Problems problems;
    check_review({{"A", "2026-11-26"}, {"B", "2026-11-25"}, {"C", "soon"}, "", {}, {{"26 Nov", "", "x"}}},
                 problems);
    std::string places;
    for (const Problem& problem : problems.items())
        places += problem.path + (problem.severity == Severity::error ? " error\n" : " warning\n");
    EXPECT_EQ(places,
              "/review/checked/date warning\n/review/released/date error\n/review/log/0/date error\n");
}

}  // namespace
}  // namespace covaria::release_test
