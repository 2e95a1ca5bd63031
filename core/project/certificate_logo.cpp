#include "core/project/certificate_logo.h"

#include "core/base/file_io.h"
#include "core/base/own_folder.h"

namespace covaria {
namespace {

constexpr std::uintmax_t largest_logo = 2'000'000;

std::string media_type_of(const std::string& bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
    if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
    return {};
}

}  // namespace

Result<LogoPicture> certificate_logo(const Project& project) {
    const std::string& name = project.certificate.logo;
    if (is_blank(name)) return LogoPicture{};
    const std::filesystem::path file = project.directory / std::filesystem::path(name);
    if (is_led_out_of(project.directory, name))
        return fail(
            ErrorCode::bad_input,
            tell<"%1 is a link that leads out of the project's folder: put the picture itself there">(name));
    std::error_code error;
    if (const auto size = std::filesystem::file_size(file, error); !error && size > largest_logo)
        return fail(ErrorCode::bad_input, tell<"%1 has more than 2 MB, too much for a logo">(name));
    auto bytes = read_file(file);
    if (!bytes) return fail(bytes.error());
    std::string type = media_type_of(*bytes);
    if (type.empty()) return fail(ErrorCode::bad_input, tell<"%1 is neither a PNG nor a JPEG picture">(name));
    return LogoPicture{std::move(*bytes), std::move(type)};
}

void check_certificate_logo(const Project& project, Problems& problems) {
    if (const auto logo = certificate_logo(project); !logo)
        problems.warning(pointer_of(certificate_field(&Certificate::logo)),
                         tell<"The certificate has no logo: %1">(logo.error().message));
}

}  // namespace covaria
