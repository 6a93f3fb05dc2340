// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyCheck.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace arris
{
namespace
{
struct Problem : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Property
{
  std::string Name;
  int Size = 0; ///< bytes of a value
  int CountSize = 0; ///< bytes of the number of values before them, if it is a list; else 0
};

struct Element
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<Property> Properties;
};

enum class Format
{
  Ascii,
  LittleEndian,
  BigEndian
};

int SizeOf(const std::string& type)
{
  static const std::map<std::string, int> sizes = { { "char", 1 }, { "uchar", 1 }, { "int8", 1 },
    { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 }, { "int", 4 },
    { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  if (found == sizes.end())
  {
    throw Problem("its header names the unknown type '" + type + "'");
  }
  return found->second;
}

/// The part of a PLY file before its data.
class Header
{
public:
  explicit Header(std::istream& file)
  {
    std::string line;
    if (!this->Next(file, line) || line != "ply")
    {
      throw Problem("it does not begin as a PLY file");
    }
    while (this->Next(file, line))
    {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "end_header")
      {
        return;
      }
      this->Read(keyword, words);
    }
    throw Problem("its header does not end");
  }

  Format DataFormat = Format::Ascii;
  std::vector<Element> Elements;

private:
  static bool Next(std::istream& file, std::string& line)
  {
    if (!std::getline(file, line))
    {
      return false;
    }
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    return true;
  }

  void Read(const std::string& keyword, std::istringstream& words)
  {
    std::string word;
    if (keyword == "format")
    {
      words >> word;
      this->DataFormat = word == "binary_little_endian" ? Format::LittleEndian
        : word == "binary_big_endian"                   ? Format::BigEndian
                                                        : Format::Ascii;
    }
    else if (keyword == "element")
    {
      Element element;
      if (!(words >> element.Name >> element.Count))
      {
        throw Problem("its header has an element without a count");
      }
      this->Elements.push_back(element);
    }
    else if (keyword == "property")
    {
      if (this->Elements.empty())
      {
        throw Problem("its header has a property of no element");
      }
      Property property;
      words >> word;
      if (word == "list")
      {
        words >> word;
        property.CountSize = SizeOf(word);
        words >> word;
      }
      property.Size = SizeOf(word);
      words >> property.Name;
      this->Elements.back().Properties.push_back(property);
    }
  }
};

[[noreturn]] void ThrowTooShort(const Element& element, std::uint64_t index)
{
  throw Problem("it ends at " + element.Name + " " + std::to_string(index) + " of " +
    std::to_string(element.Count));
}

void CheckListLength(const Element& element, std::uint64_t index, std::uint64_t length)
{
  constexpr std::uint64_t Longest = 255; // that vtkPLYReader has room for
  if (element.Name == "face" && length > Longest)
  {
    throw Problem(element.Name + " " + std::to_string(index) + " lists " + std::to_string(length) +
      " values, and at most " + std::to_string(Longest) + " can be read");
  }
}

bool Has(const Element& element, const std::string& name, bool asList)
{
  return std::any_of(element.Properties.begin(), element.Properties.end(),
    [&](const Property& property)
    { return property.Name == name && (property.CountSize > 0) == asList; });
}

/// Whether vertices and faces have what vtkPLYReader takes for granted.
void CheckProperties(const Header& header)
{
  for (const Element& element : header.Elements)
  {
    if (element.Name == "vertex" &&
      !(Has(element, "x", false) && Has(element, "y", false) && Has(element, "z", false)))
    {
      throw Problem("its vertices have no x, y and z");
    }
    if (element.Name == "face" && !Has(element, "vertex_indices", true) &&
      !Has(element, "vertex_index", true))
    {
      throw Problem("its faces have no list vertex_indices");
    }
  }
}

/// Whether each element has a line, with numbers enough in it.
void CheckAscii(std::istream& file, const Header& header)
{
  std::string line;
  for (const Element& element : header.Elements)
  {
    for (std::uint64_t i = 0; i < element.Count; ++i)
    {
      if (!std::getline(file, line))
      {
        ThrowTooShort(element, i);
      }
      std::istringstream words(line);
      double value = 0.0;
      for (const Property& property : element.Properties)
      {
        double count = 1.0;
        if (property.CountSize > 0)
        {
          words >> count;
          CheckListLength(element, i, words && count >= 0.0 ? std::uint64_t(count) : 0);
        }
        for (int k = 0; k < count && words; ++k)
        {
          words >> value;
        }
      }
      if (!words)
      {
        throw Problem("the line of " + element.Name + " " + std::to_string(i) + " of " +
          std::to_string(element.Count) + " has too few numbers");
      }
    }
  }
}

/// Walks through binary data.
class BinaryWalk
{
public:
  BinaryWalk(std::istream& file, std::uint64_t bytes, Format format)
    : File(file)
    , Left(bytes)
    , DataFormat(format)
  {
  }

  bool Skip(std::uint64_t bytes)
  {
    if (bytes > this->Left)
    {
      return false;
    }
    this->Left -= bytes;
    this->File.ignore(static_cast<std::streamsize>(bytes));
    return true;
  }

  /// Reads an unsigned number of so many bytes. A signed one below 0 comes out as a large one.
  bool Read(int bytes, std::uint64_t& number)
  {
    number = 0;
    if (static_cast<std::uint64_t>(bytes) > this->Left)
    {
      return false;
    }
    this->Left -= bytes;
    for (int i = 0; i < bytes; ++i)
    {
      const auto byte = static_cast<std::uint64_t>(this->File.get() & 0xff);
      number =
        this->DataFormat == Format::BigEndian ? (number << 8) | byte : number | (byte << (8 * i));
    }
    return true;
  }

private:
  std::istream& File;
  std::uint64_t Left;
  Format DataFormat;
};

bool SkipProperty(
  BinaryWalk& walk, const Property& property, const Element& element, std::uint64_t index)
{
  if (property.CountSize == 0)
  {
    return walk.Skip(property.Size);
  }
  std::uint64_t length = 0;
  if (!walk.Read(property.CountSize, length))
  {
    return false;
  }
  CheckListLength(element, index, length);
  return walk.Skip(length * property.Size);
}

void CheckBinary(std::istream& file, std::uint64_t bytes, const Header& header)
{
  BinaryWalk walk(file, bytes, header.DataFormat);
  for (const Element& element : header.Elements)
  {
    for (std::uint64_t i = 0; i < element.Count; ++i)
    {
      for (const Property& property : element.Properties)
      {
        if (!SkipProperty(walk, property, element, i))
        {
          ThrowTooShort(element, i);
        }
      }
    }
  }
}
}

std::string ProblemWithPly(const std::string& path)
{
  try
  {
    std::ifstream file(path, std::ios::binary);
    const Header header(file);
    CheckProperties(header);
    if (header.DataFormat == Format::Ascii)
    {
      CheckAscii(file, header);
    }
    else
    {
      const auto size = std::filesystem::file_size(path);
      CheckBinary(file, size - static_cast<std::uint64_t>(file.tellg()), header);
    }
    return {};
  }
  catch (const Problem& problem)
  {
    return problem.what();
  }
}
}
