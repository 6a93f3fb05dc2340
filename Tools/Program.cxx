// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Program.h"

#include "Commands.h"
#include "ErrorCapture.h"
#include "Failure.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdio>
#include <new>

namespace arris
{
namespace
{
enum ExitStatus
{
  Done = 0,
  Failed = 1,
  WrongUsage = 2
};

/// One line on standard error, whatever the message holds.
void Complain(std::string message)
{
  for (char& letter : message)
  {
    letter = letter == '\n' || letter == '\r' ? ' ' : letter;
  }
  std::fputs(("arris: " + message + "\n").c_str(), stderr);
}

/// What the command line asked for instead of work, or got wrong.
int Answer(const CLI::App& program, const CLI::ParseError& parsed, const std::string& first)
{
  if (parsed.get_exit_code() == 0)
  {
    std::ostringstream text;
    program.exit(parsed, text, text);
    std::fputs(text.str().c_str(), stdout);
    return Done;
  }
  std::string problem = parsed.what();
  if (program.get_subcommands().empty() && (first.empty() || first[0] != '-'))
  {
    problem = first.empty() ? "a command is missing" : "there is no command " + first;
  }
  std::string help = "arris ";
  for (const CLI::App* command : program.get_subcommands())
  {
    help += command->get_name() + " ";
  }
  Complain(problem + "; see `" + help + "--help`");
  return WrongUsage;
}

int RunCommand(const std::vector<Command>& commands)
{
  for (const Command& command : commands)
  {
    if (command.Arguments->parsed())
    {
      command.Run();
    }
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) // lines flushed earlier count too
  {
    throw Failure("standard output", "cannot be written", "send it to another place");
  }
  return Done;
}
}

int RunProgram(int argc, const char* const* argv)
{
  // A write beyond the limit of a file's size fails, as one to a full disk does, and is told so.
  std::signal(SIGXFSZ, SIG_IGN);
  const ErrorCapture silence; // what the program says, it says in its own words
  try
  {
    CLI::App program(
      "Gives triangle meshes back the sharp edges that sampling took from them.", "arris");
    program.set_version_flag("--version", "arris " ARRIS_VERSION);
    program.require_subcommand(1);
    program.get_formatter()->column_width(34);
    program.footer(
      "Examples:\n"
      "  arris sharpen scan.ply -o sharp.ply\n"
      "  arris contour part.mha --value 0 -o part.vtp\n"
      "  arris compare truth.stl part.vtp\n"
      "`arris COMMAND --help` tells more. Exit status: 0 done, 1 failed, 2 wrong usage.");
    const std::vector<Command> commands = { AddSharpen(program), AddClassify(program),
      AddEdges(program), AddRegions(program), AddContour(program), AddCompare(program),
      AddDemo(program) };
    try
    {
      program.parse(argc, argv);
    }
    catch (const CLI::ParseError& parsed)
    {
      return Answer(program, parsed, argc > 1 ? argv[1] : "");
    }
    return RunCommand(commands);
  }
  catch (const std::bad_alloc&)
  {
    Complain("out of memory; use a machine with more of it or a smaller input");
  }
  catch (const std::exception& failure)
  {
    Complain(failure.what());
  }
  return Failed;
}
}
