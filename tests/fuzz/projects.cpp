// Projects and typed equations: read, checked and, where nothing is wrong, evaluated to first order.
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/made/load_project.h"
#include "tests/fuzz/fuzz.h"

namespace covaria::fuzz {

namespace {

namespace fs = std::filesystem;

std::string shown(const Problem& problem) {
    return problem.file + ":" + std::to_string(problem.line) + ": " + problem.path + ": " +
           problem.message.english();
}

/// Whether the message is one that no input may cause.
bool is_defect(const std::string& message) {
    return message.find("a defect of the program") != std::string::npos;
}

Outcome evaluated(const LoadedProject& loaded) {
    Outcome outcome{true, false, {}};
    for (const AnalysisEntry& analysis : loaded.project.analyses) {
        const auto prepared = loaded.made->analysis(analysis.id);
        if (!prepared) return {true, false, "checked without errors, but not made: " + analysis.id};
        PreparedAnalysis quick = *prepared;
        quick.options.method = Method::first_order;
        // Trials asked for are a matter of patience, not of hanging.
        for (std::uint64_t* trials : {&quick.options.sobol_trials, &quick.options.one_at_a_time_trials,
                                      &quick.options.contributor_trials})
            *trials = std::min<std::uint64_t>(*trials, 1000);
        const auto result = run_analysis(quick);
        outcome.evaluated = outcome.evaluated || result;
        if (!result &&
            (result.error().message.english().empty() || is_defect(result.error().message.english())))
            return {true, false, "evaluation: " + result.error().message.english()};
    }
    return outcome;
}

Outcome of_project(const std::string& text, const fs::path& folder) {
    const LoadedProject loaded = parse_project(text, folder, "input.covaria");
    for (const Problem& problem : loaded.problems.items()) {
        const bool placed = !problem.file.empty() && problem.line > 0 && !problem.message.english().empty();
        if (!placed || is_defect(problem.message.english()))
            return {false, false, "problem: " + shown(problem)};
    }
    if (loaded.problems.has_errors()) return {};
    return evaluated(loaded);
}

/// Inputs are to be many: of a list of rows or poses the first few, of a table in a file every so many.
constexpr std::size_t rows_kept = 10;

Json shortened(Json value) {
    if (value.is_array() && value.size() > rows_kept)
        value.erase(value.begin() + static_cast<std::ptrdiff_t>(rows_kept), value.end());
    if (value.is_structured())
        for (auto& inner : value) inner = shortened(inner);
    return value;
}

/// Head, and rows from all over the table, so that no group of them is missing.
std::string thinned(const std::string& csv) {
    constexpr std::size_t most = 36;
    const auto lines = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n'));
    const std::size_t step = 1 + lines / most;
    std::istringstream in(csv);
    std::string line, kept;
    std::size_t row = 0;
    while (std::getline(in, line)) {
        const bool head = line.starts_with("#") || row == 0;
        if (head || row % step == 0) kept += line + "\n";
        row += !line.starts_with("#");
    }
    return kept;
}

/// Whether any text in `value` is `id`.
bool names(const Json& value, const std::string& id) {
    if (value.is_string()) return value.get_ref<const std::string&>() == id;
    return value.is_structured() &&
           std::any_of(value.begin(), value.end(), [&](const Json& inner) { return names(inner, id); });
}

/// One analysis, and the assets that it or another of them names.
Json with_one_analysis(Json document, std::size_t index) {
    Json& analyses = document["analyses"];
    if (!analyses.empty()) analyses = Json::array({analyses[index % analyses.size()]});
    Json used = Json::array(), left = document["assets"];
    for (std::size_t i = 0; i < left.size();) {
        const std::string id = left[i].value("id", std::string());
        if (names(analyses, id) || names(used, id)) {
            used.push_back(left[i]);
            left.erase(i);
            i = 0;  // an asset before it may be named by it
        } else {
            ++i;
        }
    }
    if (!analyses.empty()) document["assets"] = used;
    return document;
}

/// Tables in files, each thinned once, in a folder that goes with the program.
class Tables {
public:
    Tables() : folder_(fs::temp_directory_path() / ("covaria-fuzz-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        for (const auto& entry : fs::directory_iterator(fs::path(COVARIA_SOURCE_DIR) / "projects"))
            if (entry.path().extension() == ".csv")
                std::ofstream(folder_ / entry.path().filename(), std::ios::binary)
                    << thinned(file_text(entry.path()));
    }
    ~Tables() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Tables(const Tables&) = delete;
    Tables& operator=(const Tables&) = delete;
    const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

class Projects : public Kind {
public:
    Projects() {
        for (const char* folder : {"projects", "projects/gum", "tests/fuzz/corpus"})
            for (const auto& entry : fs::directory_iterator(fs::path(COVARIA_SOURCE_DIR) / folder))
                if (entry.path().extension() == ".covaria") files_.push_back(entry.path());
        std::sort(files_.begin(), files_.end());
        for (const fs::path& file : files_) {
            texts_.push_back(file_text(file));
            Json document = shortened(Json::parse(texts_.back()));
            for (std::size_t i = 0; i == 0 || i < document["analyses"].size(); ++i)
                documents_.push_back(with_one_analysis(document, i));
        }
    }

    std::string make(Noise& noise) override {
        if (noise.chance(100)) return damaged_text(noise.pick(texts_), words_, noise);
        Json document = noise.pick(documents_);
        if (noise.chance(10)) return damaged_text(document.dump(1), words_, noise);
        damage(document, noise);
        return document.dump(noise.chance(2) ? 1 : -1);
    }

    Outcome run(const std::string& input) override { return of_project(input, tables_.folder()); }

private:
    Tables tables_;
    std::vector<fs::path> files_;
    std::vector<std::string> texts_;
    std::vector<Json> documents_;
    std::vector<std::string> words_{"{",    "}",     "[",   "]", ",",       ":", "\"",
                                    "null", "1e400", "NaN", "-", "\\u0000", "\n"};
};

class Equations : public Kind {
public:
    std::string make(Noise& noise) override {
        if (noise.chance(3)) return damaged_text(noise.pick(known_), words_, noise);
        std::string text;
        for (std::size_t i = 1 + noise.below(3); i > 0; --i)
            text += (text.empty() ? "" : "\n") + std::string(i == 1 ? "y" : "w" + std::to_string(i)) + " = " +
                    expression(noise, 5);
        return text;
    }

    Outcome run(const std::string& input) override { return of_project(project_of(input), {}); }

private:
    std::string expression(Noise& noise, int depth) {
        if (depth == 0 || noise.chance(4)) return noise.pick(leaves_);
        const auto inner = [&] { return expression(noise, depth - 1); };
        switch (noise.below(7)) {
            case 0:
                return noise.pick(functions_) + "(" + inner() + ")";
            case 1:
                return noise.pick(pairs_) + "(" + inner() + ", " + inner() + ")";
            case 2:
                return "if(" + inner() + noise.pick(comparisons_) + inner() + ", " + inner() + ", " +
                       inner() + ")";
            case 3:
                return "(" + inner() + ")^" + noise.pick(leaves_);
            case 4:
                return "-" + inner();
            default:
                return "(" + inner() + noise.pick(signs_) + inner() + ")";
        }
    }

    static std::string project_of(const std::string& text) {
        Json lines = Json::array();
        std::string line;
        for (const char c : text + "\n") {
            if (c != '\n')
                line += c;
            else
                lines.push_back(std::exchange(line, {}));
        }
        Json project = Json::parse(R"({
            "format": "covaria", "schemaVersion": 1, "title": "t", "assets": [],
            "analyses": [{"id": "a", "model": "measurement-equation", "setup": {
                "equations": [],
                "outputs": {"columns": ["symbol", "name", "unit"], "rows": [["y", "y", null]]},
                "quantities": {"columns": ["symbol", "name", "unit", "value", "statement", "a"], "rows": [
                    ["x", "x", "1", 0.5, "standard", 0.01], ["l", "l", "mm", 12.0, "rectangular", 0.1],
                    ["t", "t", "s", 3.0, "standard", 1.0]]}}}]})");
        project["analyses"][0]["setup"]["equations"] = lines;
        return project.dump(1, ' ', false, Json::error_handler_t::replace);
    }

    const std::vector<std::string> leaves_{"x",    "l",    "t",     "0",  "1",         "2",      "-1", "0.5",
                                           "1e-9", "1e99", "1e308", "pi", "20 [degC]", "3 [mm]", "w2", "w3"};
    const std::vector<std::string> functions_{"sqrt", "sin",  "cos", "tan",  "exp",  "ln",   "log10", "asin",
                                              "acos", "atan", "abs", "sinh", "cosh", "tanh", "cbrt"};
    const std::vector<std::string> pairs_{"atan2", "hypot", "min", "max"};
    const std::vector<std::string> comparisons_{" > ", " < ", " >= ", " <= ", " == "};
    const std::vector<std::string> signs_{" + ", " - ", "*", "/"};
    const std::vector<std::string> known_{
        "y = x*l/t + sqrt(x)", "y = if(x > 0, ln(x), 0)", "solve y = 1: y^2 - x = 0",
        "solve y = 1, w = 2: y + w = x; y*w = 0.1", "w = x^2 # square\ny = w*(l + 3 [mm])"};
    const std::vector<std::string> words_{"(", ")",  "+", "-", "*",      "/",   "^",
                                          ",", "=",  ":", ";", "solve ", "if(", "[mm]",
                                          "#", "\n", "x", "y", "e",      ".",   "\xCE\xB1"};
};

}  // namespace

std::unique_ptr<Kind> project_kind() {
    return std::make_unique<Projects>();
}
std::unique_ptr<Kind> equation_kind() {
    return std::make_unique<Equations>();
}

}  // namespace covaria::fuzz
