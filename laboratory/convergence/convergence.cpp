#include "laboratory/convergence/convergence.h"

#include <fmt/format.h>

#include "laboratory/convergence/convergence_estimate_tables.h"
#include "laboratory/convergence/convergence_figure.h"
#include "laboratory/convergence/convergence_pictures.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/held/prepared_folder.h"
#include "support/files/markdown_table.h"

namespace seamline::renderer {
namespace {

constexpr double compositing_share = 0.5;  // of the seconds of the samples part

/// Writes each part when it is finished and collects what the page says.
class Writer {
 public:
  Writer(const ConvergenceSubject& subject, const ConvergenceRequest& request)
      : subject_(subject), out_(request.out) {}

  template <class Result>
  void add(ConvergencePart part, const Result& result) {
    const std::string name(word(part));
    const PartTables tables = tables_of(result);
    write_file_atomically(out_ / (name + ".csv"), csv_text(tables.table));
    page_ += fmt::format("\n## {}\n\n", name);
    if constexpr (requires(const FigureText& text) { draw_figure(result, text); }) {
      draw_figure(result,
                  FigureText{.svg = out_ / (name + ".svg"), .subject = heading(), .slopes = tables.slopes});
      page_ += fmt::format("![{0}]({0}.svg)\n\n", name);
    }
    page_ += markdown_table(tables.table);
    for (const std::string& remark : tables.remarks) page_ += "\n" + remark + "\n";
    slopes_.insert(slopes_.end(), tables.slopes.begin(), tables.slopes.end());
    written_.push_back(tables.table);
  }

  std::string finish() {
    const CsvTable slopes = slope_table(slopes_);
    write_file_atomically(out_ / "slopes.csv", csv_text(slopes));
    written_.push_back(slopes);
    write_file_atomically(out_ / "data_dictionary.csv", csv_text(data_dictionary(written_)));
    const std::string page = fmt::format("# Error against run time: {}\n{}\n## slopes\n\n{}", heading(),
                                         page_, markdown_table(slopes));
    write_file_atomically(out_ / "convergence.md", page);
    return page;
  }

 private:
  [[nodiscard]] std::string heading() const {
    return fmt::format("{}, isolation {}, {} x {}, {} {}", stimulus_id(subject_.stimulus),
                       word(subject_.study.isolation), subject_.study.width_px, subject_.study.height_px,
                       subject_.threads, subject_.threads == 1 ? "thread" : "threads");
  }

  const ConvergenceSubject& subject_;
  std::filesystem::path out_;
  std::string page_;
  std::vector<SlopeRow> slopes_;
  std::vector<CsvTable> written_;
};

}  // namespace

std::string run_convergence(const StudyDefinition& study, const ConvergenceRequest& request) {
  require_gnuplot();
  const ConvergenceSubject subject = load_subject(study, request);
  const PreparedFolder prepared(request.out);
  Writer writer(subject, request);
  const auto wanted = [&](ConvergencePart part) { return request.parts.contains(part); };
  if (wanted(ConvergencePart::samples))
    writer.add(ConvergencePart::samples, measure_samples(subject, request.seconds));
  if (wanted(ConvergencePart::mesh) || wanted(ConvergencePart::width) || wanted(ConvergencePart::links) ||
      wanted(ConvergencePart::realtime)) {
    const TruthSums truth =
        render_truth(subject.scene, subject.geometry, subject.pass(subject.spp, subject.study.seed));
    if (wanted(ConvergencePart::mesh))
      writer.add(ConvergencePart::mesh, measure_mesh(subject, truth, request.tolerances));
    if (wanted(ConvergencePart::width)) writer.add(ConvergencePart::width, measure_width(subject, truth));
    if (wanted(ConvergencePart::links)) writer.add(ConvergencePart::links, measure_links(subject, truth));
    if (wanted(ConvergencePart::realtime))
      writer.add(ConvergencePart::realtime, measure_realtime(subject, truth));
  }
  if (wanted(ConvergencePart::light)) writer.add(ConvergencePart::light, measure_light(subject));
  if (wanted(ConvergencePart::compositing))
    writer.add(ConvergencePart::compositing,
               measure_compositing(subject, compositing_share * request.seconds));
  if (wanted(ConvergencePart::mitigation))
    writer.add(ConvergencePart::mitigation, measure_mitigation(subject));
  if (wanted(ConvergencePart::filter)) writer.add(ConvergencePart::filter, measure_filter(subject));
  const std::uint64_t seed = subject.study.seed;
  if (wanted(ConvergencePart::sensor)) writer.add(ConvergencePart::sensor, measure_sensor(seed));
  if (wanted(ConvergencePart::repair)) writer.add(ConvergencePart::repair, measure_repair(seed));
  if (wanted(ConvergencePart::registration))
    writer.add(ConvergencePart::registration, measure_registration());
  if (wanted(ConvergencePart::fit)) writer.add(ConvergencePart::fit, measure_fit(seed));
  if (wanted(ConvergencePart::joint)) writer.add(ConvergencePart::joint, measure_joint(seed));
  if (wanted(ConvergencePart::interval)) writer.add(ConvergencePart::interval, measure_interval(seed));
  if (wanted(ConvergencePart::plan)) writer.add(ConvergencePart::plan, measure_plan(study.file, seed));
  return writer.finish();
}

}  // namespace seamline::renderer
