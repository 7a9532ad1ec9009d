// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session_end.h"

#include <sys/socket.h>
#include <unistd.h>

#include <QApplication>
#include <QSessionManager>
#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <utility>

namespace ew {

namespace {

constexpr std::array<int, 3> kSignals{SIGTERM, SIGINT, SIGHUP};

// A signal handler may do next to nothing: it writes a byte that the event loop reads.
std::array<int, 2> wire{-1, -1};

void onSignalNow(int) {
    const char byte = 1;
    [[maybe_unused]] const auto written = ::write(wire[0], &byte, 1);
}

}  // namespace

SessionEnd::SessionEnd(QObject& owner, std::function<bool()> mayLose)
    : QObject(&owner), mayLose_(std::move(mayLose)) {
    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, &SessionEnd::commit,
            Qt::DirectConnection);
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, wire.data()) != 0) return;
    notifier_ = new QSocketNotifier(wire[1], QSocketNotifier::Read, this);
    connect(notifier_, &QSocketNotifier::activated, this, &SessionEnd::onSignal);
    for (const int signal : kSignals) std::signal(signal, onSignalNow);
}

SessionEnd::~SessionEnd() {
    if (notifier_ == nullptr) return;
    for (const int signal : kSignals) std::signal(signal, SIG_DFL);
    for (int& end : wire) ::close(std::exchange(end, -1));
}

void SessionEnd::onSignal() {
    char byte = 0;
    if (::read(wire[1], &byte, 1) != 1) return;
    // While it asks, the event loop runs and the next signal must not ask again.
    notifier_->setEnabled(false);
    QApplication::closeAllWindows();
    notifier_->setEnabled(true);
}

void SessionEnd::commit(QSessionManager& session) {
    if (!session.allowsInteraction()) return;
    if (!mayLose_()) session.cancel();
    session.release();
}

}  // namespace ew
