// The picture at the head of a certificate.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// The bytes of a PNG or JPEG file as they are; empty where a project names none.
struct LogoPicture {
    std::string bytes = {};
    std::string media_type = {};  ///< the type of the picture: "image/png"

    bool empty() const { return bytes.empty(); }
};

/// The logo, read from the project's folder or from where an absolute name says. Error{not_found}, {io} as
/// those of read_file; Error{bad_input}: neither PNG nor JPEG, or more than 2 MB.
Result<LogoPicture> certificate_logo(const Project& project);

/// Warns, at the logo's place, of a file that cannot be the logo: the certificate is made without it.
void check_certificate_logo(const Project& project, Problems& problems);

}  // namespace covaria
