#include "viz/vtk/shading.h"

#include <vtkDataObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace covaria::detail {
namespace {

// The key light in the space of the camera: from the left, from above, from before.
constexpr const char* lit = R"(//VTK::Light::Impl
  float toSky = 0.5 + 0.5 * dot(normalVCVSOutput, toTheSky);
  vec3 toKey = normalize(vec3(-0.5, 0.72, 0.62));
  float facing = max(0.0, dot(normalVCVSOutput, toKey));
  vec3 halfway = normalize(toKey + vec3(0.0, 0.0, 1.0));
  float gloss = 0.1 * pow(max(0.0, dot(normalVCVSOutput, halfway)), 28.0);
  gl_FragData[0] = vec4(diffuseColor * (0.66 * mix(0.66, 1.0, toSky) + 0.4 * facing) + vec3(gloss), opacity);
)";

constexpr const char* clear = R"(//VTK::Light::Impl
  float rim = 1.0 - abs(normalVCVSOutput.z);
  float toSky = 0.5 + 0.5 * dot(normalVCVSOutput, toTheSky);
  vec3 halfway = normalize(normalize(vec3(-0.5, 0.72, 0.62)) + vec3(0.0, 0.0, 1.0));
  float gloss = 0.16 * pow(max(0.0, dot(normalVCVSOutput, halfway)), 12.0);
  float density = opacity * (1.0 + 0.5 * rim * rim + 0.5 * pow(rim, 6.0));
  gl_FragData[0] = vec4(diffuseColor * mix(0.92, 1.06, toSky) + vec3(gloss), min(1.0, density));
  if (!gl_FrontFacing) gl_FragData[0] = vec4(diffuseColor, 0.6 * opacity);
)";

constexpr const char* begin_declared = "//VTK::PositionVC::Dec\nin vec4 begin;\nout vec2 beginOfLine;\n";
constexpr const char* begin_passed = R"(//VTK::PositionVC::Impl
  vec4 beginDC = MCDCMatrix * vec4(begin.xyz, 1.0);
  beginOfLine = beginDC.xy / beginDC.w;
)";
constexpr const char* dash_declared = "//VTK::PositionVC::Dec\nin vec2 beginOfLine;\n";
constexpr const char* dashed = R"(//VTK::Light::Impl
  vec2 fromBegin = gl_FragCoord.xy - (0.5 * beginOfLine + 0.5) * pictureSize.xy;
  if (mod(length(fromBegin), 10.0 * pictureSize.z) > 6.0 * pictureSize.z) discard;
)";

}  // namespace

void shade(vtkActor* actor, Surface surface) {
    vtkShaderProperty* shaders = actor->GetShaderProperty();
    vtkProperty* property = actor->GetProperty();
    if (surface == Surface::dashed) {
        auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper());
        if (!mapper) return;
        mapper->MapDataArrayToVertexAttribute("begin", "begin", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
        shaders->AddVertexShaderReplacement("//VTK::PositionVC::Dec", true, begin_declared, false);
        shaders->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, begin_passed, false);
        shaders->AddFragmentShaderReplacement("//VTK::PositionVC::Dec", true, dash_declared, false);
        shaders->AddFragmentShaderReplacement("//VTK::Light::Impl", true, dashed, false);
    } else {
        property->SetAmbient(0.0);
        property->SetDiffuse(1.0);
        property->SetSpecular(0.0);
        shaders->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                              surface == Surface::matt ? lit : clear, false);
    }
    set_view(actor, surface, {});
}

void set_view(vtkActor* actor, Surface surface, const ShadingView& view) {
    vtkUniforms* uniforms = actor->GetShaderProperty()->GetFragmentCustomUniforms();
    if (surface == Surface::dashed) {
        const float size[] = {static_cast<float>(view.width), static_cast<float>(view.height),
                              static_cast<float>(view.pixels_per_point)};
        uniforms->SetUniform3f("pictureSize", size);
    } else {
        const float up[] = {static_cast<float>(view.up.x()), static_cast<float>(view.up.y()),
                            static_cast<float>(view.up.z())};
        uniforms->SetUniform3f("toTheSky", up);
        if (surface == Surface::clear) actor->GetProperty()->SetBackfaceCulling(!view.is_cut);
    }
}

}  // namespace covaria::detail
