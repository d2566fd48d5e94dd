#include <array>
#include <numbers>

#include "analysis/detection/detection_pattern.h"

namespace seamline::analysis {
namespace {

/// Mean over 16 people of the mean of their four thresholds, and the standard deviation between people.
constexpr DetectionPattern modelfest_pattern(int number, std::string_view name, PatternKind kind,
                                             std::array<double, 5> shape, double threshold_db,
                                             double people_sd_db) {
  return {.number = number,
          .name = name,
          .kind = kind,
          .frequency_cpd = shape[0],
          .sigma_x_deg = shape[1],
          .sigma_y_deg = shape[2],
          .angle_deg = shape[3],
          .other = shape[4],
          .threshold_db = threshold_db,
          .people_sd_db = people_sd_db,
          .mean_luminance_cdm2 = 30,
          .pixels_per_degree = 120,
          .side_px = 256};
}

constexpr std::array<DetectionPattern, 42> modelfest_patterns = {
    modelfest_pattern(1, "Gabor 1.12 c/deg", PatternKind::gabor, {1.12, 0.5, 0.5, 0, 0}, 36.42, 2.69),
    modelfest_pattern(2, "Gabor 2 c/deg", PatternKind::gabor, {2, 0.5, 0.5, 0, 0}, 39.21, 3.59),
    modelfest_pattern(3, "Gabor 2.83 c/deg", PatternKind::gabor, {2.83, 0.5, 0.5, 0, 0}, 41.26, 3.58),
    modelfest_pattern(4, "Gabor 4 c/deg", PatternKind::gabor, {4, 0.5, 0.5, 0, 0}, 42.13, 4.26),
    modelfest_pattern(5, "Gabor 5.66 c/deg", PatternKind::gabor, {5.66, 0.5, 0.5, 0, 0}, 39.84, 3.67),
    modelfest_pattern(6, "Gabor 8 c/deg", PatternKind::gabor, {8, 0.5, 0.5, 0, 0}, 36.87, 3.49),
    modelfest_pattern(7, "Gabor 11.3 c/deg", PatternKind::gabor, {11.3, 0.5, 0.5, 0, 0}, 32.42, 3.66),
    modelfest_pattern(8, "Gabor 16 c/deg", PatternKind::gabor, {16, 0.5, 0.5, 0, 0}, 25.95, 4.18),
    modelfest_pattern(9, "Gabor 22.6 c/deg", PatternKind::gabor, {22.6, 0.5, 0.5, 0, 0}, 19.19, 5.41),
    modelfest_pattern(10, "Gabor 30 c/deg", PatternKind::gabor, {30, 0.5, 0.5, 0, 0}, 11.35, 3.95),
    modelfest_pattern(11, "Gabor 2 c/deg, one octave", PatternKind::gabor, {2, 0.28, 0.28, 0, 0}, 35.39,
                      3.22),
    modelfest_pattern(12, "Gabor 4 c/deg, one octave", PatternKind::gabor, {4, 0.14, 0.14, 0, 0}, 32.37,
                      2.63),
    modelfest_pattern(13, "Gabor 8 c/deg, one octave", PatternKind::gabor, {8, 0.07, 0.07, 0, 0}, 23.86,
                      3.37),
    modelfest_pattern(14, "Gabor 16 c/deg, one octave", PatternKind::gabor, {16, 0.035, 0.035, 0, 0}, 10.27,
                      3.92),
    modelfest_pattern(15, "Gabor 4 c/deg, two octaves, long", PatternKind::gabor, {4, 0.5, 0.28, 0, 0}, 40.03,
                      3.45),
    modelfest_pattern(16, "Gabor 8 c/deg, two octaves, long", PatternKind::gabor, {8, 0.5, 0.14, 0, 0}, 33.71,
                      3.65),
    modelfest_pattern(17, "Gabor 16 c/deg, two octaves, long", PatternKind::gabor, {16, 0.5, 0.07, 0, 0},
                      21.21, 5.34),
    modelfest_pattern(18, "Gabor 4 c/deg, wide", PatternKind::gabor, {4, 0.28, 0.14, 0, 0}, 35.46, 3.46),
    modelfest_pattern(19, "Gabor 4 c/deg, widest", PatternKind::gabor, {4, 0.5, 0.14, 0, 0}, 36.88, 2.86),
    modelfest_pattern(20, "Gabor 4 c/deg, tall", PatternKind::gabor, {4, 0.14, 0.28, 0, 0}, 35.09, 3.09),
    modelfest_pattern(21, "Gabor 4 c/deg, tallest", PatternKind::gabor, {4, 0.14, 0.5, 0, 0}, 36.19, 3.16),
    modelfest_pattern(22, "Gabors 2 and 2.8 c/deg", PatternKind::compound,
                      {2, 0.5, 0.5, 0, std::numbers::sqrt2}, 38.96, 4.12),
    modelfest_pattern(23, "Gabors 2 and 4 c/deg", PatternKind::compound, {2, 0.5, 0.5, 0, 2}, 37.64, 4.21),
    modelfest_pattern(24, "Gabors 4 and 5.7 c/deg", PatternKind::compound,
                      {4, 0.5, 0.5, 0, std::numbers::sqrt2}, 38.27, 4.15),
    modelfest_pattern(25, "Gabors 4 and 8 c/deg", PatternKind::compound, {4, 0.5, 0.5, 0, 2}, 36.51, 4.18),
    modelfest_pattern(26, "Gaussian 30 arcmin", PatternKind::gaussian, {0, 0.5, 0.5, 0, 0}, 32.73, 6.40),
    modelfest_pattern(27, "Gaussian 8.43 arcmin", PatternKind::gaussian, {0, 8.43 / 60, 8.43 / 60, 0, 0},
                      30.52, 2.85),
    modelfest_pattern(28, "Gaussian 2.106 arcmin", PatternKind::gaussian, {0, 2.106 / 60, 2.106 / 60, 0, 0},
                      24.17, 2.12),
    modelfest_pattern(29, "Gaussian 1.05 arcmin", PatternKind::gaussian, {0, 1.05 / 60, 1.05 / 60, 0, 0},
                      16.61, 3.51),
    modelfest_pattern(30, "edge", PatternKind::edge, {0, 0.5, 0.5, 0, 0}, 38.72, 2.75),
    modelfest_pattern(31, "line", PatternKind::line, {0, 0.5, 0.5, 0, 0}, 18.68, 3.48),
    modelfest_pattern(32, "dipole", PatternKind::dipole, {0, 0.5, 0.5, 0, 0}, 12.51, 2.98),
    modelfest_pattern(33, "five Gabors in phase", PatternKind::row_of_five, {8, 0.07, 0.07, 0, 1}, 27.77,
                      3.65),
    modelfest_pattern(34, "five Gabors, signs alternate", PatternKind::row_of_five, {8, 0.07, 0.07, 0, -1},
                      27.14, 3.48),
    modelfest_pattern(35, "noise", PatternKind::noise, {0, 0.5, 0.5, 0, 0}, 26.61, 2.82),
    modelfest_pattern(36, "Gabor 4 c/deg, oblique", PatternKind::gabor, {4, 0.14, 0.14, 45, 0}, 32.07, 2.99),
    modelfest_pattern(37, "Gabor 4 c/deg, vertical", PatternKind::gabor, {4, 0.14, 0.14, 90, 0}, 33.15, 2.55),
    modelfest_pattern(38, "plaid", PatternKind::plaid, {4, 0.14, 0.14, 0, 0}, 28.52, 2.32),
    modelfest_pattern(39, "plaid, oblique", PatternKind::plaid, {4, 0.14, 0.14, 45, 0}, 29.72, 2.25),
    modelfest_pattern(40, "disk", PatternKind::disk, {0, 0.125, 0, 0, 0}, 32.53, 2.99),
    modelfest_pattern(41, "Bessel", PatternKind::bessel, {4, 0.5, 0.5, 0, 0}, 30.95, 2.95),
    modelfest_pattern(42, "checkerboard", PatternKind::checkerboard, {4, 0.5, 0.5, 0, 0}, 41.30, 3.59),
};

/// Side so that six standard deviations fit in, and at least five pixels a cycle.
constexpr DetectionPattern hdr_vdp_pattern(int number, double luminance_cdm2, double frequency_cpd,
                                           double sigma_deg, double threshold_db) {
  const double pixels_per_degree =
      sigma_deg > 1 ? (frequency_cpd * 5 > 28 ? frequency_cpd * 5 : 28) : (sigma_deg > 0.3 ? 60 : 120);
  return {.number = number,
          .name = "Gabor",
          .kind = PatternKind::gabor,
          .frequency_cpd = frequency_cpd,
          .sigma_x_deg = sigma_deg,
          .sigma_y_deg = sigma_deg,
          .angle_deg = 90,
          .other = 0,
          .threshold_db = threshold_db,
          .people_sd_db = 0,
          .mean_luminance_cdm2 = luminance_cdm2,
          .pixels_per_degree = pixels_per_degree,
          .side_px = static_cast<int>(6 * sigma_deg * pixels_per_degree)};
}

constexpr std::array hdr_vdp_patterns = {
    hdr_vdp_pattern(1, 2, 0.125, 1.5, 28.18),    hdr_vdp_pattern(2, 2, 0.25, 1.5, 32.89),
    hdr_vdp_pattern(3, 2, 0.5, 1.5, 40.61),      hdr_vdp_pattern(4, 2, 1, 0.15, 26.05),
    hdr_vdp_pattern(5, 2, 1, 0.5, 35.11),        hdr_vdp_pattern(6, 2, 1, 1.5, 44.81),
    hdr_vdp_pattern(7, 2, 1.41, 1.5, 45.41),     hdr_vdp_pattern(8, 2, 2, 1.5, 45.75),
    hdr_vdp_pattern(9, 2, 2.83, 1.5, 44.18),     hdr_vdp_pattern(10, 2, 4, 1.5, 42.11),
    hdr_vdp_pattern(11, 2, 8, 0.15, 18.03),      hdr_vdp_pattern(12, 2, 8, 0.5, 25.80),
    hdr_vdp_pattern(13, 2, 8, 1.5, 31.25),       hdr_vdp_pattern(14, 2, 16, 1.5, 14.67),
    hdr_vdp_pattern(15, 20, 0.125, 1.5, 28.35),  hdr_vdp_pattern(16, 20, 0.25, 1.5, 32.73),
    hdr_vdp_pattern(17, 20, 0.5, 1.5, 39.87),    hdr_vdp_pattern(18, 20, 1, 0.15, 29.63),
    hdr_vdp_pattern(19, 20, 1, 0.5, 37.07),      hdr_vdp_pattern(20, 20, 1, 1.5, 45.53),
    hdr_vdp_pattern(21, 20, 1.41, 1.5, 49.02),   hdr_vdp_pattern(22, 20, 2, 1.5, 49.49),
    hdr_vdp_pattern(23, 20, 2.83, 1.5, 50.24),   hdr_vdp_pattern(24, 20, 4, 1.5, 47.46),
    hdr_vdp_pattern(25, 20, 8, 0.15, 26.98),     hdr_vdp_pattern(26, 20, 8, 0.5, 36.09),
    hdr_vdp_pattern(27, 20, 8, 1.5, 41.55),      hdr_vdp_pattern(28, 20, 16, 1.5, 26.90),
    hdr_vdp_pattern(29, 150, 0.125, 1.5, 27.06), hdr_vdp_pattern(30, 150, 0.25, 1.5, 31.58),
    hdr_vdp_pattern(31, 150, 0.5, 1.5, 38.53),   hdr_vdp_pattern(32, 150, 1, 0.15, 30.60),
    hdr_vdp_pattern(33, 150, 1, 0.5, 37.61),     hdr_vdp_pattern(34, 150, 1, 1.5, 45.57),
    hdr_vdp_pattern(35, 150, 1.41, 1.5, 48.02),  hdr_vdp_pattern(36, 150, 2, 1.5, 48.25),
    hdr_vdp_pattern(37, 150, 2.83, 1.5, 48.79),  hdr_vdp_pattern(38, 150, 4, 1.5, 47.49),
    hdr_vdp_pattern(39, 150, 8, 0.15, 31.87),    hdr_vdp_pattern(40, 150, 8, 0.5, 39.64),
    hdr_vdp_pattern(41, 150, 8, 1.5, 44.96),     hdr_vdp_pattern(42, 150, 16, 1.5, 31.82),
};

/// The field is 256 px wide: 2.1 degrees, 4 for the largest disc.
constexpr DetectionPattern disc_pattern(int number, double luminance_cdm2, double radius_deg,
                                        double threshold_db, double people_sd_db) {
  return {.number = number,
          .name = "disc",
          .kind = PatternKind::disk,
          .frequency_cpd = 0,
          .sigma_x_deg = radius_deg,
          .sigma_y_deg = 0,
          .angle_deg = 0,
          .other = 0,
          .threshold_db = threshold_db,
          .people_sd_db = people_sd_db,
          .mean_luminance_cdm2 = luminance_cdm2,
          .pixels_per_degree = radius_deg < 1 ? 120.0 : 64.0,
          .side_px = 256};
}

constexpr std::array disc_patterns = {
    disc_pattern(1, 2, 1.0 / 12, 32.42, 3.74),   disc_pattern(2, 2, 0.25, 34.41, 3.54),
    disc_pattern(3, 2, 1, 35.82, 3.27),          disc_pattern(4, 20, 1.0 / 12, 36.29, 2.31),
    disc_pattern(5, 20, 0.25, 38.19, 1.16),      disc_pattern(6, 20, 1, 38.65, 1.12),
    disc_pattern(7, 200, 1.0 / 12, 38.84, 3.04), disc_pattern(8, 200, 0.25, 39.48, 1.89),
    disc_pattern(9, 200, 1, 41.01, 1.94),
};

constexpr DetectionThresholds modelfest = {
    .name = "ModelFest",
    .source = "Carney et al. 1999, Proc. SPIE 3644, 542; the group's public table of 16 people",
    .people = "16 people, two intervals, 84 % right",
    .seen_share = 0.68,
    .patterns = modelfest_patterns};

constexpr DetectionThresholds hdr_vdp = {
    .name = "HDR-VDP-2",
    .source = "Mantiuk et al. 2011, ACM Trans. Graph. 30(4), 40; as in the castleCSF data set (MIT licence)",
    .people = "10 to 18 measurements a pattern, four alternatives; that 75 % were right is taken",
    .seen_share = 2.0 / 3,
    .patterns = hdr_vdp_patterns};

constexpr DetectionThresholds discs = {
    .name = "Discs",
    .source =
        "Ashraf, Mantiuk and Chapiro 2022, Proc. IS&T CIC 30, grey discs from 2 cd/m2 on; as in the castleCSF data set "
        "(MIT licence)",
    .people = "4 to 12 people a disc, four alternatives; that 75 % were right, and sharp edges, are taken",
    .seen_share = 2.0 / 3,
    .patterns = disc_patterns};

}  // namespace

const DetectionThresholds& modelfest_thresholds() {
  return modelfest;
}

const DetectionThresholds& hdr_vdp_thresholds() {
  return hdr_vdp;
}

const DetectionThresholds& disc_thresholds() {
  return discs;
}

}  // namespace seamline::analysis
