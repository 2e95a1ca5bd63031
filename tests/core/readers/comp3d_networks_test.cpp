// Networks of Comp3D against its own results, where its examples are beside the checkout, and against
// networks that are computed by hand.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/kinds/registries.h"
#include "core/readers/comp3d_site.h"
#include "tests/core/readers/adjusted_import.h"
#include "tests/fresh_folder.h"

namespace covaria::readers_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path examples = "/work/shared/formats/comp3d";

json results_of(const std::string& example) {
    const std::string text = read_file(examples / example / "ex_ref.comp").value_or("");
    return json::parse(text.substr(std::min(text.find('{'), text.size())), nullptr, false);
}

/// Holds coordinates, sigma 0, redundancy and standard deviations against those of Comp3D.
void hold(const std::string& example, const std::string& file, double printed, double of_sigma0 = 1e-6) {
    SCOPED_TRACE(example + "/" + file);
    const AdjustedImport here = adjusted(import(examples / example / file));
    const json results = results_of(example);
    ASSERT_TRUE(results.is_object());
    const json& computed = results["computation"];
    EXPECT_EQ(here.degrees_of_freedom,
              computed["nbr_active_obs"].get<int>() - computed["nbr_parameters"].get<int>())
        << here.found;
    const double sigma0 = computed["sigma_0_final"].get<double>();
    EXPECT_NEAR(here.s0, sigma0, of_sigma0 * sigma0);
    std::size_t held = 0;
    for (const auto& [name, point] : results["points"].items())
        for (const auto& [key, parameter] : point["params"].items()) {
            const std::size_t axis = std::string("xyz").find(key.back());
            if (key.size() != name.size() + 2 || axis == std::string::npos) continue;
            if (name.starts_with("axe"))
                continue;  // a point on an axis, where ours has the middle of a circle
            ASSERT_TRUE(here.estimate.contains(key)) << key << "\n" << here.found;
            EXPECT_NEAR(here.estimate.at(key), point["coord_compensated_georef"][axis].get<double>(), printed)
                << key;
            ++held;
            if (parameter.contains("sigma") && parameter["sigma"].is_number()) {
                const double sigma = parameter["sigma"].get<double>();
                EXPECT_NEAR(here.u.at(key) * here.s0, sigma, 1e-4 * sigma) << key;
            }
        }
    EXPECT_GT(held, 0u);
}

class Comp3dExamples : public testing::Test {
    void SetUp() override {
        if (!fs::exists(examples)) GTEST_SKIP() << "the examples of Comp3D are not beside the checkout";
    }
};

TEST_F(Comp3dExamples, AgreeWithItsOwnResults) {
    for (const char* file : {"obs.obs", "ex_ref.comp"}) {
        hold("simple2D", file, 1e-7);
        hold("centering", file, 1e-7);
        hold("corcov", file, 1e-7);
    }
    for (const char* file : {"ex.obs", "ex_ref.comp"}) hold("minimal", file, 1e-7);
    // It prints 0.1 mm there, and ends its search where sigma 0 changes by less than 1e-3: ours is less.
    hold("axe", "obs.obs", 5e-6, 1e-3);
}

TEST_F(Comp3dExamples, WithNothingToAdjustAreQuantities) {
    const auto fixed = import(examples / "fixed_points/obs.obs");
    ASSERT_TRUE(fixed);
    EXPECT_EQ(errors_of(*fixed), "");
    EXPECT_NE(all_found(*fixed).find("would change none of its points"), std::string::npos)
        << all_found(*fixed);
}

/// A sphere with points over the plane that touches it at (0, 0), written without the code under test.
struct Sphere {
    double radius = 6380935.2757568145;
    static Eigen::Vector3d unit(double radius, double e, double n) {
        const double rho = std::hypot(e, n), c = 2.0 * std::atan2(rho, 2.0 * radius);
        if (rho == 0.0) return Eigen::Vector3d::UnitZ();
        return {std::sin(c) * e / rho, std::sin(c) * n / rho, std::cos(c)};
    }
    Eigen::Vector3d place(const Eigen::Vector3d& p, double up = 0.0) const {
        return (radius + p.z() + up) * unit(radius, p.x(), p.y());
    }
    /// East, north, up of an instrument at p.
    Eigen::Matrix3d axes(const Eigen::Vector3d& p) const {
        const double d = 100.0;
        Eigen::Matrix3d axes;
        axes.col(2) = unit(radius, p.x(), p.y());
        axes.col(0) = (unit(radius, p.x() + d, p.y()) - unit(radius, p.x() - d, p.y())).normalized();
        axes.col(1) = axes.col(2).cross(axes.col(0)).normalized();
        axes.col(0) = axes.col(1).cross(axes.col(2));
        return axes;
    }
    Eigen::Vector3d seen(const Eigen::Vector3d& from, double hi, const Eigen::Vector3d& to, double ht) const {
        return axes(from).transpose() * (place(to, ht) - place(from, hi));
    }
};

