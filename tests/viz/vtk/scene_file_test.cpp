// Scenes as glTF and VTP, read in again: positions in metres, colours, what is not in them.
#include "viz/vtk/scene_file.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/viz/stewart_scene.h"

namespace covaria::scene_file_test {
namespace {

using nlohmann::json;
using Vector = Eigen::Vector3d;

Scene stewart(int trials = 500) {
    const auto setup = test::stewart_setup(trials);
    return build_scene(setup.source(), {});
}

/// One ball far from the origin, where single precision would lose it.
Scene ball(const Vector& at) {
    Scene scene;
    scene.size = 1.0;
    ScenePoint point;
    point.item.id = "point:P";
    point.item.position = at;
    point.item.u = Vector(1e-6, 2e-6, 3e-6);
    point.radius = 0.01;
    scene.points.push_back(point);
    return scene;
}

std::string base64_decoded(const std::string& text) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned value = 0, bits = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) break;
        value = value << 6 | static_cast<unsigned>(digit);
        if ((bits += 6) < 8) continue;
        bytes += static_cast<char>(value >> (bits -= 8) & 255u);
    }
    return bytes;
}

/// Vertices of all meshes in the frame of the file, and the colours that stand with them.
struct GltfScene {
    std::vector<Vector> points;
    std::size_t coloured = 0;
    std::map<std::string, bool> blended;  ///< whether some of a layer is

    explicit GltfScene(const std::string& text) {
        const json file = json::parse(text);
        EXPECT_EQ(file.at("asset").at("version"), "2.0");
        for (const json& node : file.at("nodes")) {
            if (!node.contains("mesh")) continue;
            Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
            if (node.contains("matrix"))
                for (int i = 0; i < 16; ++i)
                    X(i % 4, i / 4) = node["matrix"].at(static_cast<std::size_t>(i)).get<double>();
            bool& blend = blended[node.at("name").get<std::string>()];
            for (const json& part : file["meshes"].at(node["mesh"].get<std::size_t>()).at("primitives")) {
                add(file, part.at("attributes").at("POSITION").get<std::size_t>(), X);
                const json& material = file["materials"].at(part.at("material").get<std::size_t>());
                blend = blend || material.value("alphaMode", "OPAQUE") == "BLEND";
                coloured += part.at("attributes").contains("COLOR_0");
            }
        }
    }

private:
    void add(const json& file, std::size_t index, const Eigen::Matrix4d& X) {
        const json& accessor = file.at("accessors").at(index);
        const json& view = file.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        const std::string uri = file.at("buffers").at(view.at("buffer").get<std::size_t>()).at("uri");
        const std::string bytes = base64_decoded(uri.substr(uri.find(',') + 1));
        const std::size_t first = view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u);
        for (std::size_t i = 0; i < accessor.at("count").get<std::size_t>(); ++i) {
            float p[3];
            ASSERT_LE(first + 12 * (i + 1), bytes.size());
            std::memcpy(p, bytes.data() + first + 12 * i, sizeof p);
            points.push_back((X * Eigen::Vector4d(p[0], p[1], p[2], 1.0)).head<3>());
        }
    }
};

vtkSmartPointer<vtkPolyData> vtp_back(const std::string& text) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(text);
    reader->Update();
    return reader->GetOutput();
}

TEST(SceneFile, EndingsChoose) {
    EXPECT_EQ(scene_format_of(".gltf"), SceneFormat::gltf);
    EXPECT_EQ(scene_format_of(".VTP"), SceneFormat::vtp);
    for (const char* picture : {".png", "", ".glb", "gltf"})
        EXPECT_FALSE(scene_format_of(picture)) << picture;
}

TEST(SceneFile, GltfHasABallWhereThePointIs) {
    const Vector at(1234.5, -67.25, 8.125);
    const auto text = scene_file_text(ball(at), SceneFormat::gltf, ScenePalette::light);
    ASSERT_TRUE(text) << text.error().message.english();
    const GltfScene read(*text);
    ASSERT_GT(read.points.size(), 100u);
    EXPECT_GT(read.coloured, 0u);
    const Vector centre(at.x(), at.z(), -at.y());  // y is up
    for (const Vector& p : read.points) EXPECT_NEAR((p - centre).norm(), 0.01, 1e-8);
}

