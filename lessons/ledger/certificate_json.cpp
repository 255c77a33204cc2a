#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/certificate_forms.hpp>
#include <lessons/ledger/certificate_json.hpp>

namespace rederive {

using Json = nlohmann::ordered_json;

Json statement_json(const Relation& relation, const CertifiedStatement& q) {
  Json list{q.text(relation.sides[0])};
  for (std::size_t k = 0; k < relation.operators.size(); ++k)
    list.push_back(relation.operators[k]), list.push_back(q.text(relation.sides[k + 1]));
  return list;
}

Json ranges_json(const std::vector<Tree>& trees, const CertifiedStatement& q) {
  std::set<std::string> names;
  for (const Tree& tree : trees) collect_names(tree, names);
  for (const Given& g : q.given)
    if (q.ranges.find(g.name)->range == all_numbers) names.erase(q.ranges.find(g.name)->name);
  Json ranges = Json::object();
  for (const std::string& name : names)
    if (const Symbol* symbol = q.ranges.find(name); symbol != nullptr && name != "pi")
      ranges[name] = symbol->range;
  return ranges;
}

Json factor_json(const CertifiedFactor& factor, const CertifiedStatement& q) {
  Json json = Json::object();
  for (const CertifiedPart& p : factor) {
    Json& exponent = json[q.text(p.part)];
    exponent = p.exponent + (exponent.is_null() ? 0 : exponent.get<int>());
  }
  return json;
}

namespace {

bool falls(const Layer& layer) {
  static const std::set<std::string> falling{"acos", "cos", "cot", "cos(atan)"};
  return layer.function == "*" || layer.function.ends_with("of") ? layer.turns
                                                                 : falling.contains(layer.function);
}

Json layers_json(const std::vector<CertifiedLayer>& layers, const CertifiedStatement& q) {
  Json list = Json::array();
  for (const auto& [layer, factor] : layers) {
    list.push_back({{"function", layer.function},
                    {"falls", falls(layer)},
                    {"left", q.text(Forms(q).short_tree(layer.left))},
                    {"right", q.text(Forms(q).short_tree(layer.right))}});
    if (layer.function == "*") list.back()["factor"] = factor_json(factor, q);
    if (layer.function.ends_with("of")) list.back()["of"] = q.text(to_tree(layer.of, q.symbols));
  }
  return list;
}

}  // namespace

Json part_json(const CertifiedSide& side, std::size_t k, const CertifiedStatement& q) {
  Json json{{"link", side.links[k]}};
  if (!side.layers[k].empty()) json["layers"] = layers_json(side.layers[k], q);
  return json;
}
Json side_json(const CertifiedSide& side, const GiNaC::ex& residual, const CertifiedStatement& q) {
  Json json{{"links", Json::array()}};
  for (std::size_t k = 0; k < side.links.size(); ++k) json["links"].push_back(part_json(side, k, q));
  if (side.sum) json["sum"] = q.text(side.sum);
  json["residual"] = fraction_text(residual);
  return json;
}

Json consequence_json(const CertifiedConsequence& why, const CertifiedStatement& q) {
  Json terms = Json::array();
  for (const auto& [factor, links] : why.terms)
    terms.push_back({{"factor", q.text(factor)}, {"links", links}});
  Json json{
      {"times", q.text(why.times)}, {"squared", why.squared}, {"terms", terms}, {"more", q.text(why.more)}};
  if (!why.product.empty()) json["product"] = factor_json(why.product, q);
  return json;
}

Json parts_of_divisors(const std::vector<CertifiedLink>& links, const CertifiedStatement& q) {
  Json json = Json::object();
  const auto add = [&](const CertifiedFactor& factor) {
    for (const CertifiedPart& p : factor)
      if (p.times)
        json[q.text(p.part)] = q.text(p.times);
      else if (p.square_of)
        json[q.text(p.part)] = {{"square of", q.text(p.square_of)}, {"more", q.text(p.more)}};
  };
  for (const CertifiedLink& link : links) {
    add(link.factor);
    if (link.follows) add(link.follows->product);
    for (const CertifiedSide& side : {link.left, link.right})
      for (const auto& layers : side.layers)
        for (const CertifiedLayer& layer : layers) add(layer.factor);
  }
  return json;
}

Json slopes_json(const std::vector<CertifiedLink>& links, const CertifiedStatement& q) {
  static const std::map<Slope::How, std::string> names{{Slope::How::range, "inside"},
                                                       {Slope::How::low, "low"},
                                                       {Slope::How::high, "high"},
                                                       {Slope::How::ends, "ends"},
                                                       {Slope::How::grows, "grows"}};
  Json json = Json::object();
  for (const CertifiedLink& link : links)
    for (const CertifiedSlope& s : link.slopes) {
      json[q.text(s.value)] = {{"in", GiNaC::ex_to<GiNaC::symbol>(s.why.in).get_name()},
                               {"sign", s.why.sign},
                               {"how", names.at(s.why.how)},
                               {"slope", q.text(s.slope)}};
      if (s.at_low) json[q.text(s.value)]["at low"] = q.text(s.at_low);
      if (s.at_high) json[q.text(s.value)]["at high"] = q.text(s.at_high);
      if (s.bend) json[q.text(s.value)]["bend"] = q.text(s.bend);
      if (s.by) json[q.text(s.value)]["by"] = q.text(s.by);
    }
  return json;
}

}  // namespace rederive
