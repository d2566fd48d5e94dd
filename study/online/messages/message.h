#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stimuli/definition/form_definition.h"
#include "study/log/origin.h"
#include "study/placement/trial.h"

namespace seamline::study::online {

// What a page of a study in a browser says, as values. One message is one line of JSON (`message_reader.h`,
// `message_writer.h`); documentation/how-to/online.md describes it. Times are whole numbers; those in ns are
// monotonic.

inline constexpr std::string_view message_format = "seamline-online-1";

// How much a message may hold.
inline constexpr std::size_t most_line_bytes = std::size_t{64} << 10;  ///< without its line end
inline constexpr std::int64_t most_sequence = 10'000'000;
inline constexpr std::int64_t most_trials = 1'000'000;
inline constexpr std::int64_t most_time_ns = std::int64_t{1}
                                             << 53;           ///< what a browser's numbers hold exactly
inline constexpr std::int64_t most_unix_s = 253'402'300'799;  ///< the end of the year 9999
inline constexpr std::size_t most_form_answers = 200;
inline constexpr std::size_t most_user_agent_bytes = 512;

/// The first message: somebody read the consent and accepted it.
struct EnrolBody {
  int slot = -1;               ///< of the orders; -1: the server gives one
  std::string consent_sha256;  ///< of the text that was shown
  std::int64_t accepted_unix_s = 0;
  std::string user_agent = {};
  Origin origin = Origin::serve;
  bool pilot = false;  ///< a trial run, as the page was exported for
  bool operator==(const EnrolBody&) const = default;
};
/// Somebody did not consent: the fact alone.
struct DeclineBody {
  bool operator==(const DeclineBody&) const = default;
};
/// The page was opened again.
struct BeginBody {
  std::string user_agent = {};
  bool operator==(const BeginBody&) const = default;
};
struct FormBody {
  std::vector<FormAnswer> answers = {};
  bool operator==(const FormBody&) const = default;
};
/// What a browser knows of its screen; sizes of the screen in device pixels, of the viewport in CSS pixels.
struct DisplayBody {
  int screen_width_px = 0, screen_height_px = 0;
  double device_pixel_ratio = 1;
  int viewport_width_px = 0, viewport_height_px = 0;
  double mm_per_px = 0;            ///< of a device pixel, measured against a bank card
  double viewing_distance_mm = 0;  ///< as entered
  double pixels_per_degree = 0;
  double refresh_hz = 0;
  bool gamma_confirmed = false;
  double image_scale = 1;  ///< device pixels a picture pixel
  bool operator==(const DisplayBody&) const = default;
};
/// What a participant did with one picture.
struct PictureAnswer {
  TrialKind kind = TrialKind::stimulus;
  std::string stimulus_id;
  int chosen_index = 0;        ///< 1 left, 2 middle, 3 right
  int rating = 0;              ///< 1..4
  std::int64_t choice_ns = 0;  ///< from the picture's onset
  std::int64_t rating_ns = 0;  ///< from the picture's onset; at least choice_ns
  int position = -1;           ///< of a slider, 0 to `slider_end`; -1: none, and no key of the message
  bool operator==(const PictureAnswer&) const = default;
};
struct TrainingBody {
  int training_index = 0;
  PictureAnswer answer;
  bool operator==(const TrainingBody&) const = default;
};
struct AnswerBody {
  int trial_index = 0;
  PictureAnswer answer;
  double image_scale = 1;
  bool operator==(const AnswerBody&) const = default;
};
/// Something raw: shown, focus_lost, zoom, reload, pause, ...
struct EventBody {
  std::int64_t monotonic_ns = 0;
  std::string kind;
  std::optional<int> trial_index = {};
  std::string detail = {};
  bool operator==(const EventBody&) const = default;
};
/// Everything is answered.
struct CompletionBody {
  bool operator==(const CompletionBody&) const = default;
};
using MessageBody = std::variant<EnrolBody, DeclineBody, BeginBody, FormBody, DisplayBody, TrainingBody,
                                 AnswerBody, EventBody, CompletionBody>;

/// "enrol", "decline", "begin", ...
[[nodiscard]] std::string_view kind_word(const MessageBody& body);

struct Message {
  std::string study_hash, set_hash;
  std::string participant;    ///< a code; empty in a decline, and in an enrolment whose code the server gives
  std::int64_t sequence = 0;  ///< 0, 1, 2, ... of this participant
  std::string id;             ///< a UUID of version 4 in lower case: the key by which nothing is stored twice
  MessageBody body;
  bool operator==(const Message&) const = default;
};

}  // namespace seamline::study::online
