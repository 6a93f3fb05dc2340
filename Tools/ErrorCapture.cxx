// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorCapture.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <iostream>
#include <mutex>

namespace arris
{
namespace
{
/// All words on one line, without punctuation at the end; readers quote what they stumble over,
/// whatever it is and however long.
std::string OnOneLine(const std::string& text)
{
  constexpr std::size_t Longest = 200;
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
  {
    line += (line.empty() ? "" : " ") + word;
  }
  std::replace_if(
    line.begin(), line.end(), [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  if (line.size() > Longest)
  {
    line.replace(Longest, std::string::npos, " ...");
  }
  while (!line.empty() && (line.back() == '.' || line.back() == '!'))
  {
    line.pop_back();
  }
  return line;
}

/// "ERROR: In file, line 1\nvtkThing (0x1): cause\n\n" without all but the cause.
std::string CauseIn(const std::string& message)
{
  std::size_t begin = message.find('\n');
  begin = begin == std::string::npos ? 0 : begin + 1;
  const std::size_t object = message.find("): ", begin);
  const std::string cause =
    OnOneLine(message.substr(object != std::string::npos ? object + 3 : begin));
  // The pipeline's own words, on top of the reader's or instead of them, tell a user nothing.
  return cause.find("returned failure for request") != std::string::npos
    ? "it is damaged or not of this format"
    : cause;
}
}

/// Hears what VTK would print. Readers may speak from several threads.
class ErrorCapture::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Keep(this->Error, text); }
  void DisplayWarningText(const char* text) override { this->Keep(this->Warning, text); }
  void DisplayGenericWarningText(const char* text) override { this->Keep(this->Warning, text); }

  std::string Error;
  std::string Warning;

private:
  void Keep(std::string& first, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (first.empty())
    {
      first = CauseIn(text);
    }
  }

  std::mutex Mutex;
};

vtkStandardNewMacro(ErrorCapture::Window);

ErrorCapture::ErrorCapture()
  : Listener(vtkSmartPointer<Window>::New())
  , PreviousWindow(vtkOutputWindow::GetInstance())
  , PreviousOut(std::cout.rdbuf(this->Out.rdbuf()))
  , PreviousErr(std::cerr.rdbuf(this->Err.rdbuf()))
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(this->Listener);
}

ErrorCapture::~ErrorCapture()
{
  vtkOutputWindow::SetInstance(this->PreviousWindow);
  std::cerr.rdbuf(this->PreviousErr);
  std::cout.rdbuf(this->PreviousOut);
}

std::string ErrorCapture::FirstError() const
{
  return this->Listener->Error;
}

std::string ErrorCapture::FirstWarning() const
{
  return this->Listener->Warning;
}

std::string ErrorCapture::FirstWord() const
{
  const std::string& error = this->Listener->Error;
  const std::string& warning = this->Listener->Warning;
  return !error.empty() ? error : !warning.empty() ? warning : OnOneLine(this->Err.str());
}
}
