#include "sets/pages/seams_page.h"

#include <fmt/format.h>

#include "sets/pages/clip_seams.h"
#include "sets/pages/page_frame.h"
#include "sets/pages/seams_figure.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/text/error.h"
#include "support/text/html.h"

namespace seamline::renderer {
namespace {

std::string seams_figure_text(const SetSeams& seams) {
  try {
    require_gnuplot();
  } catch (const InputError&) {
    return "<p>There is no figure: gnuplot (Debian package gnuplot-nox) was not found.</p>\n";
  }
  return "<figure>" + seams_figure(seams) +
         fmt::format(
             "<figcaption>Above the area, below the widest band that differs from the reference by more "
             "than {}, {} and {} steps of 255 beyond noise. {:.4g} px are one degree, {:.4g} px one square "
             "degree. Hollow, on the lower axis: 0.</figcaption></figure>\n",
             seam_steps[0], seam_steps[1], seam_steps[2], seams.pixels_per_degree,
             seams.pixels_per_degree * seams.pixels_per_degree);
}

/// A table whose cells are text.
std::string html_table(const CsvTable& table) {
  std::string text = "<div class=\"scroll\"><table><thead><tr>";
  for (const CsvColumn& column : table.columns) text += "<th>" + html_escape(column.name) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const std::vector<CsvValue>& row : table.rows) {
    text += "<tr>";
    for (const CsvValue& value : row) text += "<td>" + html_escape(std::get<std::string>(value)) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

CsvTable stimuli_table(const SetSeams& seams) {
  CsvTable table{.name = "stimuli", .columns = {{"stimulus", "", ""}}, .rows = {}};
  for (const char* what : {"area", "band"})
    for (const int step : seam_steps) table.columns.push_back({fmt::format("{} > {}", what, step), "", ""});
  table.columns.push_back({"noise", "", ""});
  for (const SeamRow& row : seams.rows) {
    std::vector<CsvValue> values{row.id};
    for (const SeamExtent& extent : row.seam.beyond) values.emplace_back(std::to_string(extent.area_px));
    for (const SeamExtent& extent : row.seam.beyond)
      values.emplace_back(fmt::format("{:.1f}", extent.widest_band_px));
    values.emplace_back(fmt::format("{:.2f}", row.seam.largest_noise_steps));
    table.rows.push_back(std::move(values));
  }
  return table;
}

}  // namespace

void write_seams_page(const std::filesystem::path& folder, const SetSeams& seams,
                      const std::vector<ClipSeam>& clips) {
  const std::string page =
      html_page("Seams: " + html_escape(seams.study_name),
                "<p>" + html_escape(seams_meaning(seams)) + "</p>\n" + seams_figure_text(seams) +
                    (clips.empty() ? std::string()
                                   : "<h2>Clips</h2>\n<p>" + html_escape(clip_seams_meaning()) + "</p>\n" +
                                         html_table(clip_cells_table(seams, clips))) +
                    (clips.empty() ? "<h2>Means</h2>\n" : "<h2>Middle frames</h2>\n") +
                    html_table(seam_cells_table(seams)) +
                    "<h2>Every stimulus</h2>\n<p class=\"soft\">Areas and bands in px. Noise: standard "
                    "deviation in the noisiest tile of 32 x 32 pixels, in steps of 255; from each "
                    "difference three standard deviations of its own tile are taken off.</p>\n" +
                    html_table(stimuli_table(seams)));
  write_file_atomically(folder / "seams.csv", csv_text(seams_table(seams)));
  if (!clips.empty())
    write_file_atomically(folder / "clip_seams.csv", csv_text(clip_seams_table(seams, clips)));
  write_file_atomically(folder / "seams.html", page);
}

}  // namespace seamline::renderer
