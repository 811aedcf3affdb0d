// SPDX-License-Identifier: MIT
#pragma once

#include "document/disk/process_lock.h"

#include <QFuture>
#include <QString>

#include <memory>

// Claim of a file among the windows of this account, also those of other processes: each has a lock with the
// user's data. Made in the background, since a drive may not answer. `former` is released before.
struct OpenClaim {
    std::shared_ptr<document::ProcessLock> lock; // held as long as the file is open here
    bool isElsewhere = false;                    // true if another window has the file open
};
using ClaimLock = std::shared_ptr<document::ProcessLock>;
QFuture<OpenClaim> claimBeside(const QString& path, ClaimLock former);
QString claimOf(const QString& path); // name of the lock
