// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file AtomicFile.h
/// Files that appear whole or not at all.

#ifndef arris_AtomicFile_h
#define arris_AtomicFile_h

#include <functional>
#include <string>

namespace arris
{
/// Throws a Failure if no file can be written there, so that nothing is computed in vain.
void CheckWritable(const std::string& path);

/// Calls `write` with the name of a scratch file for it to fill, and puts what it wrote at `path`,
/// in place of a file that is there. Whatever goes wrong, a full disk for one, is thrown as a
/// Failure and leaves `path` as it was.
void WriteAtomically(
  const std::string& path, const std::function<void(const std::string& scratch)>& write);
}

#endif
