// SPDX-FileCopyrightText: Copyright (c) The Arris developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AtomicFile.h"

#include "Failure.h"
#include "InputFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace arris
{
namespace
{
namespace fs = std::filesystem;

Failure CannotWrite(const std::string& path, int error)
{
  const char* advice = "write to another place";
  if (error == ENOSPC || error == EDQUOT)
  {
    advice = "free some space or write to another place";
  }
  else if (error == EFBIG)
  {
    advice = "raise the limit of the size of files (ulimit -f)";
  }
  else if (error == ENOENT)
  {
    advice = "make its folder first";
  }
  return Failure(path, std::string("cannot be written: ") + std::strerror(error), advice);
}

/// An open file, closed at the end.
class Descriptor
{
public:
  explicit Descriptor(int number)
    : Number(number)
  {
  }
  ~Descriptor() { this->Close(); }
  Descriptor(const Descriptor&) = delete;
  void operator=(const Descriptor&) = delete;

  operator int() const { return this->Number; }
  bool Close()
  {
    const int number = this->Number;
    this->Number = -1;
    return number < 0 || close(number) == 0;
  }

private:
  int Number;
};

/// Deletes a file at the end unless it has been renamed.
struct Remover
{
  std::string Name;
  ~Remover()
  {
    if (!this->Name.empty())
    {
      unlink(this->Name.c_str());
    }
  }
};

/// A file in memory, under a name with the extension that writers expect.
class Scratch
{
public:
  explicit Scratch(const std::string& extension)
    : Memory(memfd_create("arris", MFD_CLOEXEC))
    , Folder((fs::temp_directory_path() / "arris-XXXXXX").string())
  {
    if (this->Memory < 0 || mkdtemp(this->Folder.data()) == nullptr)
    {
      throw Failure(this->Folder, std::string("cannot be made: ") + std::strerror(errno),
        "name a folder for temporary files in TMPDIR");
    }
    this->Name = this->Folder + "/scratch" + extension;
    fs::create_symlink("/proc/self/fd/" + std::to_string(this->Memory), this->Name);
  }
  ~Scratch()
  {
    std::error_code ignored;
    fs::remove(this->Name, ignored);
    fs::remove(this->Folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  void operator=(const Scratch&) = delete;

  Descriptor Memory;
  std::string Name;

private:
  std::string Folder;
};

/// Whether a file has come to where files may not grow any more (`ulimit -f`).
bool IsAtLimit(off_t size)
{
  struct rlimit limit;
  return getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
    static_cast<rlim_t>(size) >= limit.rlim_cur;
}

bool WriteAll(int file, const char* bytes, ssize_t count)
{
  while (count > 0)
  {
    const ssize_t written = write(file, bytes, static_cast<std::size_t>(count));
    if (written < 0 && errno != EINTR)
    {
      return false;
    }
    if (written > 0)
    {
      bytes += written;
      count -= written;
    }
  }
  return true;
}

bool CopyAll(int from, int to)
{
  std::vector<char> buffer(1 << 20);
  for (off_t offset = 0;;)
  {
    const ssize_t count = pread(from, buffer.data(), buffer.size(), offset);
    if (count == 0)
    {
      return fsync(to) == 0; // some file systems find out only now that they are full
    }
    if (count < 0 || !WriteAll(to, buffer.data(), count))
    {
      return false;
    }
    offset += count;
  }
}

/// The permissions that the file has, or that a new one would get.
mode_t PermissionsOf(const std::string& path)
{
  struct stat status;
  if (stat(path.c_str(), &status) == 0)
  {
    return status.st_mode & 07777;
  }
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

/// Where the file itself is, if `path` is a symbolic link to it.
std::string TargetOf(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}
}

void CheckWritable(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Failure(path,
      fs::is_directory(status) ? "cannot be written: it is a folder"
                               : "cannot be written: it is not a regular file",
      "give the name of a file");
  }
  const std::string target = TargetOf(path);
  fs::path folder = fs::path(target).parent_path();
  if (folder.empty())
  {
    folder = ".";
  }
  if (!fs::is_directory(folder, error))
  {
    throw CannotWrite(path, fs::exists(folder, error) ? ENOTDIR : ENOENT);
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw CannotWrite(path, errno);
  }
}

void WriteAtomically(
  const std::string& path, const std::function<void(const std::string& scratch)>& write)
{
  // Not all of VTK's writers notice that a disk is full. So they write to memory, and the bytes go
  // from there to the disk with every step checked. Files in memory obey the limit of size, too.
  const Scratch scratch(Extension(path));
  std::exception_ptr problem;
  try
  {
    write(scratch.Name);
  }
  catch (const Failure&)
  {
    problem = std::current_exception();
  }
  struct stat written;
  if (fstat(scratch.Memory, &written) != 0)
  {
    throw CannotWrite(path, errno);
  }
  if (IsAtLimit(written.st_size))
  {
    throw CannotWrite(path, EFBIG);
  }
  if (problem)
  {
    std::rethrow_exception(problem);
  }
  if (written.st_size == 0)
  {
    throw Failure(path, "cannot be written: its writer gave nothing", "try another format");
  }

  const std::string target = TargetOf(path);
  Remover partial{ target + ".XXXXXX" };
  Descriptor file(mkstemp(partial.Name.data()));
  if (file < 0)
  {
    const int error = errno;
    partial.Name.clear();
    throw CannotWrite(path, error);
  }
  if (fchmod(file, PermissionsOf(target)) != 0 || !CopyAll(scratch.Memory, file) || !file.Close() ||
    std::rename(partial.Name.c_str(), target.c_str()) != 0)
  {
    throw CannotWrite(path, errno);
  }
  partial.Name.clear();
}
}
