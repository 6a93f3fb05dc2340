// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file Validators.h
/// What the values of options must be.

#ifndef arris_Validators_h
#define arris_Validators_h

#include <CLI/CLI.hpp>

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

/// Accepts these words.
CLI::Validator OneOf(const std::vector<std::string>& words);
}

#endif
