// Tables of points: SpatialAnalyzer's formats, headers, stated columns; what is asked for and what is
// refused.
#include "core/kinds/registries.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

SetupCell point_cell(const AssetEntry& asset, std::size_t row, const std::string& column) {
    return cell(find_asset_kind(asset.kind)->schema, asset.setup, "points", row, column);
}
double u_cal(const AssetEntry& asset, std::size_t axis) {
    return std::get<double>(
        cell(find_asset_kind(asset.kind)->schema, asset.setup, "components", axis, "u_cal"));
}

TEST(ReadPoints, GroupsOfSpatialAnalyzerBecomeArtefacts) {
    const auto read = read_with("spatialanalyzer", data("sa-groups.txt"), {.chosen = true});
    ASSERT_TRUE(read) << read.error().message.english();
    ASSERT_EQ(read->assets.size(), 2u);
    EXPECT_EQ(read->assets[0].name, "Jig");
    EXPECT_EQ(read->assets[1].id, "wall");
    EXPECT_EQ(point_cell(read->assets[0], 1, "x"), SetupCell(1000.5));
    EXPECT_EQ(u_cal(read->assets[0], 2), 0.02);
    EXPECT_EQ(u_cal(read->assets[1], 0), 0.02);
    EXPECT_TRUE(read->analyses.empty()) << "each artefact holds the figures of its points";
    EXPECT_NE(all_found(*read).find("lengths are taken as mm"), std::string::npos);
    EXPECT_EQ(errors_of(*read), "");
}

TEST(ReadPoints, SixNumbersAreUncertaintiesOnlyWhereThatIsSaid) {
    const auto read = read_with("spatialanalyzer", data("sa-groups.txt"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::usage);
    EXPECT_NE(read.error().message.english().find("Ux Uy Uz"), std::string::npos)
        << read.error().message.english();
    for (const char* text : {"1 0 0 0\n", "A 1 2 3 note\n", "A 1 2 3 4\n", "A 1 2 3 4 5 6 7\n"}) {
        const auto other = read_with("spatialanalyzer", text);
        ASSERT_FALSE(other) << text;
        EXPECT_EQ(other.error().code, ErrorCode::usage) << text;
    }
    EXPECT_TRUE(read_with("spatialanalyzer", "1 0 0 0\n", {.chosen = true}));
    EXPECT_TRUE(read_with("spatialanalyzer", "C,G,P,0,0,0\n"));
}

TEST(ReadPoints, HeadersUnitsAndDecimalCommas) {
    const auto read = read_with("points", data("points.csv"));
    ASSERT_TRUE(read) << read.error().message.english();
    ASSERT_EQ(read->assets.size(), 1u);
    EXPECT_EQ(point_cell(read->assets[0], 0, "x"), SetupCell(1.5));
    EXPECT_EQ(std::get<SetupTable>(read->assets[0].setup.values.at("points")).units[1], Unit::of("m"));
    EXPECT_DOUBLE_EQ(u_cal(read->assets[0], 0), 11e-6);
    EXPECT_NE(all_found(*read).find("column 8 'Notes'"), std::string::npos) << all_found(*read);
    EXPECT_NE(all_found(*read).find("1 lines of comment"), std::string::npos) << all_found(*read);
    ASSERT_EQ(read->analyses.size(), 1u) << "the points have uncertainties of their own";
    const AnalysisEntry& analysis = read->analyses[0];
    EXPECT_EQ(cell(find_model(analysis.model)->schema, analysis.setup, "quantities", 3, "a"),
              SetupCell(11e-6));
    EXPECT_EQ(errors_of(*read), "");
}

TEST(ReadPoints, StatedColumnsAndUnit) {
    const auto read = read_with("points", "9 1 2 3 0.2\n",
                                {.length_unit = Unit::of("in"), .columns = {"name", "x", "y", "z", "U"}});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(point_cell(read->assets[0], 0, "name"), SetupCell(std::string("9")));
    EXPECT_EQ(u_cal(read->assets[0], 1), 0.1) << "an expanded uncertainty, k = 2";
    EXPECT_NE(all_found(*read).find("(U, k = 2)"), std::string::npos);
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"x", "y"}, {"x", "y", "z", "x"}, {"x", "y", "z", "Uy"}}) {
        const auto refused = read_with("points", "1 2 3 4\n", {.columns = wrong});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::usage);
    }
}

TEST(ReadPoints, AHeaderThatMayMeanTwoThingsIsAskedFor) {
    const auto read = read_with("points", "name,x,y,z,U_x\na,1,2,3,4\n");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::usage);
    EXPECT_NE(read.error().message.english().find("'U_x' may mean"), std::string::npos)
        << read.error().message.english();
    const auto twice = read_with("points", "name,x,y,z,X\na,1,2,3,4\n");
    ASSERT_FALSE(twice);
    EXPECT_NE(twice.error().message.english().find("columns 2 (x) and 5 (X) are the same"), std::string::npos)
        << twice.error().message.english();
}

