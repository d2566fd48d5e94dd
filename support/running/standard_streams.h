#pragma once

namespace seamline {

/// Makes the standard streams safe, whatever they lead to; `main` calls it before anything else.
/// A descriptor 0, 1 or 2 that the caller closed is opened on /dev/null, so that no file of ours gets its
/// number and no message is written into that file (as `stdopen` of gnulib does).
/// From then on printing never fails where it stands: a command whose output is lost still finishes its work.
void guard_standard_streams();

/// Throws InputError where something printed on standard output was lost: the disk is full, or the caller
/// closed it. For the end of a command, which then ends with status 1 instead of 0. What standard error loses
/// can be told nobody.
void require_standard_output();

}  // namespace seamline
