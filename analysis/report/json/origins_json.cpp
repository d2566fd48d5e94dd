#include "analysis/report/json/thresholds_parts.h"

#include "analysis/report/json/json_values.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json group_json(const OriginGroup& group, const NoticeabilityData& data) {
  const std::string unit = unit_suffix(data.axis);
  Json json;
  json["participants"] = group.participants;
  json["artifacts"] = Json::array();
  for (const ArtifactThresholds& one : group.thresholds) {
    Json artifact;
    artifact["artifact"] = word(one.artifact);
    if (has_conditions(data)) artifact["condition"] = one.condition;
    artifact["participants"] = one.participants;
    artifact["perceptual_threshold" + unit] = json_estimate(one.estimates.perceptual, data.axis);
    artifact["slightly_noticeable" + unit] = json_estimate(one.estimates.slightly_noticeable, data.axis);
    artifact["inflection" + unit] = json_estimate(one.estimates.inflection, data.axis);
    json["artifacts"].push_back(std::move(artifact));
  }
  return json;
}

}  // namespace

Json origins_json(const Analysis& analysis) {
  const OriginComparison& origins = *analysis.origins;
  Json json;
  json["lab"] = group_json(origins.lab, analysis.data);
  json["web"] = group_json(origins.web, analysis.data);
  json["permutations"] = origins.permutations;
  json["differences"] = Json::array();
  for (const OriginDifference& found : origins.differences) {
    Json one;
    one["artifact"] = word(found.artifact);
    if (has_conditions(analysis.data)) one["condition"] = found.condition;
    one["quantity"] = found.quantity;
    one["lab"] = found.lab;
    one["web"] = found.web;
    one["difference_" + length_key(analysis.data.axis)] = json_number(found.difference);
    one["p"] = json_number(found.p);
    one["p_holm"] = json_number(found.p_holm);
    json["differences"].push_back(std::move(one));
  }
  return json;
}

}  // namespace seamline::analysis
