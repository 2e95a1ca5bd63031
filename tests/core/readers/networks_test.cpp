// Points of networks: GNU Gama with its covariance, Comp3D with its codes.
#include "core/kinds/models.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

TEST(ReadGama, ObservedCoordinatesKeepTheirCovariance) {
    const auto read = read_with("gama", data("frame.gkf"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    EXPECT_EQ(cell(schema, analysis.setup, "quantities", 3, "value"), SetupCell(10.501))
        << "observed, not approximate";
    EXPECT_EQ(cell(schema, analysis.setup, "quantities", 2, "a"), SetupCell(3e-3))
        << "mm² in the file, m here";
    ASSERT_EQ(analysis.correlations.size(), 3u);
    EXPECT_EQ(analysis.correlations[0].first, "x_1");
    EXPECT_EQ(analysis.correlations[0].second, "y_1");
    EXPECT_DOUBLE_EQ(analysis.correlations[0].coefficient, 0.25);
    EXPECT_DOUBLE_EQ(analysis.correlations[1].coefficient, -0.5) << "y_1 with x_2";
    const std::string said = all_found(*read);
    for (const char* words : {"8 1 points without x and y", "9 1 <obs>", "axes-xy = en", "4 <parameters>",
                              "u_cal is the largest"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ((*reader_for(data("frame.gkf"), "frame.gkf"))->name, "gama");
}

TEST(ReadGama, PlanarNetworksAndLeftHandedFramesAreSaid) {
    const auto read = read_with("gama",
                                "<gama-local><network><points-observations><point id='1' x='1' y='2'/>"
                                "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_NE(all_found(*read).find("1 points have no z: it is taken as 0"), std::string::npos);
    EXPECT_NE(all_found(*read).find("left-handed"), std::string::npos) << all_found(*read);
}

TEST(ReadGama, WhatIsWrongHasAPlace) {
    const std::string file = data("frame.gkf");
    struct Case {
        std::string text;
        int line;
        const char* words;
    };
    for (const Case& c :
         {Case{replaced(file, "dim=\"6\"", "dim=\"5\""), 13, "its dim must be the 6"},
          Case{replaced(file, "band=\"2\"", "band=\"6\""), 13, "its dim must be"},
          Case{replaced(file, "9 0 0", "9 x 0"), 13, "element 3, 4: 'x' is no number"},
          Case{replaced(file, "4 1 0\n", "4 9 0\n"), 13, "no covariance matrix"},
          Case{replaced(file, "9 0 0", "-9 0 0"), 13, "is negative"},
          Case{replaced(file, "x=\"10.5\"", "x=\"10,5\""), 7, "x = '10,5' is no number"},
          Case{replaced(file, "<gama-local", "<!DOCTYPE gama-local>\n<gama-local"), 2, "document type"},
          Case{"<other/>", 1, "no network"}}) {
        const auto read = read_with("gama", c.text);
        ASSERT_FALSE(read) << c.words;
        EXPECT_EQ(read.error().line, c.line) << c.words;
        EXPECT_NE(read.error().message.find(c.words), std::string::npos) << read.error().message;
    }
}

TEST(ReadComp3d, OnlyConstrainedPointsHaveUncertainties) {
    const auto read = read_with("comp3d", data("stations.cor"), {.file_name = "stations.cor"});
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(errors_of(*read), "");
    const std::string said = all_found(*read);
    for (const char* words :
         {"2 a file that it includes: '@more.cor'", "5 standard deviations of 1 points of code 0",
          "2 comments", "1 point without a stated one"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    ASSERT_EQ(read->analyses.size(), 1u);
    EXPECT_EQ((*reader_for(data("stations.cor"), "stations.cor"))->name, "comp3d");
    EXPECT_FALSE(reader_for("Dear reader\n", "letter.cor"));
}

TEST(ReadComp3d, WhatIsWrongHasAPlace) {
    for (const auto& [text, words] :
         {std::pair<const char*, const char*>{"\nX A 1 2 3\n", "column 1: the code"},
          {"\n1 A 1 2\n", "there are 4 columns"},
          {"\n1 A 1 2 x 1 1 1\n", "column 5: 'x' is not a number"},
          {"\n1 A 1 2 3 1 -1 1\n", "column 7: '-1' is negative"}}) {
        const auto read = read_with("comp3d", text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().line, 2) << text;
        EXPECT_NE(read.error().message.find(words), std::string::npos) << read.error().message;
    }
}

}  // namespace

}  // namespace covaria::readers_test
