// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Validators.h"

#include "Text.h"

#include <algorithm>
#include <cmath>

namespace arris
{
namespace
{
/// A validator that accepts the numbers for which `accept` holds.
template <typename Accept>
CLI::Validator NumberThat(const std::string& what, Accept accept)
{
  return CLI::Validator(
    [what, accept](const std::string& text)
    {
      double value = 0.0;
      const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
      return good && accept(value) ? std::string() : "must be " + what + ", not " + text;
    },
    "");
}
}

CLI::Validator Positive()
{
  return NumberThat("a number greater than 0", [](double value) { return value > 0.0; });
}

CLI::Validator NotNegative()
{
  return NumberThat("a number that is not negative", [](double value) { return value >= 0.0; });
}

CLI::Validator Angle()
{
  return NumberThat("an angle greater than 0 and at most 180 degrees",
    [](double value) { return value > 0.0 && value <= 180.0; });
}

CLI::Validator Finite()
{
  return NumberThat("a finite number", [](double) { return true; });
}

std::optional<std::array<double, 3>> ParsePosition(const std::string& text)
{
  const std::vector<std::string> parts = CLI::detail::split(text, ',');
  std::array<double, 3> position;
  if (parts.size() != position.size())
  {
    return {};
  }
  for (std::size_t i = 0; i < position.size(); ++i)
  {
    if (!CLI::detail::lexical_cast(parts[i], position[i]) || !std::isfinite(position[i]))
    {
      return {};
    }
  }
  return position;
}

CLI::Validator PositionText()
{
  return CLI::Validator(
    [](const std::string& text)
    {
      return ParsePosition(text) ? std::string()
                                 : "must be three numbers, as in 1,2.5,-3, not " + text;
    },
    "");
}

CLI::Validator OneOf(const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words)
  {
    list += (list.empty() ? "" : " or ") + word;
  }
  return CLI::Validator(
    [words, list](const std::string& text)
    {
      const bool good = std::find(words.begin(), words.end(), text) != words.end();
      return good ? std::string() : "must be " + list + ", not " + text;
    },
    "");
}

CLI::Validator WholeNumber(double largest)
{
  return NumberThat("a whole number from 1 to " + Number(largest, 12),
    [largest](double value)
    { return value >= 1.0 && value <= largest && value == std::floor(value); });
}
}
