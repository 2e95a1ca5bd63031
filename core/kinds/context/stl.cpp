#include "core/kinds/context/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string>

#include "core/base/file_io.h"
#include "core/base/in_quotes.h"

namespace covaria {

namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;
constexpr float largest_coordinate = 1e15F;  // squares and sums of them stay numbers

tl::unexpected<Error> no_stl(Message message, int line = 0) {
    return fail(Error{ErrorCode::bad_input, std::move(message), {}, {}, line});
}

bool is_drawable(float coordinate) {
    return std::isfinite(coordinate) && std::abs(coordinate) <= largest_coordinate;
}

/// Number of the triangle that is being read: counts from 1.
std::size_t number_of_next(const TriangleMesh& mesh) {
    return mesh.triangles() + 1;
}

Message too_many() {
    return tell<"it has more than %1 triangles: thin it out">(most_triangles);
}

Message not_finite(const TriangleMesh& mesh) {
    return tell<"triangle %1 has a coordinate that is not a finite number">(number_of_next(mesh));
}

std::uint32_t little_endian(const char* bytes) {
    std::array<unsigned char, 4> b{};
    std::memcpy(b.data(), bytes, b.size());
    return std::uint32_t{b[0]} | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 |
           std::uint32_t{b[3]} << 24;
}

Result<TriangleMesh> from_binary(std::string_view bytes, std::size_t count) {
    if (count > most_triangles) return no_stl(too_many());
    TriangleMesh mesh;
    mesh.corners.reserve(9 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* at = bytes.data() + header_bytes + i * triangle_bytes + 12;  // behind the normal
        std::array<float, 9> corners{};
        for (std::size_t k = 0; k < 9; ++k) corners[k] = std::bit_cast<float>(little_endian(at + 4 * k));
        if (!std::ranges::all_of(corners, is_drawable)) return no_stl(not_finite(mesh));
        mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    }
    return mesh;
}

/// Words of a text, with the line of the last one.
class StlWords {
public:
    explicit StlWords(std::string_view text) : text_(text) {}

