// Frames per second of the scene at 1280 x 800 with 100 000 trials, and the time to build scene and actors.
#include <benchmark/benchmark.h>

#include "tests/viz/stewart_scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria {
namespace {

const Scene& scene_of_100000() {
    static const Scene scene = [] {
        const auto setup = test::stewart_setup(14'286);  // seven clouds
        return build_scene(setup.source(), {});
    }();
    return scene;
}

void turn(benchmark::State& state, RenderQuality quality) {
    SceneRenderer renderer;
    renderer.set_size(1280, 800);
    renderer.set_scene(scene_of_100000());
    if (auto first = renderer.render(quality); !first)
        return state.SkipWithError(first.error().message.english().c_str());
    for (auto _ : state) {
        renderer.orbit(5, 0);
        benchmark::DoNotOptimize(renderer.render(quality));
    }
    state.counters["frames"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(turn, moving, RenderQuality::moving)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(turn, full, RenderQuality::full)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(turn, fine, RenderQuality::fine)->Unit(benchmark::kMillisecond)->UseRealTime();

void build(benchmark::State& state) {
    const auto setup = test::stewart_setup(14'286);
    for (auto _ : state) benchmark::DoNotOptimize(build_scene(setup.source(), {}));
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

void first_picture(benchmark::State& state) {
    for (auto _ : state) {
        SceneRenderer renderer;
        renderer.set_size(1280, 800);
        renderer.set_scene(scene_of_100000());
        benchmark::DoNotOptimize(renderer.render(RenderQuality::full));
    }
}
BENCHMARK(first_picture)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace covaria

BENCHMARK_MAIN();
