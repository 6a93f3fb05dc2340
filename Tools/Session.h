// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Session.h
/// What all commands share: options, progress, messages, the report.

#ifndef arris_Session_h
#define arris_Session_h

#include "ProgressBar.h"

#include "Core/StopWatch.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace CLI
{
class App;
}

namespace arris
{
struct SessionOptions
{
  bool Quiet = false;
  std::string JsonFile; ///< "-": standard output
  int Threads = 0; ///< 0: as many as VTK takes by itself
};

/// --quiet, --json, --threads.
void AddSessionOptions(CLI::App& command, SessionOptions& options);

/// One run of a command.
class Session
{
public:
  using Json = nlohmann::ordered_json;

  /// Finds out whether pictures can be drawn, if any are wanted, and starts the threads.
  Session(const std::string& command, const SessionOptions& options, bool wantsPictures = false);

  /// What --json writes.
  Json Report;

  ProgressBar Progress;

  /// Prints a line of the result, unless --quiet.
  void Say(const std::string& line) const;

  /// Puts a warning into the report, and on standard error unless --quiet.
  void Warn(const std::string& warning);

  /// Counts the seconds until the value it returns goes as those of this stage.
  class Timer;
  Timer Time(const std::string& stage);
  void AddSeconds(const std::string& stage, double seconds);

  /// Writes the report if it is asked for. To be called when all but the pictures is done.
  void WriteReport();

  /// Draws the pictures; where that is impossible throws a Failure that names `file`, one of them.
  void Draw(const std::string& file, const std::function<void()>& draw);

private:
  SessionOptions Options;
  bool CanDrawHere;
  Json Seconds = Json::object();
  StopWatch Total;
};

class Session::Timer
{
public:
  Timer(Session& session, const std::string& stage)
    : Owner(session)
    , Stage(stage)
  {
  }
  ~Timer() { this->Owner.AddSeconds(this->Stage, this->Watch.Seconds()); }
  Timer(const Timer&) = delete;
  void operator=(const Timer&) = delete;

private:
  Session& Owner;
  std::string Stage;
  StopWatch Watch;
};
}

#endif
