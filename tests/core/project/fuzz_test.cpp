// Damaged files: never a crash, and never a damaged project without a problem.
#include <gtest/gtest.h>

#include <cstdint>

#include "core/project/csv_table.h"
#include "core/project/json_location.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::fuzz_test {

namespace {

// A small generator of the test's own: the same damage on every machine (Marsaglia, xorshift64).
class Noise {
public:
    std::size_t below(std::size_t limit) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return static_cast<std::size_t>(state_ % limit);
    }

private:
    std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

// A project without errors must save as text that loads as the same project.
void expect_problem_or_project(const std::string& text, const std::string& what) {
    const LoadedProject loaded = parse(text);
    if (loaded.problems.has_errors()) {
        for (const Problem& problem : loaded.problems.items()) {
            EXPECT_FALSE(problem.message.english().empty()) << what;
            EXPECT_EQ(problem.file, "test.covaria") << what;
        }
        return;
    }
    const LoadedProject again = parse(project_text(loaded.project));
    EXPECT_FALSE(again.problems.has_errors()) << what;
    EXPECT_TRUE(again.project == loaded.project) << what;
}

}  // namespace

TEST(Fuzz, TruncatedAtEveryByte) {
    const std::string text = whole_project;
    for (std::size_t size = 0; size < text.size() - 1; ++size) {
        const LoadedProject loaded = parse(text.substr(0, size));
        ASSERT_EQ(loaded.problems.items().size(), 1u) << size;
        const Problem& problem = loaded.problems.items().front();
        const bool said = problem.message.english().find("truncated") != std::string::npos ||
                          problem.message.english() == "the file is empty";
        EXPECT_TRUE(said) << size << ": " << problem.message.english();
    }
}

TEST(Fuzz, FlippedBytes) {
    Noise noise;
    for (int round = 0; round < 4000; ++round) {
        std::string text = whole_project;
        const std::size_t flips = 1 + noise.below(3);
        for (std::size_t i = 0; i < flips; ++i) {
            char& byte = text[noise.below(text.size())];
            byte = static_cast<char>(byte ^ (1 << noise.below(8)));
        }
        expect_problem_or_project(text, "round " + std::to_string(round));
    }
}

TEST(Fuzz, ValuesOfAnotherKind) {
    const std::string others[] = {"null",  "true",        "-1",       "1e300",
                                  "1e999", "-1e999",      "1e-400",   "18446744073709551616",
                                  "\"\"",  "\"\\ud800\"", "\"\xff\"", "\"\\u001b[2J\"",
                                  "[]",    "{}",          "[[]]",     "{\"value\": 1}"};
    const std::string text = whole_project;
    for (std::size_t at = text.find(": "); at != std::string::npos; at = text.find(": ", at + 1)) {
        const std::size_t begin = at + 2;
        if (text[begin] == '{' || text[begin] == '[') continue;
        const std::size_t end =
            text[begin] == '"' ? text.find('"', begin + 1) + 1 : text.find_first_of(",}\n", begin);
        for (const std::string& other : others)
            expect_problem_or_project(std::string(text).replace(begin, end - begin, other),
                                      "byte " + std::to_string(begin) + " " + other);
    }
}

TEST(Fuzz, CsvOfNoise) {
    FieldSpec field{"t", "table", FieldKind::table, "A table."};
    field.columns = {{"a", "a", FieldKind::text}, {"b", "b", FieldKind::number, Unit::of("mm")}};
    const std::string alphabet = "ab,;\t\"\n\r# [m]1.-";
    Noise noise;
    for (int round = 0; round < 20000; ++round) {
        std::string text = "a,b [mm]\n";
        for (std::size_t i = noise.below(40); i > 0; --i) text += alphabet[noise.below(alphabet.size())];
        const auto csv = read_csv(text);
        if (!csv) {
            EXPECT_GT(csv.error().line, 0);
            continue;
        }
        const CsvTable table = table_from_csv(*csv, field);
        EXPECT_EQ(table.lines.size(), table.table.rows.size());
        for (const auto& row : table.table.rows) EXPECT_EQ(row.size(), 2u);
    }
}

TEST(JsonLocations, LinesOfValuesAndOfWhatSurroundsThem) {
    const auto locations = JsonLocations::scan("{\n\"a\": [1,\n 2, {\"b/c\": \n3}],\n\"d\": {}\n}\n");
    ASSERT_TRUE(locations);
    EXPECT_EQ(locations->line("/a"), 2);
    EXPECT_EQ(locations->line("/a/1"), 3);
    EXPECT_EQ(locations->line("/a/2/b~1c"), 4);
    EXPECT_EQ(locations->line("/a/2/none/deeper"), 3);
    EXPECT_EQ(locations->line("/d/x"), 5);
    EXPECT_EQ(locations->line("/none"), 0);
    EXPECT_EQ(locations->line(""), 0);
}

}  // namespace covaria::test::fuzz_test
