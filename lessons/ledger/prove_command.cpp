#include <algorithm>
#include <chrono>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/failure.hpp>
#include <lessons/bounded.hpp>
#include <lessons/ledger/cases.hpp>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/checked.hpp>
#include <lessons/ledger/counterexample.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/one_phase.hpp>
#include <lessons/ledger/parts_by_sign.hpp>
#include <lessons/ledger/reading.hpp>
#include <lessons/ledger/report.hpp>

namespace rederive {

namespace {

using Json = nlohmann::ordered_json;

bool is_proved(const Proof& proof) {
  return proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
}

/// Whether it says that something holds, if only to an order.
bool is_positive(const Proof& proof) { return is_proved(proof) || proof.verdict == Verdict::approximation; }

/// What the computer algebra throws, overflows and poles, leaves a statement undecided.
template <class Work>
Certified<Proof> or_undecided(Work work) {
  try {
    return work();
  } catch (const BadInput&) {
    throw;
  } catch (const std::exception& error) {
    Proof proof;
    proof.reason = in_plain_words(error);
    return {proof, nullptr};
  }
}

/// With the equations that are assumed, where these are needed, and those that only tell the cases apart.
Json certificate_of(const Proof& proof, const std::vector<Case>& cases, const ProveRequest& request) {
  const bool with_equations = proof.verdict == Verdict::proved_under || !has_equations(request);
  std::vector<Json> each;
  for (const auto& [request, context, in_pieces] : cases)
    if (has_values(context, request))
      each.push_back(certificate(read(request.left, context.symbols), read(request.right, context.symbols),
                                 context.symbols, context.put_in_at_once(with_equations)));
  return each.size() == 1 ? each[0] : certificate_of_cases(each);
}

/// Decides in all cases. Nothing is proved but what has a certificate that its checker accepts.
Certified<Proof> decide_as_they_stand(const std::vector<Case>& cases, const ProveRequest& request) {
  Certified<Proof> found{decide_each(cases, request), nullptr};
  if (!is_proved(found.proof)) return found;
  std::string why;
  try {
    found.certificate = certificate_of(found.proof, cases, request);
    why = objection_to(found.certificate);
  } catch (const Undecidable& error) {
    why = error.what();
  }
  if (why.empty()) return found;
  Proof undecided;
  undecided.reason = "it seems to hold (" + found.proof.reason + "), but the proof was not confirmed: " + why;
  return {undecided, nullptr};
}

/// The same; and what that leaves open with symbols that stand together taken for one.
Certified<Proof> decide_also_with_one_phase(const std::vector<Case>& cases, const ProveRequest& request) {
  auto found = decide_as_they_stand(cases, request);
  if (found.proof.verdict != Verdict::undecided || request.order) return found;
  std::vector<Case> taken;
  bool is_other = false;
  for (const Case& one : cases) {
    auto parts = with_one_phase(one);
    is_other = is_other || !parts.empty();
    if (parts.empty()) parts.push_back(one);
    std::move(parts.begin(), parts.end(), std::back_inserter(taken));
  }
  if (!is_other) return found;
  try {
    auto as_one = decide_as_they_stand(taken, request);
    if (is_proved(as_one.proof)) return as_one;
  } catch (const BadInput&) {  // of what the user did not say
  }
  return found;
}

/// The same, and nothing that a point speaks against.
Certified<Proof> decide_and_check(const std::vector<Case>& cases, const ProveRequest& request) {
  auto found = decide_also_with_one_phase(cases, request);
  found.proof = unless_contradicted(std::move(found.proof), request);
  if (!is_proved(found.proof)) found.certificate = nullptr;
  return found;
}

/// All that a proof may rest on.
std::vector<std::string> conditions_of(const std::vector<Case>& cases, const ProveRequest& request) {
  return of_each(cases, request, [](const Case& one) { return conditions_of(one.context, one.request); });
}

/// What must hold for both sides to have values.
std::vector<std::string> side_conditions(const Case& one, Verdict verdict) {
  const Context& context = one.context;
  std::vector<Tree> sides;
  for (const std::string* text : {&one.request.left, &one.request.right})
    for (const Tree& side : read(*text, context.symbols).sides) sides.push_back(side);
  return side_conditions(sides, context.symbols, context.put_in_at_once(verdict == Verdict::proved_under));
}

/// What the whole leaves open, in parts. Nothing where they leave it open, too.
std::optional<Certified<Proof>> decide_in_parts(const ProveRequest& request) {
  const auto decide_all = [&](const std::vector<Case>& parts) {
    return or_undecided([&] { return decide_and_check(parts, request); });
  };
  for (const Way& way : parts_by_sign(request)) {
    const std::vector<Case> parts = way();
    const auto is_open = [&](const Case& one) { return !is_proved(decide_all({one}).proof); };
    if (parts.empty() || is_open(parts.back()) || is_open(parts.front())) continue;  // most ways end here
    auto found = decide_all(parts);
    if (!is_proved(found.proof)) continue;
    const std::vector<Case> whole = cases_of(request);
    found.proof.side_conditions = side_conditions(whole[0], found.proof.verdict);
    add_new(conditions_of(whole, request), found.proof.side_conditions);
    return found;
  }
  return std::nullopt;
}

}  // namespace

Certified<Proof> decide(const ProveRequest& request) {
  return or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    auto found = decide_and_check(cases, request);
    if (found.proof.verdict == Verdict::undecided) return decide_in_parts(request).value_or(found);
    Proof& proof = found.proof;
    if (is_positive(proof)) add_new(conditions_used(proof.verdict, cases, request), proof.side_conditions);
    return found;
  });
}

