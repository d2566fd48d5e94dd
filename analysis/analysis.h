#pragma once
// analysis/: a log becomes a report.
//
// analyze_log does all of it. Its steps can be called alone: answers become scores, scores become cells and
// curves, the joint model gives thresholds, and people's own counts are fitted by psychometric/.

#include "analysis/analyze_log.h"
#include "analysis/joint/joint_model.h"
#include "analysis/log_analysis/analysis.h"
#include "analysis/psychometric/likelihood/level_counts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/thresholds/thresholds.h"
