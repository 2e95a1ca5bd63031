// The applicability of figures: dates against a count of days of its own, ranges, the users of certificates,
// the count of assumed figures; none of it influences a number.
#include "core/made/applicability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/project/project_file.h"

namespace covaria::applicability_test {
namespace {

/// A date, whose days are counted by the Julian day number (Fliegel and Van Flandern 1968).
struct Day {
    int year, month, day;
    int count() const {
        const int a = (14 - month) / 12, y = year + 4800 - a, m = month + 12 * a - 3;
        return day + (153 * m + 2) / 5 + 365 * y + y / 4 - y / 100 + y / 400;
    }
    std::string text() const {
        char digits[] = "0000-00-00";
        int y = year;
        for (int i = 3; i >= 0; --i, y /= 10) digits[i] = static_cast<char>('0' + y % 10);
        digits[5] = static_cast<char>('0' + month / 10), digits[6] = static_cast<char>('0' + month % 10);
        digits[8] = static_cast<char>('0' + day / 10), digits[9] = static_cast<char>('0' + day % 10);
        return digits;
    }
};

TEST(Applicability, OfTenThousandRandomDatesIsThatOfCountedDays) {
    std::mt19937 random(17025);
    const auto pick = [&](int from, int to) { return from + int(random() % unsigned(to - from + 1)); };
    // The dates are close together, so that all verdicts and equal days come often.
    const auto day = [&] { return Day{pick(2023, 2025), pick(1, 12), pick(1, 28)}; };
    std::array<int, 4> counts{};
    for (int trial = 0; trial < 10'000; ++trial) {
        AssetCertificate certificate;
        const bool is_sheet = random() % 5 == 0;
        certificate.kind = is_sheet ? FiguresFrom::data_sheet : FiguresFrom::certificate;
        std::optional<Day> begins, until, first, last;
        if (random() % 6) certificate.calibrated = (begins = day())->text();
        if (random() % 6) certificate.valid_until = (until = day())->text();
        std::string measured;
        if (random() % 6) {
            first = last = day();
            measured = first->text();
            if (const Day other = day(); random() % 2 && first->count() <= other.count()) {
                last = other;
                measured += "/" + other.text();
            }
        }
        auto expected = Applicability::applicable;
        if (!until && !is_sheet) expected = Applicability::unknown;
        if (!first && (begins || until || !is_sheet)) expected = Applicability::unknown;
        if (first && begins && first->count() < begins->count()) expected = Applicability::outside;
        if (last && until && last->count() > until->count()) expected = Applicability::expired;
        const ApplicabilityVerdict verdict = applicable_at(certificate, measured);
        ASSERT_EQ(verdict.verdict, expected)
            << measured << ", " << certificate.calibrated << ", " << certificate.valid_until;
        EXPECT_EQ(verdict.reasons.empty(), expected == Applicability::applicable);
        ++counts[std::size_t(expected)];
    }
    for (const int count : counts) EXPECT_GT(count, 500);
}

Project platform() {
    LoadedProject loaded = load_project(data_directory() / "projects/stewart-platform.covaria");
    EXPECT_FALSE(loaded.problems.has_errors());
    return loaded.project;
}

AssetCertificate in_date() {
    return {.number = "C 1", .calibrated = "2025-01-10", .valid_until = "2027-01-10"};
}

std::vector<CertificateUse> uses_in(const Project& project, const std::string& analysis) {
    return figures_used(*MadeProject::make(project), analysis).certificates;
}

TEST(Applicability, CountsWhatIsAssumed) {
    Project project = platform();
    const FiguresUsed before = figures_used(*MadeProject::make(project), "from-artefacts");
    EXPECT_EQ(before.assets, 2u);
    EXPECT_EQ(before.assumed, (std::vector<std::string>{"2D artefact", "Length standard"}));
    project.assets[0].certificates = {in_date()};
    const FiguresUsed now = figures_used(*MadeProject::make(project), "from-artefacts");
    EXPECT_EQ(now.assumed, (std::vector<std::string>{"Length standard"}));
    ASSERT_EQ(now.certificates.size(), 1u);
    EXPECT_EQ(now.certificates[0].path, "/assets/0/certificates/0");
    EXPECT_EQ(figures_used(*MadeProject::make(project), "printed").assets, 0u);
}

TEST(Applicability, CountsStatedQuantitiesThatNoCertificateCovers) {
    Project project = load_project(data_directory() / "projects/certificate-gauge-block.covaria").project;
    const std::string id = project.analyses[0].id;
    const auto used = [&] { return figures_used(*MadeProject::make(project), id); };
    EXPECT_EQ(used().stated, 0u) << "nobody names certificates here";
    AssetCertificate certificate;
    certificate.number = "NMI 2025-3321";
    certificate.quantities = {"l_S"};
    project.analyses[0].certificates = {certificate};
    // L is a constant; all others have an uncertainty of Type B
    const FiguresUsed some = used();
    EXPECT_EQ(some.stated, 9u);
    EXPECT_EQ(some.assumed_quantities.size(), 8u);
    EXPECT_EQ(std::ranges::count(some.assumed_quantities, "l_S"), 0);
    EXPECT_EQ(std::ranges::count(some.assumed_quantities, "alpha"), 1);
    project.analyses[0].certificates[0].quantities.clear();
    EXPECT_TRUE(used().assumed_quantities.empty()) << "it covers all that is stated";
}

TEST(Applicability, TakesTheDateOfTheAnalysisOrOfTheCertificate) {
    Project project = platform();
    project.assets[0].certificates = {in_date()};
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::unknown);
    project.certificate.calibrated = "2026-03-01";
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::applicable);
    project.analyses[1].measured = "2027-01-09/2027-01-11";
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::expired);
    const auto made = MadeProject::make(project);
    const Problems problems = made->problems();
    const auto said = std::find_if(problems.items().begin(), problems.items().end(),
                                   [](const Problem& p) { return p.path == "/assets/0/certificates/0"; });
    ASSERT_NE(said, problems.items().end());
    EXPECT_EQ(said->severity, Severity::warning);
    EXPECT_EQ(said->message.english(),
              "certificate C 1: expired: it was valid until 2027-01-10, and the measurement is of "
              "2027-01-09/2027-01-11");
    EXPECT_FALSE(made->warnings_of("from-artefacts").empty());
}

