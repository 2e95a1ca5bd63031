#include "app/program_facts.h"

#include <gnu/libc-version.h>

#include <Eigen/Core>
#include <QDate>
#include <QSysInfo>
#include <algorithm>
#include <boost/version.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <xsimd/xsimd.hpp>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/base/sha256.h"
#include "core/base/version.h"
#include "viz/vtk/vtk_version.h"

namespace covaria {
namespace {

std::string dotted(int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
}

/// The digest of all lists of cases and their projects, in the order of their names.
Result<std::string> digest_of_cases() {
    namespace fs = std::filesystem;
    const fs::path folder = data_directory() / "resources";
    std::vector<fs::path> files{folder / "verification.json"};
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder / "verification", gone))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string digests;
    for (const fs::path& file : files) {
        const auto bytes = read_file(file);
        if (!bytes) return fail(bytes.error());
        digests += file.filename().string() + " " + sha256_of(*bytes) + "\n";
    }
    return sha256_of(digests);
}

}  // namespace

Result<ProgramFacts> program_facts() {
    const auto program = read_file(std::filesystem::read_symlink("/proc/self/exe"));
    if (!program) return fail(program.error());
    const auto cases = digest_of_cases();
    if (!cases) return fail(cases.error());
    return ProgramFacts{
        {"Program", std::string("Covaria ") + version()},
        {"SHA-256 of the program", sha256_of(*program)},
        {"SHA-256 of the cases", *cases},
        {"Compiler", std::string("GCC ") + __VERSION__},
        {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"Boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
        {"xsimd", dotted(XSIMD_VERSION_MAJOR, XSIMD_VERSION_MINOR, XSIMD_VERSION_PATCH)},
        {"Qt", std::string(qVersion())},
        {"VTK", vtk_version()},
        {"nlohmann-json",
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
        {"C library", std::string("glibc ") + gnu_get_libc_version()},
        {"System", QSysInfo::prettyProductName().toStdString() + ", " +
                       QSysInfo::currentCpuArchitecture().toStdString()},
        {"Date", QDate::currentDate().toString(Qt::ISODate).toStdString()},
    };
}

}  // namespace covaria
