#pragma once
#include <filesystem>
#include <string>

#include "laboratory/convergence/convergence_tables.h"

namespace seamline::renderer {

/// What every figure says besides its data.
struct FigureText {
  std::filesystem::path svg;
  std::string subject;           ///< stimulus and size of the picture, under the title
  std::vector<SlopeRow> slopes;  ///< of this part, for the key
};

/// Error against seconds, log-log: the stimulus as a set renders it, and off the object on a given
/// background.
void draw_figure(const SampleResult& result, const FigureText& text);
/// Error, changed pixels and cost against the tolerance; the rule for the default as dotted lines.
void draw_figure(const MeshResult& result, const FigureText& text);
/// Error and cost against the width of the depth map.
void draw_figure(const std::vector<WidthRow>& rows, const FigureText& text);
/// Error against the seconds that the local scene takes, a line a link from "none" on.
void draw_figure(const std::vector<LinkRow>& rows, const FigureText& text);
/// Error against processor time, a panel a kind of light: its strategies with one ray a sample, and the last
/// of them with more.
void draw_figure(const LightResult& result, const FigureText& text);
/// Error against the seconds of a frame, a line a method of real time; rays as a dotted line.
void draw_figure(const std::vector<RealtimeRow>& rows, const FigureText& text);

}  // namespace seamline::renderer