TEST(ReadPoints, ErrorsHaveLineAndColumn) {
    struct Case {
        const char* text;
        int line;
        const char* words;
    };
    for (const Case& c :
         {Case{"name,x,y,z\na,1,2,3\nb,1,two,3\n", 3, "column 3: (y) 'two' is not a number"},
          Case{"name,x,y,z\na,1,2\n", 2, "column 4: (z) '' is empty"},
          Case{"name x y z\na 1 2 3\nmy b 1 2 3\n", 3, "is not a number"},
          Case{"name x y z\na 1 2 3 4\n", 2, "instead of 4"},
          Case{"name,x,y,z,u_x\na,1,2,3,-1\n", 2, "must not be negative"},
          Case{"name,x,y,z\na,1,2,1e999\n", 2, "is not a number"},
          Case{"name,x,y,z\n\"a,1,2,3\n", 2, "not closed"}, Case{"name x y z\na\xFF 1 2 3\n", 2, "UTF-8"}}) {
        const auto read = read_with("points", c.text);
        ASSERT_FALSE(read) << c.text;
        EXPECT_EQ(read.error().line, c.line) << c.text;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

TEST(ReadPoints, NamesThatOccurAgainGetANumber) {
    const auto read = read_with("points", "name x y z\na 1 2 3\na 4 5 6\n\"a (2)\" 7 8 9\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    EXPECT_NE(all_found(*read).find("2 names occur again"), std::string::npos) << all_found(*read);
}

TEST(ReadPoints, ManyGroupsAreOneArtefactAndManyPointsHaveNoAnalysis) {
    std::string text = "group,name,x,y,z,u_x\n";
    for (int i = 0; i < 200; ++i) text += "g" + std::to_string(i) + ",p,1,2,3," + std::to_string(i) + "\n";
    const auto read = read_with("points", text);
    ASSERT_TRUE(read) << read.error().message.english();
    ASSERT_EQ(read->assets.size(), 1u);
    EXPECT_EQ(point_cell(read->assets[0], 199, "name"), SetupCell(std::string("g199/p")));
    EXPECT_EQ(u_cal(read->assets[0], 0), 199.0);
    EXPECT_TRUE(read->analyses.empty());
    EXPECT_NE(all_found(*read).find("only up to 100 points"), std::string::npos) << all_found(*read);
}

TEST(ReadPoints, HeadersAsProgramsWriteThem) {
    for (const char* text :
         {"sep=;\nPunktname;X/mm;Y/mm;Z/mm;u(x)/um\nP1;1,5;2,5;3,5;10\n",
          "Jig 7\n\nName\tCoord X (mm)\tY (mm)\tZ (mm)\tsigma x (um)\nP1\t1.5\t2.5\t3.5\t10\n",
          "Point Name,X,Y,Z,Ux\n,mm,mm,mm,um\nP1,1.5,2.5,3.5,10\n",
          "! written by hand\nTarget,X Coordinate [mm],Y Coordinate [mm],Z Coordinate [mm],Std X "
          "[um]\nP1,1.5,2.5,3.5,10\n"}) {
        ASSERT_TRUE(reader_for(text, "a.csv")) << text;
        const auto read = read_with("points", text);
        ASSERT_TRUE(read) << text << read.error().message.english();
        EXPECT_EQ(point_cell(read->assets[0], 0, "name"), SetupCell(std::string("P1"))) << text;
        EXPECT_EQ(point_cell(read->assets[0], 0, "z"), SetupCell(3.5)) << text;
        EXPECT_DOUBLE_EQ(u_cal(read->assets[0], 0), 0.01) << text;
    }
    const auto wrong = read_with("points", "Jig 7\nof May\nName,X,Y,Z\nP1,1,2,q\n");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().line, 4);
}

TEST(ReadPoints, LinesOfColumnsWithoutEndAreRefused) {
    for (const char separator : {',', ' '})
        for (const std::size_t columns : {2000, 300'000}) {
            std::string text = std::string("name") + separator + "x" + separator + "y" + separator + "z";
            for (std::size_t i = 0; i < columns; ++i) text += std::string(1, separator) + "q";
            const auto read = read_with("points", text + "\n");
            ASSERT_FALSE(read);
            EXPECT_NE(read.error().message.english().find("columns"), std::string::npos)
                << read.error().message.english();
        }
}

TEST(ReadSpatialAnalyzer, NamesWithBlanksStandBetweenTabs) {
    const auto read = read_with("spatialanalyzer", "Jig A\tMain Group\tP 1\t1.0\t2.0\t3.0\n");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(point_cell(read->assets[0], 0, "name"), SetupCell(std::string("P 1")));
}

}  // namespace

}  // namespace covaria::readers_test
