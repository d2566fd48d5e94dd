#include <nlohmann/json.hpp>

#include "analysis/psychometric/report/fit_json.h"
#include "analysis/psychometric/report/grouped_fit.h"
#include "support/files/assets.h"
#include "support/text/printable.h"

namespace seamline::analysis {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson people_json(const FittedGroup& group, const std::vector<std::string>& names) {
  const PeopleFit& mixed = *group.mixed;
  OrderedJson json = {{"identified", mixed.identified},
                      {"reason", mixed.why.empty() ? OrderedJson(nullptr) : OrderedJson(mixed.why)},
                      {"participants", mixed.people},
                      {"remarks", mixed.remarks}};
  if (!mixed.identified) return json;
  const std::string& unit = group.sums.request.unit;
  const std::string axis_unit = group.sums.fit.options.axis == study::Axis::log2 ? "octaves" : unit;
  json["threshold"] = {
      {"estimate", mixed.threshold}, {"ci95", ends_json(mixed.threshold_ci95)}, {"unit", unit}};
  json["threshold_sd"] = {{"estimate", mixed.threshold_sd}, {"unit", axis_unit}};
  json["width"] = {{"estimate", mixed.width}, {"ci95", ends_json(mixed.width_ci95)}, {"unit", axis_unit}};
  json["log2_width_sd"] = mixed.width_sd;
  json["lapse"] = mixed.lapse;
  json["guess"] = mixed.guess;
  json["log_likelihood"] = mixed.log_likelihood;
  json["aic"] = mixed.aic;
  json["each"] = OrderedJson::array();
  for (std::size_t p = 0; p < mixed.each.size(); ++p) {
    const PersonEstimate& one = mixed.each[p];
    json["each"].push_back({{"participant", clean_text(names[group.people[p]])},
                            {"trials", one.trials},
                            {"threshold", one.threshold},
                            {"threshold_ci95", ends_json(one.threshold_ci95)},
                            {"width", one.width},
                            {"width_ci95", ends_json(one.width_ci95)}});
  }
  return json;
}

OrderedJson difference_json(const GroupDifference& difference) {
  return {{"estimate", difference.estimate ? number_or_null(*difference.estimate) : OrderedJson(nullptr)},
          {"ci95", ends_json(difference.ci95)},
          {"p", number_or_null(difference.p)},
          {"p_adjusted", number_or_null(difference.adjusted_p)}};
}

}  // namespace

std::string grouped_json(const GroupedFit& fits) {
  OrderedJson json;
  if (fits.groups.front().name.empty()) {
    json = OrderedJson::parse(fit_json(fits.groups.front().sums));
    json["people"] = people_json(fits.groups.front(), fits.participants);
  } else {
    json["format"] = "seamline psychometric fit";
    json["version"] = 1;
    json["program_version"] = program_version();
    json["groups"] = OrderedJson::array();
    for (const FittedGroup& group : fits.groups) {
      OrderedJson one = {{"group", clean_text(group.name)}};
      one.update(OrderedJson::parse(fit_json(group.sums)));
      for (const char* key : {"format", "version", "program_version"}) one.erase(key);
      if (group.mixed) one["people"] = people_json(group, fits.participants);
      json["groups"].push_back(one);
    }
    json["differences"] = OrderedJson::array();
    for (const GroupPair& pair : fits.pairs)
      json["differences"].push_back({{"first", clean_text(fits.groups[pair.first].name)},
                                     {"second", clean_text(fits.groups[pair.second].name)},
                                     {"threshold", difference_json(pair.threshold)},
                                     {"log2_width", difference_json(pair.log2_width)}});
  }
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace seamline::analysis
