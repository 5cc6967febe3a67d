// SPDX-License-Identifier: Apache-2.0
#include "program/commands/named_matching.hpp"

#include "engines/clocked/core_modules.hpp"
#include "engines/clocked/match_clocked.hpp"
#include "program/commands/options_json.hpp"
#include "program/errors.hpp"

namespace stereo::app {

const Configuration& require_configuration(const std::string& name) {
   const Configuration* const found = find_configuration(name);
   if (found != nullptr) return *found;
   throw InputError("--config " + name + ": " + no_such_configuration());
}

std::shared_ptr<const Algorithm> named_algorithm(const std::string& config, const std::vector<std::string>& settings) {
   auto algorithm = with_options(require_configuration(config).algorithm, settings);
   const std::string problem = algorithm->problem();
   if (problem.empty()) return algorithm;
   std::string said;
   for (const std::string& setting : settings) said += "--set " + setting + (&setting == &settings.back() ? "" : " ");
   throw InputError((said.empty() ? "--config " + config : said) + ": " + problem);
}

const std::map<std::string, Engine>& engine_words() {
   static const std::map<std::string, Engine> words{{word_of(Engine::fast), Engine::fast},
                                                    {word_of(Engine::clocked), Engine::clocked}};
   return words;
}

const char* word_of(Engine engine) { return engine == Engine::fast ? "fast" : "clocked"; }

void require_settable(Engine engine, const std::vector<std::string>& settings) {
   if (engine == Engine::clocked && !settings.empty())
      throw InputError("--set " + settings.front() +
                       ": a clocked core has its options built in; leave --set out, or take --engine fast");
}

namespace {

template <class Pair>
DisparityMap match(const std::string& config, const Pair& pair, const Algorithm& algorithm, int threads,
                   Engine engine) {
   try {
      if (engine == Engine::clocked) return match_clocked(core_module(config), pair);
      return algorithm.match_fast(pair.left, pair.right, threads);
   } catch (const std::invalid_argument& problem) {
      throw InputError("--config " + config + ": " + problem.what());
   }
}

}  // namespace

DisparityMap match_named(const std::string& config, const ImagePair& pair, const Algorithm& algorithm, int threads,
                         Engine engine) {
   return match(config, pair, algorithm, threads, engine);
}

DisparityMap match_named(const std::string& config, const DeepPair& pair, const Algorithm& algorithm, int threads,
                         Engine engine) {
   return match(config, pair, algorithm, threads, engine);
}

}  // namespace stereo::app
