// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Validators.h
/// What the values of options must be.

#ifndef arris_Validators_h
#define arris_Validators_h

#include <CLI/CLI.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace arris
{
/// Accepts finite numbers.
CLI::Validator Finite();

/// Accepts finite numbers above 0.
CLI::Validator Positive();

/// Accepts finite numbers from 0 on.
CLI::Validator NotNegative();

/// Accepts degrees above 0, at most 180.
CLI::Validator Angle();

/// Accepts 1, 2 ... up to `largest`.
CLI::Validator WholeNumber(double largest);

/// Three finite numbers with commas between them, or nothing if the text is something else.
std::optional<std::array<double, 3>> ParsePosition(const std::string& text);

/// Accepts what ParsePosition does.
CLI::Validator PositionText();

/// Accepts these words.
CLI::Validator OneOf(const std::vector<std::string>& words);
}

#endif
