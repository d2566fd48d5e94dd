#include <fmt/core.h>

#include "stimuli/artifact.h"
#include "study/log_database.h"

namespace seamline {
namespace {

/// 'receiver', 'shadow', ...
std::string artifact_list() {
  std::string list;
  for (const Artifact artifact : every_artifact)
    list += fmt::format("{}'{}'", list.empty() ? "" : ", ", word(artifact));
  return list;
}

// STRICT tables refuse values of another type. Participants are codes, and codes have no room for a name with
// spaces. Rows of a participant hang on the participant, so that forgetting one is one DELETE.
constexpr const char* schema = R"sql(
CREATE TABLE study (
  id              INTEGER PRIMARY KEY CHECK (id = 1),
  study_name      TEXT NOT NULL,
  study_hash      TEXT NOT NULL CHECK (length(study_hash) > 0),
  set_hash        TEXT NOT NULL CHECK (length(set_hash) > 0),
  set_folder      TEXT NOT NULL,
  study_text      TEXT NOT NULL,
  program_version TEXT NOT NULL
) STRICT;

CREATE TABLE stimuli (
  stimulus        INTEGER PRIMARY KEY CHECK (stimulus >= 0),  -- place in the manifest
  stimulus_id     TEXT NOT NULL UNIQUE CHECK (length(stimulus_id) > 0),
  scene           TEXT NOT NULL CHECK (length(scene) > 0),
  artifact        TEXT NOT NULL CHECK (artifact IN ({artifacts})),
  object          TEXT NOT NULL CHECK (length(object) > 0),
  object_index    INTEGER NOT NULL CHECK (object_index BETWEEN 1 AND 3),
  depth_width_px  INTEGER NOT NULL CHECK (depth_width_px >= 2 AND depth_width_px % 2 = 0),
  yaw_texels      INTEGER NOT NULL,
  sha256          TEXT NOT NULL
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
  CHECK ((observer IS NULL) = (seed IS NULL))
) STRICT;

CREATE TABLE sessions (
  session         INTEGER PRIMARY KEY,
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  started_unix_s  INTEGER NOT NULL CHECK (started_unix_s >= 0),
  program_version TEXT NOT NULL
) STRICT;
CREATE INDEX sessions_of_participant ON sessions (participant);

CREATE TABLE trials (  -- planned; an adaptive procedure adds them one by one, and may show a stimulus again
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  trial_index     INTEGER NOT NULL CHECK (trial_index >= 0),
  stimulus        INTEGER NOT NULL REFERENCES stimuli,
  PRIMARY KEY (participant, trial_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE answers (
  participant     INTEGER NOT NULL REFERENCES participants ON DELETE CASCADE,
  trial_index     INTEGER NOT NULL,
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  chosen_index    INTEGER NOT NULL CHECK (chosen_index BETWEEN 1 AND 3),
  rating          INTEGER NOT NULL CHECK (rating BETWEEN 1 AND 4),
  choice_ns       INTEGER NOT NULL CHECK (choice_ns >= 0),     -- from the image's onset
  rating_ns       INTEGER NOT NULL CHECK (rating_ns >= choice_ns),
  PRIMARY KEY (participant, trial_index),
  FOREIGN KEY (participant, trial_index) REFERENCES trials ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE events (  -- raw: shown, choice, rating, focus, pause, resize, ...
  event           INTEGER PRIMARY KEY,
  session         INTEGER NOT NULL REFERENCES sessions ON DELETE CASCADE,
  monotonic_ns    INTEGER NOT NULL CHECK (monotonic_ns >= 0),
  kind            TEXT NOT NULL CHECK (length(kind) > 0),
  trial_index     INTEGER CHECK (trial_index >= 0),            -- NULL outside trials
  detail          TEXT NOT NULL DEFAULT ''
) STRICT;
CREATE INDEX events_of_session ON events (session);

CREATE TABLE deletions (  -- that someone was forgotten, and when; not who
  deletion        INTEGER PRIMARY KEY,
  deleted_unix_s  INTEGER NOT NULL CHECK (deleted_unix_s >= 0),
  answers         INTEGER NOT NULL CHECK (answers >= 0)
) STRICT;
)sql";

}  // namespace

std::string log_schema_sql() {
  return fmt::format("{}PRAGMA application_id = {};\nPRAGMA user_version = {};\n",
                     fmt::format(fmt::runtime(schema), fmt::arg("artifacts", artifact_list())),
                     log_application_id, log_schema_version);
}

}  // namespace seamline
