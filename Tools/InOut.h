// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

/// @file InOut.h
/// The arguments IN, -o OUT and --picture that most commands have.

#ifndef arris_InOut_h
#define arris_InOut_h

#include <CLI/CLI.hpp>

#include <string>

namespace arris
{
inline void AddInput(CLI::App& command, std::string& file, const char* what)
{
  command.add_option("IN", file, what)->required()->type_name("");
}

inline void AddOutput(CLI::App& command, std::string& file, const char* what)
{
  command.add_option("-o,--output", file, what)->required()->type_name("OUT");
}

inline void AddFaces(CLI::App& command, std::string& file)
{
  command.add_option("--faces", file, "Where the table of the faces and their shapes goes: .csv")
    ->type_name("FILE");
}

inline void AddPicture(CLI::App& command, std::string& file, const char* what)
{
  command.add_option("--picture", file, what)->type_name("FILE.png")->group("General");
}

constexpr const char* MeshInput = "The mesh: .vtp .vtk .ply .stl .obj";
constexpr const char* MeshOutput =
  "Where to: .vtp or .vtk with all arrays; .ply, .stl or .obj\nwithout";
}

#endif
