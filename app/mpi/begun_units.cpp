#include "app/mpi/begun_units.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/file_io.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

constexpr const char* note_prefix = "computing-rank-";
constexpr const char* count_name = "ended-while-computing.txt";

std::string line_of(const UnitWork& work, std::uint64_t unit) {
    return work.analysis + "\t" + work.study + "\t" + std::to_string(unit);
}

std::vector<fs::path> notes_in(const fs::path& journal) {
    std::vector<fs::path> notes;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(journal, none))
        if (entry.path().filename().string().starts_with(note_prefix)) notes.push_back(entry.path());
    std::sort(notes.begin(), notes.end());
    return notes;
}

void add_lines(const fs::path& file, int times, std::vector<DeadlyUnit>& units) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream cells(line);
        DeadlyUnit unit;
        std::string number, count;
        std::getline(cells, unit.analysis, '\t');
        std::getline(cells, unit.study, '\t');
        std::getline(cells, number, '\t');
        unit.unit = std::strtoull(number.c_str(), nullptr, 10);
        unit.times = std::getline(cells, count, '\t') ? std::atoi(count.c_str()) : times;
        const auto known = std::find_if(units.begin(), units.end(), [&](const DeadlyUnit& other) {
            return other.analysis == unit.analysis && other.study == unit.study && other.unit == unit.unit;
        });
        if (known == units.end())
            units.push_back(unit);
        else
            known->times += unit.times;
    }
}

}  // namespace

BegunUnits::BegunUnits(fs::path journal, int rank)
    : file_(std::move(journal) / (note_prefix + std::to_string(rank))) {}

void BegunUnits::begins(const UnitWork& work, std::uint64_t unit) {
    const std::lock_guard lock(mutex_);
    lines_.insert(line_of(work, unit));
    write();
}

void BegunUnits::ends(const UnitWork& work, std::uint64_t unit) {
    const std::lock_guard lock(mutex_);
    lines_.erase(line_of(work, unit));
    write();
}

void BegunUnits::clear() {
    const std::lock_guard lock(mutex_);
    lines_.clear();
    std::error_code none;
    fs::remove(file_, none);
}

// A note that cannot be written only makes it harder to find out why a rank was ended.
void BegunUnits::write() const {
    std::ofstream out(file_, std::ios::trunc);
    for (const std::string& line : lines_) out << line << '\n';
}

std::vector<DeadlyUnit> left_units(const fs::path& journal) {
    std::vector<DeadlyUnit> units;
    for (const fs::path& note : notes_in(journal)) add_lines(note, 1, units);
    return units;
}

Result<std::vector<DeadlyUnit>> counted_deadly_units(const fs::path& journal) {
    std::vector<DeadlyUnit> units = left_units(journal);
    add_lines(journal / count_name, 1, units);
    if (units.empty()) return units;
    std::string text;
    for (const DeadlyUnit& unit : units)
        text += unit.analysis + "\t" + unit.study + "\t" + std::to_string(unit.unit) + "\t" +
                std::to_string(unit.times) + "\n";
    if (auto written = write_file_atomically(journal / count_name, text); !written)
        return fail(written.error());
    std::error_code none;
    for (const fs::path& note : notes_in(journal)) fs::remove(note, none);
    return units;
}

}  // namespace covaria
