#include "core/readers/comp3d_project.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text_places.h"
#include "core/base/utf8.h"

namespace covaria {

namespace {

using nlohmann::json;

std::string setting_text(const json& config, const char* key) {
    const auto found = config.find(key);
    return found != config.end() && found->is_string() ? found->get<std::string>() : std::string();
}
double setting_number(const json& config, const char* key, double otherwise) {
    const auto found = config.find(key);
    return found != config.end() && found->is_number() ? found->get<double>() : otherwise;
}
bool setting_flag(const json& config, const char* key) {
    const auto found = config.find(key);
    return found != config.end() && found->is_boolean() && found->get<bool>();
}

std::size_t begin_of_settings(std::string_view text) {
    const std::size_t name = text.find_first_not_of(" \t\r\n");
    if (name == std::string_view::npos || !text.substr(name).starts_with("data"))
        return std::string_view::npos;
    const std::size_t sign = text.find_first_not_of(" \t\r\n", name + 4);
    if (sign == std::string_view::npos || text[sign] != '=') return std::string_view::npos;
    const std::size_t brace = text.find_first_not_of(" \t\r\n", sign + 1);
    return brace != std::string_view::npos && text[brace] == '{' ? brace : std::string_view::npos;
}

}  // namespace

bool is_comp3d_project(std::string_view beginning) {
    return begin_of_settings(beginning) != std::string_view::npos;
}

Result<Comp3dProject> comp3d_project(const std::string& text) {
    constexpr double gons = 1.0;  // of "files_unit"
    const std::string_view whole = without_byte_order_mark(text);
    const std::size_t begin = begin_of_settings(whole);
    if (begin == std::string_view::npos)
        return refused_at(1, tell<"settings of Comp3D begin with data = {">());
    const json read =
        json::parse(whole.begin() + static_cast<std::ptrdiff_t>(begin), whole.end(), nullptr, false);
    const auto config = read.is_object() ? read.find("config") : read.end();
    if (!read.is_object() || config == read.end() || !config->is_object())
        return refused_at(1, tell<"no settings of Comp3D: a part \"config\" is expected">());
    Comp3dProject project{.name = setting_text(*config, "name"),
                          .coordinates = setting_text(*config, "root_COR_file"),
                          .observations = setting_text(*config, "root_OBS_file"),
                          .covariance = setting_text(*config, "coord_cov_file"),
                          .has_angle_unit = setting_number(*config, "files_unit", 0.0) == gons,
                          .is_simulated = setting_number(*config, "compute_type", 0.0) != 0.0};
    Comp3dSettings& settings = project.settings;
    settings.latitude = setting_number(*config, "center_latitude", settings.latitude);
    settings.refraction = setting_number(*config, "refraction", settings.refraction);
    if (!(std::abs(settings.latitude) <= 90.0) || !(std::abs(settings.refraction) <= 10.0))
        return refused_at(1, tell<"the latitude or the refraction coefficient is none">());
    if (const auto centre = config->find("local_center"); centre != config->end() && centre->is_array())
        for (std::size_t i = 0; i < 2 && i < centre->size(); ++i)
            if ((*centre)[i].is_number())
                settings.centre[static_cast<Eigen::Index>(i)] = (*centre)[i].get<double>();
    settings.has_internal_constraints = setting_flag(*config, "internal_constraints");
    if (setting_flag(*config, "use_proj")) {
        settings.projection = setting_text(*config, "proj_def");
        if (settings.projection.empty()) settings.projection = "?";
    }
    return project;
}

}  // namespace covaria
