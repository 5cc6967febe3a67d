// SPDX-License-Identifier: Apache-2.0
// How fast the software is: the fast models beside OpenCV's StereoBM and StereoSGBM, with one thread each and with all
// cores, and the clocked core.
//
// Mde/s counts million disparity evaluations a second: outputs that are computed, times disparities that are tried for
// each. Both matchers run on the same generated scene.
#include <benchmark/benchmark.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <thread>

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

using Bench = benchmark::internal::Benchmark;

/// In one thread and in all cores: the first argument of a benchmark is the number of threads.
std::vector<int64_t> thread_counts() { return {1, std::max<int64_t>(2, std::thread::hardware_concurrency())}; }
void with_threads(Bench* bench) {
   bench->ArgName("threads")->ArgsProduct({thread_counts()})->UseRealTime()->Unit(benchmark::kMillisecond);
}
/// {disparities, window} each.
void with_sizes_and_threads(Bench* bench, const std::vector<std::pair<int64_t, int64_t>>& sizes) {
   for (const auto& [disparities, window] : sizes)
      for (const int64_t threads : thread_counts()) bench->Args({threads, disparities, window});
   bench->ArgNames({"threads", "", ""})->UseRealTime()->Unit(benchmark::kMillisecond);
}
int threads_of(const benchmark::State& state) { return int(state.range(0)); }