TEST(SceneFile, GltfHasEveryPointOfAScene) {
    const Scene scene = stewart();
    const auto text = scene_file_text(scene, SceneFormat::gltf, ScenePalette::light);
    ASSERT_TRUE(text) << text.error().message.english();
    EXPECT_EQ(*text, *scene_file_text(scene, SceneFormat::gltf, ScenePalette::light));
    const GltfScene read(*text);
    EXPECT_TRUE(read.blended.at("ellipsoids")) << "what is inside is seen";
    EXPECT_FALSE(read.blended.at("points"));
    ASSERT_GT(scene.points.size(), 5u);
    for (const ScenePoint& point : scene.points) {
        const Vector at = point.item.position;
        Vector low = Vector::Constant(1e9), high = Vector::Constant(-1e9);
        std::size_t on_ball = 0;
        for (const Vector& p : read.points) {
            const Vector in_W(p.x(), -p.z(), p.y());
            if (std::abs((in_W - at).norm() - point.radius) > 1e-7) continue;
            low = low.cwiseMin(in_W);
            high = high.cwiseMax(in_W);
            ++on_ball;
        }
        if (point.kind != PointKind::nest) continue;
        EXPECT_GT(on_ball, 100u) << point.item.id;
        EXPECT_LT(((low + high) / 2 - at).norm(), 1e-2 * point.radius) << point.item.id;
    }
}

TEST(SceneFile, VtpHasPointsWithTheirUncertainty) {
    const Scene scene = stewart();
    const auto text = scene_file_text(scene, SceneFormat::vtp, ScenePalette::dark);
    ASSERT_TRUE(text) << text.error().message.english();
    EXPECT_EQ(*text, *scene_file_text(scene, SceneFormat::vtp, ScenePalette::dark));
    const auto mesh = vtp_back(*text);
    auto* u = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray("u"));
    auto* layer = vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetArray("layer"));
    auto* colour = vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetArray("colour"));
    ASSERT_TRUE(u && layer && colour);
    std::size_t known = 0;
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
        const auto id = static_cast<vtkIdType>(i);
        const SceneItem& item = scene.points[i].item;
        EXPECT_EQ(Vector(mesh->GetPoint(id)), item.position) << item.id;
        EXPECT_EQ(layer->GetValue(id), static_cast<int>(Layer::points));
        if (item.u) {
            EXPECT_EQ(Vector(u->GetTuple3(id)), *item.u) << item.id;
        }
        known += item.u.has_value();
    }
    EXPECT_GT(known, 0u);
    EXPECT_DOUBLE_EQ(mesh->GetFieldData()->GetArray("magnification")->GetTuple1(0), scene.magnification);
    std::array<std::size_t, layer_count> vertices{};
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) ++vertices.at(layer->GetValue(i));
    std::size_t trials = 0;
    for (const SceneCloud& cloud : scene.clouds) trials += cloud.size();
    EXPECT_EQ(vertices[static_cast<std::size_t>(Layer::clouds)], trials);  // none twice for moving pictures
    for (const Layer shown : {Layer::frames, Layer::bodies, Layer::ellipsoids})
        EXPECT_GT(vertices[static_cast<std::size_t>(shown)], 0u) << layer_key(shown);
    for (const Layer words : {Layer::labels, Layer::axes, Layer::legend, Layer::wall_histograms})
        EXPECT_EQ(vertices[static_cast<std::size_t>(words)], 0u) << layer_key(words);
}

TEST(SceneFile, VtpFarFromTheOriginKeepsItsDigits) {
    const Vector at(1234.5, -67.25, 8.125);
    const auto text = scene_file_text(ball(at), SceneFormat::vtp, ScenePalette::light);
    ASSERT_TRUE(text) << text.error().message.english();
    const auto mesh = vtp_back(*text);
    ASSERT_GT(mesh->GetNumberOfPoints(), 100);
    for (vtkIdType i = 1; i < mesh->GetNumberOfPoints(); ++i)
        EXPECT_NEAR((Vector(mesh->GetPoint(i)) - at).norm(), 0.01, 1e-8);
}

TEST(SceneFile, AnEmptySceneIsRefused) {
    for (const SceneFormat format : {SceneFormat::gltf, SceneFormat::vtp})
        EXPECT_FALSE(scene_file_text(Scene{}, format, ScenePalette::light));
}

}  // namespace
}  // namespace covaria::scene_file_test
