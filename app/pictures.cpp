#include "app/pictures.h"

#include <algorithm>
#include <cstdio>

#include "app/application.h"
#include "app/chart_picture.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/model/has_layout.h"
#include "core/project/stated_requirements.h"
#include "core/result_files/results_json.h"
#include "viz/scene/analysis_scene.h"
#include "viz/scene/context_meshes.h"
#include "viz/scene/design_scene.h"
#include "viz/scene/saved_camera.h"
#include "viz/scene/section.h"
#include "viz/scene/study_scene.h"
#include "viz/vtk/scene_file.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria {
namespace {

/// Views of the first group of an analysis in the pictures of a run.
const std::vector<std::string> views = {"iso", "top", "front", "right"};

std::string joined(const auto& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

Result<void> check_group(const EvaluatedAnalysis& evaluated, const std::string& group) {
    const std::vector<Name> groups = groups_of(evaluated.analysis->model->outputs());
    if (group.empty() || std::find(groups.begin(), groups.end(), group) != groups.end()) return {};
    return fail(ErrorCode::bad_input,
                "there is no group \"" + group + "\"; the analysis has: " + joined(groups));
}

Result<Scene> scene_of_study(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                             const SceneOptions& options) {
    for (const auto& study : evaluated.studies) {
        if (study->id != request.study) continue;
        StudySceneOptions wanted;
        wanted.ellipsoids = request.ellipsoids;
        const auto quantities = study_quantities(*study);
        std::vector<std::string> titles;
        for (const StudyQuantity& quantity : quantities) titles.push_back("\"" + quantity.id + "\"");
        const auto found =
            std::find_if(quantities.begin(), quantities.end(), [&](const StudyQuantity& quantity) {
                return quantity.id == request.quantity || to_unicode(quantity.title) == request.quantity;
            });
        if (!request.quantity.empty() && found == quantities.end())
            return fail(ErrorCode::bad_input,
                        "the study has no quantity \"" + request.quantity + "\"; it has: " + joined(titles));
        if (found != quantities.end()) wanted.quantity = static_cast<std::size_t>(found - quantities.begin());
        return study_scene(*evaluated.analysis, *study, wanted, options);
    }
    return fail(ErrorCode::not_found, "the analysis has no study \"" + request.study + "\"");
}

Result<Scene> scene_of_design(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                              const SceneOptions& options) {
    for (const auto& design : evaluated.designs) {
        if (design->id != request.design) continue;
        if (!stands_in_space(*design))
            return fail(ErrorCode::bad_input, "nothing that design \"" + request.design +
                                                  "\" has found stands in space: there is no picture of it");
        return design_scene(*design, options);
    }
    return fail(ErrorCode::not_found, "the analysis has no design \"" + request.design + "\"");
}

// Limits of sizes: either takes some 3 GB while a picture is drawn, the whole picture at once in either case.
constexpr std::int64_t most_fine_pixels = 9'000'000, most_pixels = 36'000'000;

Result<void> render_to(SceneRenderer& renderer, const std::filesystem::path& file,
                       RenderQuality quality = RenderQuality::fine) {
    const auto image = renderer.render(quality);
    if (!image) return fail(image.error());
    return write_png(*image, file);
}

Result<void> write_scene(const Scene& scene, SceneFormat format, bool dark,
                         const std::filesystem::path& file) {
    const auto text = scene_file_text(scene, format, dark ? ScenePalette::dark : ScenePalette::light);
    if (!text) return fail(text.error());
    if (auto written = write_file_atomically(file, *text); !written) return written;
    if (!scene.caption.empty()) std::printf("lengths in m; %s\n", scene.caption.c_str());
    return {};
}

void take_section(const PictureRequest& request, Scene& scene) {
    if (!request.section) return;
    SectionPlane plane = request.section->plane;
    if (request.section->in_middle) plane.at = middle_section(scene, plane.axis, {}).at;
    scene.section = plane;
}

void look(SceneRenderer& renderer, const PictureRequest& request) {
    if (request.saved) {
        renderer.set_camera(camera_of(*request.saved, {request.width, request.height}));
        renderer.set_perspective(request.perspective.value_or(request.saved->perspective));
        return;
    }
    renderer.set_perspective(request.perspective.value_or(false));
    renderer.set_view(*standard_view_from(request.view));
}

}  // namespace

Result<Scene> scene_of(const EvaluatedAnalysis& evaluated, const PictureRequest& request) {
    if (auto known = check_group(evaluated, request.group); !known) return fail(known.error());
    SceneOptions options;
    options.group = request.group;
    options.context = request.context;
    options.verdicts = request.verdicts;
    options.units = evaluated.analysis->style.units;
    options.magnification = request.magnification;
    options.probability =
        request.probability > 0 ? request.probability : evaluated.analysis->options.coverage_probability;
    if (!request.design.empty()) return scene_of_design(evaluated, request, options);
    if (!request.study.empty()) return scene_of_study(evaluated, request, options);
    return analysis_scene(*evaluated.analysis, evaluated.result.get(), options,
                          evaluated.before ? &evaluated.before->comparison : nullptr);
}

Result<void> write_picture(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                           const std::filesystem::path& file) {
    const std::int64_t pixels = std::int64_t{request.width} * request.height;
    if (pixels > most_pixels)
        return fail(ErrorCode::usage, "a picture of " + std::to_string(request.width) + " x " +
                                          std::to_string(request.height) +
                                          " pixels is too large: at most 36 million, such as 8000 x 4500");
    if (!request.saved && !standard_view_from(request.view))
        return fail(ErrorCode::bad_input,
                    "there is no view \"" + request.view + "\"; there are: " + joined(standard_view_names()));
    const auto format = scene_format_of(file.extension().string());
    if (request.study.empty() && request.design.empty() &&
        !has_layout(*evaluated.analysis->model, evaluated.analysis->inputs)) {
        if (!format) return write_chart(evaluated, request, file);
        return fail(ErrorCode::bad_input, "analysis " + evaluated.analysis->id +
                                              " has no scene, only a chart: write it as PNG (-o FILE.png)");
    }
    auto scene = scene_of(evaluated, request);
    if (!scene) return fail(scene.error());
    if (request.saved) scene = visible_part(*std::move(scene), visibility_of(*request.saved));
    if (format && request.section)
        return fail(ErrorCode::usage, "a section is one of a picture: write it as PNG (-o FILE.png)");
    if (format) return write_scene(*scene, *format, request.dark, file);
    SceneRenderer renderer;
    renderer.set_size(request.width, request.height);
    renderer.set_palette(request.dark ? ScenePalette::dark : ScenePalette::light);
    take_section(request, *scene);
    renderer.set_scene(std::move(*scene));
    look(renderer, request);
    return render_to(renderer, file, pixels > most_fine_pixels ? RenderQuality::full : RenderQuality::fine);
}

std::vector<PlannedPicture> planned_pictures(const std::vector<EvaluatedAnalysis>& analyses) {
    std::vector<PlannedPicture> pictures;
    FileNames names;
    const auto add = [&](PlannedPicture picture, const std::vector<std::string>& parts) {
        std::string stem;
        for (const std::string& part : parts) stem += part.empty() ? "" : (stem.empty() ? "" : "-") + part;
        picture.file = names.unique(stem, ".png");
        pictures.push_back(std::move(picture));
    };
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        const PreparedAnalysis& analysis = *analyses[i].analysis;
        if (!has_layout(*analysis.model, analysis.inputs)) {
            const auto& outputs = analyses[i].result->outputs;
            for (std::size_t j = 0; j < outputs.size(); ++j) {
                const OutputQuantity& quantity = outputs[j].quantity;
                add({i, quantity.group, {}, j, {}},
                    {analysis.id, file_name_part(quantity.symbol), file_name_part(quantity.group)});
            }
            continue;
        }
        const std::vector<Name> groups = groups_of(analysis.model->outputs());
        for (const std::string& group : groups)
            for (const std::string& view : group == groups.front() ? views : std::vector<std::string>{"iso"})
                add({i, group, view, {}, {}}, {analysis.id, file_name_part(group), view});
    }
    return pictures;
}

