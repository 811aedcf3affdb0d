// SPDX-License-Identifier: MIT
#pragma once

// System calls that fail as a disk or a kernel makes them fail. The program that links refusing_kernel.cpp
// uses these in place of those of the C library. Linux only.
namespace support {

// Reads from a position fail with EIO while this is true.
extern bool readsFail;
extern int failedReads;

// Symbolic links are protected as with fs.protected_symlinks = 1: in a sticky folder that everybody may write
// to, only those of the user or of the owner of the folder are followed.
extern bool linksAreProtected;

// The permissions with which files were made, all of them together, before anything changed them.
extern unsigned permissionsOfNewFiles;

} // namespace support
