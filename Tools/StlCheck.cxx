// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StlCheck.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace arris
{
namespace
{
constexpr std::uint64_t HeaderSize = 80;
constexpr std::uint64_t CountSize = 4;
constexpr std::uint64_t TriangleSize = 50;

bool IsText(std::istream& file)
{
  std::array<char, 512> beginning;
  file.read(beginning.data(), beginning.size());
  const auto end = beginning.begin() + file.gcount();
  return std::all_of(beginning.begin(), end,
    [](char letter)
    {
      const auto byte = static_cast<unsigned char>(letter);
      return std::isprint(byte) || std::isspace(byte) || byte >= 0x80;
    });
}

std::string ProblemWithText(std::istream& file, std::uint64_t size)
{
  std::string word;
  file.clear();
  file.seekg(0);
  file >> word;
  if (word != "solid")
  {
    return "it does not begin as an STL file";
  }
  constexpr std::uint64_t Reach = 1000; // enough for the name of a solid
  file.clear();
  file.seekg(static_cast<std::streamoff>(size - std::min(size, Reach)));
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const std::size_t last = text.rfind("endsolid");
  return last == std::string::npos || text.find("facet", last) != std::string::npos
    ? "it does not end with 'endsolid'"
    : "";
}

std::uint64_t TriangleCount(std::istream& file)
{
  std::array<char, CountSize> bytes{};
  file.clear();
  file.seekg(HeaderSize);
  file.read(bytes.data(), bytes.size());
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    count |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return count;
}
}

std::string ProblemWithStl(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::uint64_t size = std::filesystem::file_size(path);
  if (IsText(file))
  {
    return ProblemWithText(file, size);
  }
  if (size < HeaderSize + CountSize)
  {
    return "it is too short for an STL file";
  }
  const std::uint64_t promised = TriangleCount(file);
  const std::uint64_t there = (size - HeaderSize - CountSize) / TriangleSize;
  return promised <= there
    ? ""
    : "it ends after " + std::to_string(there) + " of " + std::to_string(promised) + " triangles";
}
}
