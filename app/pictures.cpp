#include "app/pictures.h"

#include <algorithm>

#include "app/chart_picture.h"
#include "core/model/has_layout.h"
#include "viz/scene/analysis_scene.h"
#include "viz/scene/study_scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria {
namespace {

const std::vector<std::string> views = {"iso", "top", "front", "right"};

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

Result<void> check_group(const EvaluatedAnalysis& evaluated, const std::string& group) {
    const std::vector<std::string> groups = groups_of(evaluated.analysis->model->outputs());
    if (group.empty() || std::find(groups.begin(), groups.end(), group) != groups.end()) return {};
    return fail(ErrorCode::bad_input,
                "there is no group \"" + group + "\"; the analysis has: " + joined(groups));
}

std::string file_name_part(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    return text;
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
                return quantity.id == request.quantity || quantity.title == request.quantity;
            });
        if (!request.quantity.empty() && found == quantities.end())
            return fail(ErrorCode::bad_input,
                        "the study has no quantity \"" + request.quantity + "\"; it has: " + joined(titles));
        if (found != quantities.end()) wanted.quantity = static_cast<std::size_t>(found - quantities.begin());
        return study_scene(*evaluated.analysis, *study, wanted, options);
    }
    return fail(ErrorCode::not_found, "the analysis has no study \"" + request.study + "\"");
}

Result<void> render_to(SceneRenderer& renderer, const std::string& view, const std::filesystem::path& file) {
    renderer.set_view(*standard_view_from(view));
    const auto image = renderer.render(RenderQuality::fine);
    if (!image) return fail(image.error());
    return write_png(*image, file);
}

}  // namespace

Result<Scene> scene_of(const EvaluatedAnalysis& evaluated, const PictureRequest& request) {
    if (auto known = check_group(evaluated, request.group); !known) return fail(known.error());
    SceneOptions options;
    options.group = request.group;
    options.magnification = request.magnification;
    options.probability =
        request.probability > 0 ? request.probability : evaluated.analysis->options.coverage_probability;
    if (!request.study.empty()) return scene_of_study(evaluated, request, options);
    return analysis_scene(*evaluated.analysis, evaluated.result.get(), options);
}

Result<void> write_picture(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                           const std::filesystem::path& file) {
    if (!standard_view_from(request.view))
        return fail(ErrorCode::bad_input,
                    "there is no view \"" + request.view + "\"; there are: " + joined(views));
    if (request.study.empty() && !has_layout(*evaluated.analysis->model, evaluated.analysis->inputs))
        return write_chart(evaluated, request, file);
    auto scene = scene_of(evaluated, request);
    if (!scene) return fail(scene.error());
    SceneRenderer renderer;
    renderer.set_size(request.width, request.height);
    renderer.set_palette(request.dark ? ScenePalette::dark : ScenePalette::light);
    renderer.set_scene(std::move(*scene));
    return render_to(renderer, request.view, file);
}

Result<void> write_pictures(const std::filesystem::path& folder,
                            const std::vector<EvaluatedAnalysis>& analyses, const std::stop_token& stop) {
    SceneRenderer renderer;
    for (const EvaluatedAnalysis& evaluated : analyses) {
        if (!has_layout(*evaluated.analysis->model, evaluated.analysis->inputs)) {
            if (auto written = write_charts(evaluated, folder); !written) return written;
            continue;
        }
        const std::vector<std::string> groups = groups_of(evaluated.analysis->model->outputs());
        for (const std::string& group : groups) {
            PictureRequest request;
            request.group = group;
            auto scene = scene_of(evaluated, request);
            if (!scene) return fail(scene.error());
            renderer.set_size(request.width, request.height);
            renderer.set_scene(std::move(*scene));
            for (const std::string& view :
                 group == groups.front() ? views : std::vector<std::string>{"iso"}) {
                if (stop.stop_requested())
                    return fail(ErrorCode::cancelled, "stopped while drawing pictures");
                const auto name = evaluated.analysis->id + "-" + file_name_part(group) + "-" + view + ".png";
                if (auto written = render_to(renderer, view, folder / name); !written) return written;
            }
        }
    }
    return {};
}

}  // namespace covaria
