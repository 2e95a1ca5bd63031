// Relations of features: elementary geometry against numbers worked out by hand, the chain from points over
// features to a frame, and what is refused.
#include <cmath>
#include <numbers>

#include "core/project/project.h"
#include "tests/core/kinds/geometry/geometry_setups.h"
#include "tests/core/made.h"

namespace covaria::geometry_test {
namespace {

using Eigen::Vector3d;

struct Typed {
    std::string name;
    Vector3d p = Vector3d::Zero(), n = Vector3d::Zero();
    double u_mm = 0.0, u_mrad = 0.0;
};

covaria::Setup relations_of(const std::vector<Typed>& features,
                            const std::vector<std::vector<std::string>>& relations) {
    covaria::Setup setup;
    SetupTable stated, wanted;
    const Unit mm = Unit::of("mm"), one;
    stated.units = {one, one, one, mm, mm, mm, one, one, one, mm, Unit::of("mrad")};
    wanted.units.assign(5, one);
    for (const Typed& f : features) {
        std::vector<SetupCell> row{f.name, {}, {}, f.p.x(), f.p.y(), f.p.z(), {}, {}, {}, f.u_mm, f.u_mrad};
        for (int c = 0; c < 3 && f.n.norm() > 0.0; ++c) row[std::size_t(6 + c)] = f.n[c];
        stated.rows.push_back(std::move(row));
    }
    for (const auto& relation : relations) {
        std::vector<SetupCell> row;
        for (const std::string& cell : relation) row.push_back(cell.empty() ? SetupCell() : SetupCell(cell));
        row.resize(5);
        wanted.rows.push_back(std::move(row));
    }
    setup.values["features"] = stated;
    setup.values["relations"] = wanted;
    return setup;
}

std::unique_ptr<MeasurementModel> relations_model(const covaria::Setup& setup, Problems& problems) {
    const ModelDescriptor& d = *find_model("feature-relations");
    check_setup(d.schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, setup), AssetLibrary{}, problems);
}

const std::vector<Typed> features{{"A", {3, 4, 5}},
                                  {"B", {3, 8, 8}},
                                  {"floor", {100, 100, 1}, {0, 0, 2}},
                                  {"wall", {7, 50, 50}, {1, 0, 0}},
                                  {"end", {50, 9, 50}, {0, 1, 0}},
                                  {"axis", {0, 0, 20}, {3, 4, 0}},
                                  {"pole", {10, 0, 0}, {0, 0, 1}}};

TEST(FeatureRelations, ElementaryGeometry) {
    Problems problems;
    const auto model =
        relations_model(relations_of(features, {{"AB", "distance", "A", "B"},
                                                {"h", "from-plane", "A", "floor"},
                                                {"r", "from-line", "A", "axis"},
                                                {"gap", "between-lines", "axis", "pole"},
                                                {"angle", "angle", "axis", "wall"},
                                                {"mid", "middle", "A", "B"},
                                                {"foot", "foot-on-plane", "A", "wall"},
                                                {"on", "foot-on-line", "B", "axis"},
                                                {"through", "line-and-plane", "pole", "floor"},
                                                {"cross", "two-lines", "axis", "pole"},
                                                {"corner", "three-planes", "floor", "wall", "end"},
                                                {"edge", "two-planes", "floor", "wall"}}),
                        problems);
    ASSERT_TRUE(model);
    const Results r = results_of(*model);
    EXPECT_NEAR(r.at("AB.l"), 5e-3, 1e-15);
    EXPECT_NEAR(r.at("h.l"), 4e-3, 1e-15);
    // across: A - axis = (3, 4, -15) lies along (3, 4, 0) and below
    EXPECT_NEAR(r.at("r.l"), 15e-3, 1e-15);
    // the pole's line is 10 from the origin along x: across (3, 4)/5 that is 8
    EXPECT_NEAR(r.at("gap.l"), 8e-3, 1e-15);
    EXPECT_NEAR(r.at("angle.phi"), std::atan2(4.0, 3.0), 1e-15);
    const auto expect_place = [&](const char* name, const Vector3d& p) {
        EXPECT_LT((place_in(r, name) - p).norm(), 1e-12) << name << place_in(r, name).transpose();
    };
    expect_place("mid", {3, 6, 6.5});
    expect_place("foot", {7, 4, 5});
    expect_place("on", {0.6 * 8.2, 0.8 * 8.2, 20});
    expect_place("through", {10, 0, 1});
    expect_place("cross", {(3.6 + 10.0) / 2.0, 2.4, 20});
    expect_place("corner", {7, 9, 1});
    expect_place("edge", {7, 100, 1});
    EXPECT_LT((direction_in(r, "edge") - Vector3d(0, 1, 0)).norm(), 1e-15);
}

TEST(FeatureRelations, FramesAndTilts) {
    const double t = 1e-3;
    Problems problems;
    const auto model = relations_model(relations_of({{"bore", {10, 20, 33}},
                                                     {"face", {0, 0, 30}, {0, 0, 1}},
                                                     {"hole", {10, 60, 31}},
                                                     {"shank", {0, 0, 0}, {2 * t, t, 1}},
                                                     {"down", {0, 0, 0}, {-2 * t, -t, -1}}},
                                                    {{"F", "frame", "bore", "face", "hole"},
                                                     {"G", "frame-on-plane", "bore", "face", "hole"},
                                                     {"T", "tilts", "shank", "face", "hole"},
                                                     {"W", "tilts", "down", "face"}}),
                                       problems);
    ASSERT_TRUE(model);
    const Results r = results_of(*model);
    EXPECT_LT((place_in(r, "F") - Vector3d(10, 20, 33)).norm(), 1e-12);
    EXPECT_LT((place_in(r, "G") - Vector3d(10, 20, 30)).norm(), 1e-12);
    EXPECT_NEAR(r.at("G.gamma"), std::numbers::pi / 2.0, 1e-15);
    EXPECT_NEAR(r.at("G.beta"), 0.0, 1e-15);
    // x points to the hole, seen from the face's place: (10, 60)/sqrt(3700)
    const double c = 10.0 / std::sqrt(3700.0), s = 60.0 / std::sqrt(3700.0);
    EXPECT_NEAR(r.at("T.t_x"), std::atan(2 * t * c + t * s), 1e-15);
    EXPECT_NEAR(r.at("T.t_y"), std::atan(-2 * t * s + t * c), 1e-15);
    EXPECT_NEAR(r.at("W.t_x"), std::atan(2 * t), 1e-15);
    EXPECT_NEAR(r.at("W.t_y"), std::atan(t), 1e-15);
}

TEST(FeatureRelations, TypedUncertaintiesPropagate) {
    Problems problems;
    const auto model =
        relations_model(relations_of({{"A", {0, 0, 0}, Vector3d::Zero(), 0.003},
                                      {"P", {0, 0, 100}, {0, 0, -5}, 0.004, 0.2},
                                      {"Q", {0, 50, 100}, {0, 0, 1}}},
                                     {{"h", "from-plane", "A", "P"}, {"t", "tilts", "P", "Q"}}),
                        problems);
    ASSERT_TRUE(model);
    EvaluationOptions options;
    options.method = Method::first_order;
    const UncertaintyResult result = evaluate(*model, model->inputs(), options).value();
    EXPECT_NEAR(result.outputs[0].first_order.estimate, 0.1, 1e-15);
    EXPECT_NEAR(result.outputs[0].first_order.standard_uncertainty, 5e-6, 1e-15);
    EXPECT_NEAR(result.outputs[1].first_order.standard_uncertainty, 2e-4, 1e-12);
    EXPECT_NEAR(result.outputs[2].first_order.standard_uncertainty, 2e-4, 1e-12);
}

std::string refusal(const std::vector<std::vector<std::string>>& relations) {
    Problems problems;
    EXPECT_FALSE(relations_model(relations_of(features, relations), problems));
    return problems.items().empty() ? "" : problems.items().front().message.english();
}

TEST(FeatureRelations, RefusesWhatHasNoValue) {
    EXPECT_NE(refusal({{"a", "angle", "floor", "pole"}}).find("ask for tilts"), std::string::npos);
    EXPECT_NE(refusal({{"a", "two-lines", "pole", "floor"}}).find("parallel"), std::string::npos);
    EXPECT_NE(refusal({{"a", "line-and-plane", "axis", "floor"}}).find("parallel"), std::string::npos);
    EXPECT_NE(refusal({{"a", "from-plane", "floor", "A"}}).find("no direction"), std::string::npos);
    EXPECT_NE(refusal({{"a", "frame", "A", "floor"}}).find("three features"), std::string::npos);
    EXPECT_NE(refusal({{"a", "distance", "A", "B", "pole"}}).find("leave the third empty"),
              std::string::npos);
    EXPECT_NE(refusal({{"a", "distance", "A", "C"}}).find("no feature 'C'"), std::string::npos);
    EXPECT_NE(refusal({{"a", "frame", "A", "floor", "pole"}}).find("x and z"), std::string::npos);
}

// Points, features and relations in one chain: what the station does is common to all features.
TEST(FeatureRelations, ACommonStationCancelsInDistances) {
    Project project;
    covaria::Setup points = setup_of({{"P", "plane", pla25}, {"Z", "cylinder", cyl24}}, 0.0);
    points.values["u_common_x"] = Quantity{1.0, Unit::of("mm")};
    points.values["u_common_y"] = Quantity{1.0, Unit::of("mm")};
    project.analyses.push_back(
        {.id = "features", .model = "geometry-from-points", .name = "Features", .setup = points});
    covaria::Setup relations = relations_of(
        {Typed{"P"}, Typed{"Z"}}, {{"l", "from-plane", "Z", "P"}, {"at", "line-and-plane", "Z", "P"}});
    for (auto& row : std::get<SetupTable>(relations.values["features"]).rows) {
        row[1] = std::string("features");
        for (std::size_t c = 3; c < row.size(); ++c) row[c] = SetupCell();
    }
    project.analyses.push_back(
        {.id = "relations", .model = "feature-relations", .name = "Relations", .setup = relations});
    project.analyses.back().options.method = Method::first_order;
    Problems problems;
    const auto prepared = made_analysis(project, "relations", problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message.english();
    ASSERT_TRUE(prepared);
    const UncertaintyResult result = run_analysis(*prepared).value();
    const Vector3d n(0.94053335499333179607, -0.20929606987242093331, 0.2675671192073981387),
        p(-1.0044566666666666667, -2.0125733333333333333, 0.0048733333333333333333),
        z(-0.29897486630809583561, -0.20692103722129259813, 0.71421155699545107194);
    EXPECT_NEAR(1e3 * result.outputs[0].first_order.estimate, n.dot(z - p), 1e-12);
    EXPECT_LT(result.outputs[0].first_order.standard_uncertainty, 1e-9);
    EXPECT_GT(result.outputs[1].first_order.standard_uncertainty, 0.9e-3);
}

}  // namespace
}  // namespace covaria::geometry_test
