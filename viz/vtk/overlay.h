// Everything written over a picture: labels, axis numbers, legend, caption, scale bar, frames, selection.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/scene/measurement.h"
#include "viz/vtk/canvas.h"
#include "viz/vtk/picture_head.h"

namespace covaria::detail {

struct OverlayView {
    Camera camera;
    LayerVisibility layers;
    ScenePalette palette = ScenePalette::light;
    double ratio = 1.0;
    std::string selected = {};
    std::string pointed = {};  ///< id of the item under the pointer
    MeasureMark measure = {};
    ScreenRect reserved = {};  ///< room in which something else will be painted
    double covered = 0.0;      ///< px at the foot of the picture that lie under something else
    ScreenRect inset = {};     ///< a picture of the whole
};

/// Paints on `image` and remembers what is taken, so that later words avoid earlier ones.
class Overlay {
public:
    Overlay(const Scene& scene, const OverlayView& view, Image& image, TextMasks& masks);
    void paint();
    /// A word with its place in the picture.
    struct PlacedWord {
        Text text;
        Role role = Role::text;
        ScreenRect rect;
        bool is_label = false;  ///< names something in the scene, or states its fact
    };
    const std::vector<PlacedWord>& words() const { return placed_; }

private:
    const TextMask& mask_of(const Word& word);
    void claim(const Word& word, double x, double y);
    void write(const Word& word, double x, double y);
    void put(const Word& word, double x, double y);  ///< claims its place, and writes it
    bool is_free(const ScreenRect& rect) const;
    bool has_room(const ScreenRect& rect) const;  ///< free, and in the picture
    Colour colour(Role role) const { return colour_of(role, view_.palette); }
    Pixel pixel_of(const Eigen::Vector3d& p_W) const { return project(view_.camera, canvas_.size(), p_W); }
    double px(double points) const { return points * view_.ratio; }
    ScreenRect whole() const { return {2, 2, canvas_.size().width - 4.0, canvas_.size().height - 4.0}; }

    void paint_head(const std::vector<HeadLine>& lines);
    void paint_legend_mark(const LegendLine& line, double x, double middle);
    void paint_caption();
    void paint_scale_bar();
    double colour_bar_height() const;
    double claim_colour_bar();
    void paint_colour_bar(double title_top);
    void paint_selection();
    // scene_frames.cpp
    /// Frames of the world, and of what is selected or pointed at.
    void paint_frames();
    bool shows(const SceneFrame& frame) const;
    bool is_of_asked(const SceneFrame& frame) const;
    /// Paints the sights of what is selected, before all others.
    void paint_selected_sights();
    void paint_diamond(Pixel centre, double half, double width, Colour ink);
    /// Paints marks around the points, or as large as a letter.
    void paint_verdicts();
    double half_of_diamond(const SceneVerdict& mark) const;
    // scene_labels.cpp
    struct PlannedLabel {
        Word word, fact;
        LabelRequest request;             ///< without its size
        std::vector<PlannedLabel> parts;  ///< the labels that it joins
    };
    bool is_asked_for(const std::string& item) const;
    bool is_written(const SceneLabel& label) const;
    void paint_labels();
    PlannedLabel planned(const SceneLabel& label) const;
    /// Labels of one sort whose anchors cannot be told apart are one: "axis 5, axis 6".
    std::vector<PlannedLabel> joined(const std::vector<PlannedLabel>& labels) const;
    /// Paints labels where there is room; returns those that have none.
    std::vector<PlannedLabel> paint_where_free(const std::vector<PlannedLabel>& labels,
                                               const std::vector<ScreenRect>& anchors,
                                               const std::vector<ScreenLine>& bodies,
                                               std::vector<ScreenLine>& drawn);
    std::vector<ScreenLine> what_labels_avoid() const;
    /// Lines that no label covers.
    std::vector<ScreenLine> bodies() const;
    ScreenLine line_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) const;
    // measure_mark.cpp
    void paint_measure();
    void paint_arc(Pixel from, Pixel apex, Pixel to);
    void paint_measured_value(Pixel at);
    // axis_words.cpp
    /// An edge of the box that bears the numbers of an axis.
    struct AxisEdge {
        std::size_t axis = 0;
        Eigen::Vector3d begin = Eigen::Vector3d::Zero();
        Pixel from, to;
        double length = 0.0;                            ///< in the picture
        Eigen::Vector2d out = Eigen::Vector2d::Zero();  ///< away from the box
    };
    /// Edges but of an axis seen from its end; the shortest first, which has least room for its numbers.
    std::vector<AxisEdge> axis_edges() const;
    void add_edge(std::size_t axis, const Eigen::Vector3d& begin, std::vector<AxisEdge>& edges) const;
    void paint_axes();
    /// Paints numbers; returns how far they reach from the edge, nothing without any.
    std::optional<double> paint_numbers(const AxisEdge& edge);
    /// Indices of ticks that have room for their numbers: evenly spaced ones, else the two farthest apart,
    /// else none, because a single number is no scale.
    std::vector<std::size_t> numbered_ticks(const std::vector<ScreenRect>& needed,
                                            const std::vector<AxisTick>& ticks) const;
    /// Paints it beside the middle of the visible part of its axis, else where there is room; false: nowhere.
    bool paint_title(const AxisEdge& edge, const std::string& title, double numbers_reach);

    const Scene& scene_;
    const OverlayView& view_;
    Canvas canvas_;
    TextMasks& masks_;
    std::vector<ScreenRect> taken_;
    std::vector<PlacedWord> placed_;
};

}  // namespace covaria::detail
