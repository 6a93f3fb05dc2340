// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Program.h
/// The `arris` program without its main().

#ifndef arris_Program_h
#define arris_Program_h

namespace arris
{
/// Runs it; the exit status: 0 done, 1 failed, 2 wrong usage.
int RunProgram(int argc, const char* const* argv);
}

#endif
