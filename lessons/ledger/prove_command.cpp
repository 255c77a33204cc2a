#include <algorithm>
#include <derivations/algebra/failure.hpp>
#include <derivations/bounded.hpp>
#include <lessons/ledger/cases.hpp>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/reading.hpp>
#include <lessons/ledger/report.hpp>

namespace rederive {

namespace {

bool is_proved(const Proof& proof) {
  return proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
}

/// What the computer algebra throws, overflows and poles, leaves a statement undecided.
template <class Work>
Proof or_undecided(Work work) {
  try {
    return work();
  } catch (const BadInput&) {
    throw;
  } catch (const std::exception& error) {
    Proof proof;
    proof.reason = in_plain_words(error);
    return proof;
  }
}

}  // namespace

Proof decide(const ProveRequest& request) {
  return or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    Proof proof = decide_each(cases, request);
    if (is_proved(proof)) add_new(conditions_used(proof.verdict, cases, request), proof.side_conditions);
    return proof;
  });
}

namespace {

/// What the work gives, as text; or why it gave nothing. The child does everything that may be expensive;
/// what it could not read is said here.
Bounded bounded(const std::function<std::string()>& work, double seconds) {
  const auto or_error = [&]() -> std::string {
    try {
      return "J" + work();
    } catch (const BadInput& error) {
      return std::string("B") + error.what();
    }
  };
  Bounded outcome = run_bounded(or_error, seconds, 480);
  if (outcome.result && outcome.result->front() == 'B') throw BadInput(outcome.result->substr(1));
  if (outcome.result) outcome.result->erase(0, 1);
  return outcome;
}

using Json = nlohmann::ordered_json;

/// The proof, and as conditions all that it may rest on.
std::string decision(const ProveRequest& request) {
  Json conditions = Json::array();
  const Proof proof = or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    Proof found = decide_each(cases, request);
    if (is_proved(found))
      conditions =
          of_each(cases, request, [](const Case& one) { return conditions_of(one.context, one.request); });
    return found;
  });
  return Json{to_json(proof), conditions}.dump();
}

/// Those among them that it does rest on; all of them, if there is no time to find out.
Json conditions_within(double seconds, const Json& all, const Json& verdict, const ProveRequest& request) {
  const auto work = [&] {
    const Verdict proved = verdict == "proved" ? Verdict::proved : Verdict::proved_under;
    return Json(conditions_used(proved, cases_of(request), request)).dump();
  };
  const Bounded outcome = all.empty() ? Bounded{} : bounded(work, seconds);
  return outcome.result ? Json::parse(*outcome.result) : all;
}

}  // namespace

Json decide_bounded(const ProveRequest& request) {
  const Bounded outcome = bounded([&] { return decision(request); }, 1.7);
  if (!outcome.result) {
    Proof proof;
    proof.reason = "given up: " + outcome.why;
    return to_json(proof);
  }
  Json parts = Json::parse(*outcome.result), &proof = parts[0];
  Json& said = proof["side_conditions"];
  for (const Json& condition : conditions_within(1.75 - outcome.seconds, parts[1], proof["verdict"], request))
    if (std::count(said.begin(), said.end(), condition) == 0) said.push_back(condition);
  return proof;
}

nlohmann::ordered_json certificate_bounded(const ProveRequest& request, bool with_equations) {
  const auto one_certificate = [&](const Case& one) {
    const Symbols& symbols = one.context.symbols;
    return certificate(read(one.request.left, symbols), read(one.request.right, symbols), symbols,
                       one.context.put_in_at_once(with_equations));
  };
  const auto work = [&]() -> std::string {
    std::vector<Json> each;
    try {
      for (const Case& one : cases_with_values(request)) each.push_back(one_certificate(one));
      return (each.size() == 1 ? each[0] : certificate_of_cases(each)).dump();
    } catch (const Undecidable& error) {
      return Json(error.what()).dump();
    }
  };
  const Bounded outcome = bounded(work, 20);
  return outcome.result ? Json::parse(*outcome.result) : Json("given up: " + outcome.why);
}

}  // namespace rederive
