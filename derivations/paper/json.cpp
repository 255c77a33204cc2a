#include <derivations/paper/json.hpp>
#include <derivations/paper/prove.hpp>
#include <nlohmann/json.hpp>

namespace rederive::paper {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace program;

using Json = nlohmann::ordered_json;

namespace {

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const Witness& witness) {
  Json json{{"at", witness.at}, {"printed", witness.printed}, {"derived", witness.derived}};
  if (!witness.exactly.empty()) json["exactly"] = witness.exactly;
  for (const auto& [name, bounds] : witness.between) json["between"][name] = {bounds.first, bounds.second};
  if (!witness.between.empty()) json["solves"] = witness.solves;
  json["in_words"] = in_words(witness);
  return json;
}

}  // namespace

std::string dimension_word(const Entry& entry) {
  if (!entry.dimension) return "not_applicable";
  return entry.dimension->consistent ? "consistent" : "inconsistent";
}

Json to_json(const Proof& proof) {
  const Json witness = proof.witness ? to_json(*proof.witness) : Json();
  Json conditions = Json::array();
  for (const Relation& condition : proof.side_conditions) conditions.push_back(print(condition));
  return {{"verdict", to_string(proof.verdict)}, {"factor", or_null(proof.factor)},
          {"side_conditions", conditions},       {"witness", witness},
          {"reason", or_null(proof.reason)},     {"by", or_null(word_of(proof.by))},
          {"certificate", proof.certificate}};
}

Json to_json(const Entry& entry) {
  const Row& row = entry.row;
  const Json proof = to_json(entry.proof);
  const bool approximate = entry.derivation && entry.derivation->order > 0;
  const bool refuted = entry.proof.verdict == Verdict::refuted;
  Json parts = Json::array();
  for (const auto& [part, derived, verdict] : entry.parts)
    parts.push_back({{"part", part.name},
                     {"printed", part.printed},
                     {"derived", or_null(derived)},
                     {"verdict", to_string(verdict)}});
  return {{"id", row.id},
          {"section", row.section},
          {"kind", to_string(row.kind)},
          {"domain", or_null(row.domain)},
          {"printed", or_null(row.typed.empty() ? row.printed : row.typed)},
          {"read_as", or_null(row.read_as)},
          {"derived", or_null(entry.derived)},
          {"parts", parts},
          {"verdict", proof["verdict"]},
          {"stated", entry.is_stated()},
          {"expected", to_string(row.expected)},
          {"factor", proof["factor"]},
          {"side_conditions", proof["side_conditions"]},
          {"assumption", entry.derivation ? or_null(entry.derivation->assumption) : Json()},
          {"order", approximate ? Json(entry.derivation->order) : Json()},
          {"error", refuted ? or_null(in_words(row.errors)) : Json()},
          {"correction", or_null(entry.correction)},
          {"witness", proof["witness"]},
          {"dimension", dimension_word(entry)},
          {"follows_from", row.follows_from},
          {"scan_repaired", !row.scan_repaired.empty()},
          {"scan", or_null(row.scan_repaired)},
          {"reason", proof["reason"]},
          {"rests_on_it", row.rests_on_it},
          {"consequence", or_null(row.consequence)}};
}

}  // namespace rederive::paper
