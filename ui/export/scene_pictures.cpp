#include "ui/export/scene_pictures.h"

#include "core/project/stated_requirements.h"
#include "ui/theme/document_language.h"
#include "viz/scene/analysis_scene.h"
#include "viz/scene/context_meshes.h"
#include "viz/scene/design_scene.h"
#include "viz/vtk/scene_fonts.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::ui {
namespace {

/// Width of a figure in units of letters' pixels: at the width of the printed text letters come out at 7
/// points, and the legend still finds room beside the scene.
constexpr double printed_width = 860.0;

Result<Scene> scene_of(const EvaluatedAnalysis& evaluated, const std::string& design,
                       const SceneOptions& options) {
    if (design.empty())
        return analysis_scene(*evaluated.analysis, evaluated.result.get(), options,
                              evaluated.before ? &evaluated.before->comparison : nullptr);
    for (const auto& one : evaluated.designs)
        if (one->id == design) return design_scene(*one, options);
    return fail(ErrorCode::not_found, "the report has no design \"" + design + "\"");
}

}  // namespace

struct ScenePictures::Renderer {
    SceneRenderer renderer;
};

ScenePictures::ScenePictures(const ReportSource& source)
    : made_(source.made),
      analyses_(source.analyses),
      context_(context_meshes(source.made)),
      renderer_(std::make_unique<Renderer>()),
      language_(document_language(source.made.project())) {}

ScenePictures::~ScenePictures() = default;

QImage ScenePictures::render(const SceneBlock& block, QSize size) {
    for (const EvaluatedAnalysis& evaluated : analyses_) {
        if (evaluated.analysis->id != block.analysis) continue;
        SceneOptions options;
        options.group = block.group;
        options.context = context_;
        options.units = evaluated.analysis->style.units;
        options.language = scene_language(language_);
        options.probability = evaluated.result->coverage_probability;
        options.verdicts = judge(*evaluated.result, made_.project(), block.analysis);
        auto scene = scene_of(evaluated, block.design, options);
        if (!scene) {
            problem_ = scene.error().message;
            return {};
        }
        SceneRenderer& renderer = renderer_->renderer;
        renderer.set_size(size.width(), size.height());
        renderer.set_pixel_ratio(size.width() / printed_width);
        renderer.set_scene(std::move(*scene));
        renderer.set_view(standard_view_from(block.view).value_or(StandardView::iso));
        const auto image = renderer.render(RenderQuality::fine);
        if (!image) {
            problem_ = image.error().message;
            return {};
        }
        return QImage(image->rgba.data(), image->width, image->height, image->width * 4,
                      QImage::Format_RGBA8888)
            .copy();
    }
    problem_ = "the report has no analysis \"" + block.analysis + "\"";
    return {};
}

}  // namespace covaria::ui