TEST(Applicability, HoldsRangesAgainstWhatIsTyped) {
    Project project = platform();
    project.certificate.calibrated = "2026-03-01";
    project.assets[1].certificates = {in_date()};
    auto& ranges = project.assets[1].certificates[0].ranges;
    const Quantity low{1.0, Unit::of("m")}, high{1.2, Unit::of("m")};
    ranges = {{"length", low, high}};
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::applicable);
    ranges = {{"length", low, Quantity{1119.8, Unit::of("mm")}}};
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::outside);
    ranges = {{"humidity", low, {}}};
    EXPECT_EQ(uses_in(project, "from-artefacts")[0].verdict.verdict, Applicability::unknown);
}

TEST(Applicability, OfAnAnalysisIsOfItsOwnQuantities) {
    Project project = load_project(data_directory() / "projects/certificate-gauge-block.covaria").project;
    AssetCertificate certificate = in_date();
    certificate.ranges = {{"L", Quantity{0.5, Unit::of("mm")}, Quantity{100.0, Unit::of("mm")}}};
    project.analyses[0].certificates = {certificate};
    EXPECT_EQ(uses_in(project, "length")[0].verdict.verdict, Applicability::applicable);
    project.analyses[0].certificates[0].ranges[0].highest = Quantity{49.0, Unit::of("mm")};
    EXPECT_EQ(uses_in(project, "length")[0].verdict.verdict, Applicability::outside);
}

TEST(Applicability, InfluencesNoNumberAndKeepsItsBytes) {
    Project project = platform();
    const std::string before = fingerprint(project);
    AssetCertificate full = in_date();
    full.kind = FiguresFrom::report;
    full.edition = "2";
    full.issuer = "Laboratory X";
    full.issued = "2025-01-12";
    full.conditions = "in still air";
    full.file = "c1.pdf";
    full.digest = std::string(64, 'a');
    full.ranges = {{"temperature", Quantity{19.0, Unit::of("degC")}, Quantity{21.0, Unit::of("degC")}}};
    full.quantities = {"l_S"};
    project.assets[0].certificates = {full, {}};
    project.analyses[0].measured = "2026-01-01";
    project.analyses[0].certificates = {full};
    EXPECT_EQ(fingerprint(project), before);
    const std::string text = project_text(project);
    const ReadProject back = read_project(text, project.directory, "back.covaria");
    ASSERT_TRUE(back.is_project);
    EXPECT_FALSE(back.problems.has_errors());
    EXPECT_EQ(back.project.assets[0].certificates, project.assets[0].certificates);
    EXPECT_EQ(back.project.analyses[0].certificates, project.analyses[0].certificates);
    EXPECT_EQ(project_text(back.project), text);
}

TEST(Applicability, RefusesWhatIsNoDateOrRange) {
    Project project = platform();
    AssetCertificate wrong = in_date();
    wrong.valid_until = "10.01.2027";
    wrong.digest = "abc";
    wrong.ranges = {{"L", {}, {}}, {"L", Quantity{2.0, Unit::of("m")}, Quantity{1.0, Unit::of("m")}}};
    project.assets[0].certificates = {wrong};
    project.analyses[0].measured = "yesterday";
    const Problems problems = MadeProject::make(project)->problems();
    for (const char* path : {"/assets/0/certificates/0/validUntil", "/assets/0/certificates/0/digest",
                             "/assets/0/certificates/0/ranges/0", "/assets/0/certificates/0/ranges/1/highest",
                             "/analyses/0/measured"})
        EXPECT_TRUE(std::any_of(problems.items().begin(), problems.items().end(), [&](const Problem& p) {
            return p.path == path && p.severity == Severity::error;
        })) << path;
}

}  // namespace
}  // namespace covaria::applicability_test
