// Letters by FreeType, through VTK.
// VTK 9.1 reads a std::string byte by byte here; only its vtkUnicodeString, marked as deprecated, keeps Greek
// letters and signs.
#define VTK_DEPRECATION_LEVEL 0
#include "viz/vtk/text_masks.h"

#include "viz/vtk/scene_fonts.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkUnicodeString.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string_view>

namespace covaria::detail {
namespace {

constexpr std::size_t most_masks = 2000;  // beyond that the store starts anew: bounded memory

/// East Asian fonts have no narrow space, and draw a box for it.
std::string drawable(std::string text) {
    if (font_file_for(text, false) == font_file_for("", false)) return text;
    constexpr std::string_view narrow = "\u202f";
    for (std::size_t at = 0; (at = text.find(narrow, at)) != std::string::npos;)
        text.replace(at, narrow.size(), " ");
    return text;
}

void set_font(vtkTextProperty* property, const std::string& text, bool bold) {
    const std::string& file = font_file_for(text, bold);
    if (file.empty()) {
        property->SetFontFamilyToArial();
        property->SetBold(bold);
        return;
    }
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
}

Mask plain_letters(const std::string& wanted, int pixels, bool bold) {
    static std::mutex freetype;  // VTK keeps one FreeType for the process
    const std::lock_guard lock(freetype);
    const std::string text = drawable(wanted);
    vtkNew<vtkTextProperty> property;
    set_font(property, text, bold);
    property->SetFontSize(pixels);
    property->SetColor(1, 1, 1);
    vtkNew<vtkImageData> data;
    int used[2] = {0, 0};
    Mask mask;
    if (!vtkFreeTypeTools::GetInstance()->RenderString(property, vtkUnicodeString::from_utf8(text), 72, data,
                                                       used))
        return mask;
    mask.width = used[0];
    mask.height = used[1];
    const int channels = data->GetNumberOfScalarComponents();
    for (int y = mask.height - 1; y >= 0; --y)
        for (int x = 0; x < mask.width; ++x)
            mask.opacity.push_back(static_cast<const std::uint8_t*>(
                data->GetScalarPointer(data->GetExtent()[0] + x, data->GetExtent()[2] + y, 0))[channels - 1]);
    return mask;
}

void copy(const Mask& part, int left, int top, Mask& whole) {
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            whole.opacity[static_cast<std::size_t>(y + top) * static_cast<std::size_t>(whole.width) +
                          static_cast<std::size_t>(x + left)] = static_cast<std::uint8_t>(part.at(x, y));
}

/// Words that end in a subscript ("frame o_p") have it small and lowered; other scripts are as Unicode has
/// them.
Mask letters_of(const Text& text, int pixels, bool bold) {
    const auto& spans = text.spans();
    const bool ends_lowered = spans.size() > 1 && spans.back().script == Script::below;
    const std::size_t on_line = ends_lowered ? text.letters().size() - spans.back().letters.size() : 0;
    if (!ends_lowered || text.part(0, on_line).has_scripts())
        return plain_letters(to_unicode(text), pixels, bold);
    const Mask base = plain_letters(text.part(0, on_line).letters(), pixels, bold);
    const Mask low = plain_letters(spans.back().letters, std::max(6, pixels * 3 / 4), bold);
    const int drop = std::max(1, pixels / 4), gap = std::max(1, pixels / 12);
    const int top = std::max(0, base.height + drop - low.height);
    Mask whole{base.width + gap + low.width, std::max(base.height, top + low.height), {}};
    whole.opacity.assign(static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height), 0);
    copy(base, 0, 0, whole);
    copy(low, base.width + gap, top, whole);
    return whole;
}

/// Each pixel takes the strongest within `reach`, fading at the rim.
Mask grown(const Mask& mask, int reach) {
    Mask halo{mask.width + 2 * reach, mask.height + 2 * reach, {}};
    halo.opacity.assign(static_cast<std::size_t>(halo.width) * static_cast<std::size_t>(halo.height), 0);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const int strength = mask.at(x, y);
            if (strength == 0) continue;
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const double fade = std::clamp(reach + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
                    const auto at =
                        static_cast<std::size_t>(y + reach + dy) * static_cast<std::size_t>(halo.width) +
                        static_cast<std::size_t>(x + reach + dx);
                    halo.opacity[at] = std::max(halo.opacity[at], static_cast<std::uint8_t>(fade * strength));
                }
        }
    return halo;
}

}  // namespace

const TextMask& TextMasks::of(const Text& text, double pixels, bool bold) {
    const int size = std::max(6, static_cast<int>(std::lround(pixels)));
    if (masks_.size() > most_masks) masks_.clear();
    auto [place, added] = masks_.try_emplace({text, size, bold});
    if (added) {
        TextMask& mask = place->second;
        mask.letters = letters_of(text, size, bold);
        mask.halo_width = std::max(1, size / 6);
        mask.halo = grown(mask.letters, mask.halo_width);
    }
    return place->second;
}

}  // namespace covaria::detail