    /// Empty at the end.
    std::string_view next() {
        while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n';
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }
    int line() const { return line_; }

private:
    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

bool is_word(std::string_view given, std::string_view lower_case) {
    return std::ranges::equal(given, lower_case, [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

class AsciiStl {
public:
    explicit AsciiStl(std::string_view text) : words_(text) {}

    Result<TriangleMesh> read() {
        words_.next();  // "solid", and a name that may be anything
        words_.skip_line();
        for (;;) {
            const std::string_view word = words_.next();
            if (word.empty()) return cut_off();
            if (is_word(word, "facet")) {
                if (auto read = facet(); !read) return fail(read.error());
            } else if (is_word(word, "endsolid")) {
                if (!another_solid()) return std::move(mesh_);
            } else {
                return unexpected("facet", word);
            }
        }
    }

private:
    bool another_solid() {
        words_.skip_line();
        const bool more = is_word(words_.next(), "solid");
        if (more) words_.skip_line();
        return more;
    }

    Result<void> facet() {
        if (mesh_.triangles() == most_triangles) return no_stl(too_many(), words_.line());
        std::array<float, 3> normal{};
        if (auto read = expect({"normal"}); !read) return read;
        if (auto read = numbers(normal, false); !read) return read;
        if (auto read = expect({"outer", "loop"}); !read) return read;
        for (int i = 0; i < 3; ++i) {
            if (auto read = expect({"vertex"}); !read) return read;
            if (auto read = numbers(corners_[static_cast<std::size_t>(i)], true); !read) return read;
        }
        if (auto read = expect({"endloop", "endfacet"}); !read) return read;
        for (const auto& corner : corners_)
            mesh_.corners.insert(mesh_.corners.end(), corner.begin(), corner.end());
        return {};
    }

    Result<void> expect(std::initializer_list<const char*> wanted) {
        for (const char* word : wanted)
            if (const std::string_view given = words_.next(); !is_word(given, word))
                return given.empty() ? cut_off() : unexpected(word, given);
        return {};
    }

    /// Normals are often written as nan where an edge has no length; nobody reads them.
    Result<void> numbers(std::array<float, 3>& into, bool finite) {
        for (float& number : into) {
            std::string_view word = words_.next();
            if (word.empty()) return cut_off();
            if (!finite) continue;
            if (word.starts_with('+')) word.remove_prefix(1);
            double read = 0.0;
            const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), read);
            // Out of range because of a negative exponent: zero.
            const bool vanishes = failure == std::errc::result_out_of_range && word.find('-', 1) != word.npos;
            if (!vanishes && (failure != std::errc() || end != word.data() + word.size()))
                return no_stl(tell<"triangle %1: %2 is no number">(
                                  number_of_next(mesh_), in_quotes(std::string(word.substr(0, 40)))),
                              words_.line());
            number = std::abs(read) <= largest_coordinate ? static_cast<float>(read) : HUGE_VALF;
            if (!is_drawable(number)) return no_stl(not_finite(mesh_), words_.line());
        }
        return {};
    }

    tl::unexpected<Error> cut_off() {
        return no_stl(tell<"it ends in triangle %1: it has been cut off">(number_of_next(mesh_)),
                      words_.line());
    }
    tl::unexpected<Error> unexpected(const std::string& wanted, std::string_view given) {
        return no_stl(
            tell<"triangle %1: %2 stands where %3 should">(
                number_of_next(mesh_), in_quotes(std::string(given.substr(0, 40))), in_quotes(wanted)),
            words_.line());
    }

    StlWords words_;
    TriangleMesh mesh_;
    std::array<std::array<float, 3>, 3> corners_{};
};

Result<TriangleMesh> triangles_in(std::string_view bytes) {
    std::size_t count = 0;
    if (bytes.size() >= header_bytes) {
        count = little_endian(bytes.data() + 80);
        if (bytes.size() == header_bytes + triangle_bytes * count) return from_binary(bytes, count);
    }
    if (is_word(bytes.substr(0, 5), "solid") && bytes.find('\0') == bytes.npos) return AsciiStl(bytes).read();
    if (bytes.size() < header_bytes)
        return no_stl(
            tell<"it is no STL file: it neither begins with \"solid\" nor has a header of 84 bytes">());
    const std::size_t whole = (bytes.size() - header_bytes) / triangle_bytes;
    if (count < whole)
        return no_stl(
            tell<"it is no STL file: its header states %1 triangles, and there is more behind them">(count));
    return no_stl(tell<"its header states %1 triangles; it ends in triangle %2">(count, whole + 1));
}

}  // namespace

Result<TriangleMesh> mesh_from_stl(std::string_view bytes) {
    auto mesh = triangles_in(bytes);
    if (!mesh) return mesh;
    if (mesh->corners.empty()) return no_stl(tell<"it has no triangles">());
    for (std::size_t i = 0; i < mesh->corners.size(); i += 3)
        mesh->box.extend(Eigen::Map<const Eigen::Vector3f>(&mesh->corners[i]));
    return mesh;
}

Result<std::shared_ptr<const TriangleMesh>> mesh_of_file(const std::filesystem::path& file) {
    struct Read {
        std::uintmax_t size = 0;
        std::filesystem::file_time_type time = {};
        std::weak_ptr<const TriangleMesh> mesh = {};
    };
    static std::mutex mutex;
    static std::map<std::filesystem::path, Read> read_files;
    const std::lock_guard lock(mutex);
    std::error_code gone;
    Read state{std::filesystem::file_size(file, gone), std::filesystem::last_write_time(file, gone)};
    std::erase_if(read_files, [](const auto& each) { return each.second.mesh.expired(); });
    if (const auto known = read_files.find(file); !gone && known != read_files.end() &&
                                                  known->second.size == state.size &&
                                                  known->second.time == state.time)
        if (auto mesh = known->second.mesh.lock()) return mesh;
    const auto bytes = read_file(file);
    if (!bytes) return fail(bytes.error());
    auto read = mesh_from_stl(*bytes);
    if (!read) {
        Error error = read.error();
        error.file = file.string();
        return fail(std::move(error));
    }
    auto mesh = std::make_shared<const TriangleMesh>(*std::move(read));
    state.mesh = mesh;
    if (!gone) read_files[file] = std::move(state);
    return mesh;
}

}  // namespace covaria
