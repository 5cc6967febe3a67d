// SPDX-License-Identifier: Apache-2.0
// How fast the software is: the fast models beside OpenCV's StereoBM and StereoSGBM, one thread each, and the clocked
// core.
//
// Mde/s counts million disparity evaluations a second: outputs that are computed, times disparities that are tried for
// each. Both matchers run on the same generated scene.
#include <benchmark/benchmark.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "definition/block_matching/models.hpp"
#include "definition/semi_global/models.hpp"
#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/run_core.hpp"
#include "engines/configurations.hpp"
#include "scene/scene.hpp"

namespace {

constexpr int kWidth = 320, kHeight = 240;

stereo::ImagePair scene(int disparities) {
   return stereo::make_scene({.width = kWidth, .height = kHeight, .disparities = disparities}).images;
}

void count_evaluations(benchmark::State& state, double columns, double rows, double disparities) {
   state.counters["Mde/s"] =
       benchmark::Counter(columns * rows * disparities * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
}

/// (W-D) x H outputs.
void fast_model_options(benchmark::State& state, const stereo::block_matching::Matching& parameters) {
   const stereo::ImagePair pair = scene(parameters.disparities);
   for (auto _ : state) benchmark::DoNotOptimize(match_fast(pair.left, pair.right, parameters));
   count_evaluations(state, map_width(kWidth, parameters), kHeight, parameters.disparities);
}

/// The paper's algorithm.
void fast_model(benchmark::State& state) {
   fast_model_options(state, {.disparities = int(state.range(0)), .window_px = int(state.range(1))});
}

/// (W-D+1) x (H-B+1) outputs: all left pixels with a complete disparity range, in rows with a complete window. StereoBM
/// fills the rest of its map without looking at it.
void opencv_stereo_bm(benchmark::State& state) {
   const int disparities = int(state.range(0)), window = int(state.range(1));
   stereo::ImagePair pair = scene(disparities);
   const cv::Mat left(kHeight, kWidth, CV_8U, pair.left.pixels.data());
   const cv::Mat right(kHeight, kWidth, CV_8U, pair.right.pixels.data());
   const cv::Ptr<cv::StereoBM> matcher = cv::StereoBM::create(disparities, window);
   cv::setNumThreads(1);
   cv::Mat map;
   for (auto _ : state) matcher->compute(left, right, map);
   count_evaluations(state, kWidth - disparities + 1, kHeight - window + 1, disparities);
}

/// All cost columns.
void semi_global_fast_model(benchmark::State& state, const stereo::semi_global::Matching& options) {
   const stereo::ImagePair pair = scene(options.disparities);
   for (auto _ : state) benchmark::DoNotOptimize(match_fast(pair.left, pair.right, options));
   count_evaluations(state, map_width(kWidth, options), kHeight, options.disparities);
}

/// (W-D) x H outputs, without its checks: block 3 and the penalties of OpenCV's regression test.
void opencv_stereo_sgbm(benchmark::State& state, int mode, int disparities) {
   stereo::ImagePair pair = scene(disparities);
   const cv::Mat left(kHeight, kWidth, CV_8U, pair.left.pixels.data());
   const cv::Mat right(kHeight, kWidth, CV_8U, pair.right.pixels.data());
   const cv::Ptr<cv::StereoSGBM> matcher = cv::StereoSGBM::create(0, disparities, 3, 90, 360);
   matcher->setMode(mode);
   cv::setNumThreads(1);
   cv::Mat map;
   for (auto _ : state) matcher->compute(left, right, map);
   count_evaluations(state, kWidth - disparities, kHeight, disparities);
}

void clocked_core(benchmark::State& state, const char* name) {
   const stereo::CoreModule& core = stereo::core_module(name);
   const stereo::Image& image = core.shape.image;
   const stereo::MapGeometry map = stereo::find_configuration(name)->algorithm->map_geometry(image.width_px);
   const stereo::Stimulus stimulus = stereo::make_stimulus(name, core.shape, scene(map.disparities));
   for (auto _ : state) benchmark::DoNotOptimize(stereo::run_core(core, stimulus.clocks));
   state.counters["clocks/s"] =
       benchmark::Counter(double(stimulus.clocks.size()), benchmark::Counter::kIsIterationInvariantRate);
   count_evaluations(state, map.width, image.height_px, map.disparities);
}

const stereo::block_matching::Matching kCensus5x5{.disparities = 64, .window_px = 5, .cost = stereo::Cost::census};
const stereo::block_matching::Matching kCensus7x7{.disparities = 64,
                                                  .window_px = 7,
                                                  .cost = stereo::Cost::census,
                                                  .census_width_px = 7,
                                                  .census_height_px = 7,
                                                  .left_right_threshold = 1,
                                                  .median = true};
const stereo::block_matching::Matching kSsd{.disparities = 64, .window_px = 7, .cost = stereo::Cost::ssd};
/// What StereoBM does by default.
const stereo::block_matching::Matching kOpenCvBm{.disparities = 64,
                                                 .window_px = 15,
                                                 .reference = stereo::Reference::left,
                                                 .prefilter = stereo::Prefilter::xsobel,
                                                 .ties = stereo::Ties::largest,
                                                 .uniqueness_percent = 15,
                                                 .texture_threshold = 10,
                                                 .subpixel = true};
const stereo::semi_global::Matching kSemiGlobal{.disparities = 64};
const stereo::semi_global::Matching kSemiGlobal128{.disparities = 128};
/// Wide penalties: the paths need 16 bits.
const stereo::semi_global::Matching kSemiGlobalWide{.disparities = 64, .cost_shift = 0, .p1 = 80, .p2 = 350};
const stereo::semi_global::Matching kSemiGlobalAll{
    .disparities = 64, .left_right_threshold = 1, .uniqueness_distance = 3, .subpixel = true, .median = true};

// Disparities, window.
BENCHMARK(fast_model)
    ->Args({100, 3})
    ->Args({96, 5})
    ->Args({112, 5})
    ->Args({64, 15})
    ->Args({100, 21})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fast_model_options, census_5x5_window_5, kCensus5x5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fast_model_options, census_7x7_window_7_left_right_median, kCensus7x7)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fast_model_options, ssd_window_7, kSsd)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fast_model_options, opencv_bm, kOpenCvBm)->Unit(benchmark::kMillisecond);
BENCHMARK(opencv_stereo_bm)->Args({64, 15})->Args({96, 5})->Args({112, 5})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(semi_global_fast_model, census_5x5, kSemiGlobal)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(semi_global_fast_model, census_5x5_128, kSemiGlobal128)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(semi_global_fast_model, wide_penalties, kSemiGlobalWide)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(semi_global_fast_model, all_checks, kSemiGlobalAll)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, sgbm_64, cv::StereoSGBM::MODE_SGBM, 64)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, 3way_64, cv::StereoSGBM::MODE_SGBM_3WAY, 64)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, 3way_128, cv::StereoSGBM::MODE_SGBM_3WAY, 128)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, hh4_64, cv::StereoSGBM::MODE_HH4, 64)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, hh_64, cv::StereoSGBM::MODE_HH, 64)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007, "ambrosch2007")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007_p2, "ambrosch2007_p2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007_p4, "ambrosch2007_p4")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
