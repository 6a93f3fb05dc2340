// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Commands.h
/// The commands of the program. Each adds its part of the command line to `program` and returns
/// what to run if the user chose it.

#ifndef arris_Commands_h
#define arris_Commands_h

#include <functional>

namespace CLI
{
class App;
}

namespace arris
{
struct Command
{
  CLI::App* Arguments;
  std::function<void()> Run; ///< throws a Failure if it cannot do its work
};

Command AddSharpen(CLI::App& program);
Command AddClassify(CLI::App& program);
Command AddEdges(CLI::App& program);
Command AddRegions(CLI::App& program);
Command AddContour(CLI::App& program);
Command AddCompare(CLI::App& program);
Command AddDemo(CLI::App& program);
}

#endif
