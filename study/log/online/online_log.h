#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "study/log/log_writer.h"
#include "study/log/origin.h"

namespace seamline::study {

/// Somebody who takes part in a browser, as the log has them.
struct OnlinePerson {
  OpenSession place;  ///< its session is the latest; its answers may have gaps where messages are missing
  std::string code;
  Origin origin = Origin::serve;
  std::int64_t accepted_unix_s = 0;  ///< the consent
  std::set<int> answered = {};       ///< indices of trials with an answer
  int training_done = 0;             ///< practice trials with an answer, from the first on
  std::int64_t next_sequence = 0;    ///< one after the highest stored
  std::int64_t stored_bytes = 0;     ///< of their messages, about: `stored_bytes_of`
};

/// A message that is stored.
struct KnownMessage {
  std::string participant;  ///< code; empty: somebody declined
  std::string content_sha256;
};

/// What is noted of a message beside what it says.
struct MessageNote {
  std::string id;
  std::int64_t sequence = 0;
  std::string kind;
  std::optional<int> trial_index = {};
  std::string content_sha256;
  std::size_t free_text_bytes = 0;  ///< of an event's kind and detail, or a browser's user agent
};

/// What a message takes in the log, about: its rows, and the text that it may choose freely.
[[nodiscard]] constexpr std::int64_t stored_bytes_of(std::size_t free_text_bytes) {
  return 512 + static_cast<std::int64_t>(free_text_bytes);
}

/// Whom to enter.
struct OnlineNewcomer {
  std::string code;
  int slot = 0;
  bool pilot = false;
  Origin origin = Origin::serve;
  std::string secret_sha256 = {};  ///< empty: none
};

/// How far somebody in a browser is, for who looks on, and for quotas.
struct OnlineStanding {
  std::string code;
  bool pilot = false, excluded = false, completed = false;
  int answered = 0, trials = 0;
  std::int64_t began_unix_s = 0, last_unix_s = 0;
  std::vector<FormAnswer> form = {};
};

/// The log, open for people in browsers: of a schema version that has their tables; a log of the window
/// becomes one. Nothing here decides what may be stored: study/online/intake does. Every call belongs inside
/// `transaction`. Not for several threads at once. Throws InputError as LogWriter does.
class OnlineLog {
 public:
  OnlineLog(const std::filesystem::path& path, const RenderedSet& set);
  ~OnlineLog();
  OnlineLog(const OnlineLog&) = delete;
  OnlineLog& operator=(const OnlineLog&) = delete;

  /// Runs `work` as one transaction, on the disk when this returns.
  void transaction(const std::function<void()>& work);

  /// Who has this code; none: nobody. Throws InputError when they take part in the window, or in a session
  /// elsewhere.
  [[nodiscard]] std::optional<OnlinePerson> find(const std::string& code);
  /// Codes of those who are excluded, if another program has written into the log since the last call; none:
  /// nobody has.
  [[nodiscard]] std::optional<std::set<std::string>> excluded_since();
  [[nodiscard]] std::vector<HeldSlot> held_slots(bool pilot);
  [[nodiscard]] OnlinePerson enter(const OnlineNewcomer& newcomer);
  void set_secret(const OnlinePerson& person, const std::string& secret_sha256);
  /// Code by the hash of each secret.
  [[nodiscard]] std::map<std::string, std::string> secrets();
  /// False when the invitation was used before.
  [[nodiscard]] bool use_token(const std::string& token_sha256);

  [[nodiscard]] std::optional<KnownMessage> message(const std::string& id);
  [[nodiscard]] bool has_sequence(const OnlinePerson& person, std::int64_t sequence);
  /// All that are stored of a participant, rising.
  [[nodiscard]] std::vector<std::int64_t> sequences(const OnlinePerson& person);
  void note_message(OnlinePerson& person, const MessageNote& note);
  void note_decline(const MessageNote& note);

  /// The person opened the page: a row of a session.
  void begin_sitting(OnlinePerson& person, const std::string& user_agent, std::int64_t unix_s);
  void record_consent(OnlinePerson& person, const std::string& text, std::int64_t accepted_unix_s);
  void record_form(OnlinePerson& person, std::span<const FormAnswer> answers);
  void record_display(OnlinePerson& person, const DisplayFacts& facts);
  void append_trials(OnlinePerson& person, std::span<const Trial> trials);
  /// False when this session has an answer to this practice trial.
  [[nodiscard]] bool append_training(OnlinePerson& person, const TrainingAnswer& answer);
  /// `seen_unix_s`: by the clock on the wall.
  void append_answer(OnlinePerson& person, const TrialAnswer& answer, double image_scale,
                     std::int64_t seen_unix_s);
  void append_events(const OnlinePerson& person, std::span<const RawEvent> events);
  void complete(OnlinePerson& person);

  /// Rows of people in browsers, and of answers of everybody.
  struct Counts {
    std::int64_t participants = 0, answers = 0, deletions = 0;
  };
  [[nodiscard]] Counts counts();
  /// Everybody in browsers, in order of arrival.
  [[nodiscard]] std::vector<OnlineStanding> standings();
  [[nodiscard]] std::int64_t declines();

 private:
  struct Statements;
  LogWriter log_;
  std::unique_ptr<Statements> sql_;
  std::int64_t seen_version_ = 0;  ///< of the file, as SQLite counts what others wrote
};

/// Hashes of the invitations that a log has used; none where there is no log yet. Throws InputError as
/// reading a log does.
[[nodiscard]] std::set<std::string> used_invitations(const std::filesystem::path& log);

}  // namespace seamline::study
