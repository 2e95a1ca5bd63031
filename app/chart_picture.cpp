#include "app/chart_picture.h"

#include "app/application.h"
#include "core/made/evaluated_analysis.h"
#include "core/views/plots.h"
#include "ui/charts/chart_painter.h"

namespace covaria {
namespace {

PlotSpecification plot_of(const UncertaintyResult& result, std::size_t output) {
    return result.trials > 0 ? histogram_plot(result, output) : contribution_plot(result, output);
}

Result<void> write(const PlotSpecification& plot, const PictureRequest& request,
                   const std::filesystem::path& file) {
    // Texts as large as in the window on a picture of its size.
    const double pixel_ratio = std::max(1.0, request.width / 720.0);
    const QSize size(static_cast<int>(request.width / pixel_ratio),
                     static_cast<int>(request.height / pixel_ratio));
    const ui::Theme theme = request.dark ? ui::Theme::dark() : ui::Theme::light();
    return ui::write_png(file.string(), {plot, theme, size, {}}, pixel_ratio);
}

std::size_t wanted_output(const UncertaintyResult& result, const std::string& group) {
    for (std::size_t j = 0; j < result.outputs.size(); ++j) {
        const OutputQuantity& quantity = result.outputs[j].quantity;
        if (quantity.role == OutputRole::measurand && (group.empty() || quantity.group == group)) return j;
    }
    return 0;
}

}  // namespace

Result<void> write_chart(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                         const std::filesystem::path& file) {
    const auto application = make_application(Platform::offscreen);
    const UncertaintyResult& result = *evaluated.result;
    return write(plot_of(result, wanted_output(result, request.group)), request, file);
}

Result<void> write_chart_of(const EvaluatedAnalysis& evaluated, std::size_t output,
                            const std::filesystem::path& file) {
    return write(plot_of(*evaluated.result, output), {}, file);
}

}  // namespace covaria
