// Everything written over a picture: labels, axis numbers, title, legend, caption, scale bar, selection.
#pragma once

#include <string>

#include "viz/vtk/canvas.h"

namespace covaria::detail {

struct OverlayView {
    Camera camera;
    LayerVisibility layers;
    ScenePalette palette = ScenePalette::light;
    double ratio = 1.0;
    std::string selected = {};
};

/// Paints on `image` and remembers what is taken, so that later words avoid earlier ones.
class Overlay {
public:
    Overlay(const Scene& scene, const OverlayView& view, Image& image, TextMasks& masks);
    void paint();

private:
    struct Word {
        Text text;
        Role role = Role::text;
        bool bold = false;
        double scale = 1.0;  ///< of the size of letters
    };
    const TextMask& mask_of(const Word& word);
    void put(const Word& word, double x, double y, bool claim = true);
    bool is_free(const ScreenRect& rect) const;
    Colour colour(Role role) const { return colour_of(role, view_.palette); }
    Pixel pixel_of(const Eigen::Vector3d& p_W) const { return project(view_.camera, canvas_.size(), p_W); }
    double px(double points) const { return points * view_.ratio; }

    void paint_heading();
    void paint_legend(double y);
    void paint_legend_mark(const LegendLine& line, double x, double middle);
    void paint_caption();
    void paint_scale_bar();
    void paint_colour_bar();
    void paint_triad_letters();
    void paint_selection();
    void paint_labels();
    // axis_words.cpp
    void paint_axes();
    void paint_axis(int axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

    const Scene& scene_;
    const OverlayView& view_;
    Canvas canvas_;
    TextMasks& masks_;
    std::vector<ScreenRect> taken_;
};

}  // namespace covaria::detail
