#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/exchange/anonymise.h"
#include "study/log/log.h"

namespace seamline::study {

/// A file of a data set: its place below the folder, with "/", and all its bytes.
struct DatasetFile {
  std::string path;
  std::string text;
};

/// How the tables of a log are laid out.
enum class TableLayout {
  plain,     ///< a CSV file a table, and a dictionary
  psych_ds,  ///< Psych-DS 1.0: https://psych-ds.github.io
  bids       ///< BIDS 1.9, behaviour without imaging: https://bids-specification.readthedocs.io
};

/// All files of the layout, the same bytes for the same log and program. `anonymity`: the log is one of
/// `anonymise`, what it must not tell is left out, and the texts say so.
[[nodiscard]] std::vector<DatasetFile> dataset_files(const LogContents& log, TableLayout layout,
                                                     const std::optional<Anonymity>& anonymity);

/// Psych-DS: `dataset_description.json` with all variables, and for every table of `answer_tables`
/// `data/study-NAME_description-TABLE_data.csv` with its columns beside it as JSON.
[[nodiscard]] std::vector<DatasetFile> psych_ds_files(const LogContents& log,
                                                      const std::optional<Anonymity>& anonymity);

/// BIDS: a subject is `sub-001`, `sub-002`, ... in the log's order, its code a column of `participants.tsv`;
/// its answers and catch answers in the order of its trials are one table, explained once for all in
/// `task-NAME_beh.json`.
[[nodiscard]] std::vector<DatasetFile> bids_files(const LogContents& log,
                                                  const std::optional<Anonymity>& anonymity);

/// Letters and figures of ASCII alone, which is all that names of files may have in both layouts; "study"
/// where nothing is left.
[[nodiscard]] std::string file_label(const std::string& name);

/// What a reader should know first: study, people, program, what is in it, and what is not said.
[[nodiscard]] std::string dataset_readme(const LogContents& log, const std::string& layout,
                                         const std::optional<Anonymity>& anonymity);

}  // namespace seamline::study
