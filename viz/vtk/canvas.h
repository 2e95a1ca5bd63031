// Paints letters and simple marks on a picture: crisp at any quality of the rendering below.
#pragma once

#include <string>

#include "viz/scene/label_placement.h"
#include "viz/vtk/image.h"
#include "viz/vtk/palette.h"
#include "viz/vtk/text_masks.h"

namespace covaria::detail {

class Canvas {
public:
    explicit Canvas(Image& image) : image_(image) {}
    PictureSize size() const { return {image_.width, image_.height}; }

    void rectangle(const ScreenRect& rect, Colour colour, double opacity);
    void line(Pixel from, Pixel to, double width, Colour colour, double opacity = 1.0);
    /// A circle line, or a disc where width >= radius.
    void ring(Pixel centre, double radius, double width, Colour colour, double opacity = 1.0);
    void ellipse(Pixel centre, double half_width, double half_height, Colour colour, double opacity);
    /// Letters with their upper left corner at (x, y), on a soft halo of the ground's colour.
    void text(const TextMask& mask, double x, double y, Colour colour, Colour halo);

private:
    void blend(int x, int y, Colour colour, double opacity);
    void paint(const Mask& mask, int x, int y, Colour colour, double opacity);
    Image& image_;
};

}  // namespace covaria::detail