void count_evaluations(benchmark::State& state, double columns, double rows, double disparities) {
   state.counters["Mde/s"] =
       benchmark::Counter(columns * rows * disparities * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
}

/// (W-D) x H outputs.
void fast_model_options(benchmark::State& state, const stereo::block_matching::Matching& parameters) {
   const stereo::ImagePair pair = scene(parameters.disparities);
   const int threads = threads_of(state);
   for (auto _ : state) benchmark::DoNotOptimize(match_fast(pair.left, pair.right, parameters, threads));
   count_evaluations(state, map_width(kWidth, parameters), kHeight, parameters.disparities);
}

/// The paper's algorithm.
void fast_model(benchmark::State& state) {
   fast_model_options(state,
                      {stereo::DisparityCount{int(state.range(1))}, stereo::MatchingWindow{int(state.range(2))}});
}

/// (W-D+1) x (H-B+1) outputs: all left pixels with a complete disparity range, in rows with a complete window. StereoBM
/// fills the rest of its map without looking at it.
void opencv_stereo_bm(benchmark::State& state) {
   const int disparities = int(state.range(1)), window = int(state.range(2));
   stereo::ImagePair pair = scene(disparities);
   const cv::Mat left(kHeight, kWidth, CV_8U, pair.left.pixels.data());
   const cv::Mat right(kHeight, kWidth, CV_8U, pair.right.pixels.data());
   const cv::Ptr<cv::StereoBM> matcher = cv::StereoBM::create(disparities, window);
   cv::setNumThreads(threads_of(state));
   cv::Mat map;
   for (auto _ : state) matcher->compute(left, right, map);
   count_evaluations(state, kWidth - disparities + 1, kHeight - window + 1, disparities);
}

/// All cost columns.
void semi_global_fast_model(benchmark::State& state, const stereo::semi_global::Matching& options) {
   const stereo::ImagePair pair = scene(options.disparities);
   const int threads = threads_of(state);
   for (auto _ : state) benchmark::DoNotOptimize(match_fast(pair.left, pair.right, options, threads));
   count_evaluations(state, map_width(kWidth, options), kHeight, options.disparities);
}

/// (W-D) x H outputs, without its checks: block 3 and the penalties of OpenCV's regression test.
void opencv_stereo_sgbm(benchmark::State& state, int mode, int disparities) {
   stereo::ImagePair pair = scene(disparities);
   const cv::Mat left(kHeight, kWidth, CV_8U, pair.left.pixels.data());
   const cv::Mat right(kHeight, kWidth, CV_8U, pair.right.pixels.data());
   const cv::Ptr<cv::StereoSGBM> matcher = cv::StereoSGBM::create(0, disparities, 3, 90, 360);
   matcher->setMode(mode);
   cv::setNumThreads(threads_of(state));
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

const stereo::block_matching::Matching kCensus5x5{stereo::DisparityCount{64}, stereo::MatchingWindow{5},
                                                  stereo::Comparison{stereo::Cost::census}};
const stereo::block_matching::Matching kCensus7x7{stereo::DisparityCount{64},
                                                  stereo::MatchingWindow{7},
                                                  stereo::Comparison{stereo::Cost::census},
                                                  stereo::CensusWindow{.census_width_px = 7, .census_height_px = 7},
                                                  stereo::LeftRightThreshold{1},
                                                  stereo::MedianFilter{true}};
const stereo::block_matching::Matching kSsd{stereo::DisparityCount{64}, stereo::MatchingWindow{7},
                                            stereo::Comparison{stereo::Cost::ssd}};
/// What StereoBM does by default.
const stereo::block_matching::Matching kOpenCvBm{stereo::DisparityCount{64},
                                                 stereo::MatchingWindow{15},
                                                 stereo::ReferenceImage{stereo::Reference::left},
                                                 stereo::Prefiltering{.prefilter = stereo::Prefilter::xsobel},
                                                 stereo::TieRule{stereo::Ties::largest},
                                                 stereo::UniquenessPercent{15},
                                                 stereo::block_matching::TextureThreshold{10},
                                                 stereo::SubpixelSteps{true}};
const stereo::semi_global::Matching kSemiGlobal{stereo::DisparityCount{64}};
const stereo::semi_global::Matching kSemiGlobal128{stereo::DisparityCount{128}};
/// Wide penalties: the paths need 16 bits.
const stereo::semi_global::Matching kSemiGlobalWide{stereo::DisparityCount{64}, stereo::CostScale{.cost_shift = 0},
                                                    stereo::semi_global::Paths{.p1 = 80, .p2 = 350}};
const stereo::semi_global::Matching kSemiGlobalAll{stereo::DisparityCount{64}, stereo::LeftRightThreshold{1},
                                                   stereo::semi_global::UniquenessDistance{3},
                                                   stereo::SubpixelSteps{true}, stereo::MedianFilter{true}};

BENCHMARK(fast_model)->Apply([](Bench* bench) {
   with_sizes_and_threads(bench, {{100, 3}, {96, 5}, {112, 5}, {64, 15}, {100, 21}});
});
BENCHMARK_CAPTURE(fast_model_options, census_5x5_window_5, kCensus5x5)->Apply(with_threads);
BENCHMARK_CAPTURE(fast_model_options, census_7x7_window_7_left_right_median, kCensus7x7)->Apply(with_threads);
BENCHMARK_CAPTURE(fast_model_options, ssd_window_7, kSsd)->Apply(with_threads);
BENCHMARK_CAPTURE(fast_model_options, opencv_bm, kOpenCvBm)->Apply(with_threads);
BENCHMARK(opencv_stereo_bm)->Apply([](Bench* bench) { with_sizes_and_threads(bench, {{64, 15}, {96, 5}, {112, 5}}); });
BENCHMARK_CAPTURE(semi_global_fast_model, census_5x5, kSemiGlobal)->Apply(with_threads);
BENCHMARK_CAPTURE(semi_global_fast_model, census_5x5_128, kSemiGlobal128)->Apply(with_threads);
BENCHMARK_CAPTURE(semi_global_fast_model, wide_penalties, kSemiGlobalWide)->Apply(with_threads);
BENCHMARK_CAPTURE(semi_global_fast_model, all_checks, kSemiGlobalAll)->Apply(with_threads);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, sgbm_64, cv::StereoSGBM::MODE_SGBM, 64)->Apply(with_threads);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, 3way_64, cv::StereoSGBM::MODE_SGBM_3WAY, 64)->Apply(with_threads);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, 3way_128, cv::StereoSGBM::MODE_SGBM_3WAY, 128)->Apply(with_threads);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, hh4_64, cv::StereoSGBM::MODE_HH4, 64)->Apply(with_threads);
BENCHMARK_CAPTURE(opencv_stereo_sgbm, hh_64, cv::StereoSGBM::MODE_HH, 64)->Apply(with_threads);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007, "ambrosch2007")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007_p2, "ambrosch2007_p2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(clocked_core, ambrosch2007_p4, "ambrosch2007_p4")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
