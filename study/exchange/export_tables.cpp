#include "study/exchange/export_tables.h"

#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"

namespace seamline::study {
namespace fs = std::filesystem;

TableSummary export_tables(const TableRequest& request) {
  const fs::path target = fs::absolute(request.out_folder).lexically_normal();
  const fs::path out = target.has_filename() ? target : target.parent_path();  // "dir/" is dir
  LogContents log = read_log(request.log);
  TableSummary summary;
  if (request.anonymise_k) {
    AnonymisedLog anonymised = anonymise(std::move(log), *request.anonymise_k);
    log = std::move(anonymised.log);
    summary.anonymity = anonymised.anonymity;
    summary.fields = std::move(anonymised.fields);
    summary.smallest_group = anonymised.smallest_group;
  }
  summary.participants = static_cast<int>(log.participants.size());
  summary.answers = static_cast<int>(log.answers.size());
  fs::create_directories(out.parent_path());
  const TemporaryFolder work(out);
  const fs::path folder = work / "tables";
  fs::create_directory(folder);
  const Readers readers = request.anonymise_k ? Readers::everybody : Readers::owner;
  for (const DatasetFile& file : dataset_files(log, request.layout, summary.anonymity)) {
    fs::create_directories((folder / file.path).parent_path());
    write_file_atomically(folder / file.path, file.text, readers);
  }
  publish_folder(folder, out);
  return summary;
}

}  // namespace seamline::study
