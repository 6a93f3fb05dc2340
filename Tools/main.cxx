// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Program.h"

int main(int argc, char* argv[])
{
  return arris::RunProgram(argc, argv);
}
