// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Session.h"

#include "AtomicFile.h"
#include "CrashGuard.h"
#include "Display.h"
#include "Failure.h"
#include "Validators.h"

#include <vtkSMPTools.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace arris
{
namespace
{
constexpr const char* StandardOutput = "-";

void StartThreads(int threads)
{
  // ParaView's VTK has threads, but uses them only when told to.
  if (std::getenv("VTK_SMP_BACKEND_IN_USE") == nullptr &&
    std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0)
  {
    vtkSMPTools::SetBackend("STDThread");
  }
  // oneTBB has no more than one thread a core, and complains when asked for more.
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const bool capped = cores > 0 && std::strcmp(vtkSMPTools::GetBackend(), "TBB") == 0;
  vtkSMPTools::Initialize(capped ? std::min(threads, cores) : threads);
}
}

void AddSessionOptions(CLI::App& command, SessionOptions& options)
{
  command.add_flag("-q,--quiet", options.Quiet, "Print errors only")->group("General");
  command
    .add_option("--json", options.JsonFile,
      "Write parameters, counts, results and seconds as JSON;\n- for standard output, which then "
      "gets nothing else")
    ->type_name("FILE")
    ->group("General");
  command.add_option("--threads", options.Threads, "How many threads to use (default: one a core)")
    ->check(WholeNumber(1024))
    ->type_name("N")
    ->group("General");
}

Session::Session(const std::string& command, const SessionOptions& options, bool wantsPictures)
  : Progress(!options.Quiet)
  , Options(options)
  , CanDrawHere(wantsPictures && CanDraw())
{
  StartThreads(options.Threads);
  if (!options.JsonFile.empty() && options.JsonFile != StandardOutput)
  {
    CheckWritable(options.JsonFile);
  }
  this->Report["program"] = "arris";
  this->Report["version"] = ARRIS_VERSION;
  this->Report["command"] = command;
  this->Report["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
}

void Session::Say(const std::string& line) const
{
  if (!this->Options.Quiet && this->Options.JsonFile != StandardOutput)
  {
    std::fputs((line + "\n").c_str(), stdout);
    std::fflush(stdout);
  }
}

void Session::Warn(const std::string& warning)
{
  this->Report["warnings"].push_back(warning);
  if (!this->Options.Quiet)
  {
    std::fputs(("arris: warning: " + warning + "\n").c_str(), stderr);
  }
}

Session::Timer Session::Time(const std::string& stage)
{
  return Timer(*this, stage);
}

void Session::AddSeconds(const std::string& stage, double seconds)
{
  this->Seconds[stage] = this->Seconds.value(stage, 0.0) + seconds;
}

void Session::WriteReport()
{
  this->Seconds["total"] = this->Total.Seconds();
  this->Report["seconds"] = this->Seconds;
  if (this->Options.JsonFile.empty())
  {
    return;
  }
  // Names of files may hold bytes that are no UTF-8.
  const std::string text = this->Report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (this->Options.JsonFile == StandardOutput)
  {
    std::fputs(text.c_str(), stdout);
    return;
  }
  WriteAtomically(this->Options.JsonFile,
    [&](const std::string& scratch) { std::ofstream(scratch, std::ios::binary) << text; });
}

void Session::Draw(const std::string& file, const std::function<void()>& draw)
{
  if (!this->CanDrawHere)
  {
    throw Failure(file, "cannot be drawn: there is no X display that VTK can draw on",
      "everything else is done; for pictures run it on a desktop or after `xvfb-run -a`");
  }
  const Failure failed(
    file, "cannot be drawn: the X display has failed", "everything else is done; try again");
  const CrashGuard guard(std::string("arris: ") + failed.what() + "\n");
  draw();
}
}
