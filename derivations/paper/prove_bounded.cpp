#include <derivations/paper/json.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <derivations/program/bounded.hpp>
#include <nlohmann/json.hpp>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace program;

/// The child does everything that may be expensive; what it could not read is said here.
nlohmann::ordered_json decide_bounded(const Paper& paper, const ProveRequest& request,
                                      const std::function<bool()>& stop) {
  const auto work = [&]() -> std::string {
    try {
      return "J" + to_json(decide(paper, request)).dump();
    } catch (const BadInput& error) {
      return std::string("B") + error.what();
    }
  };
  const Bounded outcome = run_bounded(work, 1.75, 480, 60, {}, stop);
  if (outcome.result && outcome.result->front() == 'B') throw BadInput(outcome.result->substr(1));
  if (outcome.result) return nlohmann::ordered_json::parse(outcome.result->substr(1));
  Proof proof;
  proof.reason = "the decision was given up: " + outcome.why;
  return to_json(proof);
}

}  // namespace rederive::paper
