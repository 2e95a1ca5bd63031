// Lists of coordinates become features of "geometry from points"; every refusal has its line.
#include "core/kinds/registries.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {
namespace {

TEST(ReadCoordinates, AFileOfNistBecomesItsFeature) {
    const std::string text = data("pla25.ds");
    EXPECT_EQ((*reader_for(text, "pla25.ds"))->name, "coordinates");
    const auto read = read_with("coordinates", text, {.file_name = "pla25.ds"});
    ASSERT_TRUE(read) << read.error().message.english();
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    EXPECT_EQ(cell(schema, analysis.setup, "features", 0, "form"), SetupCell(std::string("plane")));
    EXPECT_EQ(cell(schema, analysis.setup, "points", 5, "z"), SetupCell(0.18796));
    EXPECT_EQ(errors_of(*read), "");
    const UncertaintyResult result = first_order(*read);
    EXPECT_NEAR(result.outputs.at(3).estimate, 0.94053335499333179607, 1e-14);
}

TEST(ReadCoordinates, WhatTheFileDoesNotSayIsSaid) {
    const auto read =
        read_with("coordinates", "3\r\n0,0,0\r\n1;0;0\r\n0\t1\t0\r\nrest\r\n", {.file_name = "scan.txt"});
    ASSERT_TRUE(read) << read.error().message.english();
    const std::string found = all_found(*read);
    EXPECT_NE(found.find("does not say which form"), std::string::npos) << found;
    EXPECT_NE(found.find("taken as mm"), std::string::npos);
    EXPECT_NE(found.find("state their uncertainty"), std::string::npos);
    EXPECT_NE(found.find("5 what stands behind the 3 points"), std::string::npos);
    EXPECT_EQ(errors_of(*read), "");
    const auto metres = read_with("coordinates", "1\n1 2 3\n", {.length_unit = Unit::of("m")});
    ASSERT_TRUE(metres);
    EXPECT_EQ(std::get<SetupTable>(metres->analyses[0].setup.values.at("points")).units[2], Unit::of("m"));
}

TEST(ReadCoordinates, RefusesWithALine) {
    const struct {
        const char* text;
        int line;
        const char* words;
    } cases[] = {{"", 1, "not a number of points"},
                 {"-3\n", 1, "not a number of points"},
                 {"2\n1 2 3\n", 2, "there are 1"},
                 {"2\n1 2 3\n4 5\n", 3, "2 columns"},
                 {"2\n\n1 2 3\n4 x 6\n", 4, "column 2: 'x'"},
                 {"999999999\n", 1, "divide the file"}};
    for (const auto& c : cases) {
        const auto read = read_with("coordinates", c.text);
        ASSERT_FALSE(read) << c.text;
        EXPECT_EQ(read.error().line, c.line) << c.text;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

}  // namespace
}  // namespace covaria::readers_test
