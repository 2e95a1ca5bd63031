#include "viz/vtk/scene_file.h"

#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkGLTFExporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>

#include "viz/vtk/layer_actors.h"
#include "viz/vtk/rendering_log.h"

namespace covaria {

namespace {

using Vector = Eigen::Vector3d;

constexpr std::array written_layers{Layer::frames, Layer::points,  Layer::bodies,
                                    Layer::links,  Layer::vectors, Layer::ellipsoids,
                                    Layer::clouds, Layer::map,     Layer::ellipsoids_before};

struct WrittenActor {
    Layer layer;
    vtkSmartPointer<vtkActor> actor;
};

vtkPolyData* mesh_of(vtkActor* actor) {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
    mapper->Update();
    return mapper->GetInput();
}

/// Actors of the scene relative to `origin`, about which single precision is enough.
std::vector<WrittenActor> actors_in(const Scene& scene, const Vector& origin, ScenePalette palette) {
    std::vector<WrittenActor> actors;
    for (const Layer layer : written_layers)
        for (const detail::LayerActor& made : detail::actors_of(layer, scene, origin, palette))
            if (made.shown != detail::LayerActor::Shown::moving &&
                mesh_of(made.actor)->GetNumberOfPoints() > 0)
                actors.push_back({layer, made.actor});
    return actors;
}

/// Colour of each vertex: the mesh's, else the actor's.
vtkSmartPointer<vtkUnsignedCharArray> colours_of(vtkActor* actor, vtkPolyData* mesh) {
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(4);
    colours->SetNumberOfTuples(mesh->GetNumberOfPoints());
    vtkProperty* property = actor->GetProperty();
    const double* colour = property->GetColor();
    for (int i = 0; i < 3; ++i) colours->FillComponent(i, std::round(255.0 * colour[i]));
    colours->FillComponent(3, std::round(255.0 * property->GetOpacity()));
    if (vtkUnsignedCharArray* mapped = actor->GetMapper()->MapScalars(1.0)) colours->DeepCopy(mapped);
    colours->SetName("colour");
    return colours;
}

/// (x, y, z) becomes (x, z, −y).
vtkSmartPointer<vtkMatrix4x4> y_up() {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    matrix->SetElement(1, 1, 0.0);
    matrix->SetElement(1, 2, 1.0);
    matrix->SetElement(2, 1, -1.0);
    matrix->SetElement(2, 2, 0.0);
    return matrix;
}

bool seen_through(vtkActor* actor) {
    const auto colours = colours_of(actor, mesh_of(actor));
    for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
        if (colours->GetComponent(i, 3) < 255.0) return true;
    return false;
}

/// The text with parts that the exporter leaves out: names of layers, and which colours are blended. Empty:
/// it wrote other meshes.
std::string completed(const std::string& text, const std::vector<WrittenActor>& actors) {
    nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
    if (file.is_discarded() || file["meshes"].size() != actors.size()) return {};
    for (nlohmann::json& node : file["nodes"]) {
        if (!node.contains("mesh")) continue;
        const auto mesh = node["mesh"].get<std::size_t>();
        node["name"] = layer_key(actors.at(mesh).layer);
        if (!seen_through(actors[mesh].actor)) continue;
        for (const nlohmann::json& part : file["meshes"][mesh]["primitives"])
            file["materials"].at(part.at("material").get<std::size_t>())["alphaMode"] = "BLEND";
    }
    return file.dump();
}

std::string gltf_text(const Scene& scene, const std::vector<WrittenActor>& actors, const Vector& origin) {
    vtkNew<vtkRenderer> renderer;
    for (const WrittenActor& written : actors) {
        vtkActor* actor = written.actor;
        actor->AddPosition(origin.x(), origin.y(), origin.z());
        actor->SetUserMatrix(y_up());
        renderer->AddActor(actor);
    }
    const double far = std::max(1e-3, 3.0 * (bounds_of(scene).high - bounds_of(scene).low).norm());
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetFocalPoint(origin.x(), origin.z(), -origin.y());
    camera->SetPosition(origin.x() + far / 2, origin.z() + far / 2, -origin.y() + far / 2);
    camera->SetClippingRange(far / 100, 2 * far);
    vtkNew<vtkGenericOpenGLRenderWindow> window;  // serves as list of renderers; it opens no display
    window->SetSize(1280, 800);
    window->AddRenderer(renderer);
    vtkNew<vtkGLTFExporter> exporter;
    exporter->SetRenderWindow(window);
    exporter->InlineDataOn();
    const std::string text = exporter->WriteToString();
    window->RemoveRenderer(renderer);
    return completed(text, actors);
}

vtkSmartPointer<vtkDoubleArray> uncertainties(vtkIdType count) {
    auto u = vtkSmartPointer<vtkDoubleArray>::New();
    u->SetName("u");
    u->SetNumberOfComponents(3);
    u->SetNumberOfTuples(count);
    u->Fill(std::numeric_limits<double>::quiet_NaN());
    return u;
}

void add_part(vtkAppendPolyData* all, vtkPolyData* part, Layer layer, vtkUnsignedCharArray* colours,
              vtkDoubleArray* u) {
    vtkNew<vtkUnsignedCharArray> layers;
    layers->SetName("layer");
    layers->SetNumberOfTuples(part->GetNumberOfPoints());
    layers->Fill(static_cast<double>(layer));
    part->GetPointData()->Initialize();
    part->GetCellData()->Initialize();
    for (vtkDataArray* array : {static_cast<vtkDataArray*>(colours), static_cast<vtkDataArray*>(layers.Get()),
                                static_cast<vtkDataArray*>(u)})
        part->GetPointData()->AddArray(array);
    all->AddInputData(part);
}

/// The actor's mesh in double precision, in W.
vtkSmartPointer<vtkPolyData> in_world(vtkActor* actor, const Vector& origin) {
    vtkPolyData* mesh = mesh_of(actor);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
    const double* position = actor->GetPosition();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
        double p[3];
        mesh->GetPoint(i, p);
        for (int k = 0; k < 3; ++k) p[k] += position[k] + origin[k];
        points->SetPoint(i, p);
    }
    auto part = vtkSmartPointer<vtkPolyData>::New();
    part->ShallowCopy(mesh);
    part->SetPoints(points);
    return part;
}

/// A vertex for each point.
void add_points(vtkAppendPolyData* all, const Scene& scene) {
    const auto count = static_cast<vtkIdType>(scene.points.size());
    if (count == 0) return;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(4);
    colours->SetNumberOfTuples(count);
    colours->Fill(255);
    const auto u = uncertainties(count);
    for (const ScenePoint& point : scene.points) {
        const vtkIdType id = points->InsertNextPoint(point.item.position.data());
        cells->InsertNextCell(1, &id);
        if (point.item.u) u->SetTuple(id, point.item.u->data());
    }
    vtkNew<vtkPolyData> part;
    part->SetPoints(points);
    part->SetVerts(cells);
    add_part(all, part, Layer::points, colours, u);
}

std::string vtp_text(const Scene& scene, const std::vector<WrittenActor>& actors, const Vector& origin) {
    vtkNew<vtkAppendPolyData> all;
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    add_points(all, scene);
    for (const WrittenActor& written : actors) {
        const auto part = in_world(written.actor, origin);
        const auto colours = colours_of(written.actor, mesh_of(written.actor));
        const auto u = uncertainties(part->GetNumberOfPoints());
        add_part(all, part, written.layer, colours, u);
    }
    all->Update();
    vtkPolyData* mesh = all->GetOutput();
    vtkNew<vtkStringArray> layers;
    layers->SetName("layers");
    for (std::size_t i = 0; i < layer_count; ++i) layers->InsertNextValue(layer_key(static_cast<Layer>(i)));
    vtkNew<vtkDoubleArray> magnification;
    magnification->SetName("magnification");
    magnification->InsertNextValue(scene.magnification);
    mesh->GetFieldData()->AddArray(layers);
    mesh->GetFieldData()->AddArray(magnification);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(mesh);
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
}

}  // namespace

std::optional<SceneFormat> scene_format_of(const std::string& ending) {
    std::string lower = ending;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower == ".gltf") return SceneFormat::gltf;
    if (lower == ".vtp") return SceneFormat::vtp;
    return {};
}

Result<std::string> scene_file_text(const Scene& scene, SceneFormat format, ScenePalette palette) {
    detail::redirect_vtk_messages();
    const std::lock_guard lock(detail::mesh_mutex());
    const SceneBounds bounds = bounds_of(scene);
    const Vector origin = (bounds.low + bounds.high) / 2;
    const std::vector<WrittenActor> actors = actors_in(scene, origin, palette);
    if (actors.empty()) return fail(ErrorCode::bad_input, "the scene is empty: there is nothing to write");
    std::string text =
        format == SceneFormat::gltf ? gltf_text(scene, actors, origin) : vtp_text(scene, actors, origin);
    if (text.empty()) return fail(ErrorCode::io, "VTK could not write the scene");
    return text;
}

}  // namespace covaria
