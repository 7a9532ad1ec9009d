// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

class QSessionManager;
class QSocketNotifier;

namespace ew {

/// Lets SIGTERM, SIGINT and SIGHUP, and a session that ends, do what closing all windows does: ask
/// about work that is not saved, or end in order. One at a time in a program.
class SessionEnd : public QObject {
  public:
    /// A signal closes all windows.
    /// \param mayLose  asks where something would be lost; false where the program is to stay.
    SessionEnd(QObject& owner, std::function<bool()> mayLose);
    ~SessionEnd() override;

    /// The session ends and wants to know whether it may; a no stops it.
    void commit(QSessionManager& session);

  private:
    void onSignal();

    std::function<bool()> mayLose_;
    QSocketNotifier* notifier_ = nullptr;
};

}  // namespace ew
