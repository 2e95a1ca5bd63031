// A mesh for context: the robot cell, the part, the fixture, the room.
#include "core/base/in_quotes.h"
#include "core/kinds/context/assets.h"
#include "core/kinds/context/stl.h"
#include "core/setup/fields.h"

namespace covaria {

namespace {

enum class MeshUnit { millimetre, metre, inch };

struct StatedMesh {
    std::string file;
    MeshUnit unit = MeshUnit::millimetre;
    Eigen::Isometry3d X_WM = Eigen::Isometry3d::Identity();
    MeshColour colour = MeshColour::grey;
    double opacity = 0.0;
};

const Fields<StatedMesh>& mesh_fields() {
    using S = StatedMesh;
    static const auto fields = [] {
        Fields<S> made;
        made.section("Mesh")
            .add(&S::file, "file", "STL file",
                 "A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is "
                 "drawn in the scenes of all analyses and influences no number.",
                 {.file_ending = "stl"})
            .choice(&S::unit, "unit", "Unit of the file",
                    "STL files do not say in which unit their numbers are.",
                    {{MeshUnit::millimetre, "mm", "millimetre"},
                     {MeshUnit::metre, "m", "metre"},
                     {MeshUnit::inch, "in", "inch"}},
                    MeshUnit::millimetre)
            .add(&S::X_WM, "placement", "Position and orientation",
                 "Where the origin of the file stands in the world frame, and how its axes are turned.",
                 {.default_value = PoseValue{}})
            .section("Appearance")
            .choice(&S::colour, "colour", "Colour", "Of the surface, on a light and on a dark ground.",
                    {{MeshColour::grey, "grey", "grey"},
                     {MeshColour::blue, "blue", "blue"},
                     {MeshColour::green, "green", "green"},
                     {MeshColour::orange, "orange", "orange"},
                     {MeshColour::red, "red", "red"}},
                    MeshColour::grey)
            .add(&S::opacity, "opacity", "Opacity",
                 "100 % hides what is behind the surface; less lets the measured points be seen.",
                 {.unit = Unit::of("%"),
                  .range = {.low = 0.05, .high = 1.0},
                  .default_value = Quantity{25.0, Unit::of("%")}});
        return made;
    }();
    return fields;
}

class ContextMesh : public Asset {
public:
    explicit ContextMesh(LayoutMesh mesh) : mesh_(std::move(mesh)) {}
    Layout layout() const override {
        Layout layout;
        if (mesh_.triangles) layout.meshes.push_back(mesh_);
        return layout;
    }

private:
    LayoutMesh mesh_;  ///< without triangles: its file could not be read
};

double metres_in(MeshUnit unit) {
    constexpr double metres[] = {1e-3, 1.0, 0.0254};
    return metres[static_cast<std::size_t>(unit)];
}

/// Only a warning: analyses have their numbers without it.
std::unique_ptr<Asset> create_mesh(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    const StatedMesh stated = mesh_fields().read(setup, assets, problems);
    LayoutMesh mesh{.name = "mesh", .X_WM = stated.X_WM};
    mesh.scale = metres_in(stated.unit);
    mesh.colour = stated.colour;
    mesh.opacity = stated.opacity;
    mesh.source.path = mesh_fields().place(&StatedMesh::X_WM);
    if (auto read = mesh_of_file(assets.folder() / stated.file)) {
        mesh.triangles = *std::move(read);
    } else {
        const Error& error = read.error();
        const Message why = error.line > 0 ? tell<"line %1, %2">(error.line, error.message) : error.message;
        problems.warning(mesh_fields().place(&StatedMesh::file),
                         error.code == ErrorCode::bad_input
                             ? tell<"The mesh is not drawn: %1: %2">(in_quotes(stated.file), why)
                             : tell<"The mesh is not drawn: %1">(why));
    }
    return std::make_unique<ContextMesh>(std::move(mesh));
}

}  // namespace

AssetDescriptor context_mesh_kind() {
    AssetDescriptor d;
    d.kind = "context-mesh";
    d.title = "Context mesh";
    d.category = AssetCategory::context;
    d.summary =
        "A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the "
        "scenes of all analyses. It is context only: no number depends on it.";
    d.references = {{"M. Burns: Automated Fabrication, Prentice Hall, 1993, section 6.5 (the STL format)"}};
    d.notes = {"The picture is fitted to what is measured, not to the mesh, which may be a whole hall.",
               "A file that is missing or damaged is warned of; analyses keep their results."};
    d.schema = mesh_fields().schema();
    d.create = create_mesh;
    return d;
}

}  // namespace covaria
