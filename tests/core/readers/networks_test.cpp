// Points of networks: GNU Gama with its covariance, Comp3D with its codes.
#include <cmath>
#include <map>

#include "core/kinds/registries.h"
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
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 2u);
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
    for (const char* words : {"8 1 points without x and y", "1 observations;", "1 points are to be adjusted",
                              "axes-xy = en", "4 <parameters>", "u_cal is the largest"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    EXPECT_EQ((*reader_for(data("frame.gkf"), "frame.gkf"))->name, "gama");
}

TEST(ReadGama, PlanarNetworksAndLeftHandedFramesAreSaid) {
    const auto read = read_with("gama",
                                "<gama-local><network><points-observations><point id='1' x='1' y='2'/>"
                                "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
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
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

// Two clusters observe A: two results, each with its own uncertainty, none overwrites the other.
TEST(ReadGama, TwoDeterminationsOfAPointAreBothKept) {
    const auto cluster = [](const char* x, const char* variance) {
        return std::string("<coordinates><point id='A' x='") + x + "' y='2'/>" +
               "<cov-mat dim='2' band='0'>" + variance + " 25</cov-mat></coordinates>";
    };
    for (const int determinations : {1, 2, 3}) {
        std::string file =
            "<gama-local><network><points-observations><point id='F' x='7' y='8' fix='xy'/>"
            "<point id='A' x='1' y='2' adj='xy'/>";
        for (int k = 0; k < determinations; ++k)
            file += cluster(("1.0" + std::to_string(k)).c_str(), std::to_string((k + 1) * (k + 1)).c_str());
        const auto read = read_with("gama", file + "</points-observations></network></gama-local>");
        ASSERT_TRUE(read) << read.error().message.english();
        EXPECT_EQ(errors_of(*read), "");
        ASSERT_EQ(read->assets.size(), static_cast<std::size_t>(determinations));
        const UncertaintyResult result = first_order(*read);
        int of_x = 0;
        for (const OutputResult& output : result.outputs) {
            if (output.standard_uncertainty == 0.0 || output.standard_uncertainty > 0.0045) continue;
            const int k = of_x++;
            EXPECT_NEAR(output.estimate, 1.0 + 0.01 * k, 1e-12);
        }
        EXPECT_GE(of_x, 1);
        for (int k = 0; k < determinations; ++k) {
            const auto& rows =
                std::get<SetupTable>(read->assets[static_cast<std::size_t>(k)].setup.values.at("points"))
                    .rows;
            EXPECT_EQ(rows.size(), 2u) << "A and the fixed point";
        }
        EXPECT_EQ(all_found(*read).find("determinations of the same points") != std::string::npos,
                  determinations > 1);
    }
}

TEST(ReadGama, TheTwoSolutionsOfCharamzasBookAreBothKept) {
    const auto read = read_with("gama", data("gama-two-determinations.gkf"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->assets.size(), 2u);
    std::size_t found = 0;
    for (const OutputResult& output : first_order(*read).outputs)
        for (const double x : {1054612.59853, 1054612.59392})
            if (std::abs(output.estimate - x) < 1e-6) {
                ++found;
                EXPECT_NEAR(output.standard_uncertainty,
                            std::sqrt(x > 1054612.595 ? 67.589719 : 24.665067) * 1e-3, 1e-9);
            }
    EXPECT_EQ(found, 2u);
}

TEST(ReadGama, ObservationsKeepUnitsDeviationsAndBands) {
    const auto read =
        read_with("gama",
                  "<gama-local><network><points-observations direction-stdev='10' distance-stdev='3 2 1'>"
                  "<point id='A' x='0' y='0'/>"
                  "<obs from='A'><direction to='B' val='12.5'/><distance to='B' val='2000' from_dh='1.6'/>"
                  "<z-angle to='B' val='-0-30-36' stdev='7.2'/><angle bs='B' fs='C' val='99.5'/></obs>"
                  "<vectors><vec from='A' to='B' dx='1' dy='2' dz='3'/>"
                  "<cov-mat dim='3' band='1'>4 1 9 -3 16</cov-mat></vectors>"
                  "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto at = [&](std::size_t row, const char* column) {
        return std::get<double>(cell(schema, analysis.setup, "quantities", row, column));
    };
    EXPECT_DOUBLE_EQ(at(0, "a"), 10e-4) << "0.1 mgon each";
    EXPECT_DOUBLE_EQ(at(1, "a"), 7e-3) << "3 mm + 2 mm/km";
    EXPECT_DOUBLE_EQ(at(2, "value"), -0.51) << "degrees";
    EXPECT_DOUBLE_EQ(at(2, "a"), 0.002);
    EXPECT_EQ(cell(schema, analysis.setup, "quantities", 3, "statement"), SetupCell());
    EXPECT_DOUBLE_EQ(at(6, "a"), 4e-3) << "mm²";
    ASSERT_EQ(analysis.correlations.size(), 2u);
    EXPECT_EQ(analysis.correlations[1].first, "o_6");
    EXPECT_DOUBLE_EQ(analysis.correlations[1].coefficient, -0.25);
}

// The zenith angles tell the face of the directions beside them; both faces lead to the same place.
TEST(ReadGama, ReadingsOfFaceTwoAreTakenAsSuch) {
    const auto read = read_with(
        "gama",
        "<gama-local><network axes-xy='en' angles='left-handed'>"
        "<points-observations direction-stdev='10' distance-stdev='2' zenith-angle-stdev='10'>"
        "<point id='S' x='0' y='0' z='0' fix='xyz'/><point id='B' x='100' y='0' z='0' fix='xyz'/>"
        "<point id='C' adj='xyz'/>"
        "<obs from='S'><direction to='B' val='50'/><z-angle to='B' val='100'/>"
        "<direction to='C' val='0.0020'/><z-angle to='C' val='91.0582'/><s-distance to='C' val='71.4143'/>"
        "<direction to='C' val='199.9980'/><z-angle to='C' val='308.9458'/>"
        "<direction to='B' val='250'/><z-angle to='B' val='300'/></obs>"
        "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    EXPECT_NE(all_found(*read).find("2 directions are of face two"), std::string::npos) << all_found(*read);
    std::map<std::string, double> found;
    for (const OutputResult& output : first_order(*read).outputs)
        found[output.quantity.group + output.quantity.symbol] = output.estimate;
    EXPECT_NEAR(found.at("Cx"), 50.0, 2e-4) << "the mean of both faces";
    EXPECT_NEAR(found.at("Cy"), 50.0, 2e-4);
    EXPECT_NEAR(found.at("Cz"), 10.0, 2e-4);
}

// x east, y north, clockwise directions; C has no coordinates, D has no height, E is not asked for.
TEST(ReadGama, ANetworkIsAnAdjustment) {
    const auto read = read_with(
        "gama",
        "<gama-local><network axes-xy='en' angles='left-handed'>"
        "<points-observations direction-stdev='10' distance-stdev='2 3 1' azimuth-stdev='20'>"
        "<point id='A' x='0' y='0' fix='xy'/><point id='B' x='100' y='0' fix='xy'/>"
        "<point id='C' adj='xy'/><point id='D' x='60.01' y='0.02' adj='XY'/><point id='E' x='1' y='1'/>"
        "<obs from='A'><direction to='B' val='50'/><direction to='C' val='390.96655'/>"
        "<distance to='C' val='100.001'/><distance to='E' val='1.4'/></obs>"
        "<obs from='B'><direction to='A' val='10'/><direction to='C' val='80.48328'/>"
        "<distance to='C' val='89.4437' from_dh='1.5'/></obs>"
        "<obs><angle from='C' bs='A' fs='B' val='-70.48328' stdev='10'/>"
        "<azimuth from='C' to='D' val='200' /><distance from='C' to='D' val='80.001'/></obs>"
        "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    EXPECT_TRUE(read->assets.empty()) << "approximate coordinates are no artefact";
    const AnalysisEntry& analysis = read->analyses[0];
    EXPECT_EQ(analysis.model, "network-adjustment");
    const SetupSchema& schema = find_model(analysis.model)->schema;
    EXPECT_EQ(cell(schema, analysis.setup, "points", 0, "plane"), SetupCell(std::string("fixed")));
    EXPECT_EQ(cell(schema, analysis.setup, "points", 3, "plane"), SetupCell(std::string("datum")));
    EXPECT_EQ(cell(schema, analysis.setup, "points", 3, "height"), SetupCell(std::string("none")));
    EXPECT_DOUBLE_EQ(std::get<double>(cell(schema, analysis.setup, "readings", 2, "u_length")), 2.300003);
    EXPECT_DOUBLE_EQ(std::get<double>(cell(schema, analysis.setup, "readings", 0, "u_angle")), 1e-3);
    EXPECT_NE(all_found(*read).find("an observation of 'E'"), std::string::npos) << all_found(*read);
    std::map<std::string, double> found;
    for (const OutputResult& output : first_order(*read).outputs)
        found[output.quantity.group + output.quantity.symbol] = output.estimate;
    EXPECT_NEAR(found.at("Cx"), 60.0, 2e-3);
    EXPECT_NEAR(found.at("Cy"), 80.0, 2e-3);
    EXPECT_NEAR(found.at("Dx"), 60.0, 4e-3) << "south of C";
    EXPECT_NEAR(found.at("Dy"), 0.0, 4e-3);
}

// Heights with a covariance of those that were observed (Krumm's dynamic network is of this kind).
TEST(ReadGama, ALevellingOnObservedHeightsIsAnAdjustment) {
    const auto read = read_with(
        "gama",
        "<gama-local><network><points-observations><point id='C' adj='z'/>"
        "<height-differences><dh from='A' to='C' val='1.5' stdev='3'/><dh from='B' to='C' val='0.504' "
        "stdev='3'/></height-differences>"
        "<coordinates><point id='A' z='10' adj='z'/><point id='B' z='11' adj='z'/>"
        "<cov-mat dim='2' band='1'>4 2 "
        "4</cov-mat></coordinates></points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const UncertaintyResult result = first_order(*read);
    // The sum by hand: A and B with variances 4, covariance 2, C by two ways: misclosure 4 mm, its variance
    // 4 + 4 - 2*2 + 9 + 9 = 22, of which the way by A has 9 + 4 - 2 = 11.
    for (const OutputResult& output : result.outputs)
        if (output.quantity.group == "C") {
            EXPECT_NEAR(output.estimate, 11.502, 1e-9);
            EXPECT_NEAR(output.standard_uncertainty, std::sqrt(13.0 - 11.0 * 11.0 / 22.0) * 1e-3, 1e-9);
        }
    EXPECT_EQ(result.outputs.size(), 3u);
}

// A blunder of 1.5 m, a height that nothing tells, sections of a levelling that state their lengths.
TEST(ReadGama, GrossReadingsAndWhatNothingTellsAreLeftOutAsGamaDoes) {
    const auto network = [](const std::string& parameters, const std::string& more) {
        return read_with(
            "gama", "<gama-local><network axes-xy='en' angles='left-handed'><parameters " + parameters +
                        "/><points-observations><point id='A' z='10' fix='z'/><point id='B' adj='z'/>"
                        "<point id='C' adj='z'/>" +
                        "<height-differences><dh from='A' to='B' val='1.5' dist='4'/>"
                        "<dh from='B' to='C' val='0.5' dist='1'/><dh from='A' to='C' val='2.003' dist='4'/>" +
                        more + "</height-differences></points-observations></network></gama-local>");
    };
    const auto of_c = [](const Result<Proposals>& read) {
        for (const OutputResult& output : first_order(*read).outputs)
            if (output.quantity.group == "C") return std::pair(output.estimate, output.standard_uncertainty);
        return std::pair(0.0, 0.0);
    };
    const auto plain = network("sigma-apr='2'", "");
    ASSERT_TRUE(plain) << plain.error().message.english();
    // Ways of 5 km and 4 km with 2 mm for 1 km: the mean by their weights.
    EXPECT_NEAR(of_c(plain).first, 10.0 + (2.0 / 5.0 + 2.003 / 4.0) / (1.0 / 5.0 + 1.0 / 4.0), 1e-9);
    EXPECT_NEAR(of_c(plain).second, 2e-3 / std::sqrt(1.0 / 5.0 + 1.0 / 4.0), 1e-9);
    const auto gross = network("sigma-apr='2' tol-abs='500'", "<dh from='A' to='C' val='3.5' dist='4'/>");
    ASSERT_TRUE(gross) << gross.error().message.english();
    EXPECT_EQ(errors_of(*gross), "");
    EXPECT_NEAR(of_c(gross).first, of_c(plain).first, 1e-9) << "the last one is left out";
    EXPECT_NE(all_found(*gross).find("by more than 0.5 m"), std::string::npos) << all_found(*gross);
    const auto kept = network("sigma-apr='2' tol-abs='5000'", "<dh from='A' to='C' val='3.5' dist='4'/>");
    ASSERT_TRUE(kept) << kept.error().message.english();
    EXPECT_GT(of_c(kept).first, of_c(plain).first + 0.1);
    const auto lone = read_with(
        "gama",
        "<gama-local><network axes-xy='en' angles='left-handed'><parameters latitude='50' "
        "sigma-act='apriori'/><points-observations distance-stdev='2' direction-stdev='10'>"
        "<point id='A' x='0' y='0' z='0' fix='xyz'/><point id='B' x='100' y='0' fix='xy' adj='z'/>"
        "<point id='C' adj='xy'/><obs from='A'><direction to='B' val='0'/><direction to='C' val='350'/>"
        "<distance to='C' val='70.71'/></obs><obs from='B'><direction to='C' val='0'/></obs>"
        "</points-observations></network></gama-local>");
    ASSERT_TRUE(lone) << lone.error().message.english();
    EXPECT_EQ(errors_of(*lone), "") << "the height of B is left out, and its lone direction";
    EXPECT_EQ(first_order(*lone).outputs.size(), 3u) << "x, y of C, the orientation at A";
    EXPECT_NE(all_found(*lone).find("latitude: readings are not reduced"), std::string::npos)
        << all_found(*lone);
}

// P is sighted from A by an azimuth, and reads two directions itself: none places it alone.
TEST(ReadGama, AResectionWithASightFromOutsidePlacesItsPoint) {
    const auto read =
        read_with("gama",
                  "<gama-local><network axes-xy='en' angles='left-handed'>"
                  "<points-observations azimuth-stdev='10' direction-stdev='10'>"
                  "<point id='A' x='0' y='0' fix='xy'/><point id='B' x='100' y='0' fix='xy'/>"
                  "<point id='C' x='60' y='-30' fix='xy'/><point id='P' adj='xy'/>"
                  "<obs from='A'><azimuth to='P' val='40.96655'/></obs>"
                  "<obs from='P'><direction to='B' val='0'/><direction to='C' val='29.51672'/></obs>"
                  "</points-observations></network></gama-local>");
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    for (const OutputResult& output : first_order(*read).outputs) {
        if (output.quantity.symbol == "x") {
            EXPECT_NEAR(output.estimate, 60.0, 0.01);
        }
        if (output.quantity.symbol == "y") {
            EXPECT_NEAR(output.estimate, 80.0, 0.01);
        }
    }
}

TEST(ReadGama, AdjustedCoordinatesKeepTheirCovariance) {
    const std::string file =
        "<gama-local-adjustment><coordinates><fixed><point><id>A</id><x>1</x><y>2</y></point></fixed>\n"
        "<adjusted><point><id>A</id><z>3</z></point><point><id>B</id><X>4</X><y>5</y></point></adjusted>\n"
        "<cov-mat><dim>4</dim><band>3</band><flt>4</flt><flt>1</flt><flt>0</flt><flt>9</flt><flt>9</flt>"
        "<flt>0</flt><flt>9</flt><flt>1</flt><flt>9</flt><flt>100</flt></cov-mat>"
        "</coordinates></gama-local-adjustment>";
    const auto read = read_with("gama", file);
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    EXPECT_EQ(cell(schema, analysis.setup, "quantities", 2, "a"), SetupCell(2e-3)) << "z of A";
    EXPECT_EQ(cell(schema, analysis.setup, "quantities", 3, "a"), SetupCell(3e-3)) << "x of B";
    ASSERT_EQ(analysis.correlations.size(), 1u) << "the fourth unknown is an orientation";
    EXPECT_DOUBLE_EQ(analysis.correlations[0].coefficient, 1.0 / 6.0);
    const auto wrong = read_with("gama", replaced(file, "<dim>4", "<dim>2"));
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().line, 3);
}

TEST(ReadComp3d, CodesSayWhatIsConstrained) {
    const auto read = read_with("comp3d",
                                "-1 gone\n2 A 1 2 3 0.001 0.002 0.003\n3 B 4 5 6 0.001 0.001 0.004\n"
                                "1 C 7 8 9 0.005 -0.005 0.005 1.5 -2\n0 D 1 1 1 0.5 0.6\n",
                                {.file_name = "a.cor"});
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->analyses.size(), 1u);
    const AnalysisEntry& analysis = read->analyses[0];
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto a = [&](std::size_t row) { return cell(schema, analysis.setup, "quantities", row, "a"); };
    EXPECT_EQ(a(1), SetupCell(0.002));
    EXPECT_EQ(a(5), SetupCell(0.004));
    EXPECT_EQ(a(8), SetupCell(0.005));
    const std::string said = all_found(*read);
    for (const char* words :
         {"1 a point that is not to be used: 'gone'", "4 'C': the constraint of y, which is switched off",
          "deflections of the vertical of 2 points", "1 points are not constrained"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
}

TEST(ReadComp3d, ObservationsAreQuantities) {
    const std::string file =
        "* two stations\n7 A B 0.0 0.001\n5 A C 100.5 0.001 0 1.6 1.5 * with heights\n3 A B 50.0 0.001 "
        "0.0001\n"
        "-4 A B 0.1 0.001\n9 A B 0 -0.02 0.001 0 0\n18 axe @axe.obs\n@more.obs\n";
    const ReadChoice choice{.file_name = "a.obs"};
    const auto read = read_with("comp3d-obs", file, choice);
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const AnalysisEntry& analysis = read->analyses.at(0);
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto at = [&](std::size_t row, const char* column) {
        return cell(schema, analysis.setup, "quantities", row, column);
    };
    EXPECT_EQ(at(1, "unit"), SetupCell(std::string("gon")));
    EXPECT_DOUBLE_EQ(std::get<double>(at(2, "a")), 0.006) << "0.001 m + 0.0001 of the distance";
    EXPECT_EQ(at(3, "a"), SetupCell(0.001)) << "centring in y";
    const std::string said = all_found(*read);
    for (const char* words : {"5 height difference A - B: it is switched off", "x: it is switched off",
                              "7 a file that it includes: '@axe.obs'", "8 a file that it includes"})
        EXPECT_NE(said.find(words), std::string::npos) << words << "\n" << said;
    ASSERT_EQ(read->unstated.size(), 1u);
    ReadChoice degrees = choice;
    degrees.units.emplace("angles", Unit::of("deg"));
    const auto in_degrees = read_with("comp3d-obs", file, degrees);
    ASSERT_TRUE(in_degrees);
    EXPECT_EQ(cell(schema, in_degrees->analyses[0].setup, "quantities", 1, "unit"),
              SetupCell(std::string("deg")));
    degrees.units.insert_or_assign("angles", Unit::of("mm"));
    EXPECT_FALSE(read_with("comp3d-obs", file, degrees));
    const auto wrong = read_with("comp3d-obs", "3 A B 1 0.001\n3 A B x 0.001\n", choice);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().line, 2);
    EXPECT_EQ(wrong.error().message.english(), "column 4: 'x' is not a number");
}

TEST(ReadComp3d, OnlyConstrainedPointsHaveUncertainties) {
    const auto read = read_with("comp3d", data("stations.cor"), {.file_name = "stations.cor"});
    ASSERT_TRUE(read) << read.error().message.english();
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
          {"\n1 A 1 2 3 1\n", "there are 6 columns"}}) {
        const auto read = read_with("comp3d", text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().line, 2) << text;
        EXPECT_NE(read.error().message.english().find(words), std::string::npos)
            << read.error().message.english();
    }
}

}  // namespace

}  // namespace covaria::readers_test
