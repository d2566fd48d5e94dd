#include "study/log/log_schema.h"

#include <fmt/core.h>

#include <vector>

#include "stimuli/definition/artifact.h"
#include "study/log/origin.h"
#include "study/placement/trial.h"

namespace seamline::study {
namespace {

/// 'receiver', 'shadow', ...
template <class Words>
std::string word_list(const Words& words) {
  std::string list;
  for (const auto value : words) list += fmt::format("{}'{}'", list.empty() ? "" : ", ", word(value));
  return list;
}

// STRICT tables refuse values of another type. Participants are codes, and codes have no room for a name with
// spaces. Rows of a participant hang on the participant, so that forgetting one is one DELETE.
// What later versions add stands at the end of its table: a row of version 2, read by the words of version 3,
// has NULL there (`study/log/recovery/log_salvage.h`).
constexpr const char* schema = R"sql(
CREATE TABLE study (
  id              INTEGER PRIMARY KEY CHECK (id = 1),
  study_name      TEXT NOT NULL,
  study_hash      TEXT NOT NULL CHECK (length(study_hash) > 0),
  set_hash        TEXT NOT NULL CHECK (length(set_hash) > 0),
  set_folder      TEXT NOT NULL,
  study_text      TEXT NOT NULL,
  program_version TEXT NOT NULL{study_since_3}
) STRICT;

CREATE TABLE stimuli (
  stimulus        INTEGER PRIMARY KEY CHECK (stimulus >= 0),  -- place in the manifest
  stimulus_id     TEXT NOT NULL UNIQUE CHECK (length(stimulus_id) > 0),
  scene           TEXT NOT NULL CHECK (length(scene) > 0),
  artifact        TEXT NOT NULL CHECK (artifact IN ({artifacts})),
  object          TEXT NOT NULL CHECK (length(object) > 0),
  object_index    INTEGER NOT NULL CHECK (object_index BETWEEN 1 AND {most}),
  depth_width_px  INTEGER NOT NULL CHECK (depth_width_px >= 2 AND depth_width_px % 2 = 0),
  yaw_texels      {yaw} NOT NULL{yaw_check},
  sha256          TEXT NOT NULL{stimuli_since_3}
) STRICT;

CREATE TABLE participants (
  participant     INTEGER PRIMARY KEY,
  code            TEXT NOT NULL UNIQUE CHECK (length(code) BETWEEN 1 AND 64 AND code NOT GLOB '*[^A-Za-z0-9._-]*'),
  slot            INTEGER NOT NULL CHECK (slot >= 0),          -- which order of trials
  pilot           INTEGER NOT NULL CHECK (pilot IN (0, 1)),
  excluded        INTEGER NOT NULL DEFAULT 0 CHECK (excluded IN (0, 1)),
  completed       INTEGER NOT NULL DEFAULT 0 CHECK (completed IN (0, 1)),
  observer        TEXT CHECK (length(observer) > 0),           -- kind of simulated observer; NULL for a person
  seed            INTEGER,                                     -- of the simulation: 64 bits, stored as signed
  image_gain      REAL CHECK (image_gain > 0),                 -- of the simulated observer `image`
  CHECK ((observer IS NULL) = (seed IS NULL)),
  CHECK (image_gain IS NULL OR observer = 'image')
) STRICT;

CREATE TABLE sessions (
  session         INTEGER PRIMARY KEY,
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  started_unix_s  INTEGER NOT NULL CHECK (started_unix_s >= 0),
  last_unix_s     INTEGER NOT NULL CHECK (last_unix_s >= 0),   -- last answer, or the start
  frames          INTEGER NOT NULL DEFAULT 0 CHECK (frames >= 0),
  late_frames     INTEGER NOT NULL DEFAULT 0 CHECK (late_frames >= 0),
  program_version TEXT NOT NULL
) STRICT;
CREATE INDEX sessions_of_participant ON sessions (participant);

CREATE TABLE displays (  -- what the pictures of a session were shown on
  session              INTEGER PRIMARY KEY REFERENCES sessions ON DELETE CASCADE,
  machine              TEXT NOT NULL,
  monitor              TEXT NOT NULL,
  renderer             TEXT NOT NULL,
  mode_width_px        INTEGER NOT NULL CHECK (mode_width_px >= 0),
  mode_height_px       INTEGER NOT NULL CHECK (mode_height_px >= 0),
  refresh_hz           REAL NOT NULL CHECK (refresh_hz >= 0),
  content_scale        REAL NOT NULL CHECK (content_scale > 0),
  framebuffer_width_px INTEGER NOT NULL CHECK (framebuffer_width_px >= 0),
  framebuffer_height_px INTEGER NOT NULL CHECK (framebuffer_height_px >= 0),
  mm_per_px            REAL NOT NULL CHECK (mm_per_px >= 0),
  viewing_distance_mm  REAL NOT NULL CHECK (viewing_distance_mm >= 0),
  pixels_per_degree    REAL NOT NULL CHECK (pixels_per_degree >= 0),
  gamma_confirmed      INTEGER NOT NULL CHECK (gamma_confirmed IN (0, 1)),
  read_back_bytes      INTEGER NOT NULL CHECK (read_back_bytes >= 0),
  read_back_different  INTEGER NOT NULL CHECK (read_back_different BETWEEN 0 AND read_back_bytes),
  scaling_allowed      INTEGER NOT NULL CHECK (scaling_allowed IN (0, 1)),
  image_scale          REAL NOT NULL CHECK (image_scale > 0),
  CHECK (scaling_allowed = 1 OR image_scale = 1)
) STRICT;

CREATE TABLE consent_texts (  -- what people agreed to, word for word; a study file can be edited
  text_sha256     TEXT PRIMARY KEY CHECK (length(text_sha256) = 64),
  text            TEXT NOT NULL CHECK (length(text) > 0)
) STRICT;

CREATE TABLE consents (
  participant     INTEGER PRIMARY KEY REFERENCES participants ON DELETE CASCADE,
  accepted_unix_s INTEGER NOT NULL CHECK (accepted_unix_s >= 0),
  text_sha256     TEXT NOT NULL REFERENCES consent_texts
) STRICT;

CREATE TABLE declines (  -- that someone did not take part, and when; not who
  decline         INTEGER PRIMARY KEY,
  declined_unix_s INTEGER NOT NULL CHECK (declined_unix_s >= 0)
) STRICT;

CREATE TABLE form_answers (
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  field           TEXT NOT NULL CHECK (length(field) > 0),
  value           TEXT NOT NULL CHECK (length(value) > 0),
  PRIMARY KEY (participant, field)
) STRICT, WITHOUT ROWID;

CREATE TABLE trials (  -- planned; an adaptive procedure adds them one by one, and may show a stimulus again
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  trial_index     INTEGER NOT NULL CHECK (trial_index >= 0),
  kind            TEXT NOT NULL CHECK (kind IN ({kinds})),
  stimulus        INTEGER NOT NULL REFERENCES stimuli,         -- of a catch trial: whose scene and object{trials_of_tasks}
  PRIMARY KEY (participant, trial_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE answers (
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  trial_index     INTEGER NOT NULL,
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  chosen_index    INTEGER NOT NULL CHECK (chosen_index BETWEEN 1 AND {most}),
  rating          INTEGER NOT NULL CHECK (rating BETWEEN 1 AND 4),
  choice_ns       INTEGER NOT NULL CHECK (choice_ns >= 0),     -- from the image's onset
  rating_ns       INTEGER NOT NULL CHECK (rating_ns >= choice_ns),
  image_scale     REAL NOT NULL CHECK (image_scale > 0),       -- screen pixels a picture pixel
  PRIMARY KEY (participant, trial_index),
  FOREIGN KEY (participant, trial_index) REFERENCES trials ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE training_answers (  -- practice with feedback: never analysed
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  training_index  INTEGER NOT NULL CHECK (training_index >= 0),
  kind            TEXT NOT NULL CHECK (kind IN ({kinds})),
  stimulus        INTEGER NOT NULL REFERENCES stimuli,
  chosen_index    INTEGER NOT NULL CHECK (chosen_index BETWEEN 1 AND {most}),
  rating          INTEGER NOT NULL CHECK (rating BETWEEN 1 AND 4),
  choice_ns       INTEGER NOT NULL CHECK (choice_ns >= 0),
  rating_ns       INTEGER NOT NULL CHECK (rating_ns >= choice_ns),
  PRIMARY KEY (session, training_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE set_aside_answers (  -- of participants who began again: never analysed
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  attempt         INTEGER NOT NULL CHECK (attempt >= 1),       -- 1: the first one
  trial_index     INTEGER NOT NULL CHECK (trial_index >= 0),
  kind            TEXT NOT NULL CHECK (kind IN ({kinds})),
  stimulus        INTEGER NOT NULL REFERENCES stimuli,
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  chosen_index    INTEGER NOT NULL CHECK (chosen_index BETWEEN 1 AND {most}),
  rating          INTEGER NOT NULL CHECK (rating BETWEEN 1 AND 4),
  choice_ns       INTEGER NOT NULL CHECK (choice_ns >= 0),
  rating_ns       INTEGER NOT NULL CHECK (rating_ns >= choice_ns),
  image_scale     REAL NOT NULL CHECK (image_scale > 0),
  PRIMARY KEY (participant, attempt, trial_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE events (  -- raw: shown, choice, rating, focus, pause, resize, ...
  event           INTEGER PRIMARY KEY,
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  monotonic_ns    INTEGER NOT NULL CHECK (monotonic_ns >= 0),
  kind            TEXT NOT NULL CHECK (length(kind) > 0),
  trial_index     INTEGER CHECK (trial_index >= 0),            -- NULL outside trials
  detail          TEXT NOT NULL DEFAULT '',
  swap            INTEGER CHECK (swap >= 0)                    -- buffer swap that showed it; NULL: none did
) STRICT;
CREATE INDEX events_of_session ON events (session);

CREATE TABLE deletions (  -- that someone was forgotten, and when; not who
  deletion        INTEGER PRIMARY KEY,
  deleted_unix_s  INTEGER NOT NULL CHECK (deleted_unix_s >= 0),
  answers         INTEGER NOT NULL CHECK (answers >= 0)
) STRICT;
)sql";

constexpr const char* study_since_3 = R"sql(,
  quantity        TEXT NOT NULL CHECK (length(quantity) > 0),  -- what the levels are values of
  noticeability   TEXT NOT NULL CHECK (noticeability IN ('falls', 'rises')))sql";

constexpr const char* trials_of_tasks = R"sql(
  right_index     INTEGER NOT NULL CHECK (right_index BETWEEN 0 AND {most}),  -- alternative that is right; 0: the object, or none)sql";

constexpr const char* stimuli_since_3 = R"sql(,
  condition       TEXT NOT NULL,                               -- '' where the study has one condition
  level           REAL NOT NULL CHECK (level >= 0 AND level < 9e999))sql";

// What browsers need is in tables of its own, so that a log of the window becomes one of both by adding them.
constexpr const char* online_schema = R"sql(
CREATE TABLE online_participants (  -- who takes part in a browser; the others in the window
  participant     INTEGER PRIMARY KEY REFERENCES participants ON DELETE CASCADE,
  origin          TEXT NOT NULL CHECK (origin IN ({origins})),
  secret_sha256   TEXT UNIQUE CHECK (length(secret_sha256) = 64)  -- of what their browser proves itself with
) STRICT;

CREATE TABLE online_messages (  -- every message that is stored, so that none is stored twice
  id              TEXT PRIMARY KEY CHECK (length(id) = 36),
  participant     INTEGER REFERENCES participants ON DELETE CASCADE,  -- NULL: somebody declined
  sequence        INTEGER NOT NULL CHECK (sequence >= 0),             -- of the participant's messages
  kind            TEXT NOT NULL CHECK (length(kind) > 0),
  trial_index     INTEGER CHECK (trial_index >= 0),                   -- of an answer
  content_sha256  TEXT NOT NULL CHECK (length(content_sha256) = 64),
  UNIQUE (participant, sequence)
) STRICT, WITHOUT ROWID;

CREATE TABLE online_sittings (  -- sessions that were in a browser
  session         INTEGER PRIMARY KEY REFERENCES sessions ON DELETE CASCADE,
  user_agent      TEXT NOT NULL
) STRICT;

CREATE TABLE online_tokens (  -- invitations that were used; not by whom
  token_sha256    TEXT PRIMARY KEY CHECK (length(token_sha256) = 64)
) STRICT, WITHOUT ROWID;
)sql";

}  // namespace

std::string online_tables_sql() {
  return fmt::format(fmt::runtime(online_schema), fmt::arg("origins", word_list(every_web_origin)));
}

namespace {

std::vector<Artifact> artifacts_of(int version) {
  std::vector<Artifact> known(every_artifact.begin(), every_artifact.end());
  if (!knows_reflection(version)) std::erase(known, Artifact::reflection);
  return known;
}

}  // namespace

std::string log_schema_sql(int version) {
  const bool since_3 = version >= 3;
  return fmt::format(
      "{}{}PRAGMA application_id = {};\nPRAGMA user_version = {};\n",
      fmt::format(fmt::runtime(schema), fmt::arg("artifacts", word_list(artifacts_of(version))),
                  fmt::arg("kinds", word_list(every_trial_kind)),
                  fmt::arg("yaw_check", since_3 ? " CHECK (typeof(yaw_texels) IN ('integer', 'real'))" : ""),
                  fmt::arg("yaw", since_3 ? "ANY" : "INTEGER"),
                  fmt::arg("study_since_3", since_3 ? study_since_3 : ""),
                  fmt::arg("stimuli_since_3", since_3 ? stimuli_since_3 : ""),
                  fmt::arg("trials_of_tasks", knows_tasks(version)
                                                  ? fmt::format(fmt::runtime(trials_of_tasks),
                                                                fmt::arg("most", most_choices(version)))
                                                  : ""),
                  fmt::arg("most", most_choices(version))),
      has_online_tables(version) ? online_tables_sql() : "", log_application_id, version);
}

}  // namespace seamline::study
