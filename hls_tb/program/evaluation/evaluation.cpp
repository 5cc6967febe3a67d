// SPDX-License-Identifier: Apache-2.0
#include "program/evaluation/evaluation.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "program/commands/options_json.hpp"

namespace stereo::app {
namespace {

constexpr const char* kBadNames[] = {"bad_0_5", "bad_1", "bad_2", "bad_4"};
constexpr const char* kBadTitles[] = {"bad 0.5", "bad 1", "bad 2", "bad 4"};
static_assert(std::size(kBadNames) == kBadThresholds.size() && std::size(kBadTitles) == kBadThresholds.size());
constexpr int kColumn = 9;  ///< characters

nlohmann::json known(double value) { return std::isnan(value) ? nlohmann::json() : nlohmann::json(value); }

nlohmann::json both_ways(const Measures& measures, int64_t bad) {
   return {{"invalid_bad", known(measures.with_invalid(bad))}, {"valid_only", known(measures.of_valid(bad))}};
}

nlohmann::json json_of(const Measures& measures) {
   nlohmann::json json{{"pixels", measures.pixels},
                       {"density", known(measures.density())},
                       {"avg_px", known(measures.average_px())},
                       {"rms_px", known(measures.rms_px())},
                       {"d1", both_ways(measures, measures.d1)}};
   for (std::size_t t = 0; t < kBadThresholds.size(); ++t) json[kBadNames[t]] = both_ways(measures, measures.bad[t]);
   return json;
}

void print(std::ostream& out, double value, int digits) {
   out << std::setw(kColumn);
   if (std::isnan(value)) out << '-';
   else out << std::setprecision(digits) << value;
}

void print_shares(std::ostream& out, const Measures& measures, bool invalid_is_bad) {
   const auto share = [&](int64_t bad) {
      print(out, 100 * (invalid_is_bad ? measures.with_invalid(bad) : measures.of_valid(bad)), 2);
   };
   for (const int64_t bad : measures.bad) share(bad);
   share(measures.d1);
}

std::size_t name_width(const Evaluation& evaluation) {
   std::size_t width = 6;
   for (const EvaluatedMethod& method : evaluation.methods) width = std::max(width, method.name.size());
   return width + 2;
}

void print_titles(std::ostream& out, int width) {
   out << std::left << std::setw(width) << "  method" << std::right;
   for (const char* const title : {"density", "avg px", "rms px"}) out << std::setw(kColumn) << title;
   for (int way = 0; way < 2; ++way) {
      for (const char* const title : kBadTitles) out << std::setw(kColumn) << title;
      out << std::setw(kColumn) << "D1" << (way == 0 ? "  |" : "\n");
   }
}

void print_mask(std::ostream& out, const Evaluation& evaluation, const std::string& name) {
   const int width = int(name_width(evaluation)) + 2;
   bool titled = false;
   for (const EvaluatedMethod& method : evaluation.methods)
      for (const NamedMeasures& mask : method.masks) {
         if (mask.mask != name) continue;
         if (!titled) out << '\n' << name << ": percent; first with invalid pixels as bad, then of the valid ones\n";
         if (!titled) print_titles(out, width);
         titled = true;
         out << std::left << std::setw(width) << "  " + method.name << std::right;
         print(out, 100 * mask.measures.density(), 2);
         print(out, mask.measures.average_px(), 3);
         print(out, mask.measures.rms_px(), 3);
         print_shares(out, mask.measures, true);
         out << "  |";
         print_shares(out, mask.measures, false);
         out << '\n';
      }
}

}  // namespace

DisparityRange range_of(const Algorithm& algorithm) {
   DisparityRange range{0, 0};
   for (const OptionValue& option : algorithm.options()) {
      if (option.name == "disparities") range.count = std::get<int>(option.value);
      if (option.name == "min_disparity") range.first = std::get<int>(option.value);
   }
   return range;
}

std::vector<NamedMeasures> measure_masks(const DisparityImage& found, Reference reference,
                                         const std::optional<DisparityRange>& range, const DisparityImage& truth,
                                         const std::vector<NamedMask>& masks) {
   std::vector<NamedMeasures> measured;
   const auto add = [&](const char* name, const GrayImage& mask) {
      const Measures measures = measure(found, truth, mask);
      if (measures.pixels > 0) measured.push_back({name, measures});
   };
   for (const NamedMask& mask : masks) {
      add(mask.name.c_str(), mask.mask);
      if (range && mask.name == kNonOccluded) add(kSearchable, searchable_mask(mask.mask, *range, reference));
   }
   return measured;
}

nlohmann::json measures_json(const std::vector<NamedMeasures>& masks) {
   nlohmann::json json = nlohmann::json::object();
   for (const NamedMeasures& mask : masks) json[mask.mask] = json_of(mask.measures);
   return json;
}

nlohmann::json evaluation_json(const Evaluation& evaluation) {
   nlohmann::json methods = nlohmann::json::array();
   for (const EvaluatedMethod& method : evaluation.methods) {
      methods.push_back({{"name", method.name},
                         {"kind", method.kind},
                         {"reference", word_of(method.reference)},
                         {"parameters", method.parameters},
                         {"milliseconds", known(method.milliseconds)},
                         {"masks", measures_json(method.masks)},
                         {"remarks", method.remarks}});
      if (!method.engine.empty())
         methods.back().update({{"engine", method.engine}, {"postprocessing", method.postprocessing}});
   }
   return {{"format", "stereo-hls evaluation 1"}, {"left", evaluation.left},
           {"right", evaluation.right},           {"width_px", evaluation.width_px},
           {"height_px", evaluation.height_px},   {"border_px", evaluation.border_px},
           {"threads", evaluation.threads},       {"methods", methods}};
}

std::string evaluation_text(const Evaluation& evaluation) {
   std::ostringstream out;
   out << std::fixed << size_text(evaluation.width_px, evaluation.height_px) << ", a border of " << evaluation.border_px
       << " px does not count; threads: " << evaluation.threads << "\n";
   for (const EvaluatedMethod& method : evaluation.methods) {
      out << std::left << std::setw(int(name_width(evaluation)) + 2) << "  " + method.name << std::right << "reference "
          << word_of(method.reference);
      if (!std::isnan(method.milliseconds)) out << ", " << std::setprecision(2) << method.milliseconds << " ms";
      if (method.masks.empty())
         out << ": no true disparities of its " << word_of(method.reference) << " image that count";
      out << '\n';
   }
   for (const EvaluatedMethod& method : evaluation.methods)
      for (const std::string& remark : method.remarks) out << remark << '\n';
   for (const char* const name : kMaskNames) print_mask(out, evaluation, name);
   return out.str();
}

}  // namespace stereo::app
