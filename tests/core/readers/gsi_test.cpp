// Leica GSI: words of fixed width, units, rounds in two faces against figures computed by hand.
#include <cmath>
#include <numbers>

#include "core/kinds/registries.h"
#include "core/readers/gsi_text.h"
#include "core/readers/rounds.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

constexpr double gon = std::numbers::pi / 200.0;

TEST(ReadGsi, RoundsInTwoFacesBecomeAnInstrumentAndItsTargets) {
    const auto read = read_with("gsi", data("rounds.gsi"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->assets.size(), 1u);
    const AssetEntry& instrument = read->assets[0];
    const auto pose = std::get<PoseValue>(instrument.setup.values.at("station"));
    EXPECT_DOUBLE_EQ(pose.position[0], 10.0);
    EXPECT_DOUBLE_EQ(pose.position[2], 2.5) << "the axes, not the ground point";
    // Means of rounds: distances 10.0001, 10.0005 and 20.0001, 20.0005 m: s = sqrt(2 * 0.4^2 / 2 / 2) mm.
    EXPECT_NEAR(std::get<Quantity>(instrument.setup.values.at("distance_constant")).value,
                std::sqrt(0.08) / std::sqrt(2.0), 1e-6);
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    // T1: Hz 0.0005 and 0.0009 gon from north, V 99.9985 and 99.9991: azimuth from east, anticlockwise.
    EXPECT_NEAR(std::get<double>(cell(schema, analysis.setup, "readings", 0, "azimuth")),
                (100.0 - 0.0007) * gon, 1e-9);
    EXPECT_NEAR(std::get<double>(cell(schema, analysis.setup, "readings", 0, "elevation")), 0.0012 * gon,
                1e-9);
    EXPECT_NEAR(std::get<double>(cell(schema, analysis.setup, "targets", 0, "y")), 30.0003, 1e-6);
    EXPECT_NE(all_found(*read).find("6 words 51 (1)"), std::string::npos) << all_found(*read);
    EXPECT_EQ((*reader_for(data("rounds.gsi"), "a.gsi"))->name, "gsi");
}

TEST(ReadGsi, PooledFiguresByHand) {
    const Rounds rounds = rounds_of({{1, "a", 0.1, 1.0, 5.0},
                                     {2, "b", 0.2, 1.2, 7.0},
                                     {3, "b", 0.2 + std::numbers::pi, 2.0 * std::numbers::pi - 1.2, 7.0},
                                     {4, "a", 0.1 + std::numbers::pi, 2.0 * std::numbers::pi - 1.0, 5.0},
                                     {5, "a", 0.101, 1.0, 5.002},
                                     {6, "b", 0.203, 1.2, 7.0}});
    ASSERT_EQ(rounds.means.size(), 2u);
    EXPECT_EQ(rounds.fewest_rounds, 2u);
    EXPECT_FALSE(rounds.two_faces);
    EXPECT_NEAR(rounds.means[1].azimuth, 0.2015, 1e-12);
    // Residuals -0.5, 0.5 and -1.5, 1.5 mrad less the turn of -1, 1: +-0.5 each.
    EXPECT_EQ(rounds.azimuth.degrees_of_freedom, 1);
    EXPECT_NEAR(rounds.azimuth.s, 1e-3, 1e-12);
    EXPECT_EQ(rounds.distance.degrees_of_freedom, 2);
    EXPECT_NEAR(rounds.distance.s, 1e-3, 1e-12);
    EXPECT_NEAR(rounds.collimation, 0.0, 1e-12);
}

TEST(ReadGsi, UnitsOfAnglesAndLengths) {
    const auto blocks = read_gsi(
        "*110001+00000000000000P1 21.324+0000000035945300 22.323+0000000009000000 31...8+0000000001234567 "
        "87..16-0000000000012000 \n"
        "110002+0000P  2 21.325+16000000 22.322+10000000 31...7+00010000 81..00+00001000 82..01+00001000 "
        "83..06-00010000");
    ASSERT_TRUE(blocks) << blocks.error().message.english();
    ASSERT_EQ(blocks->size(), 2u);
    EXPECT_NEAR(*(*blocks)[0].azimuth, (359.0 + 45.0 / 60.0 + 30.0 / 3600.0) * std::numbers::pi / 180.0,
                1e-12);
    EXPECT_NEAR(*(*blocks)[0].zenith, 0.5 * std::numbers::pi, 1e-12);
    EXPECT_DOUBLE_EQ(*(*blocks)[0].distance, 12.34567);
    EXPECT_DOUBLE_EQ(*(*blocks)[0].target_height, -1.2);
    EXPECT_EQ((*blocks)[1].point, "P 2") << "a name may hold blanks";
    EXPECT_NEAR(*(*blocks)[1].azimuth, 0.5 * std::numbers::pi, 1e-12) << "1600 of 6400 mil";
    EXPECT_DOUBLE_EQ(*(*blocks)[1].distance, 0.3048) << "1/10,000 ft";
    EXPECT_DOUBLE_EQ(*(*blocks)[1].target[1], 0.3048);
    EXPECT_DOUBLE_EQ(*(*blocks)[1].target[2], -1.0);
}

TEST(ReadGsi, FilesWithoutLineEndsAndWithCarriageReturns) {
    const std::string block = "110001+00000A01 81..00+00001000 82..00+00002000 83..00+00003000 ";
    for (const std::string& text : {block + block, "\r" + block + "\r" + block, block + "\r\n" + block}) {
        const auto read = read_with("gsi", text);
        ASSERT_TRUE(read) << read.error().message.english();
        ASSERT_EQ(read->assets.size(), 1u);
        EXPECT_EQ(std::get<SetupTable>(read->assets[0].setup.values.at("points")).rows.size(), 2u);
    }
}

TEST(ReadGsi, ReadingsThatDoNotRepeatAreOnlyPoints) {
    const auto read = read_with("gsi",
                                "110001+00000A01 21.322+00000000 22.322+10000000 31..00+00010000\n"
                                "110001+00000A01 21.322+10000000 22.322+10000000 31..00+00010000\n"
                                "110001+00000A02 21.322+10000000 22.322+10000000 31..00+00000000\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_TRUE(read->analyses.empty());
    EXPECT_EQ(std::get<SetupTable>(read->assets[0].setup.values.at("points")).rows.size(), 2u);
    EXPECT_NE(all_found(*read).find("3 the reading of 'A02'"), std::string::npos) << all_found(*read);
    EXPECT_EQ(errors_of(*read), "");
}

TEST(ReadGsi, WhatIsWrongHasLineAndColumn) {
    struct Case {
        const char* text;
        int line;
        const char* words;
    };
    for (const Case& c :
         {Case{"110001+00000A01 21.322+000x0000 \n", 1, "column 24"},
          Case{"\n110001+00000A01 21.32 \n", 2, "column 17"}, Case{"21.322+00000000 \n", 1, "a block begins"},
          Case{"110001+00000A01 21.320+00000000 \n", 1, "column 22: the unit '0' is none of an angle"},
          Case{"110001+00000A01 31..09+00000000 \n", 1, "none of a length"}}) {
        const auto read = read_with("gsi", c.text);
        ASSERT_FALSE(read) << c.text;
        EXPECT_EQ(read.error().line, c.line) << c.text;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

}  // namespace

}  // namespace covaria::readers_test