const std::map<std::string, Eigen::Vector3d> hillside{
    {"S1", {10.0, 20.0, 812.0}},    {"S2", {420.0, 35.0, 790.0}},  {"S3", {230.0, -380.0, 861.0}},
    {"P1", {150.0, -120.0, 830.0}}, {"P2", {310.0, 160.0, 905.0}}, {"P3", {-140.0, -90.0, 779.0}}};

std::string line(std::initializer_list<std::string> words) {
    std::string all;
    for (const std::string& word : words) all += word + " ";
    return all + "\n";
}
std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9f", value);
    return text;
}

/// What stations read of each other and of the points, without errors: two rounds, the second turned.
std::string readings_of(const std::string& station, double hi) {
    const Sphere sphere;
    const double gon = 200.0 / std::numbers::pi, k = 0.12;
    std::string text;
    for (const double turn : {37.0, 218.0}) {
        bool first = true;
        for (const auto& [name, p] : hillside) {
            if (name == station) continue;
            const double ht = name == "P2" ? 0.0 : 1.3;
            const Eigen::Vector3d v = sphere.seen(hillside.at(station), hi, p, ht);
            const double zenith =
                std::atan2(v.head<2>().norm(), v.z()) - 0.5 * k * v.head<2>().norm() / sphere.radius;
            const std::string heights = number(hi) + " " + number(ht);
            text += line({first ? "7" : "5", station, name, number(std::atan2(v.x(), v.y()) * gon + turn),
                          "0.0006", "0.0005", heights});
            text += line({"6", station, name, number(zenith * gon), "0.001 0", heights});
            text += line({"3", station, name, number(v.norm()), "0.001 0.000001", heights, "* slope"});
            first = false;
        }
    }
    return text;
}

std::string coordinates_of(const std::string& code, const std::string& name, const std::string& rest) {
    const Eigen::Vector3d& p = hillside.at(name);
    return line({code, name, number(p.x()), number(p.y()), number(p.z()), rest});
}

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    ASSERT_TRUE(write_file_atomically(file, text));
}

void expect_hillside(const AdjustedImport& made, double within) {
    for (const auto& [name, p] : hillside)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string key = name + "_" + "xyz"[axis];
            if (!made.estimate.contains(key)) continue;
            EXPECT_NEAR(made.estimate.at(key), p[static_cast<Eigen::Index>(axis)], within) << key;
        }
}

// 860 m above the sphere make 130 ppm: 4 cm in 300 m. Points without coordinates are placed by readings.
TEST(Comp3dNetworks, HeightsOnTheSphereAreReduced) {
    const fs::path folder = test::fresh_folder("comp3d-hillside");
    write(folder / "hill.cor", coordinates_of("1", "S1", "0.001 0.001 0.001") +
                                   coordinates_of("1", "S2", "0 0 0") + coordinates_of("0", "S3", "") +
                                   coordinates_of("0", "P1", "") + "-1 gone * not used\n");
    write(folder / "hill.obs", readings_of("S1", 1.6) +
                                   "@more/rest.obs\n-3 S1 S2 399.0 0.001\n3 S1 S2 399.0 -0.001\n"
                                   "3 S1 gone 12.0 0.001\n");
    write(folder / "more/rest.obs", readings_of("S2", 1.5) + "@third.obs\n");
    write(folder / "more/third.obs", readings_of("S3", 0.0));
    const AdjustedImport made = adjusted(import(folder / "hill.obs"));
    expect_hillside(made, 5e-6);
    EXPECT_TRUE(made.estimate.contains("P3_z")) << made.found;
    EXPECT_LT(made.s0, 0.01);
    for (const char* words :
         {"readings are reduced to the plane", "2 readings are switched off", "'gone' is not to be used",
          "no settings beside it", "refraction coefficient of 0.12"})
        EXPECT_NE(made.found.find(words), std::string::npos) << words << "\n" << made.found;
}