namespace {

/// What the work gives, as text; or why it gave nothing. The child does everything that may be expensive;
/// what it could not read is said here.
Bounded bounded(const std::function<std::string()>& work, double seconds, double patience) {
  const auto or_error = [&]() -> std::string {
    try {
      return "J" + work();
    } catch (const BadInput& error) {
      return std::string("B") + error.what();
    }
  };
  Bounded outcome = run_bounded(or_error, seconds, 480, patience);
  if (outcome.result && outcome.result->front() == 'B') throw BadInput(outcome.result->substr(1));
  if (outcome.result) outcome.result->erase(0, 1);
  return outcome;
}

/// The proof, as conditions all that it may rest on, and the certificate.
std::string decision(const ProveRequest& request) {
  Json conditions = Json::array();
  const auto [proof, certificate] = or_undecided([&] {
    const std::vector<Case> cases = cases_of(request);
    auto found = decide_and_check(cases, request);
    if (is_positive(found.proof)) conditions = conditions_of(cases, request);
    return found;
  });
  return Json{to_json(proof), conditions, certificate}.dump();
}

/// The proof and the certificate of what is proved in parts; null if it is not.
std::string decision_in_parts(const ProveRequest& request) {
  const auto found = decide_in_parts(request);
  return found ? Json{to_json(found->proof), found->certificate}.dump() : "null";
}

/// Those among them that it does rest on; all of them, if there is no time to find out.
Json conditions_within(double seconds, double patience, const Json& all, const Json& verdict,
                       const ProveRequest& request) {
  const auto work = [&] {
    const Verdict found = verdict == "proved"         ? Verdict::proved
                          : verdict == "proved_under" ? Verdict::proved_under
                                                      : Verdict::approximation;
    return Json(conditions_used(found, cases_of(request), request)).dump();
  };
  const Bounded outcome = all.empty() ? Bounded{} : bounded(work, seconds, patience);
  return outcome.result ? Json::parse(*outcome.result) : all;
}

}  // namespace

Certified<Json> decide_bounded(const ProveRequest& request, double patience) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto left = [&] { return patience - std::chrono::duration<double>(Clock::now() - start).count(); };
  const Bounded outcome = bounded([&] { return decision(request); }, 1.7, left());
  if (!outcome.result) {
    Proof proof;
    proof.reason = "given up: " + outcome.why;
    return {to_json(proof), nullptr};
  }
  Json parts = Json::parse(*outcome.result), &proof = parts[0];
  if (proof["verdict"] == "undecided") {
    const Bounded again = bounded([&] { return decision_in_parts(request); }, 1.7 - outcome.seconds, left());
    const Json found = Json::parse(again.result.value_or("null"));
    return found.is_null() ? Certified<Json>{proof, nullptr} : Certified<Json>{found[0], found[1]};
  }
  Json& said = proof["side_conditions"];
  const Json used = conditions_within(1.75 - outcome.seconds, left(), parts[1], proof["verdict"], request);
  for (const Json& condition : used)
    if (std::count(said.begin(), said.end(), condition) == 0) said.push_back(condition);
  return {proof, parts[2]};
}

}  // namespace rederive