ResultFile listed(const PlannedPicture& picture, const std::vector<EvaluatedAnalysis>& analyses) {
    const EvaluatedAnalysis& evaluated = analyses[picture.analysis];
    ResultFile file{picture.file, {{"analysis", evaluated.analysis->id}}};
    if (picture.output)
        file.of.emplace_back("output", evaluated.result->outputs[*picture.output].quantity.symbol);
    if (!picture.group.empty()) file.of.emplace_back("group", picture.group);
    if (!picture.view.empty()) file.of.emplace_back("view", picture.view);
    return file;
}

Result<void> write_pictures(const std::filesystem::path& folder,
                            const std::vector<EvaluatedAnalysis>& analyses,
                            const std::vector<PlannedPicture>& pictures, const MadeProject& made,
                            const std::stop_token& stop) {
    const std::vector<LayoutMesh> context = context_meshes(made);
    std::unique_ptr<QApplication> application;
    SceneRenderer renderer;
    const PlannedPicture* drawn = nullptr;  // the renderer has its scene
    for (const PlannedPicture& picture : pictures) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "stopped while drawing pictures");
        const EvaluatedAnalysis& evaluated = analyses[picture.analysis];
        if (picture.output) {
            if (!application) application = make_application(Platform::offscreen);
            if (auto written = write_chart_of(evaluated, *picture.output, folder / picture.file); !written)
                return written;
            continue;
        }
        if (!drawn || drawn->analysis != picture.analysis || drawn->group != picture.group) {
            PictureRequest request;
            request.group = picture.group;
            request.context = context;
            request.verdicts = judge(*evaluated.result, made.project(), evaluated.analysis->id);
            auto scene = scene_of(evaluated, request);
            if (!scene) return fail(scene.error());
            renderer.set_size(request.width, request.height);
            renderer.set_scene(std::move(*scene));
            drawn = &picture;
        }
        renderer.set_view(*standard_view_from(picture.view));
        if (auto written = render_to(renderer, folder / picture.file); !written) return written;
    }
    return {};
}

}  // namespace covaria