// Coordinates in frames that begin at a point, one level and one that leans; a tracker that leans.
TEST(Comp3dNetworks, OwnFramesAndLeaningInstrumentsAreRead) {
    const fs::path folder = test::fresh_folder("comp3d-frames");
    const Sphere sphere;
    const auto turn = [](double x, double y, double z) {
        return Eigen::Matrix3d(Eigen::AngleAxisd(z, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(y, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(x, Eigen::Vector3d::UnitX()));
    };
    const auto file_of = [&](const std::string& origin, const Eigen::Matrix3d& turned, bool polar,
                             double share) {
        std::string text = "* target and figures\n";
        for (const auto& [name, p] : hillside) {
            if (name == origin) continue;
            const Eigen::Vector3d near = hillside.at(origin) + share * (p - hillside.at(origin));
            const Eigen::Vector3d v = turned * sphere.seen(hillside.at(origin), 0.0, near, 0.0);
            const double gon = 200.0 / std::numbers::pi;
            const std::string target = share < 1.0 ? name + "n" : name;
            if (polar)
                text += line({target, number(std::atan2(v.y(), v.x()) * gon),
                              number(std::atan2(v.z(), v.head<2>().norm()) * gon), number(v.norm()),
                              "0.0005 0.0005 0.000001"});
            else
                text += line({target, number(v.x()), number(v.y()), number(v.z()), "0.001 0.000001"});
        }
        return text;
    };
    std::string cor;
    for (const auto& [name, p] : hillside)
        cor += coordinates_of(name == "S1" || name == "P1" ? "1" : "0", name, "0.001 0.001 0.001");
    write(folder / "f.cor", cor);
    write(folder / "f.obs",
          readings_of("S1", 1.6) +
              "11 S2 @level.xyz 1 * level\n12 S3 @tracker.xyz\n12 P3 @level-tracker.xyz 1\n");
    write(folder / "level.xyz", file_of("S2", turn(0.0, 0.0, 0.7), false, 1.0));
    write(folder / "tracker.xyz", file_of("S3", turn(0.03, -0.02, 2.0), true, 1.0));
    write(folder / "level-tracker.xyz", file_of("P3", turn(0.0, 0.0, -1.1), true, 1.0));
    const AdjustedImport made = adjusted(import(folder / "f.obs"));
    expect_hillside(made, 2e-5);
    EXPECT_LT(made.s0, 0.02) << made.found;
    EXPECT_GT(made.degrees_of_freedom, 40.0);
    write(folder / "f.obs", readings_of("S1", 1.6) + "11 S2 @level.xyz 1\n12 P3 @level-tracker.xyz 1\n");
    const AdjustedImport of_level = adjusted(import(folder / "f.obs"));
    expect_hillside(of_level, 2e-5);
    EXPECT_LT(of_level.s0, 0.05) << of_level.found;
}

TEST(Comp3dNetworks, ConstraintsOfOneCoordinateAndPlanesAreKept) {
    const fs::path folder = test::fresh_folder("comp3d-plane");
    write(folder / "a.cor",
          "7 A 0 0 0 0.001 0.001 1\n9 B 100 0 0 0 -0.001 0\n6 C 60 80 3\n2 D 60.001 0.001 0 0 0.002 0\n");
    write(folder / "a.obs",
          "2 A C 100.001 0.001\n2 B C 89.4427 0.001\n2 A B 100.002 0.001\n8 A C 40.9666 0.002\n"
          "14 C D 0.001 0.001\n15 C D -80.001 0.001\n");
    const AdjustedImport made = adjusted(import(folder / "a.obs"));
    EXPECT_NEAR(made.estimate.at("C_x"), 60.0, 3e-3);
    EXPECT_NEAR(made.estimate.at("B_x"), 100.0, 1e-6) << "fixed beside a y that is not";
    EXPECT_NEAR(made.u.at("B_x"), 1e-7, 1e-9);
    EXPECT_GT(made.u.at("B_y"), 1e-4) << "its constraint is off";
    EXPECT_FALSE(made.estimate.contains("C_z"));
    // Readings 6, coordinates A 2, B 1, D 2; unknowns 8.
    EXPECT_EQ(made.degrees_of_freedom, 3.0) << made.found;
    EXPECT_NE(made.found.find("'B': the constraint of y"), std::string::npos) << made.found;
}

// Four points on a sphere about one that nothing else tells.
TEST(Comp3dNetworks, EqualDistancesOfUnknownLengthAreReadings) {
    const fs::path folder = test::fresh_folder("comp3d-equal");
    write(folder / "a.cor",
          "1 A 10 0 0 0 0 0\n1 B 0 10 0 0 0 0\n1 C -10 0 0 0 0 0\n1 D 0 0 10 0 0 0\n0 M 0.3 -0.2 0.4\n");
    write(folder / "a.obs", "22 @a.eq\n21 @b.eq\n");
    write(folder / "a.eq", "* about M\nM A 0.001\nM B 0.001\nM C 0.001\nM D 0.001\n");
    const AdjustedImport made = adjusted(import(folder / "a.obs"));
    for (const char* axis : {"x", "y", "z"})
        EXPECT_NEAR(made.estimate.at(std::string("M_") + axis), 0.0, 1e-6) << axis << made.found;
    EXPECT_EQ(made.degrees_of_freedom, 0.0);
    EXPECT_NE(made.found.find("2 equal height differences"), std::string::npos) << made.found;
}

TEST(Comp3dNetworks, OnlyFilesWithinTheFolderAreRead) {
    const fs::path folder = test::fresh_folder("comp3d-links"),
                   outside = test::fresh_folder("comp3d-outside");
    write(outside / "secret.obs", "3 A B 5 0.001\n");
    write(folder / "a.cor", "1 A 0 0 0 0 0 0\n3 B 5 0 0 0 0 0.001\n");
    fs::create_symlink(outside / "secret.obs", folder / "link.obs");
    write(folder / "a.obs", "3 A B 5.001 0.001\n8 A B 100 0.01\n@../comp3d-outside/secret.obs\n@" +
                                (outside / "secret.obs").string() + "\n@link.obs\n@none.obs\n");
    const AdjustedImport made = adjusted(import(folder / "a.obs"));
    EXPECT_NEAR(made.estimate.at("B_x"), 5.001, 1e-9);
    for (const char* words :
         {"3 a file that it includes", "4 a file that it includes", "leads out", "6 a file"})
        EXPECT_NE(made.found.find(words), std::string::npos) << words << "\n" << made.found;
    write(folder / "a.obs", "@a.obs\n");
    const auto circle = import(folder / "a.obs");
    ASSERT_FALSE(circle);
    EXPECT_EQ(circle.error().line, 1);
}

TEST(Comp3dNetworks, WhatIsWrongHasAPlaceInTheFileThatIsWrong) {
    const fs::path folder = test::fresh_folder("comp3d-wrong");
    write(folder / "a.cor", "1 A 0 0 0 0 0 0\n0 B 5 0 0\n");
    write(folder / "sub.obs", "\n3 A B x 0.001\n");
    write(folder / "a.obs", "3 A B 5.001 0.001\n@sub.obs\n");
    auto read = import(folder / "a.obs");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().line, 2);
    EXPECT_EQ(read.error().file, "sub.obs");
    write(folder / "b.cor", "0 B 5 0 0\n");
    fs::create_directory(folder / "apart");
    write(folder / "apart/other.cor", "0 Z 5 0 0\n");
    write(folder / "apart/c.obs", "3 A B 5.001 0.001\n");
    read = import(folder / "apart/c.obs");
    ASSERT_TRUE(read);
    EXPECT_NE(all_found(*read).find("nor a single one with its points"), std::string::npos);
    write(folder / "c.obs", "3 A B 5.001 0.001\n");
    read = import(folder / "c.obs");
    ASSERT_TRUE(read);
    EXPECT_NE(all_found(*read).find("nor a single one"), std::string::npos) << all_found(*read);
    EXPECT_EQ(read->analyses.at(0).model, "measurement-equation");
    write(folder / "c.comp",
          "data=\n{\"config\": {\"root_COR_file\": \"b.cor\", "
          "\"root_OBS_file\": \"none.obs\", \"files_unit\": 1}}");
    read = import(folder / "c.comp");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().line, 1);
    EXPECT_FALSE(read_with("comp3d-comp", "data=[1,2", {.file_name = "c.comp"}));
    EXPECT_FALSE(read_with("comp3d-comp", "data={\"config\":3}", {.file_name = "c.comp"}));
}

}  // namespace

}  // namespace covaria::readers_test
