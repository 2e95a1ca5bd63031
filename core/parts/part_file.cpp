// A line that names the format, a line of JSON, the bytes of the sections, a check sum over all.
#include "core/parts/part_file.h"

#include <nlohmann/json.hpp>

#include "core/base/bytes.h"
#include "core/base/file_io.h"

namespace covaria {

namespace {

using Json = nlohmann::json;

constexpr std::string_view format_line = "covaria part 1\n";

/// FNV-1a, eight bytes at a time.
std::uint64_t check_sum(std::string_view bytes) {
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    const auto add = [&sum](std::uint64_t word) { sum = (sum ^ word) * 0x100000001b3ULL, sum ^= sum >> 29; };
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, 8);
        add(word);
    }
    for (; i < bytes.size(); ++i) add(static_cast<unsigned char>(bytes[i]));
    return sum;
}

Json head_of(const Part& part, const ProgramIdentity& by) {
    Json sections = Json::array();
    for (const PartSection& s : part.sections)
        sections.push_back({{"analysis", s.work.analysis},
                            {"study", s.work.study},
                            {"fingerprint", s.work.fingerprint},
                            {"units", s.work.units},
                            {"first", s.range.first},
                            {"last", s.range.last}});
    return {{"program", by.program},
            {"instructions", by.instructions},
            {"project", part.request.project},
            {"arguments", part.request.arguments},
            {"sections", sections}};
}

/// Throws nlohmann's exceptions for what is not as `head_of` made it.
Part part_of(const Json& head) {
    Part part{{head.at("project").get<std::string>(), head.at("arguments").get<std::vector<std::string>>()},
              {}};
    for (const Json& s : head.at("sections"))
        part.sections.push_back({{s.at("analysis").get<std::string>(), s.at("study").get<std::string>(),
                                  s.at("fingerprint").get<std::string>(), s.at("units").get<std::uint64_t>()},
                                 {s.at("first").get<std::uint64_t>(), s.at("last").get<std::uint64_t>()},
                                 {}});
    return part;
}

tl::unexpected<Error> damaged(const std::filesystem::path& file) {
    return fail(ErrorCode::bad_input,
                tell<"%1: the part is damaged or no part at all: delete it and make it anew">(file.string()));
}

tl::unexpected<Error> foreign(const std::filesystem::path& file, const std::string& what,
                              const std::string& theirs, const std::string& ours) {
    return fail(
        ErrorCode::bad_input,
        tell<
            "%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run">(
            file.string(), what, theirs, ours));
}

}  // namespace

Result<void> write_part(const std::filesystem::path& file, const Part& part, const ProgramIdentity& by) {
    ByteWriter writer;
    writer.put_all(std::span<const char>(format_line));
    writer.put_all(
        std::span<const char>(head_of(part, by).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"));
    for (const PartSection& section : part.sections)
        for (const std::string& partial : section.partials) writer.put_list(partial);
    std::string bytes = writer.take();
    ByteWriter sum;
    sum.put(check_sum(bytes));
    bytes += sum.take();
    if (bytes.size() > largest_file)
        return fail(ErrorCode::numeric,
                    tell<"%1: the part would have %2 MB, more than %3: divide the run into more parts">(
                        file.string(), bytes.size() / 1'000'000, largest_file / 1'000'000));
    return write_file_atomically(file, bytes);
}

Result<Part> read_part(const std::filesystem::path& file, bool with_partials) {
    const auto bytes = read_file(file);
    if (!bytes) return fail(bytes.error());
    std::string_view rest = *bytes;
    if (!rest.starts_with(format_line) || rest.size() < format_line.size() + sizeof(std::uint64_t))
        return damaged(file);
    const std::string_view summed = rest.substr(0, rest.size() - sizeof(std::uint64_t));
    if (ByteReader(rest.substr(summed.size())).get<std::uint64_t>() != check_sum(summed))
        return damaged(file);
    rest = summed.substr(format_line.size());
    const std::size_t line = rest.find('\n');
    try {
        const Json head = Json::parse(rest.substr(0, line));
        const ProgramIdentity& ours = this_program();
        const ProgramIdentity theirs{head.at("program"), head.at("instructions")};
        if (theirs.program != ours.program) return foreign(file, "by", theirs.program, ours.program);
        if (theirs.instructions != ours.instructions)
            return foreign(file, "with", theirs.instructions, ours.instructions);
        Part part = part_of(head);
        if (!with_partials) return part;
        ByteReader reader(rest.substr(line + 1));
        for (PartSection& section : part.sections)
            for (std::uint64_t u = section.range.first; u < section.range.last && !reader.is_short(); ++u)
                reader.get_list(section.partials.emplace_back());
        if (!reader.complete()) return damaged(file);
        return part;
    } catch (const Json::exception&) {
        return damaged(file);
    }
}

}  // namespace covaria
