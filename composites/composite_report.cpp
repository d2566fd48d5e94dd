#include "composites/composite_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sets/pages/page_frame.h"
#include "stimuli/pictures/flip.h"
#include "stimuli/pictures/flip_map.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/counted.h"
#include "support/text/html.h"

namespace seamline::renderer {
namespace {

/// Pictures inside the page.
class Figures {
 public:
  std::string figure(const ByteImage& picture, const std::string& caption) {
    const std::filesystem::path file = folder_.path() / fmt::format("{}.png", ++number_);
    write_png(file, picture);
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
        html_escape(caption), base64(read_file(file)));
  }

 private:
  TemporaryFolder folder_;
  int number_ = 0;
};

std::string row(const std::string& name, const std::string& value) {
  return "<tr><td>" + html_escape(name) + "</td><td style=\"text-align:left;white-space:normal\">" +
         html_escape(value) + "</td></tr>\n";
}

std::string error_text(const MadeComposite& made) {
  if (!made.error) return "not known: one sample a pixel";
  return fmt::format(
      "{:.4f} over the picture, {:.4f} in the worst tile (display units; one 8-bit step is 0.0039)",
      *made.error, *made.worst_tile);
}

std::string facts(const CompositeRequest& request, const MadeComposite& made) {
  std::string text = "<div class=\"scroll\"><table><tbody>\n";
  text += row("photograph", request.photograph);
  for (const std::string& object : made.objects) text += row("object", object);
  text += row("depth used", made.depth_text);
  text += row("triangles of the local scene", fmt::format("{}", made.triangles));
  for (const std::string& light : made.light) text += row("light", light);
  for (const std::string& answer : made.answers) text += row("given", answer);
  text += row("estimator", made.estimator + ", " + samples_text(made.taken));
  text += row("estimated error", error_text(made));
  text += row("seconds", fmt::format("{:.1f} for the local scene, {:.1f} for the picture", made.mesh_seconds,
                                     made.picture_seconds));
  text += row("pixels changed", fmt::format("{} (other 8-bit codes)", made.changed_pixels));
  for (const std::string& note : made.notes) text += row("note", note);
  return text + "</tbody></table></div>\n";
}

/// Of a picture's pixels.
double black_share(const Image& picture) {
  std::size_t black = 0;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) black += (picture.rgb(x, y) == 0.0F).all() ? 1 : 0;
  return static_cast<double>(black) / (double{1} * picture.width_px * picture.height_px);
}

std::string needs(const MadeComposite& made) {
  if (!made.width) return "";
  std::string text =
      "<h2>Which width is enough</h2>\n<table><thead><tr><th>artifact present</th><th>width, px</th><th "
      "style=\"text-align:left\">rule</th></tr></thead><tbody>\n";
  for (const WidthNeed& need : made.width->needs)
    text += fmt::format("<tr><td>{}</td><td>{}</td><td style=\"text-align:left\">{}</td></tr>\n",
                        word(need.artifact), need.width_px ? std::to_string(*need.width_px) : "none",
                        html_escape(need.rule));
  return text + "</tbody></table>\n";
}

std::string against_full(const CompositeRequest& request, const MadeComposite& made, const FullDepth& full,
                         Figures& figures) {
  const ByteImage shown = display_image(made.picture.picture, request.exposure_ev);
  const ByteImage finest = display_image(full.picture.picture, request.exposure_ev);
  const Image flip = flip_difference(finest, shown, request.pixels_per_degree);
  double sum = 0, largest = 0;
  for (const float value : flip.values) sum += double{value}, largest = std::max(largest, double{value});
  return "<h2>Against full depth</h2>\n" +
         figures.figure(finest, fmt::format("Through the full depth map: {} triangles, {:.1f} s.",
                                            full.triangles, full.seconds)) +
         figures.figure(
             flip_map(flip),
             fmt::format("FLIP between the two, black 0 to pale yellow 1, at {:g} pixels per degree: mean "
                         "{:.4f}, largest {:.3f}.",
                         request.pixels_per_degree, sum / static_cast<double>(flip.values.size()), largest));
}

}  // namespace

std::string samples_text(const SamplesTaken& taken) {
  if (taken.least == taken.most) return counted(taken.most, "sample") + " a pixel";
  return fmt::format("{} to {} samples a pixel, {:.1f} in the mean", taken.least, taken.most, taken.mean);
}

void write_composite_report(const CompositeRequest& request, const MadeComposite& made,
                            const std::optional<FullDepth>& full) {
  Figures figures;
  std::string body =
      figures.figure(display_image(made.picture.picture, request.exposure_ev), "The composite.");
  body += facts(request, made) + needs(made);
  if (full)
    body += against_full(request, made, *full, figures);
  else
    body +=
        "<p class=\"soft\">The depth map is used as it is, so that there is nothing finer to compare "
        "with.</p>\n";
  body += "<h2>What it was made of</h2>\n";
  body += figures.figure(display_image(*made.photograph, request.exposure_ev), "The photograph.");
  body += figures.figure(display_image(made.local_scene),
                         fmt::format("The local scene, lit from the camera; black: no depth, {:.1f} % of it.",
                                     100 * black_share(made.local_scene)));
  write_file_atomically(request.report, html_page("Composite: " + html_escape(request.out), body));
}

}  // namespace seamline::renderer
