#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "study/online/intake/refusal.h"
#include "study/online/serving/http_request.h"
#include "study/online/serving/recruitment_desk.h"

namespace seamline::study::online {

/// What the server says to a page, as JSON.
[[nodiscard]] HttpResponse json_answer(const nlohmann::ordered_json& json, int status = 200);

/// `reason`: what the page has words of its own for, in the study's language; empty: nothing.
[[nodiscard]] HttpResponse error_answer(int status, const std::string& sentence,
                                        const std::string& reason = {});
[[nodiscard]] HttpResponse error_answer(const Refusal& refusal);
[[nodiscard]] HttpResponse error_answer(const NoEntry& no);

/// Whoever had a secret and was forgotten, and whoever never had one, are the same in a log that somebody was
/// deleted from: nothing is left of them. Where nobody ever was, this is more likely another log than the one
/// that they answered into: their page waits, and the operator can begin again with the right one.
[[nodiscard]] HttpResponse nobody_answer(const std::string& secret, bool anybody_was_deleted);

/// Which messages are stored by now; `refusal`: why the next one is not, null where all are.
[[nodiscard]] HttpResponse messages_answer(const std::vector<std::string>& stored, const Refusal* refusal);

/// How a visit ended, with code and link; `outcome` is null where it has not.
[[nodiscard]] nlohmann::ordered_json json_of_end(const std::optional<VisitEnd>& end);

}  // namespace seamline::study::online
