// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Csv.h"

#include "AtomicFile.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cstdio>
#include <fstream>

namespace arris
{
namespace
{
/// A number so that reading it gives the same again, with as few digits as do that.
std::string Exact(double value)
{
  char text[32];
  for (int digits = 6; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof(text), "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
    {
      break;
    }
  }
  return text;
}

/// Calls put(column, component) for each field of a line.
template <typename Put>
void WriteLine(std::ostream& out, vtkTable* table, Put&& put)
{
  const char* separator = "";
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    for (int c = 0; c < column->GetNumberOfComponents(); ++c)
    {
      out << separator << put(column, c);
      separator = ",";
    }
  }
  out << "\n";
}
}

void WriteCsv(vtkTable* table, const std::string& path)
{
  WriteAtomically(path,
    [&](const std::string& scratch)
    {
      std::ofstream out(scratch, std::ios::binary);
      WriteLine(out, table,
        [](vtkAbstractArray* column, int c)
        {
          const std::string name = column->GetName();
          return column->GetNumberOfComponents() == 1 ? name : name + ":" + std::to_string(c);
        });
      for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
      {
        WriteLine(out, table,
          [row](vtkAbstractArray* column, int c)
          {
            auto* numbers = vtkDataArray::SafeDownCast(column);
            return numbers != nullptr ? Exact(numbers->GetComponent(row, c))
                                      : std::string(column->GetVariantValue(row).ToString());
          });
      }
    });
}
}
