// The picture at the head of a certificate.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria {

/// A PNG or JPEG file as it is; empty where a project names none.
struct LogoPicture {
    std::string bytes = {};
    std::string media_type = {};  ///< "image/png"

    bool empty() const { return bytes.empty(); }
};

/// Read from the project's folder, or where an absolute name says. Error{not_found}, {io} as of read_file;
/// Error{bad_input}: neither PNG nor JPEG, more than 2 MB.
Result<LogoPicture> certificate_logo(const Project& project);

/// A warning at its place for a file that cannot be the logo: the certificate is made without it.
void check_certificate_logo(const Project& project, Problems& problems);

}  // namespace covaria
